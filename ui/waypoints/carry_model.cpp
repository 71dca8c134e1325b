#include "ui/waypoints/carry_model.h"

#include <array>

#include <QLocale>

#include "carry/verdict_sentence.h"
#include "ui/kit/name_order.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/fixed.h"

namespace mapwright::window {
namespace {

Mark markOf(const CarryRow& row) {
  if (row.state != CarryRow::State::Open) return Mark::Neutral;
  if (carry::sound(row.carried.verdict)) return Mark::Good;
  return row.carried.verdict == carry::Verdict::NotSupported ? Mark::Warning : Mark::Bad;
}

QString becameText(const CarryRow& row) {
  switch (row.state) {
    case CarryRow::State::Carried:
      return CarryModel::tr("carried over");
    case CarryRow::State::There:
      return CarryModel::tr("on the new map already");
    case CarryRow::State::Open:
      return carry::verdictText(row.carried.verdict);
  }
  return {};
}

QString becameMeans(const CarryRow& row) {
  switch (row.state) {
    case CarryRow::State::Carried:
      return CarryModel::tr("It is a waypoint of the map on screen now.");
    case CarryRow::State::There:
      return CarryModel::tr("The map on screen has a waypoint of this name. It stays as it is there.");
    case CarryRow::State::Open:
      return carry::meaningOf(row.carried.verdict);
  }
  return {};
}

/// The worst first, what needs nothing last.
int rankOf(const CarryRow& row) {
  if (row.state == CarryRow::State::Carried) return 102;
  if (row.state == CarryRow::State::There) return 101;
  return carry::sound(row.carried.verdict) ? 100 - int(row.carried.verdict) : int(row.carried.verdict);
}

}  // namespace

QString carrySumText(const std::vector<CarryRow>& rows) {
  std::array<qint64, carry::kVerdicts> odd{};
  qint64 sound = 0, to_look_at = 0, there = 0, carried = 0;
  for (const CarryRow& row : rows) {
    sound += row.sound();
    there += row.state == CarryRow::State::There;
    carried += row.state == CarryRow::State::Carried;
    if (row.toLookAt()) ++to_look_at, ++odd[std::size_t(row.carried.verdict)];
  }
  QStringList reasons;
  for (int i = 0; i < carry::kVerdicts; ++i) {
    if (odd[std::size_t(i)] > 0)
      reasons << QStringLiteral("%1 %2").arg(countText(odd[std::size_t(i)]),
                                             carry::verdictText(carry::Verdict(i)));
  }
  QStringList parts{CarryModel::tr("%1 sound").arg(countText(sound))};
  if (to_look_at > 0)
    parts << CarryModel::tr("%1 to look at (%2)")
                 .arg(countText(to_look_at), reasons.join(QStringLiteral(", ")));
  if (there > 0) parts << CarryModel::tr("%1 on the new map already").arg(countText(there));
  if (carried > 0) parts << CarryModel::tr("%1 carried over").arg(countText(carried));
  return parts.join(QStringLiteral(", "));
}

void CarryModel::setRows(std::vector<CarryRow> rows) {
  if (rows.empty() && rows_.empty()) return;
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

void CarryModel::setThere(const edit::Items& items) {
  std::set<std::string> names;
  for (const auto& [key, point] : items) names.insert(point.name);
  bool differs = false;
  for (CarryRow& row : rows_) {
    const bool carried = !row.key.empty() && items.contains(row.key);
    const bool there = !row.point.name.empty() && names.contains(row.point.name);
    const auto state = carried ? CarryRow::State::Carried
                       : there ? CarryRow::State::There
                               : CarryRow::State::Open;
    differs = differs || state != row.state;
    row.state = state;
  }
  if (differs) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

QVariant CarryModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const CarryRow& row = rows_[std::size_t(index.row())];
  const bool number = index.column() == WallsOff, became = index.column() == Became;
  if (role == Qt::TextAlignmentRole) return int((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::ForegroundRole && became) return markTextColor(markOf(row), appColors());
  if (role == Qt::DecorationRole && became) return markPixmap(markOf(row));
  if (role == Qt::ToolTipRole) return plainToolTip(becameMeans(row));
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case Called:
      return shortWaypointName(row.point);
    case Became:
      return becameText(row);
    case WallsOff:
      return row.carried.local_residual_m ? words::fixed(*row.carried.local_residual_m, 2)
                                          : QStringLiteral("–");
  }
  return {};
}

QVariant CarryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section == WallsOff ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && section == WallsOff)
    return tr("How far the walls within 3 m are from where they should be");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case Called:
      return tr("Waypoint");
    case Became:
      return tr("Became");
    case WallsOff:
      return tr("Walls off (m)");
  }
  return {};
}

CarryFilter::CarryFilter(CarryModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), model_(model), order_(nameOrder()) {
  setSourceModel(&model);
}

void CarryFilter::show(Shown shown) {
  shown_ = shown;
  invalidateFilter();
}

bool CarryFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const CarryRow& one = model_.rows()[std::size_t(row)];
  return shown_ == Shown::All || (shown_ == Shown::Sound ? one.sound() : one.toLookAt());
}

bool CarryFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const CarryRow& a = model_.rows()[std::size_t(left.row())];
  const CarryRow& b = model_.rows()[std::size_t(right.row())];
  if (left.column() == CarryModel::Became) return rankOf(a) < rankOf(b);
  if (left.column() == CarryModel::WallsOff)
    return a.carried.local_residual_m.value_or(-1) < b.carried.local_residual_m.value_or(-1);
  return order_.compare(shortWaypointName(a.point), shortWaypointName(b.point)) < 0;
}

}  // namespace mapwright::window

#include "moc_carry_model.cpp"
