// The state of the robot, its safety conditions, and whether it is in the map on screen.
#pragma once

#include <QSet>

#include "ui/kit/controller.h"
#include "ui/kit/safety_badge.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class RobotDock;

class RobotController : public Controller {
  Q_OBJECT
 public:
  explicit RobotController(WindowContext& context, QObject* parent = nullptr);

  RobotDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;

 Q_SIGNALS:
  void safetyChanged(const mapwright::ui::SafetyText& text);

 private:
  bool comesFirst(session::Session* session) const;
  void refreshSafety();
  void refreshPlace();
  /// Why what a topic sends, or the robot, is not drawn in its place on the map; empty: it is.
  static QString lackOfPlace(const session::Session& session);
  void sayPlace(const QString& sentence, const QString& offer, bool closable, Mark mark = Mark::Neutral);
  void changePlace();

  WindowContext& context_;
  RobotDock* dock_;
  QSet<QString> dismissed_;
};

}  // namespace mapwright::ui
