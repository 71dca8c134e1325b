#include "ui/replay/events_dock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
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
#include "ui/replay/timeline_events.h"

namespace mapwright::window {

EventsDock::EventsDock(ReplayClock& clock, QWidget* parent)
    : QDockWidget(tr("Events"), parent),
      clock_(clock),
      model_(new EventsModel(this)),
      table_(new QuietTableView(this)),
      search_(new QLineEdit(this)),
      group_(new QComboBox(this)),
      summary_(new PlainLabel(this)),
      empty_(new QLabel(this)),
      follow_(new QToolButton(this)),
      read_(new QPushButton(tr("Read the rest"), this)),
      retry_(new QPushButton(tr("Retry"), this)),
      save_(new QPushButton(tr("Save…"), this)) {
  setObjectName(QStringLiteral("events"));
  showRows(*table_, model_, tr("Events"));
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->installEventFilter(this);
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setStretchLastSection(true);
  const auto wide = [this](const QString& sample) {
    QFont bold = font();
    bold.setBold(true);
    return QFontMetrics(bold).horizontalAdvance(sample) + 24;
  };
  header->resizeSection(EventsModel::TimeColumn, wide(QStringLiteral("00:00:00.000")));
  header->resizeSection(
      EventsModel::SinceColumn,
      wide(model_->headerData(EventsModel::SinceColumn, Qt::Horizontal, Qt::DisplayRole).toString()));
  header->resizeSection(EventsModel::KindColumn, wide(kindName(replay::EventKind::EmergencyStopOn)) + 20);
  search_->setPlaceholderText(tr("Search events"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search events"));
  search_->setMaximumWidth(220);
  group_->addItem(tr("All kinds"));
  for (const replay::EventGroup group : replay::kEventGroups) group_->addItem(groupName(group), int(group));
  group_->setAccessibleName(tr("Kind of event"));
  group_->setToolTip(tr("Which kinds of events to list"));
  group_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  group_->setMinimumContentsLength(14);
  follow_->setIcon(themedIcon(QStringLiteral("follow")));
  follow_->setIconSize({16, 16});
  follow_->setCheckable(true);
  follow_->setChecked(true);
  follow_->setAutoRaise(true);
  follow_->setAccessibleName(tr("Follow the time"));
  follow_->setToolTip(tr("Scroll to the event at the current time"));
  read_->setToolTip(tr("Read to the end to find all events"));
  retry_->setToolTip(tr("Retry what could not be loaded"));
  save_->setToolTip(tr("Save the listed events as CSV"));
  layOut();

  connect(search_, &QLineEdit::textChanged, this, &EventsDock::takeFilter);
  connect(group_, &QComboBox::currentIndexChanged, this, &EventsDock::takeFilter);
  connect(table_, &QTableView::doubleClicked, this, &EventsDock::goTo);
  connect(table_, &QTableView::customContextMenuRequested, this, &EventsDock::showMenu);
  connect(follow_, &QToolButton::toggled, this, &EventsDock::scrollToPresent);
  connect(read_, &QPushButton::clicked, this, &EventsDock::readAllWanted);
  connect(retry_, &QPushButton::clicked, &clock_, &ReplayClock::retry);
  connect(save_, &QPushButton::clicked, this, &EventsDock::saveWanted);
  connect(&clock_, &ReplayClock::timeChanged, this, &EventsDock::takeTime);
  connect(&clock_, &ReplayClock::stateChanged, this, &EventsDock::takeState);
  connect(&clock_, &ReplayClock::closed, this, [this] { setEvents({}); });
  takeState();
}

EventsDock::~EventsDock() { table_->removeEventFilter(this); }

void EventsDock::layOut() {
  empty_->setTextFormat(Qt::PlainText);
  empty_->setWordWrap(true);
  empty_->setContentsMargins(12, 8, 12, 8);
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  retry_->setIcon(themedIcon(QStringLiteral("retry")));
  save_->setIcon(themedIcon(QStringLiteral("save")));
  summary_->setSample(QStringLiteral("x"));
  summary_->setSecondary(true);
  summary_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* const body = new QWidget(this);
  auto* const row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(6);
  row->addWidget(search_, 1);
  row->addWidget(group_);
  row->addWidget(follow_);
  row->addWidget(summary_, 2);
  for (QPushButton* const button : {read_, retry_, save_}) {
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

void EventsDock::setEvents(const std::vector<replay::Event>& events) {
  if (!isVisible()) {
    waiting_ = events;
    // Nothing of a closed bag stays.
    if (events.empty()) model_->setEvents({}, clock_.start());
    return;
  }
  waiting_.clear();
  const bool in_view = presentInView();
  model_->setEvents(events, clock_.start());
  takeState();
  takeTime();
  // Earlier events found later push it away.
  if (in_view) scrollToPresent();
}

void EventsDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  if (!waiting_.empty()) setEvents(std::exchange(waiting_, {}));
  takeState();
  takeTime();
  scrollToPresent();
}

void EventsDock::setReadsAll(bool all) {
  reads_all_ = all;
  takeState();
}

bool EventsDock::follows() const { return follow_->isChecked(); }
void EventsDock::setFollows(bool follows) { follow_->setChecked(follows); }
QString EventsDock::summaryShown() const { return summary_->text(); }
QString EventsDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }

QString EventsDock::summaryText() const {
  if (!clock_.isOpen()) return {};
  const int total = int(model_->total()), listed = model_->rowCount();
  QString found = sentences::counted(tr("%1 events", nullptr, total), total);
  if (listed < total) found = tr("%1 of %2").arg(QString::number(listed), found);
  const double share = clock_.readShare();
  if (share >= 1) return tr("%1: the whole bag has been read").arg(found);
  return tr("%1 found so far: %2 % of the bag has been read")
      .arg(found, QString::number(int(std::floor(share * 100))));
}

void EventsDock::takeState() {
  const replay::Reading* const reading = clock_.reading();
  const bool open = reading != nullptr;
  for (QWidget* const control :
       {static_cast<QWidget*>(search_), static_cast<QWidget*>(group_), static_cast<QWidget*>(follow_)})
    control->setEnabled(open);
  const bool missing = open && !reading->chunks().wholeRead();
  const bool failed =
      missing && std::any_of(reading->chunks().cells().begin(), reading->chunks().cells().end(),
                             [](const auto& cell) { return cell.second.state == replay::CellState::Failed; });
  read_->setVisible(missing && !reads_all_);
  retry_->setVisible(failed);
  save_->setEnabled(model_->rowCount() > 0);
  summary_->setText(summaryText());
  QString why;
  if (!open) {
    why = tr("The events of a bag are listed here while it is replayed.");
  } else if (model_->total() == 0) {
    why = missing ? tr("No events found so far.") : tr("This bag has no events.");
  } else if (model_->rowCount() == 0) {
    why = tr("No event matches the search.");
  }
  empty_->setText(why);
  empty_->setVisible(!why.isEmpty());
  table_->setVisible(why.isEmpty());
}

void EventsDock::takeFilter() {
  EventFilter filter;
  if (group_->currentIndex() > 0) filter.group = replay::EventGroup(group_->currentData().toInt());
  filter.text = search_->text().trimmed();
  model_->setFilter(filter);
  takeState();
  takeTime();
  scrollToPresent();
}

void EventsDock::takeTime() {
  if (!isVisible()) return;
  model_->setAt(clock_.isOpen() ? std::optional(clock_.at()) : std::nullopt);
  const replay::Event* const now = model_->event(model_->presentRow());
  // Scrolling away stops following until something happens.
  if (!now || now_ == *now) return;
  now_ = *now;
  scrollToPresent();
}

bool EventsDock::presentInView() const {
  const int row = model_->presentRow();
  return row >= 0 && table_->viewport()->rect().intersects(table_->visualRect(model_->index(row, 0)));
}

void EventsDock::scrollToPresent() {
  if (follow_->isChecked() && model_->presentRow() >= 0)
    table_->scrollTo(model_->index(model_->presentRow(), 0));
}

void EventsDock::goTo(const QModelIndex& index) {
  const replay::Event* const event = model_->event(index.row());
  if (index.isValid() && event) clock_.seek(event->at_s);
}

void EventsDock::copy() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return;
  const int count = int(rows.size());
  Q_EMIT copyWanted(model_->copied(rows), sentences::counted(tr("%1 events copied", nullptr, count), count));
}

void EventsDock::showMenu(const QPoint& at) {
  const QModelIndex index = table_->indexAt(at);
  if (!index.isValid()) return;
  QMenu menu(this);
  menu.addAction(themedIcon(QStringLiteral("goto")), tr("Go there"), this,
                 [this, row = QPersistentModelIndex(index)] { goTo(row); });
  QAction* const copied =
      menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy"), this, &EventsDock::copy);
  copied->setEnabled(table_->selectionModel()->hasSelection());
  menu.addAction(tr("Select all"), table_, &QTableView::selectAll);
  menu.exec(table_->viewport()->mapToGlobal(at));
}

bool EventsDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_ && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride)) {
    auto* const key = static_cast<QKeyEvent*>(event);
    const bool copies = key->matches(QKeySequence::Copy);
    const bool goes = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (event->type() == QEvent::ShortcutOverride) {
      if (copies) event->accept();
      return copies;
    }
    if (copies) copy();
    if (goes) goTo(table_->currentIndex());
    if (copies || goes) return true;
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_events_dock.cpp"
