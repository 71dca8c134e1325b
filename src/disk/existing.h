// Whether a file that is written may take the place of another one.
#pragma once

#include <cstdint>
#include <string>

namespace mapwright::disk {

enum class Existing : std::uint8_t {
  Replace,
  Refuse,  // also what appears while the new file is made
};

/// What follows from a name that was just chosen: if there is a file, replacing it was agreed to; otherwise
/// nobody was asked about one that comes later.
Existing existingNow(const std::string& path);

}  // namespace mapwright::disk
