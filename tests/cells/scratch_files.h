// What becomes of those who keep things in files without a name when the disk breaks.
#pragma once

#include <filesystem>
#include <string>

namespace mapwright::test {

/// All files without a name that this program has are empty from now on.
inline void truncateScratchFiles() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code failed;
    const std::string target = std::filesystem::read_symlink(entry.path(), failed).string();
    if (target.ends_with(" (deleted)")) std::filesystem::resize_file(entry.path(), 0, failed);
  }
}

}  // namespace mapwright::test
