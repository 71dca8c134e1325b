// One snapshot, from connecting to the picture. Uses the same session and scene as the window.
#pragma once

#include <memory>

#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/cloud_wish.h"
#include "app/deadline.h"
#include "app/layer_wish.h"
#include "app/map_wish.h"
#include "app/snapshot_options.h"
#include "app/snapshot_picture.h"
#include "app/snapshot_report.h"
#include "regions/region_fetch.h"
#include "session/session.h"
#include "work/workers.h"

namespace mapwright::replay {
class ReplayRobot;
}

namespace mapwright::app {

/// What the picture is made from, and what the report says about it.
struct SnapshotChoice {
  session::SubmapCounts counts;
  QStringList problems;
  std::optional<QJsonObject> map;
  bool refused = false;  // the robot refused something because the secret is wrong or missing
};

class SnapshotRun : public QObject {
  Q_OBJECT
 public:
  /// --timeout counts from `start`.
  SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot,
              CommandStart start = {std::chrono::steady_clock::now(), {}});
  ~SnapshotRun() override;

  void start();
  QJsonObject report() const;               // docs/command-line.md, "mapwright snapshot"
  QString error() const { return error_; }  // a sentence if nothing could be drawn
  QStringList warnings() const;
  /// A sentence if the picture shows something else than requested; otherwise empty.
  QString shownInstead() const { return shown_instead_; }
  const SnapshotOptions& options() const { return options_; }
  /// Of the picture, once it is complete.
  const geometry::ViewTransform& view() const { return view_; }
  /// A sentence if the picture or the report would replace a file that the map is read from.
  std::optional<QString> overItsSource() const;

  /// A recent state, for other threads.
  std::shared_ptr<const SnapshotBoard> standing() const { return board_; }

 Q_SIGNALS:
  void progressed(const QString& line);
  void contentChosen();  // from here on the picture and its report use what is loaded now
  void finished(int exit_code);

 private:
  static constexpr double kTopicsWithinS = 3;  // live layers, after connecting

  void look();  // checks whether it is time for the next step; call it whenever something may have changed
  bool connected();
  /// For a bag: the state at its time has been applied.
  bool recalled();
  bool topicsChoosable();
  void noteChosenTopics();
  /// There is no map, but sensor data to show.
  bool drawsScansAlone() const;
  /// The mode is automatic, no submap list arrives, and a whole map is available.
  bool wantsWholeInstead();
  void takeWholeInstead();
  void tellProgress();
  void noteStanding();
  void timeOut();
  void cutOff();
  void paint(bool settled);
  void write();
  QString noConnection() const;
  /// A sentence about a lost connection, after a blank; empty while connected.
  QString whatOfTheLink() const;
  /// Waypoints should be drawn but could not be loaded.
  bool waypointsLost() const;
  bool isLocal() const;
  bool wantsTrack() const;  // of a whole bag
  /// The same as look(), for a picture of a region.
  void lookAtRegion();
  /// Computes the picture size from the cell size; false: impossible, and the run has failed.
  bool sizeRegion();
  QString tooManyPixels() const;
  void takeRegion(SnapshotContent& content);
  std::optional<QJsonObject> regionJson() const;
  bool topicsIn() const;
  bool lacksSubmaps() const;  // a bag that contains no submap list up to its time: none will arrive
  bool everythingIn() const;
  /// Requests the cloud of what is drawn, if that is wanted and the area is known.
  bool cloudIn();
  bool wantsCloud() const;
  bool somethingIn() const;
  /// The connection is lost, and it is time to draw what has arrived.
  bool goneForGood() const;
  void fail(int exit_code, const QString& sentence);
  void finish(int exit_code);
  double seconds() const;
  /// How long to wait for a submap list if a whole map can be drawn instead.
  double listWithin() const;

  const bool automatic_;  // the user did not choose what to draw
  SnapshotOptions options_;
  std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>();
  session::Session session_;
  MapWish map_;
  LayerWish live_layers_;
  bool scans_alone_ = false;
  CloudWish cloud_;
  replay::ReplayRobot* replayed_ = nullptr;  // null = a live robot
  bool recalled_ = false;
  std::unique_ptr<regions::RegionFetch> fetch_;  // of a region
  std::unique_ptr<SnapshotChoice> chosen_;
  std::unique_ptr<SnapshotPicture> picture_;
  std::shared_ptr<SnapshotBoard> board_ = std::make_shared<SnapshotBoard>();
  CommandStart start_;
  QTimer timeout_, cut_off_, settle_, poll_;
  geometry::ViewTransform view_;
  double connected_s_ = -1, first_paint_s_ = -1, complete_s_ = -1, noted_s_ = -1, note_took_s_ = 0;
  double whole_asked_s_ = 0;  // when the whole map was asked for, after connecting
  double made_ = 0;           // which share of the picture has been drawn
  bool done_ = false, complete_ = false;
  bool asks_where_ = false;  // checks whether the robot is in the map that is drawn
  QString error_;
  QString shown_instead_;
  QStringList notes_;
};

}  // namespace mapwright::app
