#include "ui/replay/bags_model.h"

#include <algorithm>

#include <QColor>
#include <QCoreApplication>
#include <QGuiApplication>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_axis.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr int kNameLength = 200;

bool isFigure(int column) { return column == BagsModel::SizeColumn || column == BagsModel::DurationColumn; }

QString iconOf(BagNote::Kind kind) {
  switch (kind) {
    case BagNote::Kind::Failed:
      return QStringLiteral("error");
    case BagNote::Kind::Downloaded:
      return QStringLiteral("ok");
    case BagNote::Kind::Stopped:
      return QStringLiteral("waiting");
    case BagNote::Kind::None:
      return {};
    default:
      return QStringLiteral("fetching");
  }
}

QColor colorOf(BagNote::Kind kind, const UiColors& colors) {
  if (kind == BagNote::Kind::Failed) return colors.error_text;
  if (kind == BagNote::Kind::Downloaded) return colors.ok_text;
  return colors.secondary_text;
}

}  // namespace

QString kindWord(robot::BagKind kind) {
  switch (kind) {
    case robot::BagKind::Bag:
      return QCoreApplication::translate("window", "bag");
    case robot::BagKind::Recording:
      return QCoreApplication::translate("window", "recording");
    case robot::BagKind::File:
      break;
  }
  return QCoreApplication::translate("window", "file");
}

QString bagCalled(const robot::BagKey& key) { return plainWords(key.name, kNameLength); }

void BagsModel::setRows(std::vector<robot::BagEntry> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  std::erase_if(notes_, [&](const auto& note) {
    return std::none_of(rows_.begin(), rows_.end(), [&](const auto& row) { return row.key == note.first; });
  });
  endResetModel();
}

void BagsModel::clear() {
  notes_.clear();
  setRows({});
}

void BagsModel::setNote(const robot::BagKey& key, BagNote note) {
  if (note.kind == BagNote::Kind::None) {
    notes_.erase(key);
  } else {
    notes_[key] = std::move(note);
  }
  const QModelIndex first = indexOf(key);
  if (first.isValid()) Q_EMIT dataChanged(first, first.siblingAtColumn(kColumns - 1));
}

void BagsModel::setDuration(const robot::BagKey& key, double length_s) {
  durations_[key] = std::max(length_s, 0.0);
  const QModelIndex row = indexOf(key);
  if (row.isValid()) {
    const QModelIndex cell = row.siblingAtColumn(DurationColumn);
    Q_EMIT dataChanged(cell, cell);
  }
}

BagNote BagsModel::note(const robot::BagKey& key) const {
  const auto found = notes_.find(key);
  return found == notes_.end() ? BagNote{} : found->second;
}

const robot::BagEntry* BagsModel::entry(int row) const {
  return row >= 0 && row < int(rows_.size()) ? &rows_[std::size_t(row)] : nullptr;
}

QModelIndex BagsModel::indexOf(const robot::BagKey& key) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [&](const auto& row) { return row.key == key; });
  return found == rows_.end() ? QModelIndex() : index(int(found - rows_.begin()), 0);
}

QString BagsModel::text(const robot::BagEntry& entry, int column) const {
  switch (column) {
    case NameColumn:
      return bagCalled(entry.key);
    case KindColumn:
      return kindWord(entry.key.kind);
    case SizeColumn:
      return entry.size_bytes ? bytesText(*entry.size_bytes) : plainWords(entry.size_text, 20);
    case DurationColumn: {
      const auto known = durations_.find(entry.key);
      // Robots give whole seconds.
      return known == durations_.end() ? QStringLiteral("—") : elapsedText(known->second).chopped(2);
    }
    case EndColumn:
      return entry.end_s ? QStringLiteral("%1 %2").arg(dayText(*entry.end_s), clockText(*entry.end_s, 0))
                         : plainWords(entry.end_text, 40);
    case NoteColumn:
      return note(entry.key).text;
    default:
      return {};
  }
}

QVariant BagsModel::sortValue(const robot::BagEntry& entry, int column) const {
  if (column == SizeColumn) return qint64(entry.size_bytes.value_or(-1));
  if (column == DurationColumn) {
    const auto known = durations_.find(entry.key);
    return known == durations_.end() ? -1 : known->second;
  }
  if (column == EndColumn) return entry.end_s.value_or(-1);
  return text(entry, column);
}

QVariant BagsModel::data(const QModelIndex& index, int role) const {
  const robot::BagEntry* const entry = index.isValid() ? this->entry(index.row()) : nullptr;
  if (!entry) return {};
  const bool of_note = index.column() == NoteColumn;
  const BagNote::Kind kind = of_note ? note(entry->key).kind : BagNote::Kind::None;
  switch (role) {
    case Qt::DisplayRole:
      return text(*entry, index.column());
    case kSortRole:
      return sortValue(*entry, index.column());
    case Qt::ToolTipRole:
      if (index.column() == DurationColumn && !durations_.contains(entry->key))
        return tr("The robot reports the length when the bag is opened.");
      return plainToolTip(text(*entry, index.column()));
    case Qt::TextAlignmentRole:
      return int(isFigure(index.column()) ? Qt::AlignRight | Qt::AlignVCenter
                                          : Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      return kind == BagNote::Kind::None ? QVariant() : QVariant(colorOf(kind, appColors()));
    case Qt::DecorationRole:
      return kind == BagNote::Kind::None ? QVariant()
                                         : QVariant(iconPixmap(iconOf(kind), 16, qApp->devicePixelRatio(),
                                                               colorOf(kind, appColors())));
    default:
      return {};
  }
}

QVariant BagsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int(isFigure(section) ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case NameColumn:
      return tr("Name");
    case KindColumn:
      return tr("Kind");
    case SizeColumn:
      return tr("Size");
    case DurationColumn:
      return tr("Duration");
    case EndColumn:
      return tr("Ended (UTC)");
    case NoteColumn:
      return tr("State");
    default:
      return {};
  }
}

}  // namespace mapwright::window

#include "moc_bags_model.cpp"
