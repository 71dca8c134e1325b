// How the formats are opened; only for this room.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "recording/source.h"

namespace mapwright::recording {

/// "SQLite format 3": which database it is, only looking into it tells.
bool looksLikeSqlite(std::span<const std::uint8_t> start);
bool looksLikeZstd(std::span<const std::uint8_t> start);

/// The SQLite3 storage of rosbag2 (.db3). NotOne: another database.
Opened openSqliteBag(const std::string& path, const Limits& limits, Stop stop);

/// The folder at this path, or that of its metadata.yaml.
std::optional<std::string> rosbagFolderAt(const std::string& path);
/// What metadata.yaml of rosbag2 says, or where that is missing or unusable, what the names of the files say.
struct RosbagFolder {
  std::vector<std::string> files;  // in their order; only names, which lie in the folder
  std::uint64_t messages = 0;      // in all of them; 0: not said
  std::uint64_t left_out = 0;      // files that are too many
  bool described = true;           // by a metadata.yaml
};
RosbagFolder rosbagFolder(const std::string& folder);

/// Several recordings as one: their messages by time, those of one time in the order of the files.
std::unique_ptr<Source> joined(std::vector<std::unique_ptr<Source>> parts, std::vector<Note> notes);

/// A source, and what is to be said of it besides.
std::unique_ptr<Source> noted(std::unique_ptr<Source> source, Note note);

/// A file in the folder for temporary files, gone with this.
class TemporaryFile {
 public:
  TemporaryFile() = default;
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }

 private:
  friend tl::expected<TemporaryFile, Failure> unpackedFile(const std::string&, const Limits&, const Stop&);
  std::string path_;
  std::uint64_t size_ = 0;
};
/// The content of a file that is compressed with Zstandard.
tl::expected<TemporaryFile, Failure> unpackedFile(const std::string& path, const Limits& limits,
                                                  const Stop& stop);

}  // namespace mapwright::recording
