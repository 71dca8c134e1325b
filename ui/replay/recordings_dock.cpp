#include "ui/replay/recordings_dock.h"

#include <algorithm>

#include <QColor>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "sentences/plural.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_axis.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

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
      return int((isFigure(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
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
    return int((isFigure(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  const QStringList names{tr("Name"), tr("Kind"), tr("Size"), tr("Duration"), tr("Ended (UTC)"), tr("State")};
  return role == Qt::DisplayRole ? names.value(section) : QVariant();
}

RecordingsDock::RecordingsDock(QWidget* parent)
    : ListDock(tr("Recordings"), tr("Search recordings"), parent),
      model_(new BagsModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      refresh_(new QToolButton(this)),
      retry_(new QPushButton(tr("Retry"), this)),
      open_(new QPushButton(themedIcon(QStringLiteral("play")), tr("Replay"), this)),
      rehearse_(new QPushButton(themedIcon(QStringLiteral("layers")), tr("Rehearse"), this)),
      download_(new QPushButton(themedIcon(QStringLiteral("download")), tr("Download…"), this)),
      stop_(new QPushButton(themedIcon(QStringLiteral("close")), tr("Stop"), this)),
      delete_(new QPushButton(themedIcon(QStringLiteral("trash")), tr("Delete…"), this)),
      record_(new QPushButton(themedIcon(QStringLiteral("recordings")), tr("Record on the robot…"), this)) {
  setObjectName(QStringLiteral("recordings"));
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(BagsModel::kSortRole);
  sorted_->setFilterKeyColumn(BagsModel::NameColumn);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  layOut(sorted_, {refresh_}, 1, {retry_, open_, rehearse_, download_, stop_, delete_, record_});
  setTabOrder(search_, refresh_);
  search_->setMaximumWidth(260);
  refresh_->setIcon(themedIcon(QStringLiteral("retry")));
  refresh_->setIconSize({16, 16});
  refresh_->setAccessibleName(tr("Refresh the list of recordings"));
  rehearse_->setToolTip(tr("Find out what its way crosses on the map on screen"));
  refresh_->setToolTip(tr("Ask the robot for its recordings again"));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  // The ends of names distinguish them.
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setSortingEnabled(true);
  table_->sortByColumn(BagsModel::EndColumn, Qt::DescendingOrder);
  QHeaderView* const header = table_->horizontalHeader();
  const auto wide = [this](const QString& sample) { return fontMetrics().horizontalAdvance(sample) + 24; };
  header->resizeSection(BagsModel::KindColumn, wide(QStringLiteral("recording")));
  header->resizeSection(BagsModel::SizeColumn, wide(QStringLiteral("000.0 MB")));
  header->resizeSection(BagsModel::DurationColumn, wide(QStringLiteral("00:00:00")));
  header->resizeSection(BagsModel::EndColumn, wide(QStringLiteral("2023-10-31 14:36:17")));
  new NameColumn(table_, header, BagsModel::NameColumn,
                 {{BagsModel::KindColumn},
                  {BagsModel::DurationColumn},
                  {BagsModel::SizeColumn},
                  {BagsModel::EndColumn},
                  {BagsModel::NoteColumn, 60}});

  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->setFilterFixedString(text.trimmed());
    refresh();
  });
  connect(refresh_, &QToolButton::clicked, this, &RecordingsDock::refreshWanted);
  connect(retry_, &QPushButton::clicked, this, &RecordingsDock::refreshWanted);
  connect(record_, &QPushButton::clicked, this, &RecordingsDock::recordWanted);
  const auto of_row = [this](QPushButton* button, void (RecordingsDock::*wanted)(const robot::BagKey&)) {
    connect(button, &QPushButton::clicked, this, [this, wanted] {
      if (const auto key = selected()) Q_EMIT(this->*wanted)(*key);
    });
  };
  of_row(open_, &RecordingsDock::openWanted);
  of_row(rehearse_, &RecordingsDock::rehearseWanted);
  of_row(download_, &RecordingsDock::downloadWanted);
  of_row(stop_, &RecordingsDock::stopWanted);
  of_row(delete_, &RecordingsDock::deleteWanted);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const auto key = keyAt(index)) Q_EMIT openWanted(*key);
  });
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &RecordingsDock::refreshButtons);
  connect(model_, &QAbstractItemModel::dataChanged, this, &RecordingsDock::refreshButtons);
  refresh();
}

RecordingsDock::~RecordingsDock() {
  // The table is destroyed later than the object it reports to.
  table_->selectionModel()->disconnect(this);
  model_->disconnect(this);
}

void RecordingsDock::setState(const RecordingsState& state) {
  state_ = state;
  refresh();
}

QString RecordingsDock::emptyText() const {
  if (!state_.connected) return tr("Connect to a robot to see its recordings.");
  if (!state_.unavailable_reason.isEmpty()) return state_.unavailable_reason;
  if (model_->rowCount() == 0) {
    if (state_.loading) return tr("Asking the robot…");
    if (!state_.error.isEmpty()) return state_.error;
    return state_.listed ? tr("The robot has no bags or recordings.")
                         : tr("The list appears as soon as the robot is connected.");
  }
  return sorted_->rowCount() == 0 ? tr("No recording matches the search.") : QString();
}

void RecordingsDock::refresh() {
  const bool offered = state_.connected && state_.unavailable_reason.isEmpty();
  search_->setEnabled(offered);
  refresh_->setEnabled(offered && !state_.loading);
  showInstead(emptyText());
  retry_->setVisible(offered && !state_.error.isEmpty() && !state_.loading);
  QString text;
  const int rows = model_->rowCount();
  if (offered && state_.loading) {
    text = tr("asking the robot…");
  } else if (offered && !state_.error.isEmpty()) {
    text = state_.error;
  } else if (offered && rows > 0) {
    const int found = sorted_->rowCount();
    text = sentences::counted(tr("%1 recordings", nullptr, rows), rows);
    if (found < rows) text = tr("%1 of %2").arg(QString::number(found), text);
  }
  summary_->setText(text);
  refreshButtons();
}

void RecordingsDock::refreshButtons() {
  const auto key = selected();
  const BagNote::Kind kind = key ? model_->note(*key).kind : BagNote::Kind::None;
  const bool busy =
      kind == BagNote::Kind::Downloading || kind == BagNote::Kind::Opening || kind == BagNote::Kind::Deleting;
  const bool offered = state_.connected && state_.unavailable_reason.isEmpty();
  const QString unavailable_reason =
      state_.replaying ? tr("While a bag is replayed, nothing can be changed on the robot.") : QString();
  open_->setEnabled(key && !busy);
  rehearse_->setEnabled(key.has_value());
  download_->setEnabled(key && !busy);
  download_->setText(kind == BagNote::Kind::Stopped ? tr("Resume") : tr("Download…"));
  // One replaces the other: a row does not need both.
  const bool downloading = kind == BagNote::Kind::Downloading;
  stop_->setEnabled(downloading);
  stop_->setVisible(downloading);
  download_->setVisible(!downloading);
  delete_->setEnabled(key && !busy && !state_.replaying);
  delete_->setToolTip(unavailable_reason);
  record_->setEnabled(offered && state_.online && !state_.replaying);
  record_->setToolTip(state_.replaying            ? unavailable_reason
                      : offered && !state_.online ? tr("The robot cannot be reached at the moment.")
                                                  : tr("Make the robot record a bag"));
}

std::optional<robot::BagKey> RecordingsDock::keyAt(const QModelIndex& index) const {
  const robot::BagEntry* const entry = model_->entry(sorted_->mapToSource(index).row());
  return entry ? std::optional(entry->key) : std::nullopt;
}

std::optional<robot::BagKey> RecordingsDock::selected() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? std::nullopt : keyAt(rows.front());
}

void RecordingsDock::select(const robot::BagKey& key) {
  const QModelIndex index = sorted_->mapFromSource(model_->indexOf(key));
  if (index.isValid()) table_->setCurrentIndex(index);
}

void RecordingsDock::showMenu(const QPoint& at) {
  const auto key = keyAt(table_->indexAt(at));
  if (!key) return;
  QMenu menu(this);
  const auto add = [&](QPushButton* button, auto wanted) {
    QAction* const action = menu.addAction(button->icon(), button->text(), this, [this, key, wanted] {
      Q_EMIT(this->*wanted)(*key);
    });
    action->setEnabled(button->isEnabled());
  };
  add(open_, &RecordingsDock::openWanted);
  add(rehearse_, &RecordingsDock::rehearseWanted);
  add(download_, &RecordingsDock::downloadWanted);
  if (stop_->isEnabled()) add(stop_, &RecordingsDock::stopWanted);
  menu.addSeparator();
  menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy name"), this, [this, key] {
    Q_EMIT copyWanted(QString::fromStdString(key->name),
                      tr("Copied %1").arg(plainWords(bagCalled(*key), 80)));
  });
  if (const BagNote note = model_->note(*key); note.kind == BagNote::Kind::Failed)
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy the error"), this, [this, note] {
      Q_EMIT copyWanted(note.text, tr("Copied %1").arg(plainWords(note.text, 80)));
    });
  menu.addSeparator();
  add(delete_, &RecordingsDock::deleteWanted);
  menu.exec(table_->viewport()->mapToGlobal(at));
}

bool RecordingsDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const auto chosen = selected();
    if (chosen && open_->isEnabled() && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
      Q_EMIT openWanted(*chosen);
      return true;
    }
    if (chosen && delete_->isEnabled() && key == Qt::Key_Delete) {
      Q_EMIT deleteWanted(*chosen);
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_recordings_dock.cpp"
