// Prevents two programs from changing the same files of a folder at the same time.
#pragma once

#include <string>

namespace mapwright::disk {

/// Waits until no other program holds the lock of this folder, and holds it until destroyed. Leaves nothing
/// on disk, and ends with the program even if that crashes. Does nothing on file systems without locks. Any
/// thread.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int fd_ = -1;
};

}  // namespace mapwright::disk
