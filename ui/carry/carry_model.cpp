#include "ui/carry/carry_model.h"

#include <array>
#include <utility>

#include <QLocale>

#include "carry/verdict_sentence.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "words/fixed.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

constexpr int kMostNamed = 5;  // of those that go together

Mark markOf(const CarryRow& row) {
  if (row.state != CarryRow::State::Open) return Mark::Neutral;
  if (carry::sound(row.carried.verdict)) return Mark::Good;
  return row.carried.verdict == carry::Verdict::NotSupported ? Mark::Warning : Mark::Bad;
}

QString becameText(const CarryRow& row) {
  switch (row.state) {
    case CarryRow::State::LeftOut:
    case CarryRow::State::OtherThere:
      return CarryModel::tr("left out");
    case CarryRow::State::Carried:
      return CarryModel::tr("carried over");
    case CarryRow::State::There:
      return CarryModel::tr("there already");
    case CarryRow::State::Open:
      return carry::verdictText(row.carried.verdict);
  }
  return {};
}

/// The worst first, what needs nothing last.
int rankOf(const CarryRow& row) {
  if (row.state != CarryRow::State::Open) return 100 + int(row.state);
  return carry::sound(row.carried.verdict) ? 100 - int(row.carried.verdict) : int(row.carried.verdict);
}

}  // namespace

CarryModel::CarryModel(const CarryWords& words, QObject* parent)
    : QAbstractTableModel(parent), words_(words) {}

QString carrySumText(const std::vector<CarryRow>& rows) {
  std::array<qint64, carry::kVerdicts> odd{};
  qint64 sound = 0, to_look_at = 0, there = 0, carried = 0, left_out = 0;
  for (const CarryRow& row : rows) {
    sound += row.sound();
    there += row.state == CarryRow::State::There;
    carried += row.state == CarryRow::State::Carried;
    left_out += row.state == CarryRow::State::LeftOut || row.state == CarryRow::State::OtherThere;
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
    parts << CarryModel::tr("%1 to look at (%2)").arg(countText(to_look_at), words::listed(reasons));
  if (there > 0) parts << CarryModel::tr("%1 on the new map already").arg(countText(there));
  if (left_out > 0) parts << CarryModel::tr("%1 left out").arg(countText(left_out));
  if (carried > 0) parts << CarryModel::tr("%1 carried over").arg(countText(carried));
  return words::listed(parts);
}

void CarryModel::setRows(std::vector<CarryRow> rows) {
  if (rows.empty() && rows_.empty()) return;
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

void CarryModel::setStates(const std::vector<CarryRow::State>& states) {
  int first = -1, last = -1;
  for (std::size_t i = 0; i < rows_.size() && i < states.size(); ++i) {
    if (std::exchange(rows_[i].state, states[i]) == states[i]) continue;
    if (first < 0) first = int(i);
    last = int(i);
  }
  if (first >= 0) Q_EMIT dataChanged(index(first, 0), index(last, kColumns - 1));
}

QString CarryModel::meansText(const CarryRow& row) const {
  QString means;
  switch (row.state) {
    case CarryRow::State::Carried:
      means = words_.carried;
      break;
    case CarryRow::State::There:
      means = words_.there;
      break;
    case CarryRow::State::OtherThere:
      means = tr("One that belongs to it is on the map on screen already, and stays as it is there.");
      break;
    case CarryRow::State::LeftOut:
      means = tr("You left it out. As found: %1").arg(carry::meaningOf(row.carried.verdict));
      break;
    case CarryRow::State::Open:
      means = carry::meaningOf(row.carried.verdict);
      break;
  }
  if (row.with.empty()) return means;
  QStringList names;
  for (const int other : row.with) {
    if (names.size() == kMostNamed) {
      names << QStringLiteral("…");
      break;
    }
    names << rows_[std::size_t(other)].name;
  }
  return means + QLatin1Char(' ') + tr("It goes together with %1.").arg(words::listed(names));
}

QVariant CarryModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const CarryRow& row = rows_[std::size_t(index.row())];
  const bool number = index.column() == WallsOff, became = index.column() == Became;
  if (role == Qt::TextAlignmentRole) return int((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::ForegroundRole && became) return markTextColor(markOf(row), appColors());
  if (role == Qt::DecorationRole && became) return markPixmap(markOf(row));
  if (role == Qt::ToolTipRole) {
    const QString means = meansText(row);
    // The name may be cut.
    return plainToolTip(index.column() == Called ? QStringLiteral("%1\n%2").arg(row.name, means) : means);
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case Called:
      return row.name;
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
      return words_.one;
    case Became:
      return tr("Became");
    case WallsOff:
      return tr("Off (m)");
  }
  return {};
}

CarryFilter::CarryFilter(CarryModel& model, QObject* parent) : SortedRows(parent), model_(model) {
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

SortedRows::SortValue CarryFilter::sortValue(const QModelIndex& source) const {
  const CarryRow& row = model_.rows()[std::size_t(source.row())];
  if (source.column() == CarryModel::Became) return {.number = double(rankOf(row))};
  if (source.column() == CarryModel::WallsOff) return {.number = row.carried.local_residual_m.value_or(-1)};
  return {.name = row.name};
}

}  // namespace mapwright::ui

#include "moc_carry_model.cpp"
