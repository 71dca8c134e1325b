// A file that is written whole or not at all.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

#include "disk/file_error.h"

namespace mapwright::disk {

/// "-", or a path that leads to the same place: who writes there must print nothing else.
bool isStandardOutput(const std::string& path);

/// Written beside its place and moved there by place(), once all of it is on the disk; until then, and when
/// anything fails, what was there before stays as it is. Where the file system can do that it has no name
/// until then (O_TMPFILE), so that a program that is killed leaves nothing; elsewhere it is
/// ".mapwright-….part" beside its place. A link is followed to what it names. A file that is
/// replaced keeps its permissions; a new one gets those that the umask leaves. A character device or a named
/// pipe is written into as the bytes come, and so is the standard output ("-"); block devices and sockets
/// are refused. One thread. SIGPIPE and SIGXFSZ must be ignored, or they end the program before that is told.
class WrittenFile {
 public:
  explicit WrittenFile(std::string path);
  /// Not placed: removed.
  ~WrittenFile();
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;

  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Nothing has failed yet.
  bool good() const { return !problem_; }
  /// All of it is on the disk, but not in its place yet. Where several files belong together, each is
  /// finished before the first is placed.
  bool finish();
  /// nullopt = it is in its place; else why not.
  std::optional<FileError> place();

 private:
  enum class Way { Aside, Through };  // Through: a device, a pipe or the standard output
  void openAside();
  /// False: this file system cannot do that.
  bool openUnnamed(mode_t mode);
  void openNamed(mode_t mode);
  bool give(const std::string& name);
  /// True: it is in its place. False: it is beside it, or that failed.
  bool giveName();
  void copyAside();
  void openThrough(bool pipe);
  void flush();
  bool waitForRoom();
  void fail(int error);
  void fail(Fault cause);

  std::string path_;    // as given
  std::string target_;  // links followed
  std::string aside_;   // empty: there is none, or it has no name
  bool unnamed_ = false, replaces_ = false;
  std::optional<FileError> problem_;
  Way way_ = Way::Aside;
  int fd_ = -1;
  bool patient_ = false;  // whoever reads may take as long as it likes
  bool finished_ = false, placed_ = false;
  std::vector<char> buffer_;
};

/// The whole of a file at once; nullopt = written, else why not.
std::optional<FileError> writeFile(const std::string& path, std::string_view bytes);

}  // namespace mapwright::disk
