#include "robot/files/yaml_shelf.h"

#include <algorithm>
#include <ctime>
#include <sys/stat.h>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "robot/files/faults.h"

namespace mapwright::robot::files {
namespace {

constexpr std::size_t kMostKept = 20'000;
constexpr std::int64_t kCoarsestTimeNs = 2'000'000'000;  // FAT

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

std::int64_t YamlShelf::timeOfDayNs() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return nanoseconds(now);
}

tl::expected<MapYaml, Fault> YamlShelf::read(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) about = {};
  const Stamp stamp{std::uint64_t(about.st_dev), std::uint64_t(about.st_ino), std::uint64_t(about.st_size),
                    nanoseconds(about.st_mtim), nanoseconds(about.st_ctim)};
  if (const auto found = kept_.find(path); found != kept_.end() && found->second.stamp == stamp) {
    return found->second.yaml;
  }
  ++reads_;
  const auto text = disk::readFile(path, kMaxYamlBytes + 1);
  tl::expected<MapYaml, Fault> yaml =
      text ? parseMapYaml(*text)
           : tl::make_unexpected(Fault(fault::FileNotOpened, {path}, {text.error().cause}));
  const bool settled = now_ns_() - std::max(stamp.modified_ns, stamp.changed_ns) > kCoarsestTimeNs;
  kept_.erase(path);
  if (!settled || !text) return yaml;
  if (kept_.size() >= kMostKept) kept_.clear();
  kept_.emplace(path, Kept{stamp, yaml});
  return yaml;
}

}  // namespace mapwright::robot::files
