#include "ui/slam/closures_model.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include "geometry/pose.h"

namespace mapwright::ui {
namespace {

QString nameOf(const std::optional<map::SubmapId>& id) {
  return id ? QString::fromStdString(map::toText(*id)) : QString();
}
QString nameOf(const std::optional<map::NodeId>& id) {
  return id ? QString::fromStdString(map::toText(*id)) : QString();
}

}  // namespace

bool ClosureFilter::lists(const ClosureRow& row) const {
  static const QRegularExpression whole_id(QStringLiteral("^\\d+-\\d+$"));
  if (!(row.kind == map::ConstraintKind::Inter ? inter : intra)) return false;
  if (row.residual_m < least_m || (submap && row.submap != submap)) return false;
  if (text.isEmpty()) return true;
  const bool whole = whole_id.match(text).hasMatch();
  const auto named = [&](const QString& name) { return whole ? name == text : name.startsWith(text); };
  return named(nameOf(row.submap)) || named(nameOf(row.node));
}

bool ClosureFilter::listsLoopClosures() const {
  ClosureFilter all;
  all.by_submap = by_submap;
  return *this == all;
}

int ClosuresModel::rowOf(const ClosureRow& closure) const {
  const auto found = std::find_if(listed_.begin(), listed_.end(), [&](const Listed& listed) {
    const ClosureRow& row = rows_[listed.row];
    return filter_.by_submap ? row.submap == closure.submap
                             : row.submap == closure.submap && row.node == closure.node &&
                                   row.at == closure.at && row.expected == closure.expected;
  });
  return found == listed_.end() ? -1 : int(found - listed_.begin());
}

void ClosuresModel::setRows(std::vector<ClosureRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  list();
  endResetModel();
}

void ClosuresModel::setFilter(ClosureFilter filter) {
  if (filter == filter_) return;
  beginResetModel();
  filter_ = std::move(filter);
  list();
  endResetModel();
}

void ClosuresModel::list() {
  listed_.clear();
  std::map<map::SubmapId, std::size_t> seen;  // where it is listed
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ClosureRow& row = rows_[i];
    if (!filter_.lists(row)) continue;
    if (!filter_.by_submap) {
      listed_.push_back({i});
    } else if (row.submap) {
      const auto [at, fresh] = seen.try_emplace(*row.submap, listed_.size());
      if (fresh) listed_.push_back({i});
      Listed& listed = listed_[at->second];
      ++listed.of_submap;
      if (row.residual_m > kContradictsMapM) ++listed.contradict;
    }
  }
  arrange();
}

void ClosuresModel::arrange() {
  const auto before = [this](const Listed& a, const Listed& b) {
    const ClosureRow &one = rows_[a.row], &other = rows_[b.row];
    switch (sort_column_) {
      case ResidualColumn:
        return one.residual_m < other.residual_m;
      case TurnColumn:
        return one.residual_rad < other.residual_rad;
      case SubmapColumn:
        return one.submap < other.submap;
      case NodeColumn:
        return filter_.by_submap ? a.contradict < b.contradict : one.node < other.node;
      case TimeColumn:
        return !filter_.by_submap && one.stamp_s < other.stamp_s;
      default:
        return a.contradict > b.contradict;
    }
  };
  if (sort_column_ >= 0 && sort_order_ == Qt::DescendingOrder)
    std::stable_sort(listed_.rbegin(), listed_.rend(), before);
  else
    std::stable_sort(listed_.begin(), listed_.end(), before);
}

void ClosuresModel::sort(int column, Qt::SortOrder order) {
  Q_EMIT layoutAboutToBeChanged({}, VerticalSortHint);
  const QModelIndexList kept = persistentIndexList();
  std::vector<std::size_t> rows;
  for (const QModelIndex& one : kept) rows.push_back(listed_[std::size_t(one.row())].row);
  sort_column_ = column;
  sort_order_ = order;
  list();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto now = std::find_if(listed_.begin(), listed_.end(),
                                  [&](const Listed& listed) { return listed.row == rows[i]; });
    changePersistentIndex(kept[qsizetype(i)], index(int(now - listed_.begin()), kept[qsizetype(i)].column()));
  }
  Q_EMIT layoutChanged({}, VerticalSortHint);
}

bool ClosuresModel::namesSubmaps() const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [](const ClosureRow& row) { return row.submap.has_value(); });
}

QVariant ClosuresModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::TextAlignmentRole) {
    const bool number = index.column() == ResidualColumn || index.column() == TurnColumn;
    return int((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const Listed& listed = listed_[std::size_t(index.row())];
  const ClosureRow& row = rows_[listed.row];
  switch (Column(index.column())) {
    case ResidualColumn:
      return QString::number(row.residual_m, 'f', 3);
    case TurnColumn:
      return row.residual_rad ? QString::number(geometry::degreesFromRadians(*row.residual_rad), 'f', 2)
                              : QString();
    case SubmapColumn:
      return nameOf(row.submap);
    case NodeColumn:
      return filter_.by_submap ? tr("%1 of %2").arg(listed.contradict).arg(listed.of_submap)
                               : nameOf(row.node);
    case TimeColumn: {
      if (!row.stamp_s || filter_.by_submap) return {};
      const QDateTime at = QDateTime::fromMSecsSinceEpoch(qint64(*row.stamp_s * 1000));
      return role == Qt::ToolTipRole ? QLocale().toString(at, QLocale::LongFormat)
                                     : at.toString(QStringLiteral("hh:mm:ss"));
    }
    case kColumns:
      break;
  }
  return {};
}

QVariant ClosuresModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section == ResidualColumn || section == TurnColumn ? Qt::AlignRight : Qt::AlignLeft) |
               Qt::AlignVCenter);
  const bool figures =
      section == ResidualColumn || section == TurnColumn || (section == NodeColumn && filter_.by_submap);
  if (role == Qt::InitialSortOrderRole) return int(figures ? Qt::DescendingOrder : Qt::AscendingOrder);
  if (role == Qt::ToolTipRole) {
    if (section == ResidualColumn)
      return tr("How far the constraint has the robot from where the finished map has it, metres");
    if (section == TurnColumn) return tr("The same for its heading, degrees");
    if (section == NodeColumn && filter_.by_submap)
      return tr("How many of its constraints contradict the finished map by more than 0.5 m");
  }
  if (role != Qt::DisplayRole) return {};
  const QString room = section == sort_column_ ? roomForArrow() : QString();
  switch (Column(section)) {
    case ResidualColumn:
      return tr("Off, m") + room;
    case TurnColumn:
      return tr("Turn, °") + room;
    case SubmapColumn:
      return tr("Submap");
    case NodeColumn:
      return (filter_.by_submap ? tr("Over 0.5 m") : tr("Node")) + room;
    case TimeColumn:
      return filter_.by_submap ? QString() : tr("Time");
    case kColumns:
      break;
  }
  return {};
}

}  // namespace mapwright::ui

#include "moc_closures_model.cpp"
