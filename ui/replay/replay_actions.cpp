#include "ui/replay/replay_actions.h"

#include <QAction>
#include <QMenu>

#include "ui/kit/actions.h"
#include "ui/kit/panels.h"
#include "ui/replay/timeline_dock.h"
#include "ui/shell/replay_clock.h"

namespace mapwright::window {

template <typename What>
QAction* ReplayActions::entry(const char* id, const QString& text, const char* icon, const char* key,
                              const QString& tip, What&& what) {
  QList<QKeySequence> keys;
  if (*key) keys << QKeySequence(QLatin1String(key));
  QAction* const action = context_.actions.add(tr("Replay"), QLatin1String(id), text, QLatin1String(icon),
                                               keys, Reach::Everywhere, tip);
  connect(action, &QAction::triggered, this, std::forward<What>(what));
  menu_->addAction(action);
  of_open_bag_.push_back(action);
  return action;
}

ReplayActions::ReplayActions(WindowContext& context, ReplayClock& clock, TimelineDock& dock, QObject* parent)
    : QObject(parent),
      context_(context),
      clock_(clock),
      dock_(dock),
      menu_(new QMenu(tr("Re&play"), &context.window)) {
  menu_->setToolTipsVisible(true);
  context_.actions.place({MenuGroup::Link, 40}, menu_->menuAction());
  entry("replayPlay", tr("&Play or pause"), "play", "Ctrl+Space", tr("Play or pause the bag"),
        [this] { clock_.togglePlaying(); });
  entry("replayBackwards", tr("&Backwards or forwards"), "", "", tr("Reverse the direction"),
        [this] { clock_.setSpeed(-clock_.speed()); });
  entry("replayFaster", tr("&Faster"), "", "", tr("Play faster"), [this] { dock_.faster(1); });
  entry("replaySlower", tr("&Slower"), "", "", tr("Play slower"), [this] { dock_.faster(-1); });
  menu_->addSeparator();
  entry("replayMessageBack", tr("Previous &message"), "message-back", "", tr("To the previous message"),
        [this] { clock_.stepMessage(-1); });
  entry("replayMessageForward", tr("Next m&essage"), "message-forward", "", tr("To the next message"),
        [this] { clock_.stepMessage(1); });
  entry("replayEventBack", tr("Previous e&vent"), "event-back", "", tr("To the previous event"),
        [this] { dock_.goToNextEvent(-1); });
  entry("replayEventForward", tr("&Next event"), "event-forward", "", tr("To the next event"),
        [this] { dock_.goToNextEvent(1); });
  entry("replayTime", tr("Go to a &time…"), "goto", "Ctrl+T", tr("Type the time to go to"), [this] {
    context_.panels.open(&dock_);
    dock_.askForTime();
  });
  menu_->addSeparator();
  end_loop_ = entry("replayEndLoop", tr("End the &loop"), "", "", tr("Continue playing beyond the loop"),
                    [this] { clock_.setLoop(std::nullopt); });
  read_all_ =
      context_.actions.addToggle(tr("Replay"), QStringLiteral("replayReadAll"), tr("&Read the whole bag"), {},
                                 {}, Reach::Everywhere, tr("Read to the end to find all events"));
  read_all_->setChecked(true);
  menu_->addAction(read_all_);
  connect(read_all_, &QAction::toggled, this, &ReplayActions::readsAllChanged);
  entry("replayExport", tr("E&xport a range…"), "export", "",
        tr("Write a part of the bag or the path of the robot to a file"), [this] { Q_EMIT exportWanted(); });
  menu_->addSeparator();
  back_ = context_.actions.add(tr("Replay"), QStringLiteral("replayBack"), tr("Back to the r&obot"),
                               QStringLiteral("robot"), {}, Reach::Everywhere, tr("End the replay"));
  connect(back_, &QAction::triggered, this, &ReplayActions::backWanted);
  menu_->addAction(back_);
  for (const auto signal : {&ReplayClock::opened, &ReplayClock::closed, &ReplayClock::stateChanged})
    connect(&clock_, signal, this, &ReplayActions::refresh);
  setReplay(false, {});
}

bool ReplayActions::readsAll() const { return read_all_->isChecked(); }
void ReplayActions::setReadsAll(bool all) { read_all_->setChecked(all); }

void ReplayActions::setReplay(bool is_replay, const QString& back) {
  back_->setEnabled(is_replay);
  if (!back.isEmpty()) back_->setText(back);
  refresh();
}

void ReplayActions::refresh() {
  for (QAction* const action : of_open_bag_) action->setEnabled(clock_.isOpen());
  end_loop_->setEnabled(clock_.loop().has_value());
}

}  // namespace mapwright::window

#include "moc_replay_actions.cpp"
