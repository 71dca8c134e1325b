#include "ui/overlays/overlays_model.h"

#include <algorithm>
#include <utility>

#include <QFont>

#include "ui/kit/name_order.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/overlays/overlay_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

using State = overlays::EditingDocument::State;

OverlaysModel::OverlaysModel(OverlayEditing* editing, QObject* parent)
    : QAbstractTableModel(parent), editing_(editing) {
  connect(editing_, &OverlayEditing::changed, this, &OverlaysModel::take);
}

void OverlaysModel::setFlawed(std::set<FeatureKey> keys) {
  if (keys == flawed_) return;
  flawed_ = std::move(keys);
  if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

void OverlaysModel::take() {
  const auto& document = editing_->document();
  std::vector<FeatureKey> rows;
  for (FeatureKey key = 0; editing_->isOpen() && key < document.size(); ++key) {
    if (document.find(key) || document.state(key) == State::Deleted) rows.push_back(key);
  }
  conflicting_.clear();
  for (const auto& conflict : document.conflicts()) conflicting_.insert(conflict.first);
  if (rows == rows_) {
    if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

QModelIndex OverlaysModel::indexOf(FeatureKey key) const {
  const auto row = std::lower_bound(rows_.begin(), rows_.end(), key);
  return row == rows_.end() || *row != key ? QModelIndex() : index(int(row - rows_.begin()), NameColumn);
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

int OverlaysModel::bits(FeatureKey key) const {
  const auto& document = editing_->document();
  return (document.isUnsaved(key) ? kOverlayUnsaved : 0) |
         (document.changedThere().contains(key) ? kOverlayChangedThere : 0) |
         (conflicting_.contains(key) ? kOverlayInConflict : 0) | (flawed_.contains(key) ? kOverlayFlawed : 0);
}

QString OverlaysModel::stateText(FeatureKey key) const {
  if (conflicting_.contains(key)) return tr("conflict");
  switch (editing_->document().state(key)) {
    case State::New:
      return tr("new, unsaved");
    case State::Changed:
      return tr("changed, unsaved");
    case State::Deleted:
      return tr("deleted, unsaved");
    case State::Same:
      break;
  }
  return editing_->document().changedThere().contains(key) ? tr("changed on the robot") : tr("saved");
}

QVariant OverlaysModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const FeatureKey at = key(index);
  const Feature* const feature = shown(at);
  if (!feature) return {};
  const int column = index.column();
  switch (role) {
    case Qt::DisplayRole:
      return column == NameColumn   ? overlayName(*feature)
             : column == TypeColumn ? overlayKind(*feature)
                                    : stateText(at);
    case kBitsRole:
      return bits(at);
    case kNamelessRole:
      return column == NameColumn && feature->name().empty();
    case Qt::DecorationRole: {
      const int is = bits(at);
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
      const bool quiet = !editing_->document().find(at) || feature->name().empty() ||
                         (column == StateColumn && bits(at) % kOverlayFlawed == 0);
      return quiet && column != TypeColumn ? QVariant(appColors().secondary_text) : QVariant();
    }
    case Qt::ToolTipRole: {
      QStringList lines{overlayName(*feature), overlayKind(*feature)};
      if (!feature->id().empty()) lines << tr("Id %1").arg(words::plainName(feature->id()));
      lines << stateText(at);
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

OverlayFilter::OverlayFilter(QObject* parent) : QSortFilterProxyModel(parent), order_(nameOrder()) {}

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

bool OverlayFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  // Those without a name come last.
  const bool nameless = left.data(OverlaysModel::kNamelessRole).toBool(),
             other_nameless = right.data(OverlaysModel::kNamelessRole).toBool();
  if (nameless != other_nameless) return other_nameless;
  return order_.compare(left.data().toString(), right.data().toString()) < 0;
}

}  // namespace mapwright::window

#include "moc_overlays_model.cpp"
