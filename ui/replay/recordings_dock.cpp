#include "ui/replay/recordings_dock.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "sentences/plural.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/tree_view.h"

namespace mapwright::window {

RecordingsDock::RecordingsDock(QWidget* parent)
    : QDockWidget(tr("Recordings"), parent),
      model_(new BagsModel(this)),
      sorted_(new QSortFilterProxyModel(this)),
      search_(new QLineEdit(this)),
      refresh_(new QToolButton(this)),
      table_(new QuietTableView(this)),
      empty_(new QLabel(this)),
      summary_(new PlainLabel(this)),
      retry_(new QPushButton(tr("Retry"), this)),
      open_(new QPushButton(tr("Replay"), this)),
      download_(new QPushButton(tr("Download…"), this)),
      stop_(new QPushButton(tr("Stop"), this)),
      delete_(new QPushButton(tr("Delete…"), this)),
      record_(new QPushButton(tr("Record on the robot…"), this)) {
  setObjectName(QStringLiteral("recordings"));
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(BagsModel::kSortRole);
  sorted_->setFilterKeyColumn(BagsModel::NameColumn);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  search_->setPlaceholderText(tr("Search recordings"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search recordings"));
  search_->setMaximumWidth(260);
  refresh_->setIcon(themedIcon(QStringLiteral("retry")));
  refresh_->setIconSize({16, 16});
  refresh_->setAccessibleName(tr("Refresh the list of recordings"));
  refresh_->setToolTip(tr("Ask the robot for its recordings again"));
  showRows(*table_, sorted_, tr("Recordings"));
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  // The ends of names distinguish them.
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->installEventFilter(this);
  table_->setSortingEnabled(true);
  table_->sortByColumn(BagsModel::EndColumn, Qt::DescendingOrder);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setStretchLastSection(true);
  const auto wide = [this](const QString& sample) { return fontMetrics().horizontalAdvance(sample) + 24; };
  header->resizeSection(BagsModel::NameColumn, wide(QStringLiteral("2023-10-31_14-36-17.bag")));
  header->resizeSection(BagsModel::KindColumn, wide(QStringLiteral("recording")));
  header->resizeSection(BagsModel::SizeColumn, wide(QStringLiteral("000.0 MB")));
  header->resizeSection(BagsModel::DurationColumn, wide(QStringLiteral("00:00:00")));
  header->resizeSection(BagsModel::EndColumn, wide(QStringLiteral("2023-10-31 14:36:17")));
  layOut();

  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->setFilterFixedString(text.trimmed());
    refresh();
  });
  connect(refresh_, &QToolButton::clicked, this, &RecordingsDock::refreshWanted);
  connect(retry_, &QPushButton::clicked, this, &RecordingsDock::refreshWanted);
  connect(record_, &QPushButton::clicked, this, &RecordingsDock::recordWanted);
  const auto of_row = [this](QPushButton* button, void (RecordingsDock::*wish)(const robot::BagKey&)) {
    connect(button, &QPushButton::clicked, this, [this, wish] {
      if (const auto key = selected()) Q_EMIT(this->*wish)(*key);
    });
  };
  of_row(open_, &RecordingsDock::openWanted);
  of_row(download_, &RecordingsDock::downloadWanted);
  of_row(stop_, &RecordingsDock::stopWanted);
  of_row(delete_, &RecordingsDock::deleteWanted);
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const auto key = keyAt(index)) Q_EMIT openWanted(*key);
  });
  connect(table_, &QTableView::customContextMenuRequested, this, &RecordingsDock::showMenu);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &RecordingsDock::refreshButtons);
  connect(model_, &QAbstractItemModel::dataChanged, this, &RecordingsDock::refreshButtons);
  refresh();
}

RecordingsDock::~RecordingsDock() {
  // The table is destroyed later than the object it reports to.
  table_->selectionModel()->disconnect(this);
  model_->disconnect(this);
  table_->removeEventFilter(this);
}

void RecordingsDock::layOut() {
  for (QLabel* const label : {empty_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setContentsMargins(12, 8, 12, 8);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
  open_->setIcon(themedIcon(QStringLiteral("play")));
  download_->setIcon(themedIcon(QStringLiteral("download")));
  stop_->setIcon(themedIcon(QStringLiteral("close")));
  delete_->setIcon(themedIcon(QStringLiteral("trash")));
  record_->setIcon(themedIcon(QStringLiteral("recordings")));
  summary_->setSample(QStringLiteral("x"));
  summary_->setSecondary(true);
  summary_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* const body = new QWidget(this);
  auto* const row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(6);
  row->addWidget(search_, 1);
  row->addWidget(refresh_);
  row->addWidget(summary_, 1);
  for (QPushButton* const button : {retry_, open_, download_, stop_, delete_, record_}) {
    button->setObjectName(QStringLiteral("compact"));
    row->addWidget(button);
  }
  auto* const column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(row);
  column->addWidget(empty_, 1);
  column->addWidget(table_, 1);
  setWidget(body);
}

void RecordingsDock::setState(const RecordingsState& state) {
  state_ = state;
  refresh();
}

QString RecordingsDock::emptyText() const {
  if (!state_.connected) return tr("Connect to a robot to see its recordings.");
  if (!state_.why_not.isEmpty()) return state_.why_not;
  if (model_->rowCount() == 0) {
    if (state_.loading) return tr("Asking the robot…");
    if (!state_.error.isEmpty()) return state_.error;
    return state_.listed ? tr("The robot has no bags or recordings.")
                         : tr("The list appears as soon as the robot is connected.");
  }
  return sorted_->rowCount() == 0 ? tr("No recording matches the search.") : QString();
}

QString RecordingsDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }
QString RecordingsDock::summaryShown() const { return summary_->text(); }

void RecordingsDock::refresh() {
  const bool offered = state_.connected && state_.why_not.isEmpty();
  search_->setEnabled(offered);
  refresh_->setEnabled(offered && !state_.loading);
  empty_->setText(emptyText());
  empty_->setVisible(!empty_->text().isEmpty());
  table_->setVisible(empty_->text().isEmpty());
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
  const bool offered = state_.connected && state_.why_not.isEmpty();
  const QString why_not =
      state_.replaying ? tr("While a bag is replayed, nothing can be changed on the robot.") : QString();
  open_->setEnabled(key && !busy);
  download_->setEnabled(key && !busy);
  download_->setText(kind == BagNote::Kind::Stopped ? tr("Resume") : tr("Download…"));
  // One replaces the other: a row does not need both.
  const bool downloading = kind == BagNote::Kind::Downloading;
  stop_->setEnabled(downloading);
  stop_->setVisible(downloading);
  download_->setVisible(!downloading);
  delete_->setEnabled(key && !busy && !state_.replaying);
  delete_->setToolTip(why_not);
  record_->setEnabled(offered && state_.online && !state_.replaying);
  record_->setToolTip(state_.replaying            ? why_not
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
  const auto add = [&](QPushButton* button, auto wish) {
    QAction* const action = menu.addAction(button->icon(), button->text(), this, [this, key, wish] {
      Q_EMIT(this->*wish)(*key);
    });
    action->setEnabled(button->isEnabled());
  };
  add(open_, &RecordingsDock::openWanted);
  add(download_, &RecordingsDock::downloadWanted);
  if (stop_->isEnabled()) add(stop_, &RecordingsDock::stopWanted);
  menu.addSeparator();
  menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy name"), this, [this, key] {
    Q_EMIT copyWanted(bagCalled(*key), tr("Copied %1").arg(bagCalled(*key).left(80)));
  });
  if (const BagNote note = model_->note(*key); note.kind == BagNote::Kind::Failed)
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy the error"), this,
                   [this, note] { Q_EMIT copyWanted(note.text, tr("Copied %1").arg(note.text.left(80))); });
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

}  // namespace mapwright::window

#include "moc_recordings_dock.cpp"
