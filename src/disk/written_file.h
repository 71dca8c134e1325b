// A file that is written completely or not at all.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

#include "disk/existing.h"
#include "disk/file_error.h"

namespace mapwright::disk {

/// "-", or a path to the same place: nothing else may be printed when writing there.
bool isStandardOutput(const std::string& path);

/// Written next to its destination and moved there by place(), once all of it is on disk; until then, and if
/// anything fails, the old file stays. If the file system supports it, it has no name until then (O_TMPFILE),
/// so that a killed program leaves nothing behind; otherwise it is called ".mapwright-….part". Links are
/// followed. A replaced file keeps its permissions; a new one follows the umask. Character devices, named
/// pipes and the standard output ("-") are written directly; block devices and sockets are refused. What may
/// replace nothing and finds its name taken in the end stays beside it, as "NAME-1.EXT", and the error says
/// so. One thread. SIGPIPE and SIGXFSZ must be ignored, otherwise they end the program before the error is
/// reported.
class WrittenFile {
 public:
  explicit WrittenFile(std::string path, Existing existing = Existing::Replace);
  /// Not placed: removed.
  ~WrittenFile();
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;

  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Nothing has failed yet.
  bool good() const { return !problem_; }
  /// All of it is on disk, but not in its place yet. If several files belong together, finish all before
  /// placing the first.
  bool finish();
  /// Where it can be read after finish(): as long as this lives, and after place() for good.
  std::string whereNow() const;
  /// nullopt = it is in its place; otherwise why not.
  std::optional<FileError> place();

 private:
  enum class Mode { Aside, Through };  // Through: a device, a pipe or the standard output
  void openAside();
  /// False: not supported by this file system.
  bool openUnnamed(mode_t mode);
  void openNamed(mode_t mode);
  bool give(const std::string& name);
  /// The unnamed file gets a name next to its place.
  void nameAside();
  void copyAside();
  void moveIntoPlace();
  void openThrough(bool pipe);
  void flush();
  bool waitForRoom();
  void fail(int error);
  void fail(Fault cause);

  std::string path_;    // as given
  std::string target_;  // links followed; where it was kept instead
  Existing existing_;
  std::string aside_;  // empty: there is none, or it has no name
  bool unnamed_ = false, replaces_ = false;
  std::optional<FileError> problem_;
  Mode mode_ = Mode::Aside;
  int fd_ = -1;
  bool patient_ = false;  // the reader may take as long as it likes
  bool finished_ = false, placed_ = false;
  std::vector<char> buffer_;
};

/// Gives a finished file its name, in the same folder. nullopt = moved; otherwise why not, as of
/// WrittenFile.
std::optional<FileError> moveInto(const std::string& from, const std::string& to, Existing existing);

/// Writes a whole file at once; nullopt = written, otherwise why not.
std::optional<FileError> writeFile(const std::string& path, std::string_view bytes,
                                   Existing existing = Existing::Replace);

}  // namespace mapwright::disk
