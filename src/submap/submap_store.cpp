#include "submap/submap_store.h"

#include <algorithm>
#include <utility>

#include "map/submap_version.h"
#include "submap/faults.h"

namespace mapwright::submap {
namespace {

std::size_t bytesOf(const std::vector<Slice>& slices) {
  std::size_t bytes = 0;
  for (const Slice& slice : slices) bytes += slice.texture ? slice.texture->bytes() : 0;
  return bytes;
}

}  // namespace

bool SubmapRow::drawable(int slice) const {
  return pose_usable && slice >= 0 && std::size_t(slice) < slices.size() &&
         slices[std::size_t(slice)].texture;
}

std::vector<Fault> SubmapRow::corruptSlices() const {
  std::vector<Fault> reasons;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Fault& corrupt = slices[i].corrupt;
    if (!corrupt.any()) continue;
    reasons.push_back(slices.size() == 1 ? corrupt : Fault(fault::OneSlice, {std::int64_t(i)}, {corrupt}));
  }
  return reasons;
}

SubmapChange SubmapStore::apply(const map::SubmapList& list) {
  return apply(compareLists(listed_before_, list));
}

SubmapChange SubmapStore::apply(const ListDifference& list) {
  SubmapChange change;
  const map::Subject list_subject = map::SubjectKind::SubmapList;
  change.problems = list.problems;
  // What is still so is said again.
  if (rows_rejected_) change.recoveries.push_back({list_subject, map::ProblemCode::Odd});
  rows_rejected_ = list.rows_rejected;
  change.recoveries.push_back({list_subject, map::ProblemCode::Unavailable});
  if (list.new_session) {
    change.new_session = true;
    change.set_changed = true;
    rows_.clear();
    ahead_.clear();
    with_slices_.clear();
    frozen_ = 0;
    uuid_ = list.uuid;
  }
  list_received_ = true;
  slam_state_ = list.slam_state;
  listed_before_ = list.now;
  for (const map::SubmapId id : listed_twice_) {
    if (!list.listed_twice.contains(id))
      change.recoveries.push_back({map::subjectOf(id), map::ProblemCode::ListedTwice});
  }
  listed_twice_ = list.listed_twice;

  for (const map::SubmapId id : list.removed) {
    const auto it = rows_.find(id);
    if (it == rows_.end()) continue;
    change.removed.push_back(id);
    change.recoveries.push_back({map::subjectOf(id)});
    change.set_changed = true;
    forget(it);
  }
  // Every list counts that lists less than what is on screen, though it be the same as the one before.
  const std::map<map::SubmapId, int> ahead = ahead_;
  for (const ListedEntry& listed : list.changed) applyListed(listed, change);
  for (const auto& [id, lists] : ahead) {
    const auto changed = std::lower_bound(change.listed.begin(), change.listed.end(), id);  // weighed already
    if (changed != change.listed.end() && *changed == id) continue;
    if (const auto it = rows_.find(id); it != rows_.end()) weighVersion(id, it->second, change);
  }
  return change;
}

SubmapChange SubmapStore::clear() {
  SubmapChange change;
  change.new_session = change.set_changed = true;
  if (rows_rejected_) change.recoveries.push_back({map::SubjectKind::SubmapList, map::ProblemCode::Odd});
  for (const map::SubmapId id : listed_twice_)
    change.recoveries.push_back({map::subjectOf(id), map::ProblemCode::ListedTwice});
  *this = SubmapStore();
  return change;
}

void SubmapStore::forget(Rows::iterator at) {
  frozen_ -= at->second.entry.is_frozen;
  countSlices(at->second.slices.size(), 0);
  ahead_.erase(at->first);
  rows_.erase(at);
}

void SubmapStore::countSlices(std::size_t before, std::size_t now) {
  if (before == now) return;
  if (now > 0) ++with_slices_[now];
  if (before == 0) return;
  const auto count = with_slices_.find(before);
  if (--count->second == 0) with_slices_.erase(count);
}

void SubmapStore::applyListed(const ListedEntry& listed, SubmapChange& change) {
  const map::SubmapEntry& entry = listed.entry;
  const FaultCode problem = listed.pose_problem;
  const bool usable = problem == FaultCode();
  const auto [it, added] = rows_.try_emplace(entry.id);
  SubmapRow& row = it->second;
  change.set_changed |= added;
  change.listed.push_back(entry.id);
  if (!usable && problem != row.pose_problem) {
    Fault why = entry.version == map::kNoVersion
                    ? Fault(fault::CannotBePlaced, {}, {problem})
                    : Fault(fault::VersionCannotBePlaced, {std::int64_t(entry.version)}, {problem});
    why.then = row.pose_usable ? Consequence::StaysWhereItWas : Consequence::ShownWithoutIt;
    change.problems.push_back(
        {map::Severity::Error, map::subjectOf(entry.id), std::move(why), map::ProblemCode::Unplaced});
  }
  if (usable && row.pose_problem != FaultCode()) {
    change.recoveries.push_back({map::subjectOf(entry.id), map::ProblemCode::Unplaced});
  }
  row.pose_problem = problem;
  const map::SubmapEntry before = row.entry;
  frozen_ += int(entry.is_frozen) - int(before.is_frozen);
  row.entry = entry;
  if (!usable) row.entry.pose = before.pose;
  const bool was_usable = row.pose_usable;
  row.pose_usable |= usable;
  weighVersion(entry.id, row, change);
  const bool looks_different = row.entry.pose != before.pose || entry.is_frozen != before.is_frozen ||
                               entry.is_incremental != before.is_incremental ||
                               entry.is_nearby != before.is_nearby || was_usable != row.pose_usable;
  if (looks_different && row.shown_version >= 0) change.placed.push_back(entry.id);
}

void SubmapStore::weighVersion(map::SubmapId id, SubmapRow& row, SubmapChange& change) {
  if (row.entry.version != map::kNoVersion && row.entry.version < row.shown_version) {
    const int lists = ++ahead_[id];
    if (!row.stale_texture) {
      change.problems.push_back(
          {map::Severity::Warning,
           map::subjectOf(id),
           {faultText(
                "submap",
                "Its version went back from %1 to %2. The newer picture stays unless the robot repeats it."),
            {std::int64_t(row.shown_version), std::int64_t(row.entry.version)}},
           map::ProblemCode::VersionWentBack});
    }
    row.stale_texture = true;
    if (lists == kBackwardLists) change.restarted.push_back(id);
    return;
  }
  ahead_.erase(id);
  if (std::exchange(row.stale_texture, false))
    change.recoveries.push_back({map::subjectOf(id), map::ProblemCode::VersionWentBack});
}

SubmapChange SubmapStore::commit(DecodedSubmap decoded) {
  SubmapChange change;
  const auto it = rows_.find(decoded.key.id);
  if (decoded.key.uuid != uuid_ || it == rows_.end()) return change;
  SubmapRow& row = it->second;
  const auto ahead = ahead_.find(decoded.key.id);
  const bool insisted = ahead != ahead_.end() && ahead->second >= kBackwardLists;
  // Without a listed version what came last counts.
  const bool listed = row.entry.version != map::kNoVersion;
  if (decoded.version < row.shown_version && listed && !insisted) return change;
  row.shown_version = decoded.version;
  if (std::exchange(row.stale_texture, false))
    change.recoveries.push_back({map::subjectOf(decoded.key.id), map::ProblemCode::VersionWentBack});
  ahead_.erase(decoded.key.id);
  if (listed && row.entry.version < row.shown_version) ahead_.emplace(decoded.key.id, 0);
  countSlices(row.slices.size(), decoded.slices.size());
  row.slices = std::move(decoded.slices);
  row.texture_bytes = bytesOf(row.slices);
  if (auto reasons = row.corruptSlices(); !reasons.empty()) {
    change.problems.push_back({map::Severity::Error,
                               map::subjectOf(decoded.key.id),
                               {fault::VersionBroken,
                                {std::int64_t(decoded.version)},
                                std::move(reasons),
                                Consequence::ShownWithoutItUntilTheNext},
                               map::ProblemCode::Unreadable});
  } else {
    change.recoveries.push_back({map::subjectOf(decoded.key.id), map::ProblemCode::Unreadable});
  }
  change.placed.push_back(decoded.key.id);
  return change;
}

SubmapChange SubmapStore::lose(map::SubmapId id) {
  SubmapChange change;
  const auto it = rows_.find(id);
  if (it == rows_.end() || it->second.shown_version < 0) return change;
  SubmapRow& row = it->second;
  countSlices(row.slices.size(), 0);
  row.slices.clear();
  row.texture_bytes = 0;
  row.shown_version = -1;
  row.stale_texture = false;
  ahead_.erase(id);
  change.placed.push_back(id);
  return change;
}

void SubmapStore::setVisible(map::SubmapId id, bool visible) {
  if (const auto it = rows_.find(id); it != rows_.end()) it->second.visible = visible;
}

const SubmapRow* SubmapStore::find(map::SubmapId id) const {
  const auto it = rows_.find(id);
  return it == rows_.end() ? nullptr : &it->second;
}

std::optional<Placement> SubmapStore::placement(map::SubmapId id, int slice) const {
  const SubmapRow* row = find(id);
  if (!row || !row->pose_usable || slice < 0 || std::size_t(slice) >= row->slices.size()) return std::nullopt;
  const Slice& chosen = row->slices[std::size_t(slice)];
  const auto world_from_submap = geometry::toIsometry(row->entry.pose);
  const auto submap_from_slice = geometry::toIsometry(chosen.slice_pose);
  if (!chosen.texture || !world_from_submap || !submap_from_slice) return std::nullopt;
  return Placement{chosen.texture, geometry::projectToPlane(*world_from_submap * *submap_from_slice)};
}

geometry::WorldRect SubmapStore::bounds(map::SubmapId id, int slice) const {
  geometry::WorldRect rect;
  const SubmapRow* row = find(id);
  if (!row || !row->pose_usable) return rect;
  if (const auto placed = placement(id, slice)) {
    const double rows_m = placed->texture->height() * placed->texture->resolutionM();
    const double columns_m = placed->texture->width() * placed->texture->resolutionM();
    for (const double along : {0.0, -rows_m}) {
      for (const double across : {0.0, -columns_m}) {
        rect.extend(placed->world_from_texture.apply({along, across}));
      }
    }
    return rect;
  }
  rect.extend(Eigen::Vector2d(row->entry.pose.x, row->entry.pose.y));
  return rect;
}

}  // namespace mapwright::submap
