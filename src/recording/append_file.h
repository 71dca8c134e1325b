// A file that is only ever added to. One thread. SIGXFSZ must be ignored, as for disk::WrittenFile.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "disk/file_error.h"

namespace mapwright::recording {

class AppendTarget {
 public:
  virtual ~AppendTarget() = default;
  /// All of it is handed to the system, or nothing is there: what was there before is as it was.
  virtual std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes) = 0;
  /// What was handed over survives the end of the machine too.
  virtual std::optional<disk::FileError> settle() = 0;
};

enum class Existing : std::uint8_t { Refuse, Replace };

/// A new file; what is no regular file is refused.
tl::expected<std::unique_ptr<AppendTarget>, disk::FileError> appendFile(const std::string& path,
                                                                        Existing existing);

}  // namespace mapwright::recording
