#include "ui/waypoints/waypoints_model.h"

#include <algorithm>
#include <array>

#include <QFont>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>
#include <QPainter>

#include "sentences/placing_sentence.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/scene/drawn_waypoint.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_warnings.h"
#include "words/fixed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

constexpr std::size_t kManyRows = 200;  // more at once are signalled as a whole
constexpr int kWaypointMarkPx = 16;

QString metresText(double metres) { return words::fixed(metres, 2); }

QVariant stateMark(const edit::ItemState& state, int pending) {
  if (pending == 0 && !state.sent) return {};
  const UiColors colors = appColors();
  const double ratio = qApp->devicePixelRatio();
  QImage picture(QSize(kWaypointMarkPx, kWaypointMarkPx) * ratio, QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  const scene::WaypointMark mark = state.changed_elsewhere ? scene::WaypointMark::Conflict
                                   : state.sent            ? scene::WaypointMark::Sent
                                   : pending & kNew        ? scene::WaypointMark::New
                                   : pending & kDeleted    ? scene::WaypointMark::Deleted
                                                           : scene::WaypointMark::Unsaved;
  const QColor color = state.changed_elsewhere ? colors.error : colors.warning;
  const QColor edge = mark == scene::WaypointMark::Deleted ? QColor(Qt::transparent) : color;
  scene::paintWaypointMark(painter, QPointF(kWaypointMarkPx / 2.0, kWaypointMarkPx / 2.0), 5, mark, color,
                           edge);
  painter.end();
  return sharedPixmap(picture);
}

}  // namespace

void WaypointsModel::setDocument(edit::WaypointDocument* document) {
  if (document_) document_->disconnect(this);
  document_ = document;
  if (document_) connect(document_, &edit::WaypointDocument::changed, this, &WaypointsModel::onChanged);
  begin();
}

void WaypointsModel::setWarnings(const WaypointWarnings* warnings) {
  warnings_ = warnings;
  connect(warnings, &WaypointWarnings::changed, this, [this](const std::vector<std::string>& keys) {
    // With many rows the table is repainted, without sorting them again because of their marks.
    if (keys.size() > kManyRows) return;
    for (const edit::Key& key : keys) {
      const QModelIndex at = indexOf(key, 0);
      if (at.isValid())
        Q_EMIT dataChanged(at, at.siblingAtColumn(kColumns - 1),
                           {Qt::DecorationRole, Qt::ToolTipRole, Qt::AccessibleTextRole});
    }
  });
}

const placing::Warnings& WaypointsModel::warningsOf(const edit::Key& key) const {
  static const placing::Warnings kNone;
  return warnings_ ? warnings_->of(key) : kNone;
}

void WaypointsModel::begin() {
  beginResetModel();
  rows_.clear();
  row_of_.clear();
  if (document_) {
    for (const auto& [key, point] : document_->items()) rows_.push_back(key);
    for (const edit::Key& key : document_->unsaved()) {
      if (!document_->find(key)) rows_.push_back(key);
    }
  }
  number(0);
  endResetModel();
}

void WaypointsModel::number(std::size_t from) {
  for (std::size_t row = from; row < rows_.size(); ++row) row_of_[rows_[row]] = int(row);
}

bool WaypointsModel::belongs(const edit::Key& key) const {
  return document_->find(key) || (document_->unsaved().contains(key) && document_->findKept(key));
}

const map::Waypoint* WaypointsModel::point(const edit::Key& key) const {
  if (!document_) return nullptr;
  const map::Waypoint* const here = document_->find(key);
  return here ? here : document_->findKept(key);
}

int WaypointsModel::pending(const edit::Key& key) const {
  return pendingOf(document_->state(key), document_->findKept(key), document_->find(key));
}

void WaypointsModel::onChanged(const edit::DocumentChange& change) {
  if (change.everything) return begin();
  std::vector<const edit::Key*> come, go;
  std::size_t others = 0;
  int first = int(rows_.size()), last = -1;
  for (const auto* keys : {&change.added, &change.changed, &change.removed}) {
    for (const edit::Key& key : *keys) {
      const auto known = row_of_.find(key);
      const bool belongs_here = belongs(key);
      if (known == row_of_.end()) {
        if (belongs_here) come.push_back(&key);
      } else if (!belongs_here) {
        go.push_back(&key);
      } else {
        ++others;
        first = std::min(first, known->second);
        last = std::max(last, known->second);
      }
    }
  }
  if (come.size() + go.size() > kManyRows) return begin();
  if (others > 1) {
    // One signal for all of them: told one by one, a sorted list would put each among others that are not
    // in their positions yet. Without unchanged columns, as one of these may be the sort column.
    using namespace edit::waypoint_field;
    const auto emitColumns = [&](edit::FieldMask field, int from, int to) {
      if (change.fields & field || !change.added.empty() || !change.removed.empty())
        Q_EMIT dataChanged(index(first, from), index(last, to));
    };
    Q_EMIT dataChanged(index(first, StateColumn), index(last, StateColumn));
    emitColumns(kName | kType, NameColumn, NameColumn);
    emitColumns(kPosition, XColumn, YColumn);
    emitColumns(kYaw, YawColumn, YawColumn);
    emitColumns(kTags, TagsColumn, TagsColumn);
  } else if (others > 0) {
    for (const auto* keys : {&change.added, &change.changed, &change.removed}) {
      for (const edit::Key& key : *keys) {
        const QModelIndex at = indexOf(key, 0);
        if (at.isValid() && belongs(key)) Q_EMIT dataChanged(at, at.siblingAtColumn(kColumns - 1));
      }
    }
  }
  for (const edit::Key* key : go) {
    const auto known = row_of_.find(*key);
    if (known == row_of_.end()) continue;
    const int row = known->second;
    beginRemoveRows({}, row, row);
    rows_.erase(rows_.begin() + row);
    row_of_.erase(known);
    number(std::size_t(row));
    endRemoveRows();
  }
  for (const edit::Key* key : come) {
    if (row_of_.contains(*key)) continue;
    beginInsertRows({}, int(rows_.size()), int(rows_.size()));
    rows_.push_back(*key);
    number(rows_.size() - 1);
    endInsertRows();
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
  const map::Waypoint* const point = this->point(at);
  if (!point) return {};
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return text(*point, column);
    case kSortRole:
      return sortValue(at, *point, column);
    case kPendingRole:
      return pending(at);
    case Qt::DecorationRole:
      if (column == NameColumn && document_->find(at) && !warningsOf(at).empty())
        return iconPixmap(QStringLiteral("problem"), kWaypointMarkPx, qApp->devicePixelRatio(),
                          appColors().warning);
      return column == StateColumn ? stateMark(document_->state(at), pending(at)) : QVariant();
    case Qt::AccessibleTextRole:
      if (column == NameColumn && document_->find(at) && !warningsOf(at).empty())
        return QString(shortWaypointName(*point, 120) + QLatin1Char('\n') +
                       sentences::sentencesOf(warningsOf(at)));
      return column == StateColumn ? pendingText(document_->state(at), pending(at)) : QVariant();
    case Qt::FontRole: {
      if (document_->find(at)) return {};
      QFont struck;  // the rest comes from the table
      struck.setStrikeOut(true);
      return struck;
    }
    case Qt::ForegroundRole:
      return document_->find(at) ? QVariant() : QVariant(appColors().secondary_text);
    case Qt::ToolTipRole: {
      QStringList lines{words::plainName(point->name)};
      if (!point->tags.empty()) lines << tr("Tags: %1").arg(tagsText(point->tags));
      const QString state = pendingText(document_->state(at), pending(at));
      if (!state.isEmpty()) lines << state;
      const map::Waypoint *const kept = document_->findKept(at), *const now = document_->find(at);
      if (kept && now && document_->state(at).unsaved) lines << changeText(*kept, *now);
      if (now && !warningsOf(at).empty()) lines << sentences::sentencesOf(warningsOf(at));
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
      const int flags = pending(key);
      return flags & kConflicting ? -1000 : -flags;
    }
    case XColumn:
      return point.position_m.x();
    case YColumn:
      return point.position_m.y();
    case YawColumn:
      return point.yaw_rad.value_or(10);
    case NameColumn:
      return QString::fromStdString(point.name.empty() ? point.id : point.name);
    default:
      return text(point, column);
  }
}

QVariant WaypointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section >= kColumns) return {};
  if (role == Qt::TextAlignmentRole && section >= XColumn && section <= YawColumn)
    return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const std::array<QString, kColumns> names{QString(), tr("Name"),  tr("x m"),
                                            tr("y m"), tr("yaw °"), tr("Tags")};
  return names.at(std::size_t(section)).isEmpty() ? QVariant() : names[std::size_t(section)];
}

WaypointFilter::WaypointFilter(QObject* parent) : SortedRows(parent) {}

void WaypointFilter::look(const QString& text) {
  wanted_ = text.trimmed();
  invalidateFilter();
}

void WaypointFilter::lookForPending(int flags) {
  pending_ = flags;
  invalidateFilter();
}

bool WaypointFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto at = [&](int column) { return sourceModel()->index(row, column, parent); };
  if (pending_ != 0 &&
      !(at(WaypointsModel::StateColumn).data(WaypointsModel::kPendingRole).toInt() & pending_))
    return false;
  if (wanted_.isEmpty()) return true;
  for (const int column : {WaypointsModel::NameColumn, WaypointsModel::TagsColumn}) {
    if (at(column).data().toString().contains(wanted_, Qt::CaseInsensitive)) return true;
  }
  return false;
}

SortedRows::SortValue WaypointFilter::sortValue(const QModelIndex& source) const {
  const QVariant value = source.data(WaypointsModel::kSortRole);
  if (value.typeId() == QMetaType::QString) return {.name = value.toString()};
  return {.number = value.toDouble()};
}

}  // namespace mapwright::ui

#include "moc_waypoints_model.cpp"
