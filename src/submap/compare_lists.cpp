#include "submap/compare_lists.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map/submap_version.h"
#include "submap/faults.h"

namespace mapwright::submap {
namespace {

FaultCode poseProblem(const geometry::Pose3& pose) {
  if (!geometry::toIsometry(pose)) {
    const double length = std::hypot(std::hypot(pose.qx, pose.qy), std::hypot(pose.qz, pose.qw));
    return std::isfinite(length) && length < 1e-6
               ? fault::TurnIsZero
               : faultText("submap", "its pose contains numbers that are not finite");
  }
  if (std::max(std::abs(pose.x), std::abs(pose.y)) > kMaxCoordinateM) {
    return faultText("submap", "its pose is more than 1,000 km from the map's origin");
  }
  return FaultCode();
}

void reportTwice(const map::SubmapEntry& first, const map::SubmapEntry& other, ListDifference& difference) {
  difference.listed_twice.insert(first.id);
  difference.problems.push_back(
      {map::Severity::Warning, map::subjectOf(first.id),
       first == other
           ? faultText("submap", "It is listed twice. It counts once.")
           : faultText("submap",
                       "It is listed twice, differently. The highest version with a usable pose is used."),
       map::ProblemCode::ListedTwice});
}

std::vector<map::SubmapEntry> uniqueEntries(const map::SubmapList& list, ListDifference& difference) {
  std::vector<map::SubmapEntry> entries = list.entries;
  const auto before = [](const map::SubmapEntry& a, const map::SubmapEntry& b) { return a.id < b.id; };
  // Lists are in order as a rule.
  if (!std::is_sorted(entries.begin(), entries.end(), before)) {
    std::stable_sort(entries.begin(), entries.end(), before);
  }
  const auto rank = [](const map::SubmapEntry& e) {
    return std::pair(poseProblem(e.pose) == FaultCode(), e.version);
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (kept == 0 || entries[kept - 1].id != entries[i].id) {
      if (kept != i) entries[kept] = entries[i];
      ++kept;
      continue;
    }
    reportTwice(entries[kept - 1], entries[i], difference);
    if (rank(entries[i]) > rank(entries[kept - 1])) entries[kept - 1] = entries[i];
  }
  entries.resize(kept);
  return entries;
}

}  // namespace

ListDifference compareLists(const ListedBefore& before, const map::SubmapList& list) {
  ListDifference difference;
  difference.uuid = list.uuid;
  difference.slam_state = list.slam_state;
  difference.new_session = !before.entries || before.uuid != list.uuid;
  difference.rows_rejected = !list.rejected.empty();
  for (const Fault& why : list.rejected) {
    difference.problems.push_back(
        {map::Severity::Warning, map::SubjectKind::SubmapList, why, map::ProblemCode::Odd});
  }
  auto entries = std::make_shared<const std::vector<map::SubmapEntry>>(uniqueEntries(list, difference));
  const auto unversioned = std::count_if(entries->begin(), entries->end(), [](const map::SubmapEntry& entry) {
    return entry.version == map::kNoVersion;
  });
  if (unversioned > 0) {
    difference.rows_rejected = true;
    difference.problems.push_back({map::Severity::Info,
                                   map::SubjectKind::SubmapList,
                                   {fault::ListedWithoutVersion, {std::int64_t(unversioned)}},
                                   map::ProblemCode::Odd});
  }
  static const std::vector<map::SubmapEntry> nothing;
  const std::vector<map::SubmapEntry>& old = difference.new_session ? nothing : *before.entries;
  auto known = old.begin();
  for (const map::SubmapEntry& entry : *entries) {
    for (; known != old.end() && known->id < entry.id; ++known) difference.removed.push_back(known->id);
    const bool listed = known != old.end() && known->id == entry.id;
    if (!listed || !(*known == entry)) difference.changed.push_back({entry, poseProblem(entry.pose)});
    if (listed) ++known;
  }
  for (; known != old.end(); ++known) difference.removed.push_back(known->id);
  difference.now = {list.uuid, std::move(entries)};
  return difference;
}

}  // namespace mapwright::submap
