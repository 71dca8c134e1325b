// Keeps two programs from changing the same files of a folder at the same moment.
#pragma once

#include <string>

namespace mapwright::disk {

/// Waits until no other program holds a lock of this folder, and holds it until destroyed. It leaves nothing
/// on the disk and ends with the program, however that ends. A file system that knows no locks gives none.
/// Any thread.
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
