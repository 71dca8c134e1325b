#include "window/waypoints/waypoints_model.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include "scene/drawn_waypoint.h"
#include "window/look/plain_label.h"
#include "window/look/ui_colors.h"
#include "window/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr std::size_t kManyRows = 200;  // more at once are told as a whole
constexpr int kMarkPx = 16;

QString metresText(double metres) { return QLocale::c().toString(metres, 'f', 2); }

QVariant stateMark(const edit::ItemState& state) {
  if (state == edit::ItemState{}) return {};
  const UiColors colors = appColors();
  const double ratio = qApp->devicePixelRatio();
  QPixmap pixmap(QSize(kMarkPx, kMarkPx) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  const scene::WaypointMark mark = state.changed_elsewhere ? scene::WaypointMark::Conflict
                                   : state.sent            ? scene::WaypointMark::Sent
                                                           : scene::WaypointMark::Unsaved;
  const QColor color = state.changed_elsewhere ? colors.error : colors.warning;
  scene::paintWaypointMark(painter, QPointF(kMarkPx / 2.0, kMarkPx / 2.0), 5, mark, color, color);
  return pixmap;
}

}  // namespace

void WaypointsModel::setDocument(edit::WaypointDocument* document) {
  if (document_) document_->disconnect(this);
  document_ = document;
  if (document_) connect(document_, &edit::DocumentEvents::changed, this, &WaypointsModel::take);
  begin();
}

void WaypointsModel::begin() {
  beginResetModel();
  rows_.clear();
  row_of_.clear();
  if (document_) {
    for (const auto& [key, point] : document_->items()) rows_.push_back(key);
  }
  number(0);
  endResetModel();
}

void WaypointsModel::number(std::size_t from) {
  for (std::size_t row = from; row < rows_.size(); ++row) row_of_[rows_[row]] = int(row);
}

void WaypointsModel::take(const edit::DocumentChange& change) {
  if (change.everything || change.added.size() + change.removed.size() > kManyRows) return begin();
  for (const edit::Key& key : change.removed) {
    const auto known = row_of_.find(key);
    if (known == row_of_.end()) continue;
    const int row = known->second;
    beginRemoveRows({}, row, row);
    rows_.erase(rows_.begin() + row);
    row_of_.erase(known);
    number(std::size_t(row));
    endRemoveRows();
  }
  for (const edit::Key& key : change.added) {
    if (row_of_.contains(key)) continue;
    beginInsertRows({}, int(rows_.size()), int(rows_.size()));
    rows_.push_back(key);
    number(rows_.size() - 1);
    endInsertRows();
  }
  for (const edit::Key& key : change.changed) {
    const QModelIndex at = indexOf(key, 0);
    if (at.isValid()) Q_EMIT dataChanged(at, at.siblingAtColumn(kColumns - 1));
  }
}

edit::Key WaypointsModel::key(const QModelIndex& index) const {
  return index.isValid() && index.row() < int(rows_.size()) ? rows_[std::size_t(index.row())] : edit::Key();
}

QModelIndex WaypointsModel::indexOf(const edit::Key& key, int column) const {
  const auto known = row_of_.find(key);
  return known == row_of_.end() ? QModelIndex() : index(known->second, column);
}

int WaypointsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}
int WaypointsModel::columnCount(const QModelIndex&) const { return kColumns; }

QVariant WaypointsModel::data(const QModelIndex& index, int role) const {
  const edit::Key at = key(index);
  const map::Waypoint* const point = document_ ? document_->find(at) : nullptr;
  if (!point) return {};
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return text(*point, column);
    case kSortRole:
      return sortValue(at, *point, column);
    case Qt::DecorationRole:
      return column == StateColumn ? stateMark(document_->state(at)) : QVariant();
    case Qt::AccessibleTextRole:
      return column == StateColumn ? stateText(document_->state(at)) : QVariant();
    case Qt::ToolTipRole: {
      QStringList lines{words::plainName(point->name)};
      if (!point->tags.empty()) lines << tr("Tags: %1").arg(tagsText(point->tags));
      const QString state = stateText(document_->state(at));
      if (!state.isEmpty()) lines << state;
      return plainToolTip(lines.join(QLatin1Char('\n')));
    }
    case Qt::TextAlignmentRole:
      return int(column == XColumn || column == YColumn || column == YawColumn
                     ? Qt::AlignRight | Qt::AlignVCenter
                     : Qt::AlignLeft | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant WaypointsModel::text(const map::Waypoint& point, int column) const {
  switch (column) {
    case NameColumn:
      return shortWaypointName(point, 120);
    case XColumn:
      return metresText(point.position_m.x());
    case YColumn:
      return metresText(point.position_m.y());
    case YawColumn:
      return yawText(point.yaw_rad).remove(QChar(0xb0));
    case TagsColumn:
      return tagsText(point.tags);
    default:
      return {};
  }
}

QVariant WaypointsModel::sortValue(const edit::Key& key, const map::Waypoint& point, int column) const {
  switch (column) {
    case StateColumn: {
      const edit::ItemState state = document_->state(key);
      return state.changed_elsewhere ? 0 : state.unsaved ? 1 : 2;
    }
    case XColumn:
      return point.position_m.x();
    case YColumn:
      return point.position_m.y();
    case YawColumn:
      return point.yaw_rad.value_or(10);
    default:
      return text(point, column);
  }
}

QVariant WaypointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section >= XColumn && section <= YawColumn)
    return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case NameColumn:
      return tr("Name");
    case XColumn:
      return tr("x m");
    case YColumn:
      return tr("y m");
    case YawColumn:
      return QStringLiteral("yaw °");
    case TagsColumn:
      return tr("Tags");
    default:
      return {};
  }
}

}  // namespace mapwright::window
