#include "ui/overlays/overlays_model.h"

#include <algorithm>
#include <utility>

#include <QFont>

#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/overlays/overlay_text.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using State = overlays::EditingDocument::State;

OverlaysModel::OverlaysModel(edit::OverlayEditing* editing, QObject* parent)
    : QAbstractTableModel(parent), editing_(editing) {
  connect(editing_, &edit::OverlayEditing::changed, this, &OverlaysModel::onEditingChanged);
}

void OverlaysModel::setFlawed(std::set<FeatureKey> keys) {
  if (keys == flawed_) return;
  flawed_ = std::move(keys);
  onEditingChanged();
}

OverlaysModel::Row OverlaysModel::rowOf(FeatureKey key, const Row* before) const {
  const Feature& feature = *shown(key);
  const State state = editing_->document().state(key);
  Row row{key, feature, {}, {}, state, false, bits(key, state)};
  // Features never change: it is the same text or another feature.
  if (before && &before->feature->text() == &feature.text()) {
    row.name = before->name;
    row.kind = before->kind;
    row.nameless = before->nameless;
  } else {
    row.name = overlayName(feature);
    row.kind = overlayKind(feature);
    row.nameless = feature.name().empty();
  }
  return row;
}

void OverlaysModel::onEditingChanged() {
  const auto& document = editing_->document();
  conflicting_.clear();
  for (const auto& conflict : document.conflicts()) conflicting_.insert(conflict.first);
  std::vector<Row> rows;
  rows.reserve(rows_.size());
  bool same_keys = true;
  std::vector<std::pair<int, int>> changed;  // rows, both included
  for (FeatureKey key = 0; editing_->isOpen() && key < document.size(); ++key) {
    if (!document.find(key) && document.state(key) != State::Deleted) continue;
    const std::size_t at = rows.size();
    const Row* const before = at < rows_.size() && rows_[at].key == key ? &rows_[at] : nullptr;
    same_keys = same_keys && before;
    rows.push_back(rowOf(key, before));
    const bool same = before && &before->feature->text() == &rows[at].feature->text() &&
                      before->bits == rows[at].bits && before->state == rows[at].state;
    if (same) continue;
    if (!changed.empty() && changed.back().second + 1 == int(at)) {
      changed.back().second = int(at);
    } else {
      changed.emplace_back(int(at), int(at));
    }
  }
  if (!same_keys || rows.size() != rows_.size()) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
    return;
  }
  rows_ = std::move(rows);
  // Each of them may be sorted in anew: of many, all at once is quicker.
  constexpr std::size_t kMostAlone = 100;
  if (changed.size() > kMostAlone) changed = {{changed.front().first, changed.back().second}};
  for (const auto& [first, last] : changed) Q_EMIT dataChanged(index(first, 0), index(last, kColumns - 1));
}

QModelIndex OverlaysModel::indexOf(FeatureKey key) const {
  const auto row = std::lower_bound(rows_.begin(), rows_.end(), key,
                                    [](const Row& each, FeatureKey wanted) { return each.key < wanted; });
  return row == rows_.end() || row->key != key ? QModelIndex() : index(int(row - rows_.begin()), NameColumn);
}

int OverlaysModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}
int OverlaysModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

const Feature* OverlaysModel::shown(FeatureKey key) const {
  const auto& now = editing_->document().find(key);
  const auto& was = editing_->document().findBase(key);
  return now ? &*now : was ? &*was : nullptr;
}

int OverlaysModel::bits(FeatureKey key, State state) const {
  return (state != State::Same ? kOverlayUnsaved : 0) |
         (editing_->document().changedThere().contains(key) ? kOverlayChangedThere : 0) |
         (conflicting_.contains(key) ? kOverlayInConflict : 0) | (flawed_.contains(key) ? kOverlayFlawed : 0);
}

QString OverlaysModel::stateText(const Row& row) const {
  if (row.bits & kOverlayInConflict) return tr("conflict");
  switch (row.state) {
    case State::New:
      return tr("new, unsaved");
    case State::Changed:
      return tr("changed, unsaved");
    case State::Deleted:
      return tr("deleted, unsaved");
    case State::Same:
      break;
  }
  if (!(row.bits & kOverlayChangedThere)) return tr("saved");
  return editing_->inFile() ? tr("changed in the file") : tr("changed on the robot");
}

QVariant OverlaysModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Row& row = rows_[std::size_t(index.row())];
  const FeatureKey at = row.key;
  const Feature* const feature = &*row.feature;
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return column == NameColumn ? row.name : column == TypeColumn ? row.kind : stateText(row);
    case kBitsRole:
      return row.bits;
    case kNamelessRole:
      return column == NameColumn && row.nameless;
    case Qt::DecorationRole: {
      const int is = row.bits;
      if (column == NameColumn) return is & kOverlayFlawed ? QVariant(markPixmap(Mark::Warning)) : QVariant();
      if (column != StateColumn) return {};
      const Mark mark = is & kOverlayInConflict     ? Mark::Bad
                        : is & kOverlayUnsaved      ? Mark::Busy
                        : is & kOverlayChangedThere ? Mark::Neutral
                                                    : Mark::None;
      return mark == Mark::None ? QVariant() : QVariant(markPixmap(mark));
    }
    case Qt::FontRole: {
      if (editing_->document().find(at)) return {};
      QFont struck;
      struck.setStrikeOut(true);
      return struck;
    }
    case Qt::ForegroundRole: {
      const bool quiet = !editing_->document().find(at) || row.nameless ||
                         (column == StateColumn && row.bits % kOverlayFlawed == 0);
      return quiet && column != TypeColumn ? QVariant(appColors().secondary_text) : QVariant();
    }
    case Qt::ToolTipRole: {
      QStringList lines{row.name, row.kind};
      if (!feature->id().empty()) lines << tr("Id %1").arg(words::plainName(feature->id()));
      lines << stateText(row);
      return plainToolTip(lines.join(QLatin1Char('\n')));
    }
    default:
      return {};
  }
}

QVariant OverlaysModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == NameColumn ? tr("Name") : section == TypeColumn ? tr("Type") : tr("State");
}

OverlayFilter::OverlayFilter(QObject* parent) : SortedRows(parent) {}

void OverlayFilter::look(const QString& text) {
  wanted_ = text.trimmed();
  invalidateFilter();
}

void OverlayFilter::lookForBits(int bits) {
  bits_ = bits;
  invalidateFilter();
}

bool OverlayFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex at = sourceModel()->index(row, OverlaysModel::NameColumn, parent);
  if (bits_ != 0 && !(at.data(OverlaysModel::kBitsRole).toInt() & bits_)) return false;
  if (wanted_.isEmpty()) return true;
  for (const int column : {OverlaysModel::NameColumn, OverlaysModel::TypeColumn}) {
    if (at.siblingAtColumn(column).data().toString().contains(wanted_, Qt::CaseInsensitive)) return true;
  }
  return at.data(Qt::ToolTipRole).toString().contains(wanted_, Qt::CaseInsensitive);
}

SortedRows::SortValue OverlayFilter::sortValue(const QModelIndex& source) const {
  // Those without a name come last.
  return {source.data(OverlaysModel::kNamelessRole).toBool() ? 1. : 0., source.data().toString()};
}

}  // namespace mapwright::ui

#include "moc_overlays_model.cpp"
