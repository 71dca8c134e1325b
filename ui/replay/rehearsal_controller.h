// A recorded way on the map on screen, from a file or from the robot: what it crosses there. If a reference
// map is laid, the way was driven on that one. Why: docs/tasks/new-map.md.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QTemporaryDir>
#include <tl/expected.hpp>

#include "map/map_identity.h"
#include "render/sample_grid.h"
#include "robot/bag_library.h"
#include "robot/robot.h"
#include "ui/kit/background_run.h"
#include "ui/kit/controller.h"
#include "ui/shell/laid_map.h"
#include "ui/shell/window_context.h"

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
  /// A recording of the robot that is connected.
  void rehearseBag(const robot::BagKey& key);
  /// The reference map; nullopt = none, or it is still being read.
  void setLaid(const std::optional<LaidMap>& laid);
  void setSession(session::Session* session) override;
  /// As drawn.
  const std::vector<carry::Stretch>& shown() const;

 Q_SIGNALS:
  /// To choose one of the robot's.
  void recordingsWanted();

 private:
  class Line;
  /// The map on screen, without unsaved changes.
  struct Ground {
    render::PlacedGrid map;
    std::string content;  // names exactly these cells; empty: not known
  };

  robot::BagLibrary* library() const;  // of the robot; null: it has none
  bool isChosen() const { return bag_ || !path_.isEmpty(); }
  QString called() const;
  void choose();
  /// What is chosen.
  void read();
  void readFile();
  /// Writes its track first.
  void readRecording(robot::BagLibrary& library, const robot::BagKey& key);
  /// Beside the one of what is shown.
  QString newTrackFile() const;
  /// On a thread beside the pool.
  void run(const QString& track_file);
  /// What the map is called that the way was driven on.
  map::MapIdentity drivenOn() const;
  void onRehearsed(const carry::Rehearsed& way);
  void show(const QString& said);
  /// A file is read again when anything beside it is saved: that is no other map.
  bool sameCells(const Ground& ground) const;
  void forget(const QString& said);
  /// What was there before the reading comes back, if it still holds; otherwise there is nothing, and why.
  void fail(const QString& why, const QString& why_nothing = {});
  /// Until it is known what it crosses.
  void wait(const QString& said);
  void onEdited();
  void goTo(int row);
  void syncRobot();

  WindowContext& context_;
  MakeRobot make_robot_;
  RehearsalDock* dock_;
  std::unique_ptr<Line> line_;
  std::optional<LaidMap> laid_;
  QString path_;                      // a file is chosen
  std::optional<robot::BagKey> bag_;  // or one of the robot
  QString track_file_;                // what was read of it; empty: nothing yet
  QString lost_;                      // what its recording lacks; empty = nothing
  std::optional<Ground> ground_;      // that it is rehearsed on
  bool edited_ = false;               // that has been painted on since then
  /// The last one that was shown.
  struct Good {
    QString path;
    std::optional<robot::BagKey> bag;
    QString track_file, lost, said;
    Ground ground;
    std::vector<carry::Stretch> stretches, crossed;
    bool edited = false;
  };
  std::optional<Good> good_;
  double told_m_ = 0;  // the radius that the robot reports, or the usual one
  std::vector<carry::Stretch> crossed_;
  QTemporaryDir folder_;
  std::unique_ptr<robot::Robot> origin_;  // of the recording
  std::unique_ptr<excerpt::ExcerptJob> job_;
  std::shared_ptr<bool> over_ = std::make_shared<bool>(false);  // answers do not count any more
  BackgroundRun run_;
};

}  // namespace mapwright::ui
