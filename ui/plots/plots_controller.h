// Plots of data from a bag or a robot.
#pragma once

#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/plots/plot_feed.h"
#include "ui/shell/replay_clock.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class PlotsDock;

class PlotsController : public Controller {
  Q_OBJECT
 public:
  /// `clock` tells the time of a replay.
  PlotsController(WindowContext& context, ReplayClock& clock, QObject* parent = nullptr);

  PlotsDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  void reset() override;
  /// A field chosen elsewhere: adds it to the active plot and shows the dock.
  void plot(const PlotSelection& selection);

 Q_SIGNALS:
  /// Raw messages of the robot are needed, or no longer.
  void rawWanted(bool wanted);

 private:
  /// Of a recording of another robot: fields whose topics are in it.
  void keepRecorded();

  WindowContext& context_;
  QPointer<ReplayClock> clock_;
  QString source_;  // the robot whose fields are plotted; empty = none yet
  PlotFeed* feed_;
  PlotsDock* dock_;
};

}  // namespace mapwright::ui
