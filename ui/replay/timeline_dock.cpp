#include "ui/replay/timeline_dock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QToolTip>

#include "excerpt/time_typed.h"
#include "sentences/failure_sentence.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/kit/wrapping_row.h"
#include "ui/shell/window_status_bar.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using replay::Knowledge;

namespace {

constexpr int kStatePx = 150;
constexpr std::array kSpeeds{20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.1, -0.1, -0.5, -1.0, -2.0, -5.0, -20.0};
// The events of a long bag are not collected again for each range read.
constexpr int kContentEveryMs = 150;

TimelineRange rangeOf(const replay::Cell& cell) {
  TimelineRange range;
  range.from_s = replay::secondsOf(cell.from);
  range.until_s = replay::secondsOf(cell.until);
  if (cell.state == replay::CellState::Failed) {
    range.state = RangeState::Failed;
    range.why = words::plainName(sentences::sentenceOf(cell.failure));
  } else if (cell.state == replay::CellState::Read) {
    range.state = cell.held ? RangeState::Held : RangeState::Read;
  } else if (cell.in_progress) {
    range.state = RangeState::InProgress;
  }
  return range;
}

}  // namespace

TimelineDock::TimelineDock(ReplayClock& clock, QWidget* parent)
    : QDockWidget(tr("Timeline"), parent), clock_(clock), view_(new TimelineView(this)) {
  setObjectName(QStringLiteral("timeline"));
  event_back_ = button("event-back", tr("Previous event"), tr("To the previous event (Page up)"));
  message_back_ = button("message-back", tr("Previous message"), tr("To the previous message (,)"));
  play_ = button("play", tr("Play"), {});
  message_forward_ = button("message-forward", tr("Next message"), tr("To the next message (.)"));
  event_forward_ = button("event-forward", tr("Next event"), tr("To the next event (Page down)"));
  events_ = button("filter", tr("Kinds of events"), {});
  makeEventsMenu();
  list_ = button("list", tr("List of events"), tr("List the events of the bag"));
  speed_ = new QComboBox(this);
  speed_->setEditable(true);
  speed_->setInsertPolicy(QComboBox::NoInsert);
  for (const double speed : kSpeeds) speed_->addItem(speedText(speed));
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Playback speed, 0.1x to 20x; negative plays backwards"));
  speed_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0.25x")) + 44);
  time_ = new QLineEdit(this);
  time_->setAccessibleName(tr("Time"));
  time_->setToolTip(
      plainToolTip(tr("The time (UTC). Type a time and press Enter to go there, Ctrl+Enter to play until "
                      "then:\n14:36:17.5, 2023-10-31 14:36:17, +1:30 after the start, -10 before the end")));
  time_->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("00:00:00.000")) + 26);
  length_ = new PlainLabel(this);
  length_->setSecondary(true);
  const QString longest = tr("%1 of %2").arg(QStringLiteral("00:00:00.0"), QStringLiteral("00:00:00.0"));
  length_->setSample(longest);
  // It is the only place with the total length: its neighbours give way.
  length_->setMinimumWidth(length_->sizeHint().width());
  state_ = new StateLabel(this);
  retry_ = new QPushButton(tr("Retry"), this);
  back_ = new QPushButton(this);
  for (QPushButton* const push : {retry_, back_}) push->setObjectName(QStringLiteral("compact"));
  retry_->setIcon(themedIcon(QStringLiteral("retry")));
  back_->setIcon(themedIcon(QStringLiteral("robot")));
  layOut();

  content_timer_.setSingleShot(true);
  content_timer_.setInterval(kContentEveryMs);
  connect(&content_timer_, &QTimer::timeout, this, &TimelineDock::onContent);
  connect(&clock_, &ReplayClock::opened, this, &TimelineDock::onOpened);
  connect(&clock_, &ReplayClock::closed, this, &TimelineDock::onClosed);
  connect(&clock_, &ReplayClock::timeChanged, this, &TimelineDock::onTime);
  connect(&clock_, &ReplayClock::stateChanged, this, &TimelineDock::onState);
  connect(&clock_, &ReplayClock::rangesChanged, this, [this] {
    if (!content_timer_.isActive()) content_timer_.start();
    onState();
  });
  connectView();
  time_->installEventFilter(this);
  onClosed();
}

TimelineDock::~TimelineDock() { time_->removeEventFilter(this); }

QToolButton* TimelineDock::button(const char* icon, const QString& name, const QString& tip) {
  auto* const made = new QToolButton(this);
  made->setIcon(themedIcon(QLatin1String(icon)));
  made->setIconSize({18, 18});
  made->setAutoRaise(true);
  made->setAccessibleName(name);
  made->setToolTip(tip);
  return made;
}

void TimelineDock::makeEventsMenu() {
  auto* const menu = new QMenu(events_);
  menu->setToolTipsVisible(true);
  for (const replay::EventGroup group : replay::kEventGroups) {
    QAction* const shown = menu->addAction(groupName(group));
    shown->setCheckable(true);
    shown->setChecked(true);
    shown->setData(int(group));
    connect(shown, &QAction::toggled, this, &TimelineDock::setGroups);
  }
  // The counts are updated when it is opened.
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    std::map<replay::EventGroup, int> counts;
    for (const replay::Event& event : view_->content().events) ++counts[replay::groupOf(event.kind)];
    for (QAction* const shown : menu->actions()) {
      const auto group = replay::EventGroup(shown->data().toInt());
      shown->setText(QStringLiteral("%1 (%2)").arg(groupName(group), QString::number(counts[group])));
    }
  });
  events_->setMenu(menu);
  events_->setPopupMode(QToolButton::InstantPopup);
  setGroups();
}

void TimelineDock::setGroups() {
  std::set<replay::EventGroup> hidden;
  for (const QAction* const shown : events_->menu()->actions()) {
    if (!shown->isChecked()) hidden.insert(replay::EventGroup(shown->data().toInt()));
  }
  view_->setHiddenGroups(hidden);
  QStringList names;
  for (const replay::EventGroup group : hidden) names << groupName(group);
  events_->setToolTip(hidden.empty()
                          ? tr("Which events to mark on the timeline")
                          : plainToolTip(tr("Hidden kinds of events: %1").arg(words::joined(names))));
  events_->setIcon(hidden.empty() ? themedIcon(QStringLiteral("filter"))
                                  : QIcon(iconPixmap(QStringLiteral("filter"), 18, devicePixelRatioF(),
                                                     appColors().accent)));
}

QStringList TimelineDock::hiddenGroups() const {
  QStringList words;
  for (const replay::EventGroup group : view_->hiddenGroups())
    words << QString::fromStdString(replay::wordOf(group));
  return words;
}

void TimelineDock::setHiddenGroups(const QStringList& words) {
  for (QAction* const shown : events_->menu()->actions())
    shown->setChecked(
        !words.contains(QString::fromStdString(replay::wordOf(replay::EventGroup(shown->data().toInt())))));
}

void TimelineDock::layOut() {
  auto* const body = new QWidget(this);
  auto* const row = new WrappingRow(QMargins(8, 4, 8, 4), 4);
  for (QWidget* const tool :
       std::initializer_list<QWidget*>{event_back_, message_back_, play_, message_forward_, event_forward_,
                                       events_, list_, speed_, time_, length_})
    row->add(tool);
  // What it says changes all the time, and nothing is to move for that.
  row->add(state_, 1, kStatePx);
  row->add(retry_);
  row->add(back_);
  body->setLayout(columnOf({row, {view_, 1}}, 0, QMargins()));
  setWidget(body);
}

void TimelineDock::connectView() {
  connect(view_, &TimelineView::seekWanted, &clock_, &ReplayClock::seek);
  connect(view_, &TimelineView::loopWanted, &clock_, &ReplayClock::setLoop);
  connect(view_, &TimelineView::playWanted, &clock_, &ReplayClock::togglePlaying);
  connect(view_, &TimelineView::stepWanted, &clock_, &ReplayClock::step);
  connect(view_, &TimelineView::messageWanted, &clock_, &ReplayClock::stepMessage);
  connect(view_, &TimelineView::eventWanted, this, &TimelineDock::goToNextEvent);
  connect(view_, &TimelineView::speedWanted, this, &TimelineDock::faster);
  connect(view_, &TimelineView::menuWanted, this, &TimelineDock::showMenu);
  connect(list_, &QToolButton::clicked, this, &TimelineDock::listWanted);
  connect(play_, &QToolButton::clicked, &clock_, &ReplayClock::togglePlaying);
  connect(message_back_, &QToolButton::clicked, this, [this] { clock_.stepMessage(-1); });
  connect(message_forward_, &QToolButton::clicked, this, [this] { clock_.stepMessage(1); });
  connect(event_back_, &QToolButton::clicked, this, [this] { goToNextEvent(-1); });
  connect(event_forward_, &QToolButton::clicked, this, [this] { goToNextEvent(1); });
  connect(speed_, &QComboBox::textActivated, this, &TimelineDock::applySpeed);
  connect(speed_->lineEdit(), &QLineEdit::editingFinished, this, &TimelineDock::applySpeed);
  connect(retry_, &QPushButton::clicked, &clock_, &ReplayClock::retry);
  connect(back_, &QPushButton::clicked, this, &TimelineDock::backWanted);
}

void TimelineDock::showMenu(const QPoint& global_pos, double at_s) {
  QMenu menu(this);
  menu.addAction(tr("Go to %1").arg(clockText(at_s)), &clock_, [this, at_s] { clock_.seek(at_s); });
  QAction* const until = menu.addAction(tr("Play until %1").arg(clockText(at_s)), &clock_,
                                        [this, at_s] { clock_.playUntil(at_s); });
  until->setEnabled(at_s > clock_.at());
  menu.addSeparator();
  menu.addAction(tr("Loop from here to %1").arg(clockText(at_s)), &clock_, [this, at_s] {
    const double now_s = clock_.at();
    clock_.setLoop(replay::Player::Loop{std::min(now_s, at_s), std::max(now_s, at_s)});
  });
  menu.addAction(tr("End the loop"), &clock_, [this] { clock_.setLoop(std::nullopt); })
      ->setEnabled(clock_.loop().has_value());
  menu.addSeparator();
  menu.addAction(themedIcon(QStringLiteral("export")),
                 clock_.loop() ? tr("Export the loop…") : tr("Export a range…"), this,
                 &TimelineDock::exportWanted);
  menu.addAction(themedIcon(QStringLiteral("fit")), tr("Show the whole bag"), view_, &TimelineView::showAll);
  menu.exec(global_pos);
}

void TimelineDock::setOpening(const QString& sentence) {
  opening_ = sentence;
  if (!clock_.isOpen()) onClosed();
}

void TimelineDock::setBack(const QString& text) {
  back_->setText(text);
  back_->setVisible(!text.isEmpty());
}

void TimelineDock::goToNextEvent(int direction) {
  if (const replay::Event* const event = nextEvent(view_->shownEvents(), clock_.at(), direction))
    clock_.seek(event->at_s);
}

void TimelineDock::faster(int direction) {
  std::vector<double> speeds(kSpeeds.begin(), kSpeeds.end());
  std::sort(speeds.begin(), speeds.end());
  const auto next = direction > 0 ? std::upper_bound(speeds.begin(), speeds.end(), clock_.speed())
                                  : std::lower_bound(speeds.begin(), speeds.end(), clock_.speed());
  if (direction > 0 && next != speeds.end()) clock_.setSpeed(*next);
  if (direction < 0 && next != speeds.begin()) clock_.setSpeed(*std::prev(next));
}

void TimelineDock::askForTime() {
  time_->setFocus(Qt::ShortcutFocusReason);
  time_->selectAll();
}

QString TimelineDock::stateShown() const { return state_->state().text; }
QString TimelineDock::lengthShown() const { return length_->text(); }

void TimelineDock::onOpened() {
  opening_.clear();
  view_->showAll();
  onContent();
  onTime(clock_.at());
  onState();
}

void TimelineDock::onClosed() {
  content_timer_.stop();
  view_->setContent({});
  view_->setLoop(std::nullopt);
  view_->setNotice(!opening_.isEmpty() ? opening_
                                       : tr("Bags opened in the Recordings panel are played here."));
  time_->setText({});  // clear() would count as typed, and typed text stays
  length_->setText({});
  onState();
}

void TimelineDock::onContent() {
  const replay::Reading* const reading = clock_.reading();
  if (!reading) return;
  TimelineContent content;
  content.first_s = clock_.start();
  content.last_s = clock_.end();
  for (const auto& [from, cell] : reading->chunks().cells()) content.ranges.push_back(rangeOf(cell));
  content.events = replay::eventsOf(reading->index().digests());
  content.silences = replay::silencesIn(reading->chunks(), reading->index().digests());
  const bool empty = content.ranges.empty();
  view_->setContent(std::move(content));
  view_->setNotice(empty ? tr("This bag contains no messages.") : QString());
  onTime(clock_.at());
  Q_EMIT eventsChanged();
}

void TimelineDock::onTime(double at_s) {
  if (!clock_.isOpen()) return;
  view_->setAt(at_s);
  // A selection that the user is about to overwrite stays.
  const bool typing = time_->isModified() || (time_->hasFocus() && time_->hasSelectedText());
  if (const QString text = clockText(at_s); !typing && text != time_->text()) time_->setText(text);
  length_->setText(
      tr("%1 of %2").arg(elapsedText(at_s - clock_.start()), elapsedText(clock_.end() - clock_.start())));
}

void TimelineDock::onState() {
  const replay::Reading* const reading = clock_.reading();
  const bool open = reading != nullptr;
  for (QWidget* const control :
       std::initializer_list<QWidget*>{event_back_, message_back_, play_, message_forward_, event_forward_,
                                       events_, list_, speed_, time_})
    control->setEnabled(open);
  const bool playing = clock_.playing();
  play_->setIcon(themedIcon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
  play_->setAccessibleName(playing ? tr("Pause") : tr("Play"));
  play_->setToolTip(playing ? tr("Pause (Space)") : tr("Play (Space)"));
  if (!speed_->lineEdit()->isModified()) speed_->setEditText(speedText(clock_.speed()));
  view_->setLoop(clock_.loop());
  StateText state;
  const replay::Cell* const gap = open ? reading->chunks().gapUntil(clock_.at()) : nullptr;
  if (open && clock_.knowledge() == Knowledge::Buffering) {
    state.mark = Mark::Busy;
    state.text = tr("buffering…");
  } else if (gap) {
    state.mark = Mark::Bad;
    state.text = tr("a gap at %1").arg(clockText(std::max(replay::secondsOf(gap->from), clock_.start()), 0));
  } else if (open && clock_.knowledge() == Knowledge::LookingBack) {
    state.mark = Mark::Busy;
    const int percent = int(std::floor(clock_.lookedBack() * 100));
    state.text = percent < 100 ? tr("reading earlier data: %1 %").arg(percent) : tr("reading earlier data…");
  }
  state_->setState(state);
  state_->setToolTip(gap ? plainToolTip(rangeOf(*gap).why) : QString());
  retry_->setVisible(open && reading->chunks().anyFailed());
}

void TimelineDock::applyTyped(bool play_until) {
  const auto at_s = excerpt::timeTyped(time_->text(), clock_.start(), clock_.end());
  if (!at_s) {
    QToolTip::showText(time_->mapToGlobal(QPoint(0, -time_->height())),
                       plainToolTip(tr("This is not a time between %1 and %2.")
                                        .arg(clockText(clock_.start()), clockText(clock_.end()))),
                       time_);
    time_->selectAll();
    return;
  }
  time_->setModified(false);
  time_->deselect();
  play_until ? clock_.playUntil(*at_s) : clock_.seek(*at_s);
  onTime(clock_.at());
  view_->setFocus();
}

void TimelineDock::applySpeed() {
  if (const auto speed = speedTyped(speed_->currentText())) clock_.setSpeed(*speed);
  speed_->lineEdit()->setModified(false);
  speed_->setEditText(speedText(clock_.speed()));
}

bool TimelineDock::eventFilter(QObject* watched, QEvent* event) {
  if (watched == time_ && event->type() == QEvent::KeyPress) {
    const auto* const key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
      applyTyped(key->modifiers() & Qt::ControlModifier);
      return true;
    }
    if (key->key() == Qt::Key_Escape) {
      time_->setModified(false);
      time_->deselect();
      onTime(clock_.at());
      view_->setFocus();
      return true;
    }
  }
  if (watched == time_ && event->type() == QEvent::FocusOut) {
    time_->setModified(false);
    time_->deselect();
    onTime(clock_.at());
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_timeline_dock.cpp"
