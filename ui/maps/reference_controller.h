// A local map as a layer under what a robot shows: chosen, laid by hand or by pairs of points, and remembered
// for that robot and map.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QJsonObject>
#include <QPointer>
#include <QUndoStack>
#include <tl/expected.hpp>

#include "placing/align.h"
#include "robot/robot.h"
#include "session/map_slot.h"
#include "session/session.h"
#include "ui/kit/controller.h"
#include "ui/maps/map_files.h"
#include "ui/shell/window_context.h"

class QAction;

namespace mapwright::window {

class ReferenceDock;
class ReferenceTool;

class ReferenceController : public Controller {
  Q_OBJECT
 public:
  /// `read`: returns a reader for the map at an address; the error is a sentence.
  using Read = std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address)>;

  ReferenceController(WindowContext& context, PicturePlacing& placing, Read read, QObject* parent = nullptr);
  ~ReferenceController() override;

  ReferenceDock* dock() const { return dock_; }
  /// Lays the map at this address ("file:/maps/a.yaml").
  void lay(const QString& address);
  void removeMap();
  const geometry::Pose2& pose() const { return laid_.pose; }

  void setSession(session::Session* session) override;

 private:
  /// How it lies.
  struct Laid {
    geometry::Pose2 pose;
    std::vector<placing::PointPair> pairs;
    bool operator==(const Laid&) const = default;
  };
  class Step;

  void choose();
  /// One step that can be undone. `drag`: steps with the same number are one; 0 = a step of its own.
  void change(const QString& what, Laid laid, int drag = 0);
  void setPairs(const QString& what, std::vector<placing::PointPair> pairs);
  void setLaid(Laid laid);
  void forgetSteps();
  void useTool(bool on, bool pairing);
  void load(const QString& address);
  void show();
  /// The robot and the map that it is on; empty = not known.
  QString currentMap() const;
  void onCurrentMapChanged();
  void remember();
  QJsonObject kept() const;  // what is remembered for this map
  void onLaid(const QJsonObject& laid);
  void showFailure(const map::Failure& failure);

  WindowContext& context_;
  PicturePlacing& placing_;
  Read read_;
  ReferenceDock* dock_;
  ReferenceTool* tool_;
  QAction* tool_action_;
  std::unique_ptr<robot::Robot> reader_, coming_;
  session::MapSlot slot_;
  QString address_;      // of the reference map; empty = none
  QString current_map_;  // for which it is remembered
  Laid laid_;
  QUndoStack steps_;
  QPointer<QUndoStack> other_steps_;  // what Ctrl+Z was about before
  int drag_ = 0;
};

}  // namespace mapwright::window
