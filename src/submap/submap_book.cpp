#include "submap/submap_book.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "words/sentences.h"

namespace mapwright::submap {
namespace {

std::string versionText(std::int32_t version) { return "Version " + std::to_string(version); }

std::string poseProblem(const geometry::Pose3& pose) {
  if (!geometry::toIsometry(pose)) {
    const double length = std::hypot(std::hypot(pose.qx, pose.qy), std::hypot(pose.qz, pose.qw));
    return std::isfinite(length) && length < 1e-6 ? "its orientation is a zero quaternion"
                                                  : "its pose holds numbers that are not finite";
  }
  if (std::max(std::abs(pose.x), std::abs(pose.y)) > kMaxCoordinateM) {
    return "its pose lies more than 1,000 km from the map's origin";
  }
  return {};
}

/// The list without duplicates: per id the highest version, then the first. `twice`: those that were listed
/// more than once.
std::map<map::SubmapId, map::SubmapEntry> uniqueEntries(const map::SubmapList& list,
                                                        std::set<map::SubmapId>& twice,
                                                        std::vector<map::Problem>& problems) {
  std::map<map::SubmapId, map::SubmapEntry> entries;
  for (const map::SubmapEntry& entry : list.entries) {
    // Lists are in order as a rule.
    const std::size_t before = entries.size();
    const auto it = entries.try_emplace(entries.end(), entry.id, entry);
    if (entries.size() > before) continue;
    twice.insert(entry.id);
    problems.push_back({map::Severity::Warning, map::subjectOf(entry.id),
                        it->second == entry ? "It is listed twice. Counted once."
                                            : "It is listed twice, differently. The highest version with a "
                                              "usable pose is used.",
                        map::ProblemCode::ListedTwice});
    const auto rank = [](const map::SubmapEntry& e) {
      return std::pair(poseProblem(e.pose).empty(), e.version);
    };
    if (rank(entry) > rank(it->second)) it->second = entry;
  }
  return entries;
}

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

std::string SubmapRow::corruptReason() const {
  std::string reason;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (slices[i].corrupt.empty()) continue;
    if (!reason.empty()) reason += "; ";
    if (slices.size() > 1) reason += "slice " + std::to_string(i) + ": ";
    reason += slices[i].corrupt;
  }
  return reason;
}

BookChange SubmapBook::apply(const map::SubmapList& list) {
  BookChange change;
  const map::Subject list_subject{map::SubjectKind::SubmapList, {}};
  for (const std::string& sentence : list.rejected) {
    change.problems.push_back({map::Severity::Warning, list_subject, sentence, map::ProblemCode::Odd});
  }
  if (rows_rejected_ && list.rejected.empty()) {
    change.recoveries.push_back({list_subject, map::ProblemCode::Odd});
  }
  rows_rejected_ = !list.rejected.empty();
  change.recoveries.push_back({list_subject, map::ProblemCode::Unavailable});
  if (list.uuid != uuid_ || !list_received_) {
    change.new_session = true;
    change.set_changed = true;
    rows_.clear();
    backward_lists_.clear();
    texture_bytes_ = 0;
    uuid_ = list.uuid;
  }
  list_received_ = true;
  slam_state_ = list.slam_state;
  std::set<map::SubmapId> listed_twice;
  const auto entries = uniqueEntries(list, listed_twice, change.problems);
  for (const map::SubmapId id : listed_twice_) {
    if (!listed_twice.contains(id))
      change.recoveries.push_back({map::subjectOf(id), map::ProblemCode::ListedTwice});
  }
  listed_twice_ = std::move(listed_twice);

  for (auto it = rows_.begin(); it != rows_.end();) {
    if (entries.contains(it->first)) {
      ++it;
      continue;
    }
    change.removed.push_back(it->first);
    change.recoveries.push_back({map::subjectOf(it->first)});
    change.set_changed = true;
    texture_bytes_ -= it->second.texture_bytes;
    backward_lists_.erase(it->first);
    it = rows_.erase(it);
  }

  auto next = rows_.begin();  // both are in order
  for (const auto& [id, entry] : entries) {
    while (next != rows_.end() && next->first < id) ++next;
    const bool added = next == rows_.end() || id < next->first;
    if (added) next = rows_.try_emplace(next, id);
    SubmapRow& row = next->second;
    change.set_changed |= added;
    const std::string problem = poseProblem(entry.pose);
    if (!problem.empty() && problem != row.pose_problem) {
      change.problems.push_back({map::Severity::Error, map::subjectOf(id),
                                 words::because(versionText(entry.version) + " cannot be placed", problem) +
                                     (row.pose_usable ? " It stays where it was." : " Shown without it."),
                                 map::ProblemCode::Unplaced});
    }
    if (problem.empty() && !row.pose_problem.empty()) {
      change.recoveries.push_back({map::subjectOf(id), map::ProblemCode::Unplaced});
    }
    row.pose_problem = problem;
    const map::SubmapEntry before = row.entry;
    row.entry = entry;
    if (!problem.empty()) row.entry.pose = before.pose;
    const bool was_usable = row.pose_usable;
    row.pose_usable |= problem.empty();

    if (entry.version < row.shown_version) {
      const int lists = ++backward_lists_[id];
      if (!row.stale_texture) {
        change.problems.push_back({map::Severity::Warning, map::subjectOf(id),
                                   "Its version went back from " + std::to_string(row.shown_version) +
                                       " to " + std::to_string(entry.version) +
                                       ". The newer picture stays unless the robot insists.",
                                   map::ProblemCode::VersionWentBack});
      }
      row.stale_texture = true;
      if (lists == kBackwardLists) change.restarted.push_back(id);
    } else {
      backward_lists_.erase(id);
      if (std::exchange(row.stale_texture, false))
        change.recoveries.push_back({map::subjectOf(id), map::ProblemCode::VersionWentBack});
    }

    const bool looks_different = row.entry.pose != before.pose || entry.is_frozen != before.is_frozen ||
                                 entry.is_incremental != before.is_incremental ||
                                 entry.is_nearby != before.is_nearby || was_usable != row.pose_usable;
    if (looks_different && row.shown_version >= 0) change.placed.push_back(id);
  }
  return change;
}

BookChange SubmapBook::commit(DecodedSubmap decoded) {
  BookChange change;
  const auto it = rows_.find(decoded.key.id);
  if (decoded.key.uuid != uuid_ || it == rows_.end()) return change;
  SubmapRow& row = it->second;
  const auto backward = backward_lists_.find(decoded.key.id);
  const bool insisted = backward != backward_lists_.end() && backward->second >= kBackwardLists;
  if (decoded.version < row.shown_version && !insisted) return change;
  row.shown_version = decoded.version;
  if (std::exchange(row.stale_texture, false))
    change.recoveries.push_back({map::subjectOf(decoded.key.id), map::ProblemCode::VersionWentBack});
  backward_lists_.erase(decoded.key.id);
  texture_bytes_ -= row.texture_bytes;
  row.slices = std::move(decoded.slices);
  row.texture_bytes = bytesOf(row.slices);
  texture_bytes_ += row.texture_bytes;
  if (const std::string reason = row.corruptReason(); !reason.empty()) {
    change.problems.push_back({map::Severity::Error, map::subjectOf(decoded.key.id),
                               words::because(versionText(decoded.version) + " is broken", reason) +
                                   " Shown without it. It will be asked for again at the next version.",
                               map::ProblemCode::Unreadable});
  } else {
    change.recoveries.push_back({map::subjectOf(decoded.key.id), map::ProblemCode::Unreadable});
  }
  change.placed.push_back(decoded.key.id);
  return change;
}

void SubmapBook::setVisible(map::SubmapId id, bool visible) {
  if (const auto it = rows_.find(id); it != rows_.end()) it->second.visible = visible;
}

const SubmapRow* SubmapBook::find(map::SubmapId id) const {
  const auto it = rows_.find(id);
  return it == rows_.end() ? nullptr : &it->second;
}

std::optional<Placement> SubmapBook::placement(map::SubmapId id, int slice) const {
  const SubmapRow* row = find(id);
  if (!row || !row->pose_usable || slice < 0 || std::size_t(slice) >= row->slices.size()) return std::nullopt;
  const Slice& chosen = row->slices[std::size_t(slice)];
  const auto world_from_submap = geometry::toIsometry(row->entry.pose);
  const auto submap_from_slice = geometry::toIsometry(chosen.slice_pose);
  if (!chosen.texture || !world_from_submap || !submap_from_slice) return std::nullopt;
  return Placement{chosen.texture, geometry::projectToPlane(*world_from_submap * *submap_from_slice)};
}

geometry::WorldRect SubmapBook::bounds(map::SubmapId id, int slice) const {
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

int SubmapBook::maxSlices() const {
  std::size_t most = 0;
  for (const auto& [id, row] : rows_) most = std::max(most, row.slices.size());
  return int(most);
}

}  // namespace mapwright::submap
