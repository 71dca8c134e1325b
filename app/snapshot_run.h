// One snapshot from connecting to the picture. The same session and scene as the window's.
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

/// What the picture is made of, and what is said of it.
struct SnapshotChoice {
  session::SubmapCounts counts;
  QStringList problems;
  std::optional<QJsonObject> map;
  bool refused = false;  // something was: not without (the right) secret
};

class SnapshotRun : public QObject {
  Q_OBJECT
 public:
  /// `start`: from then on --timeout counts.
  SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot,
              CommandStart start = {std::chrono::steady_clock::now(), {}});
  ~SnapshotRun() override;

  void start();
  QJsonObject report() const;               // docs/command-line.md, "mapwright snapshot"
  QString error() const { return error_; }  // the sentence when nothing could be made
  QStringList warnings() const;
  /// What is said of a picture that shows something else than was expected; empty = it does not.
  QString shownInstead() const { return shown_instead_; }
  const SnapshotOptions& options() const { return options_; }
  /// Of the picture, once it is finished.
  const geometry::ViewTransform& view() const { return view_; }
  /// A sentence when the picture or the report would replace a file that the map is read from.
  std::optional<QString> overItsSource() const;

  /// How things stood a short while ago.
  std::shared_ptr<const SnapshotBoard> standing() const { return board_; }

 Q_SIGNALS:
  void progressed(const QString& line);
  void contentChosen();  // from now on the picture and its report are about what is held now
  void finished(int exit_code);

 private:
  static constexpr double kTopicsWithinS = 3;  // live layers, after connecting

  void look();  // whatever may have changed: is it time for the next step?
  bool connected();
  /// Of a bag: the world of its time has been taken over.
  bool recalled();
  bool topicsChoosable();
  void noteChosenTopics();
  /// There is no map, and something to be seen all the same.
  bool drawsScansAlone() const;
  /// The mode was not chosen by anybody, no list of submaps comes, and a whole map can be had.
  bool wantsWholeInstead();
  void takeWholeInstead();
  void tellProgress();
  void noteStanding();
  void timeOut();
  void cutOff();
  void paint(bool settled);
  void write();
  QString noConnection() const;
  /// A sentence about a link that is lost, after a blank; empty while it stands.
  QString whatOfTheLink() const;
  /// The waypoints that are to be drawn could not be had.
  bool waypointsLost() const;
  bool isLocal() const;
  bool wantsTrack() const;  // of a whole bag
  /// The same as look(), of a picture of a region.
  void lookAtRegion();
  /// How large the picture is, now that a cell's size is known; false: there is none, and it has failed.
  bool sizeRegion();
  QString tooManyPixels() const;
  void takeRegion(SnapshotContent& content);
  std::optional<QJsonObject> regionJson() const;
  bool topicsIn() const;
  bool lacksSubmaps() const;  // of a bag that lists none until then: none will come
  bool everythingIn() const;
  /// Asks for the cloud of what is drawn, where that is wanted, once it is known what that is.
  bool cloudIn();
  bool wantsCloud() const;
  bool somethingIn() const;
  /// The link is lost, and it is about time to draw what has come.
  bool goneForGood() const;
  void fail(int exit_code, const QString& sentence);
  void finish(int exit_code);
  double seconds() const;
  /// How long a list of submaps is waited for where a whole map can be drawn instead.
  double listWithin() const;

  const bool automatic_;  // nobody has said what is to be drawn
  SnapshotOptions options_;
  std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>();
  session::Session session_;
  MapWish map_;
  LayerWish live_layers_;
  bool scans_alone_ = false;
  CloudWish cloud_;
  replay::ReplayRobot* replayed_ = nullptr;  // null = a robot as it is
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
  double made_ = 0;           // the share of the picture that was made
  bool done_ = false, complete_ = false;
  bool asks_where_ = false;  // whether the robot is in the map that is drawn
  QString error_;
  QString shown_instead_;
  QStringList notes_;
};

}  // namespace mapwright::app
