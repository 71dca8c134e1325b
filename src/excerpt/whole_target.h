// The destination of a recording that is written completely or not at all.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "disk/written_file.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"

namespace mapwright::excerpt {

/// Nobody reads it before it is complete, so chunks are closed by size only.
inline recording::WriterOptions wholeFileOptions(std::string profile = {}) {
  recording::WriterOptions options;
  options.profile = std::move(profile);
  options.chunk_bytes = std::size_t(4) << 20;
  options.chunk_ns = std::numeric_limits<std::int64_t>::max();
  return options;
}

class WholeTarget : public recording::AppendTarget {
 public:
  explicit WholeTarget(const std::string& path) : file_(path) {}
  /// After an error all further calls fail.
  std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes) override {
    file_.write(bytes.data(), bytes.size());
    return file_.good() ? std::nullopt : file_.place();
  }
  std::optional<disk::FileError> settle() override { return file_.good() ? std::nullopt : file_.place(); }
  /// After the writer is closed: gives the file its name.
  std::optional<disk::FileError> place() { return file_.place(); }

 private:
  disk::WrittenFile file_;
};

}  // namespace mapwright::excerpt
