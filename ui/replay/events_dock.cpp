#include "ui/replay/events_dock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QFont>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "replay/event_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/icons.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/replay/timeline_axis.h"
#include "ui/replay/timeline_events.h"

namespace mapwright::ui {

using replay::Event;

namespace {

// As with steps from event to event: the one just reached counts as past.
constexpr double kHairS = 1e-6;
constexpr int kMarkPx = 14;

std::string quotedField(const QString& text) {
  QString quoted = text;
  quoted.replace(QLatin1Char('"'), QStringLiteral("\"\""));
  return '"' + quoted.toStdString() + '"';
}

}  // namespace

bool EventsModel::passes(const Event& event) const {
  if (filter_.group && replay::groupOf(event.kind) != *filter_.group) return false;
  return filter_.text.isEmpty() || replay::eventText(event).contains(filter_.text, Qt::CaseInsensitive) ||
         kindName(event.kind).contains(filter_.text, Qt::CaseInsensitive);
}

std::vector<std::uint32_t> EventsModel::passing(const std::vector<Event>& events) const {
  std::vector<std::uint32_t> rows;
  rows.reserve(events.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (passes(events[i])) rows.push_back(std::uint32_t(i));
  }
  return rows;
}

void EventsModel::setEvents(std::vector<Event> events, double start_s) {
  const bool moved = std::exchange(start_s_, start_s) != start_s;
  if (events != events_) replaceEvents(std::move(events));
  if (moved && !rows_.empty())
    Q_EMIT dataChanged(index(0, SinceColumn), index(int(rows_.size()) - 1, SinceColumn));
  onPresent();
}

void EventsModel::setFilter(const EventFilter& filter) {
  if (filter == filter_) return;
  filter_ = filter;
  replaceEvents(events_);
  onPresent();
}

void EventsModel::replaceEvents(std::vector<Event> events) {
  std::vector<std::uint32_t> rows = passing(events);
  const std::size_t least = std::min(rows.size(), rows_.size());
  std::size_t same = 0, same_after = 0;
  while (same < least && events[rows[same]] == events_[rows_[same]]) ++same;
  while (same_after < least - same &&
         events[rows[rows.size() - 1 - same_after]] == events_[rows_[rows_.size() - 1 - same_after]])
    ++same_after;
  present_ = -1;  // onPresent() tells anew
  if (const std::size_t gone = rows_.size() - same - same_after; gone > 0) {
    beginRemoveRows({}, int(same), int(same + gone) - 1);
    rows_.erase(rows_.begin() + std::ptrdiff_t(same), rows_.begin() + std::ptrdiff_t(same + gone));
    endRemoveRows();
  }
  const std::size_t come = rows.size() - same - same_after;
  if (come > 0) beginInsertRows({}, int(same), int(same + come) - 1);
  events_ = std::move(events);
  rows_ = std::move(rows);
  if (come > 0) endInsertRows();
}

void EventsModel::setAt(std::optional<double> at_s) {
  at_s_ = at_s;
  onPresent();
}

void EventsModel::onPresent() {
  int now = -1;
  if (at_s_) {
    const auto after = std::partition_point(rows_.begin(), rows_.end(), [&](std::uint32_t index) {
      return events_[index].at_s <= *at_s_ + kHairS;
    });
    now = int(after - rows_.begin()) - 1;
  }
  const int before = std::exchange(present_, now);
  if (before == now) return;
  for (const int row : {before, now}) {
    if (row >= 0 && row < int(rows_.size())) Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1));
  }
}

const Event* EventsModel::event(int row) const {
  return row >= 0 && row < int(rows_.size()) ? &events_[at(row)] : nullptr;
}

int EventsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}

QString EventsModel::text(const Event& event, int column) const {
  switch (column) {
    case TimeColumn:
      return clockText(event.at_s);
    case SinceColumn:
      return elapsedText(event.at_s - start_s_);
    case KindColumn:
      return kindName(event.kind);
    default:
      return replay::eventText(event);
  }
}

QVariant EventsModel::data(const QModelIndex& index, int role) const {
  const Event* const event = index.isValid() ? this->event(index.row()) : nullptr;
  if (!event) return {};
  const bool present = index.row() == present_;
  switch (role) {
    case Qt::DisplayRole:
      return text(*event, index.column());
    case Qt::ToolTipRole:
      return plainToolTip(QStringLiteral("%1 %2\n%3")
                              .arg(dayText(event->at_s), clockText(event->at_s), replay::eventText(*event)));
    case Qt::TextAlignmentRole:
      return int((index.column() == SinceColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::DecorationRole:
      if (index.column() != KindColumn) return {};
      return eventMarkPixmap(markOf(*event), kMarkPx, qApp->devicePixelRatio());
    case Qt::FontRole: {
      if (!present) return {};
      QFont font = QGuiApplication::font();
      font.setBold(true);
      return font;
    }
    case Qt::BackgroundRole: {
      if (!present) return {};
      QColor color = appColors().accent;
      color.setAlpha(48);
      return color;
    }
    default:
      return {};
  }
}

QVariant EventsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section == SinceColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  const QStringList names{tr("Time (UTC)"), tr("Since start"), tr("Kind"), tr("Event")};
  return role == Qt::DisplayRole ? names.value(section) : QVariant();
}

QString EventsModel::copied(const QModelIndexList& rows) const {
  std::vector<int> numbers;
  for (const QModelIndex& index : rows) numbers.push_back(index.row());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  QString lines;
  for (const int row : numbers) {
    const Event* const event = this->event(row);
    if (!event) continue;
    lines += QStringLiteral("%1 %2").arg(dayText(event->at_s), text(*event, TimeColumn));
    for (const int column : {SinceColumn, KindColumn, TextColumn})
      lines += QLatin1Char('\t') + text(*event, column);
    lines += QLatin1Char('\n');
  }
  return lines;
}

std::string EventsModel::csv() const {
  std::string csv = "stamp_s,time_utc,since_start_s,kind,event\r\n";
  for (const std::uint32_t index : rows_) {
    const Event& event = events_[index];
    csv += QByteArray::number(event.at_s, 'f', 6).toStdString() + ',' + dayText(event.at_s).toStdString() +
           'T' + clockText(event.at_s).toStdString() + "Z," +
           QByteArray::number(event.at_s - start_s_, 'f', 3).toStdString() + ',' +
           quotedField(kindName(event.kind)) + ',' + quotedField(replay::eventText(event)) + "\r\n";
  }
  return csv;
}

EventsDock::EventsDock(ReplayClock& clock, QWidget* parent)
    : ListDock(tr("Events"), tr("Search events"), parent),
      clock_(clock),
      model_(new EventsModel(this)),
      group_(new QComboBox(this)),
      follow_(new QToolButton(this)),
      read_(new QPushButton(tr("Read the rest"), this)),
      retry_(new QPushButton(tr("Retry"), this)),
      save_(new QPushButton(tr("Save…"), this)) {
  setObjectName(QStringLiteral("events"));
  group_->addItem(tr("All kinds"));
  for (const replay::EventGroup group : replay::kEventGroups) group_->addItem(groupName(group), int(group));
  group_->setAccessibleName(tr("Kind of event"));
  group_->setToolTip(tr("Which kinds of events to list"));
  group_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  group_->setMinimumContentsLength(14);
  layOut(model_, {group_, follow_}, 2, {read_, retry_, save_});
  setTabOrder(table_, search_);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  QHeaderView* const header = table_->horizontalHeader();
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
  new NameColumn(table_, header, EventsModel::TextColumn,
                 {{EventsModel::SinceColumn},
                  {EventsModel::KindColumn, 90},
                  {EventsModel::TimeColumn, header->sectionSize(EventsModel::TimeColumn)}});
  search_->setMaximumWidth(220);
  follow_->setIcon(themedIcon(QStringLiteral("follow")));
  follow_->setIconSize({16, 16});
  follow_->setCheckable(true);
  follow_->setChecked(true);
  follow_->setAutoRaise(true);
  follow_->setAccessibleName(tr("Follow the time"));
  follow_->setToolTip(tr("Scroll to the event at the current time"));
  read_->setToolTip(tr("Read to the end to find all events"));
  retry_->setIcon(themedIcon(QStringLiteral("retry")));
  retry_->setToolTip(tr("Retry what could not be loaded"));
  save_->setIcon(themedIcon(QStringLiteral("save")));
  save_->setToolTip(tr("Save the listed events as CSV"));

  connect(search_, &QLineEdit::textChanged, this, &EventsDock::applyFilter);
  connect(group_, &QComboBox::currentIndexChanged, this, &EventsDock::applyFilter);
  connect(table_, &QTableView::doubleClicked, this, &EventsDock::goTo);
  connect(follow_, &QToolButton::toggled, this, &EventsDock::scrollToPresent);
  connect(read_, &QPushButton::clicked, this, &EventsDock::readAllWanted);
  connect(retry_, &QPushButton::clicked, &clock_, &ReplayClock::retry);
  connect(save_, &QPushButton::clicked, this, &EventsDock::saveWanted);
  connect(&clock_, &ReplayClock::timeChanged, this, &EventsDock::onTime);
  connect(&clock_, &ReplayClock::stateChanged, this, &EventsDock::onState);
  connect(&clock_, &ReplayClock::closed, this, [this] { setEvents({}); });
  onState();
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
  onState();
  onTime();
  // Earlier events found later push it away.
  if (in_view) scrollToPresent();
}

void EventsDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  if (!waiting_.empty()) setEvents(std::exchange(waiting_, {}));
  onState();
  onTime();
  scrollToPresent();
}

void EventsDock::setReadsAll(bool all) {
  reads_all_ = all;
  onState();
}

bool EventsDock::follows() const { return follow_->isChecked(); }
void EventsDock::setFollows(bool follows) { follow_->setChecked(follows); }

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

void EventsDock::onState() {
  const replay::Reading* const reading = clock_.reading();
  const bool open = reading != nullptr;
  for (QWidget* const control : std::initializer_list<QWidget*>{search_, group_, follow_})
    control->setEnabled(open);
  const bool missing = open && !reading->chunks().wholeRead();
  read_->setVisible(missing && !reads_all_);
  retry_->setVisible(missing && reading->chunks().anyFailed());
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
  showInstead(why);
}

void EventsDock::applyFilter() {
  EventFilter filter;
  if (group_->currentIndex() > 0) filter.group = replay::EventGroup(group_->currentData().toInt());
  filter.text = search_->text().trimmed();
  model_->setFilter(filter);
  onState();
  onTime();
  scrollToPresent();
}

void EventsDock::onTime() {
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

}  // namespace mapwright::ui

#include "moc_events_dock.cpp"
