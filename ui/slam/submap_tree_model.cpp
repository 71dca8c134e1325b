#include "ui/slam/submap_tree_model.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QRegularExpression>

#include "sentences/fault_sentence.h"
#include "submap/row_version.h"
#include "submap/submap_store.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {

// The id of an index tells what it is: 0 = All, 1 = a trajectory, 2 +
// trajectory = a submap of it. Trajectories are identified by number, not by
// row, so the ids of leaves stay valid when rows are added or removed above
// them.
constexpr quintptr kAllId = 0;
constexpr quintptr kBranchId = 1;
constexpr quintptr kFirstLeafId = 2;

quintptr leafId(std::int32_t trajectory) { return kFirstLeafId + std::uint32_t(trajectory); }
std::int32_t trajectoryOf(quintptr id) { return std::int32_t(std::uint32_t(id - kFirstLeafId)); }

SubmapFacts factsOf(const session::Session& session, map::SubmapId id, const submap::SubmapRow& row) {
  SubmapFacts facts;
  facts.id = id;
  facts.version = submap::versionOf(row);
  facts.shown_version = row.shown_version;
  facts.frozen = row.entry.is_frozen;
  facts.incremental = row.entry.is_incremental;
  facts.nearby = row.entry.is_nearby;
  facts.visible = row.visible;
  facts.shown = row.visible && row.drawable(session.slice());
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
  recount();
  widest_leaf_.clear();
  endResetModel();
  sync();
}

void SubmapTreeModel::sync() {
  Rows fresh;
  longest_index_ = longest_version_ = 0;
  widest_leaf_.clear();
  if (session_) {
    for (const auto& [id, row] : session_->submaps().rows()) {
      if (fresh.empty() || fresh.back().front().id.trajectory != id.trajectory) fresh.emplace_back();
      fresh.back().push_back(factsOf(*session_, id, row));
      updateWidth(fresh.back().back());
    }
  }
  if (widest_leaf_.isEmpty()) updateWidth({});
  replaceRows(fresh);
}

void SubmapTreeModel::updateWidth(const SubmapFacts& facts) {
  const auto longer = [](std::int32_t a, std::int32_t b) {
    return QString::number(b).size() > QString::number(a).size() ? b : a;
  };
  std::int32_t index = longest_index_, version = longest_version_;
  // Compares the number first: creating a text for each of ten thousand rows
  // would be slow.
  if (facts.id.index > index || facts.id.index < 0) index = longer(index, facts.id.index);
  if (facts.version > version || facts.version < 0) version = longer(version, facts.version);
  if (!widest_leaf_.isEmpty() && index == longest_index_ && version == longest_version_) return;
  longest_index_ = index;
  longest_version_ = version;
  static const QRegularExpression digit(QStringLiteral("\\d"));
  widest_leaf_ = leafName({0, index}, version).replace(digit, QStringLiteral("0"));
}

void SubmapTreeModel::syncRows(const std::vector<map::SubmapId>& ids) {
  constexpr int kManyOthers = 500;  // rows that come or go, one by one
  if (!session_) return;
  const submap::SubmapStore& store = session_->submaps();
  int others = 0;
  for (const map::SubmapId id : ids) {
    if (branchRow(id.trajectory) < 0) return sync();
    others += (store.find(id) != nullptr) != indexOf(id).isValid();
  }
  if (others > kManyOthers) return sync();
  std::vector<int> touched;   // rows of branches
  int first = -1, last = -1;  // adjacent changed leaves, of touched.back()
  const auto emitChanged = [&] {
    if (first < 0) return;
    const quintptr id = leafId(branches_[std::size_t(touched.back())].trajectory);
    Q_EMIT dataChanged(createIndex(first, 0, id), createIndex(last, kColumns - 1, id));
    first = -1;
  };
  for (const map::SubmapId id : ids) {
    const submap::SubmapRow* const row = store.find(id);
    const int branch_row = branchRow(id.trajectory);
    Branch& branch = branches_[std::size_t(branch_row)];
    const auto leaf = std::lower_bound(branch.leaves.begin(), branch.leaves.end(), id,
                                       [](const SubmapFacts& f, map::SubmapId i) { return f.id < i; });
    const bool known = leaf != branch.leaves.end() && leaf->id == id;
    const int at = int(leaf - branch.leaves.begin());
    const SubmapFacts fresh = row ? factsOf(*session_, id, *row) : SubmapFacts{};
    if (!row && !known) continue;
    if (row && known && *leaf == fresh) continue;
    if (first >= 0 && (!row || !known || at != last + 1 || touched.back() != branch_row)) emitChanged();
    if (touched.empty() || touched.back() != branch_row) touched.push_back(branch_row);
    if (known) count(branch, *leaf, -1);
    if (row) {
      count(branch, fresh, 1);
      updateWidth(fresh);
    }
    if (!row) {
      beginRemoveRows(createIndex(branch_row, 0, kBranchId), at, at);
      branch.leaves.erase(leaf);
      endRemoveRows();
    } else if (!known) {
      beginInsertRows(createIndex(branch_row, 0, kBranchId), at, at);
      branch.leaves.insert(leaf, fresh);
      endInsertRows();
    } else {
      *leaf = fresh;
      if (first < 0) first = at;
      last = at;
    }
  }
  emitChanged();
  if (touched.empty()) return;
  const auto emptied = [this](int row) { return branches_[std::size_t(row)].leaves.empty(); };
  if (std::any_of(touched.begin(), touched.end(), emptied)) return sync();
  for (const int row : touched)
    Q_EMIT dataChanged(createIndex(row, 0, kBranchId), createIndex(row, kColumns - 1, kBranchId));
  Q_EMIT dataChanged(allIndex(), createIndex(0, kColumns - 1, kAllId));
}

void SubmapTreeModel::syncVisibility() {
  Rows fresh;
  for (const Branch& branch : branches_) {
    fresh.push_back(branch.leaves);
    for (SubmapFacts& facts : fresh.back()) {
      if (const submap::SubmapRow* row = session_ ? session_->submaps().find(facts.id) : nullptr)
        facts.visible = row->visible;
    }
  }
  replaceRows(fresh);
}

void SubmapTreeModel::replaceRows(const Rows& fresh) {
  std::vector<std::pair<int, int>> before;
  syncBranches(fresh);
  for (const Branch& branch : branches_) before.emplace_back(branch.visible, branch.shown);
  const std::tuple all_before(total_, visible_, shown_);
  for (int row = 0; row < int(branches_.size()); ++row) syncLeaves(row, fresh[std::size_t(row)]);
  recount();
  bool changed = false;
  for (int row = 0; row < int(branches_.size()); ++row) {
    const Branch& branch = branches_[std::size_t(row)];
    if (before[std::size_t(row)] == std::pair(branch.visible, branch.shown)) continue;
    changed = true;
    Q_EMIT dataChanged(createIndex(row, 0, kBranchId), createIndex(row, kColumns - 1, kBranchId));
  }
  if (changed || all_before != std::tuple(total_, visible_, shown_))
    Q_EMIT dataChanged(allIndex(), createIndex(0, kColumns - 1, kAllId));
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
  // Removed: in runs, from the end, so that earlier rows keep their numbers.
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
  // New: in runs. The rest of `leaves` is a subset of `fresh` in the same
  // order.
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

void SubmapTreeModel::recount() {
  total_ = visible_ = shown_ = 0;
  nearby_ = incremental_ = {};
  for (Branch& branch : branches_) {
    branch.visible = branch.shown = 0;
    for (const SubmapFacts& facts : branch.leaves) count(branch, facts, 1);
  }
}

void SubmapTreeModel::count(Branch& branch, const SubmapFacts& facts, int by) {
  const int visible = facts.visible ? by : 0, shown = facts.shown ? by : 0;
  total_ += by;
  visible_ += visible;
  shown_ += shown;
  branch.visible += visible;
  branch.shown += shown;
  for (const auto& [belongs, group] :
       {std::pair(facts.nearby, &nearby_), std::pair(facts.incremental, &incremental_)}) {
    if (!belongs) continue;
    group->total += by;
    group->visible += visible;
  }
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

Qt::CheckState SubmapTreeModel::visibilityWhere(bool SubmapFacts::*flag, int* count) const {
  const Group& group = flag == &SubmapFacts::nearby ? nearby_ : incremental_;
  if (count) *count = group.total;
  return checkState(group.visible, group.total);
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

QString SubmapTreeModel::leafName(map::SubmapId id, std::int32_t version) {
  const QString name = QStringLiteral("#%1").arg(id.index);
  return version == map::kNoVersion ? name : QStringLiteral("%1 v%2").arg(name).arg(version);
}
QString SubmapTreeModel::groupName(std::int32_t trajectory) { return tr("Trajectory %1").arg(trajectory); }
QString SubmapTreeModel::totalText(int shown, int total) {
  return total > 0 ? tr("%1 of %2").arg(countText(shown), countText(total)) : QString();
}

QString SubmapTreeModel::widestGroup() const {
  QString widest = groupName(0);
  for (const Branch& branch : branches_) {
    if (const QString name = groupName(branch.trajectory); name.size() > widest.size()) widest = name;
  }
  return widest;
}

QString SubmapTreeModel::widestTotal() const {
  // A group never shows more than it has, nor has more than all.
  return totalText(total_, total_);
}

QVariant SubmapTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (const auto leaf = facts(index)) return leafData(*leaf, index.column(), role);
  if (const auto number = trajectory(index)) {
    const Branch& branch = branches_[std::size_t(index.row())];
    return groupData(groupName(*number), branch.visible, branch.shown, int(branch.leaves.size()),
                     index.column(), role);
  }
  return groupData(tr("All"), visible_, shown_, total_, index.column(), role);
}

QVariant SubmapTreeModel::groupData(const QString& name, int visible, int shown, int total, int column,
                                    int role) const {
  switch (role) {
    case Qt::DisplayRole:
      if (column == NameColumn) return name;
      return column == StatusColumn && total > 0 ? QVariant(totalText(shown, total)) : QVariant();
    case Qt::CheckStateRole:
      if (column != NameColumn) return {};
      return int(checkState(visible, total));
    case Qt::ToolTipRole:
      return plainToolTip(tr("%1: %2, %3 shown, %4 hidden")
                              .arg(name, submapsText(total), countText(shown), countText(total - visible)));
    case TotalRole:
      return totalText(shown, total);
    case HiddenRole:
      return total > 0 && visible == 0;
    default:
      return {};
  }
}

QVariant SubmapTreeModel::leafData(const SubmapFacts& leaf, int column, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      if (column == NameColumn) return leafName(leaf.id, leaf.version);
      if (column == StatusColumn) return statusWord(leaf.status);
      return {};
    case Qt::CheckStateRole:
      if (column == NameColumn) return int(leaf.visible ? Qt::Checked : Qt::Unchecked);
      return {};
    case Qt::ToolTipRole: {
      if (column == LocateColumn) return tr("Centre the map on this submap");
      const QString name = QString::fromStdString(map::toText(leaf.id));
      QStringList lines{leaf.version == map::kNoVersion
                            ? tr("Submap %1, version unknown").arg(name)
                            : tr("Submap %1, version %2").arg(name).arg(leaf.version)};
      if (leaf.visible && leaf.shown_version >= 0 && leaf.shown_version != leaf.version) {
        lines << tr("Version %1 is on screen.").arg(leaf.shown_version);
      }
      const QString reason = session_ ? sentences::sentenceOf(session_->reason(leaf.id)) : QString();
      lines << (reason.isEmpty() ? statusWord(leaf.status) : words::about(statusWord(leaf.status), reason));
      return plainToolTip(lines.join(QLatin1Char('\n')));
    }
    case BadgesRole:
      return badges(leaf);
    case StatusRole:
      return int(leaf.status);
    case HiddenRole:
      return !leaf.visible;
    default:
      return {};
  }
}

QVariant SubmapTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case NameColumn:
      return tr("Submap");
    case BadgeColumn:
      return tr("Flags");
    case StatusColumn:
      return tr("Status");
    default:
      return QString();
  }
}

Qt::ItemFlags SubmapTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.column() == NameColumn) flags |= Qt::ItemIsUserCheckable;
  if (index.internalId() > 1) flags |= Qt::ItemNeverHasChildren;
  return flags;
}

bool SubmapTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != NameColumn || !session_) return false;
  session_->setVisible(submapsBelow(index), value.toInt() == Qt::Checked);
  syncVisibility();  // the boxes follow at once, not with the next update
  return true;
}

SubmapFilterModel::SubmapFilterModel(SubmapTreeModel* tree, QObject* parent)
    : QSortFilterProxyModel(parent), tree_(tree) {
  setRecursiveFilteringEnabled(true);
  setSourceModel(tree);
}

void SubmapFilterModel::setFilter(const SubmapFilter& filter) {
  if (filter == filter_) return;
  filter_ = filter;
  invalidateFilter();
}

bool SubmapFilterModel::filterAcceptsRow(int source_row, const QModelIndex& source_parent) const {
  if (filter_.empty() || !source_parent.isValid()) return true;  // "All" is always there
  const auto facts = tree_->facts(tree_->index(source_row, 0, source_parent));
  return facts && filter_.matches(*facts);  // groups are only kept for their content
}

}  // namespace mapwright::ui

#include "moc_submap_tree_model.cpp"
