// One run of a report: reads the bag up to its moment and half a minute beyond, and draws the map around the
// robot. Uses a session of its own, so a replay on screen is not disturbed.
#pragma once

#include <memory>
#include <optional>
#include <set>

#include <QObject>
#include <QSize>
#include <QTimer>

#include "geometry/view_transform.h"
#include "incident/report.h"
#include "map/failure.h"
#include "replay/replay_robot.h"
#include "session/session.h"
#include "ui/shot/map_shot.h"
#include "ui/shot/picture.h"
#include "ui/shot/recall.h"
#include "work/workers.h"

namespace mapwright::ui::reporting {

struct Wanted {
  robot::BagKey bag = {};
  bool any_kind = false;                             // only its name is known
  std::optional<double> at_s = {};                   // the moment; else when the robot was nearest to:
  std::optional<Eigen::Vector2d> near_m = {};        // world metres
  std::optional<geometry::ViewTransform> view = {};  // of the picture; nullopt: around the robot
  QSize picture_px = {1000, 700};
};

class Gathering : public QObject {
  Q_OBJECT
 public:
  /// `origin` is not connected.
  Gathering(std::unique_ptr<robot::Robot> origin, Wanted wanted, std::shared_ptr<work::Workers> workers,
            QObject* parent = nullptr);
  ~Gathering() override;
  void start();

  /// Why there is nothing; empty: it is complete, or still going on.
  const QString& error() const { return error_; }
  map::FailureKind failure() const { return failure_; }
  /// Once it has ended well.
  incident::Run& run() { return run_; }
  const geometry::ViewTransform& view() const { return view_; }

 Q_SIGNALS:
  void progressed(double share);  // of the bag, 0..1
  void ended();

 private:
  void look();
  bool opened();
  bool momentChosen();
  /// Asks for what the report shows besides the state; true: all of it is there.
  bool minuteRead();
  void take(const replay::ChunkPtr& chunk);
  void addMessages(const replay::Chunk& chunk);
  void openMap();
  bool mapIn();
  void onState();
  geometry::ViewTransform chosenView() const;
  void draw();
  void onPicture();
  void fail(const QString& sentence, map::FailureKind kind);
  void end(shot::Stage stage);

  Wanted wanted_;
  std::shared_ptr<work::Workers> workers_;
  session::Session session_;
  replay::ReplayRobot* replayed_;
  shot::MapShot shot_;
  shot::Recall recall_;
  std::unique_ptr<shot::ScenePicture> picture_;
  QTimer poll_;
  incident::Run run_;
  std::optional<incident::Minute> minute_;
  std::optional<std::set<replay::Tick>> awaited_;  // ranges whose messages are still needed
  geometry::ViewTransform view_;
  QString error_;
  map::FailureKind failure_ = map::FailureKind::None;
};

}  // namespace mapwright::ui::reporting
