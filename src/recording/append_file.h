// A file that is only appended to. One thread. SIGXFSZ must be ignored, as for disk::WrittenFile.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "disk/existing.h"
#include "disk/file_error.h"

namespace mapwright::recording {

class AppendTarget {
 public:
  virtual ~AppendTarget() = default;
  /// Appends all of it, or nothing: after a failure the file is as before.
  virtual std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes) = 0;
  /// Everything appended so far survives a power loss.
  virtual std::optional<disk::FileError> settle() = 0;
};

using disk::Existing;

/// Creates a file; anything but a regular file is refused.
tl::expected<std::unique_ptr<AppendTarget>, disk::FileError> appendFile(const std::string& path,
                                                                        Existing existing);

}  // namespace mapwright::recording
