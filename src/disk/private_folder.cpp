#include "disk/private_folder.h"

#include <cerrno>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace mapwright::disk {
namespace {

constexpr mode_t kMine = 0700, kOfOthers = 0077;

bool make(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), kMine) == 0 || errno == EEXIST) return true;
  if (errno != ENOENT || !folder.has_relative_path()) return false;
  return make(folder.parent_path()) && (::mkdir(folder.c_str(), kMine) == 0 || errno == EEXIST);
}

}  // namespace

bool makePrivateFolder(const std::string& folder) {
  std::filesystem::path path(folder);
  if (!path.has_filename()) path = path.parent_path();  // ends in a slash
  struct stat about {};
  return make(path) && ::stat(path.c_str(), &about) == 0 && S_ISDIR(about.st_mode);
}

void makePrivate(const std::string& path) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0 || about.st_uid != ::geteuid()) return;
  if (!S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode)) return;
  if ((about.st_mode & kOfOthers) == 0) return;
  // Without the permission it stays as it is.
  if (::chmod(path.c_str(), about.st_mode & 07777 & ~kOfOthers) != 0) return;
}

}  // namespace mapwright::disk
