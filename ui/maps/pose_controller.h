// Tells the robot where it is: placed by hand or typed, or found by the robot itself.
#pragma once

#include <optional>

#include "geometry/pose.h"
#include "map/live_topics.h"
#include "robot/call.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

class QAction;

namespace mapwright::robot {
class Localization;
}

namespace mapwright::ui {

class PoseDock;
class PoseTool;

class PoseController : public Controller {
  Q_OBJECT
 public:
  explicit PoseController(WindowContext& context, QObject* parent = nullptr);

  PoseDock* dock() const { return dock_; }
  const std::optional<geometry::Pose2>& pose() const { return pose_; }
  void setSession(session::Session* session) override;

 private:
  robot::Localization* localization() const;
  void setPose(const std::optional<geometry::Pose2>& pose);
  void useTool(bool on);
  void set(const geometry::Pose2& pose, bool adjust);
  void find();
  void refresh();
  QString unavailableReason() const;

  WindowContext& context_;
  PoseDock* dock_;
  PoseTool* tool_;
  QAction *open_, *tool_action_;
  std::optional<geometry::Pose2> pose_, proposed_;
  robot::Call call_;
};

}  // namespace mapwright::ui
