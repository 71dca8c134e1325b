// A recorded way on the map on screen: what it crosses there. If a reference map is laid, the way was driven
// on that one. Why: docs/tasks/new-map.md.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QTemporaryDir>
#include <tl/expected.hpp>

#include "map/grid_reference.h"
#include "robot/robot.h"
#include "ui/kit/controller.h"
#include "ui/shell/laid_map.h"
#include "ui/shell/window_context.h"
#include "work/workers.h"

namespace mapwright::carry {
struct Rehearsed;
struct Stretch;
}  // namespace mapwright::carry
namespace mapwright::excerpt {
class ExcerptJob;
}

namespace mapwright::ui {

class RehearsalDock;

class RehearsalController : public Controller {
  Q_OBJECT
 public:
  /// Makes the robot of a recording, not yet connected. The error is a sentence.
  using MakeRobot =
      std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(const QString& address)>;
  RehearsalController(WindowContext& context, MakeRobot make_robot, QObject* parent = nullptr);
  ~RehearsalController() override;

  RehearsalDock* dock() const { return dock_; }
  /// A recording, or a track that was exported.
  void rehearse(const QString& path);
  /// The reference map; nullopt = none, or it is still being read.
  void setLaid(const std::optional<LaidMap>& laid);
  void setSession(session::Session* session) override;
  /// As drawn.
  const std::vector<carry::Stretch>& shown() const;

 private:
  class Line;

  void choose();
  /// Writes its track first.
  void readRecording(const QString& path);
  /// On a thread beside the pool.
  void run(const QString& track_file);
  void onRehearsed(const carry::Rehearsed& way);
  /// A file is read again when anything beside it is saved: that is no other map.
  bool sameCells() const;
  void forget(const QString& said);
  void goTo(int row);

  WindowContext& context_;
  MakeRobot make_robot_;
  RehearsalDock* dock_;
  std::unique_ptr<Line> line_;
  std::optional<LaidMap> laid_;
  QString path_;         // empty = none is chosen
  QString lost_;         // what its recording lacks; empty = nothing
  std::string content_;  // of the map that it was rehearsed on: names exactly these cells; empty: not known
  map::GridReference reference_;
  std::vector<carry::Stretch> crossed_;
  QTemporaryDir folder_;
  std::unique_ptr<robot::Robot> origin_;  // of the recording
  std::unique_ptr<excerpt::ExcerptJob> job_;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
