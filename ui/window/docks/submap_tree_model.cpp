#include "window/docks/submap_tree_model.h"

#include <algorithm>

#include <QRegularExpression>

#include "window/look/plain_label.h"
#include "window/status/status_text.h"

namespace mapwright::window {

namespace {

// What an index stands for is in its id: 0 = All, 1 = a trajectory, 2 + trajectory = a submap of it.
// Trajectories are named by number and not by row, so the ids of leaves survive rows that come and go above
// them.
constexpr quintptr kAllId = 0;
constexpr quintptr kBranchId = 1;
constexpr quintptr kFirstLeafId = 2;

quintptr leafId(std::int32_t trajectory) { return kFirstLeafId + std::uint32_t(trajectory); }
std::int32_t trajectoryOf(quintptr id) { return std::int32_t(std::uint32_t(id - kFirstLeafId)); }

SubmapFacts factsOf(const session::Session& session, map::SubmapId id, const submap::SubmapRow& row) {
  SubmapFacts facts;
  facts.id = id;
  facts.version = row.entry.version;
  facts.shown_version = row.shown_version;
  facts.frozen = row.entry.is_frozen;
  facts.incremental = row.entry.is_incremental;
  facts.nearby = row.entry.is_nearby;
  facts.visible = row.visible;
  facts.drawable = row.drawable(session.slice());
  facts.status = session.status(id);
  return facts;
}

Qt::CheckState checkState(int visible, int total) {
  return visible == 0 ? Qt::Unchecked : visible == total ? Qt::Checked : Qt::PartiallyChecked;
}

}  // namespace

SubmapTreeModel::SubmapTreeModel(QObject* parent) : QAbstractItemModel(parent) {}

void SubmapTreeModel::setSession(session::Session* session) {
  beginResetModel();
  session_ = session;
  branches_.clear();
  total_ = visible_ = shown_ = 0;
  widest_leaf_.clear();
  endResetModel();
  sync();
}

void SubmapTreeModel::sync() {
  Rows fresh;
  std::int32_t longest_index = 0, longest_version = 0;
  const auto longer = [](std::int32_t a, std::int32_t b) {
    return QString::number(b).size() > QString::number(a).size() ? b : a;
  };
  if (session_) {
    for (const auto& [id, row] : session_->book().rows()) {
      if (fresh.empty() || fresh.back().front().id.trajectory != id.trajectory) fresh.emplace_back();
      fresh.back().push_back(factsOf(*session_, id, row));
      // Looked at by the number first: a text for each of ten thousand rows would be felt.
      if (id.index > longest_index || id.index < 0) longest_index = longer(longest_index, id.index);
      if (row.entry.version > longest_version || row.entry.version < 0)
        longest_version = longer(longest_version, row.entry.version);
    }
  }
  static const QRegularExpression digit(QStringLiteral("\\d"));
  widest_leaf_ = leafName({0, longest_index}, longest_version).replace(digit, QStringLiteral("0"));
  takeOver(fresh);
}

void SubmapTreeModel::syncVisibility() {
  Rows fresh;
  for (const Branch& branch : branches_) {
    fresh.push_back(branch.leaves);
    for (SubmapFacts& facts : fresh.back()) {
      if (const submap::SubmapRow* row = session_ ? session_->book().find(facts.id) : nullptr)
        facts.visible = row->visible;
    }
  }
  takeOver(fresh);
}

void SubmapTreeModel::takeOver(const Rows& fresh) {
  syncBranches(fresh);
  bool changed = false;
  for (int row = 0; row < int(branches_.size()); ++row) {
    syncLeaves(row, fresh[std::size_t(row)]);
    if (recount(branches_[std::size_t(row)])) {
      changed = true;
      Q_EMIT dataChanged(createIndex(row, 0, kBranchId), createIndex(row, kColumns - 1, kBranchId));
    }
  }
  int total = 0, visible = 0, shown = 0;
  for (const Branch& branch : branches_) {
    total += int(branch.leaves.size());
    visible += branch.visible;
    shown += branch.shown;
  }
  if (changed || total != total_ || visible != visible_ || shown != shown_) {
    total_ = total;
    visible_ = visible;
    shown_ = shown;
    Q_EMIT dataChanged(allIndex(), createIndex(0, kColumns - 1, kAllId));
  }
}

void SubmapTreeModel::syncBranches(const Rows& fresh) {
  const auto listed = [&fresh](std::int32_t trajectory) {
    return std::any_of(fresh.begin(), fresh.end(), [trajectory](const auto& leaves) {
      return leaves.front().id.trajectory == trajectory;
    });
  };
  for (int row = int(branches_.size()) - 1; row >= 0; --row) {
    if (listed(branches_[std::size_t(row)].trajectory)) continue;
    beginRemoveRows(allIndex(), row, row);
    branches_.erase(branches_.begin() + row);
    endRemoveRows();
  }
  for (int row = 0; row < int(fresh.size()); ++row) {
    const std::int32_t wanted = fresh[std::size_t(row)].front().id.trajectory;
    if (row < int(branches_.size()) && branches_[std::size_t(row)].trajectory == wanted) continue;
    beginInsertRows(allIndex(), row, row);
    branches_.insert(branches_.begin() + row, Branch{wanted, {}, 0, 0});
    endInsertRows();
  }
}

void SubmapTreeModel::syncLeaves(int branch_row, const std::vector<SubmapFacts>& fresh) {
  std::vector<SubmapFacts>& leaves = branches_[std::size_t(branch_row)].leaves;
  const QModelIndex parent = createIndex(branch_row, 0, kBranchId);
  const auto before = [](const SubmapFacts& a, const SubmapFacts& b) { return a.id < b.id; };
  // Gone: in runs, from the end, so that the rows before stay what they are.
  for (int last = int(leaves.size()) - 1; last >= 0;) {
    const auto gone = [&](int row) {
      return !std::binary_search(fresh.begin(), fresh.end(), leaves[std::size_t(row)], before);
    };
    if (!gone(last)) {
      --last;
      continue;
    }
    int first = last;
    while (first > 0 && gone(first - 1)) --first;
    beginRemoveRows(parent, first, last);
    leaves.erase(leaves.begin() + first, leaves.begin() + last + 1);
    endRemoveRows();
    last = first - 1;
  }
  // New: in runs. What is left of `leaves` is a subset of `fresh` in the same order.
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    if (row < leaves.size() && leaves[row].id == fresh[row].id) continue;
    std::size_t end = row + 1;
    while (end < fresh.size() && !(row < leaves.size() && leaves[row].id == fresh[end].id)) ++end;
    beginInsertRows(parent, int(row), int(end) - 1);
    leaves.insert(leaves.begin() + std::ptrdiff_t(row), fresh.begin() + std::ptrdiff_t(row),
                  fresh.begin() + std::ptrdiff_t(end));
    endInsertRows();
    row = end - 1;
  }
  // Changed: in runs.
  const quintptr id = leafId(branches_[std::size_t(branch_row)].trajectory);
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    if (leaves[row] == fresh[row]) continue;
    const std::size_t first = row;
    while (row < fresh.size() && leaves[row] != fresh[row]) {
      leaves[row] = fresh[row];
      ++row;
    }
    Q_EMIT dataChanged(createIndex(int(first), 0, id), createIndex(int(row) - 1, kColumns - 1, id));
  }
}

bool SubmapTreeModel::recount(Branch& branch) {
  int visible = 0, shown = 0;
  for (const SubmapFacts& facts : branch.leaves) {
    visible += facts.visible;
    shown += facts.drawable;
  }
  const bool changed = visible != branch.visible || shown != branch.shown;
  branch.visible = visible;
  branch.shown = shown;
  return changed;
}

int SubmapTreeModel::branchRow(std::int32_t trajectory) const {
  const auto at = std::lower_bound(branches_.begin(), branches_.end(), trajectory,
                                   [](const Branch& b, std::int32_t t) { return b.trajectory < t; });
  return at != branches_.end() && at->trajectory == trajectory ? int(at - branches_.begin()) : -1;
}

std::optional<SubmapFacts> SubmapTreeModel::facts(const QModelIndex& index) const {
  if (!index.isValid() || index.internalId() < kFirstLeafId) return std::nullopt;
  const int row = branchRow(trajectoryOf(index.internalId()));
  if (row < 0) return std::nullopt;
  const auto& leaves = branches_[std::size_t(row)].leaves;
  if (index.row() < 0 || index.row() >= int(leaves.size())) return std::nullopt;
  return leaves[std::size_t(index.row())];
}

std::optional<std::int32_t> SubmapTreeModel::trajectory(const QModelIndex& index) const {
  if (!index.isValid() || index.internalId() != kBranchId || index.row() >= int(branches_.size()))
    return std::nullopt;
  return branches_[std::size_t(index.row())].trajectory;
}

QModelIndex SubmapTreeModel::indexOf(map::SubmapId id) const {
  const int row = branchRow(id.trajectory);
  if (row < 0) return {};
  const auto& leaves = branches_[std::size_t(row)].leaves;
  const auto at = std::lower_bound(leaves.begin(), leaves.end(), id,
                                   [](const SubmapFacts& f, map::SubmapId i) { return f.id < i; });
  if (at == leaves.end() || at->id != id) return {};
  return createIndex(int(at - leaves.begin()), 0, leafId(id.trajectory));
}

std::vector<map::SubmapId> SubmapTreeModel::submapsBelow(const QModelIndex& index) const {
  std::vector<map::SubmapId> ids;
  if (const auto leaf = facts(index)) return {leaf->id};
  const auto only = trajectory(index);
  for (const Branch& branch : branches_) {
    if (only && *only != branch.trajectory) continue;
    for (const SubmapFacts& leaf : branch.leaves) ids.push_back(leaf.id);
  }
  return ids;
}

std::vector<map::SubmapId> SubmapTreeModel::submapsWhere(bool SubmapFacts::*flag) const {
  std::vector<map::SubmapId> ids;
  for (const Branch& branch : branches_) {
    for (const SubmapFacts& leaf : branch.leaves) {
      if (leaf.*flag) ids.push_back(leaf.id);
    }
  }
  return ids;
}

Qt::CheckState SubmapTreeModel::visibility(const std::vector<map::SubmapId>& ids) const {
  int visible = 0;
  for (const map::SubmapId id : ids) {
    const auto leaf = facts(indexOf(id));
    visible += leaf && leaf->visible;
  }
  return checkState(visible, int(ids.size()));
}

Qt::CheckState SubmapTreeModel::visibilityWhere(bool SubmapFacts::*flag, int* count) const {
  int visible = 0, total = 0;
  for (const Branch& branch : branches_) {
    for (const SubmapFacts& leaf : branch.leaves) {
      total += leaf.*flag;
      visible += leaf.*flag && leaf.visible;
    }
  }
  if (count) *count = total;
  return checkState(visible, total);
}

QModelIndex SubmapTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (row < 0 || column < 0 || column >= kColumns || row >= rowCount(parent)) return {};
  if (!parent.isValid()) return createIndex(row, column, kAllId);
  if (parent.internalId() == kAllId) return createIndex(row, column, kBranchId);
  return createIndex(row, column, leafId(branches_[std::size_t(parent.row())].trajectory));
}

QModelIndex SubmapTreeModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == kAllId) return {};
  if (child.internalId() == kBranchId) return allIndex();
  const int row = branchRow(trajectoryOf(child.internalId()));
  return row < 0 ? QModelIndex() : createIndex(row, 0, kBranchId);
}

int SubmapTreeModel::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  if (!parent.isValid()) return 1;
  if (parent.internalId() == kAllId) return int(branches_.size());
  if (parent.internalId() == kBranchId && parent.row() < int(branches_.size())) {
    return int(branches_[std::size_t(parent.row())].leaves.size());
  }
  return 0;
}

}  // namespace mapwright::window
