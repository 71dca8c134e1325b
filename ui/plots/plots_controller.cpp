#include "ui/plots/plots_controller.h"

#include <set>
#include <string>

#include <QPushButton>

#include "session/session.h"
#include "ui/kit/actions.h"
#include "ui/kit/panels.h"
#include "ui/plots/plots_dock.h"
#include "ui/shell/current_session.h"
#include "ui/view/replay_state.h"

namespace mapwright::ui {

namespace {
const QString kLayout = QStringLiteral("plots/layout");
const QString kSource = QStringLiteral("plots/source");  // whose fields these are
}  // namespace

PlotsController::PlotsController(WindowContext& context, ReplayClock& clock, QObject* parent)
    : Controller(parent),
      context_(context),
      clock_(&clock),
      feed_(new PlotFeed(context.workers, {}, this)),
      dock_(new PlotsDock(*feed_, &context.window)) {
  feed_->setParent(dock_);  // which shows it as long as it lives
  context.panels.add(dock_, {.side = PanelPosition::Side::Right, .tab = 60, .menu_rank = 49, .open = false});
  connect(&clock, &ReplayClock::opened, this, [this] {
    keepRecorded();
    feed_->setReading(clock_->reading());
    dock_->openBag(clock_->start(), clock_->end());
    dock_->setCurrent(clock_->at());
  });
  connect(&clock, &ReplayClock::closed, this, [this] {
    feed_->setReading(nullptr);
    dock_->closeBag();
  });
  connect(&clock, &ReplayClock::timeChanged, dock_, &PlotsDock::setCurrent);
  connect(&clock, &ReplayClock::rangesChanged, this, [this] { dock_->extendBag(clock_->end()); });
  connect(dock_, &PlotsDock::seekWanted, &clock, &ReplayClock::seek);
  // It is the same setting as in the menu.
  if (QAction* const whole = context.actions.find(QStringLiteral("replayReadAll"))) {
    dock_->wholeButton()->setChecked(whole->isChecked());
    connect(dock_, &PlotsDock::wholeWanted, whole, &QAction::setChecked);
    connect(whole, &QAction::toggled, dock_->wholeButton(), &QPushButton::setChecked);
  }
  connect(feed_, &PlotFeed::rawWanted, this, &PlotsController::rawWanted);
}

void PlotsController::setSession(session::Session* session) {
  // Fields of topics mean something for the robot that has them; quantities are those of any. Those of a
  // replay follow when its bag is open.
  if (session && !replayOf(session)) {
    const QString source = session->robot().address();
    if (!source_.isEmpty() && source != source_) dock_->removeFields();
    source_ = source;
  }
  feed_->setSession(session);
  dock_->sourceChanged();
}

void PlotsController::keepRecorded() {
  const QString source = context_.current.address();
  if (source_.isEmpty()) source_ = source;
  if (source == source_) return;
  std::set<std::string> recorded;
  for (const robot::BagTopic& topic : clock_->reading()->info()->topics) recorded.insert(topic.name);
  dock_->removeFields(recorded);
}

void PlotsController::recall(const QSettings& settings) {
  dock_->restoreLayout(settings.value(kLayout).toString());
  source_ = settings.value(kSource).toString();
}

void PlotsController::remember(QSettings& settings) {
  settings.setValue(kLayout, dock_->layout());
  settings.setValue(kSource, source_);
}

void PlotsController::reset() { dock_->clearPlots(); }

void PlotsController::plot(const PlotSelection& selection) {
  context_.panels.open(dock_);
  dock_->addCurve(dock_->plots().back(), selection);
}

}  // namespace mapwright::ui

#include "moc_plots_controller.cpp"
