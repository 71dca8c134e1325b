// One snapshot, from connecting to the picture. Uses the same session and scene as the window.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "app/deadline.h"
#include "app/map_request.h"
#include "app/snapshot.h"
#include "app/snapshot_region.h"
#include "session/session.h"
#include "ui/shot/layer_subscription.h"
#include "ui/shot/map_shot.h"
#include "ui/shot/picture.h"
#include "ui/shot/recall.h"
#include "work/workers.h"

namespace mapwright::replay {
class ReplayRobot;
}

namespace mapwright::app {

/// A recent state of the snapshot, for another thread that ends the run.
struct SnapshotStanding {
  int exit_code = 0;
  QString sentence;
  QJsonObject report;
};
/// On any thread.
class SnapshotBoard {
 public:
  void put(SnapshotStanding standing) {
    const std::lock_guard lock(mutex_);
    standing_ = std::move(standing);
  }
  SnapshotStanding take() const {
    const std::lock_guard lock(mutex_);
    return standing_;
  }

 private:
  mutable std::mutex mutex_;
  SnapshotStanding standing_;
};

class SnapshotRun : public QObject {
  Q_OBJECT
 public:
  /// --timeout counts from `start`. Several at once may share their `workers`.
  SnapshotRun(SnapshotOptions options, std::unique_ptr<robot::Robot> robot,
              CommandStart start = {std::chrono::steady_clock::now(), {}},
              std::shared_ptr<work::Workers> workers = std::make_shared<work::Workers>());
  ~SnapshotRun() override;

  void start();
  QJsonObject report() const;               // docs/json.md
  QString error() const { return error_; }  // a sentence if nothing could be drawn
  QStringList warnings() const;
  /// A sentence if the picture shows something else than requested; otherwise empty.
  QString shownInstead() const { return shown_instead_; }
  const SnapshotOptions& options() const { return options_; }
  /// Of the picture, once it is complete.
  const geometry::ViewTransform& view() const { return view_; }
  /// What it was to show, with the maps.
  ui::shot::Look shown() const;
  /// What the picture is made from; it stands still once contentChosen().
  const session::Session& session() const { return session_; }
  /// A sentence if the picture or the report would replace a file that the map is read from.
  std::optional<QString> overItsSource() const;

  /// A recent state, for other threads.
  std::shared_ptr<const SnapshotBoard> standing() const { return board_; }

 Q_SIGNALS:
  void progressed(const QString& line);
  void contentChosen();  // from here on the picture and its report use what is loaded now
  void finished(int exit_code);

 private:
  /// What the picture is made from, and what the report says about it.
  struct Choice {
    session::SubmapCounts counts;
    QStringList problems;
    std::optional<QJsonObject> map;
    bool refused = false;  // the robot refused something because the secret is wrong or missing
  };
  /// The cloud of what is drawn; may arrive after this object is gone.
  struct Cloud {
    std::optional<clouds::CloudPiece> came;
    QString problem;  // why it cannot be loaded, as a sentence; empty = nothing is known to be wrong
  };
  /// What is drawn when the user has not chosen it.
  enum class Ground { AsAsked, WholeInstead, ScansAlone };

  void look();  // checks whether it is time for the next step; call it whenever something may have changed
  void lookAndWait();
  bool connected();
  /// For a bag: the state at its time has been applied.
  bool recalled();
  bool topicsChoosable();
  void awaitContent();
  /// Take the next step for what is drawn; false: it is decided.
  bool stepMap();
  bool stepRegion();
  void checkChosenTopics();
  void noteDrawn(const ui::shot::ScenePicture& drawn);
  void reportUnplaced();
  /// There is no map, but sensor data to show.
  bool drawsScansAlone() const;
  /// The mode is automatic, no submap list arrives, and a whole map is available.
  bool wantsWholeInstead();
  void useWholeInstead();
  void reportProgress();
  void updateStanding();
  void draw(ui::shot::EndOfWaiting why);
  void write();
  QString timeUpText() const;
  QString noConnection() const;
  /// A sentence about a lost connection, after a blank; empty while connected.
  QString whatOfTheLink() const;
  /// The requested view, or all that has been received so far.
  geometry::ViewTransform chooseView() const;
  std::unique_ptr<ui::shot::Picture> makePicture(std::shared_ptr<const ui::scene::Track> track);
  /// The cells of the whole map, if it is drawn.
  std::optional<render::PlacedGrid> wholeGrid() const;
  /// For the picture, or to compare them.
  bool needsSubmaps();
  bool wantsWholeMap() const { return options_.wantsWhole() && ground_ != Ground::ScansAlone; }
  /// Waypoints should be drawn but could not be loaded.
  bool waypointsLost() const;
  /// Overlays should be drawn but cannot be read.
  bool overlaysLost() const;
  bool isLocal() const { return session_.robot().isLocal(); }
  bool wantsTrack() const;  // of a whole bag
  bool wantsCloud() const;
  bool wantsClosures() const;
  void askForCloud(const geometry::WorldRect& seen);
  bool lacksSubmaps();  // a bag that contains no submap list up to its time: none will arrive
  /// Requests the cloud of what is drawn: the area is known.
  bool cloudIn();
  bool somethingIn() const;
  void fail(int exit_code, const QString& sentence);
  void finish(int exit_code);
  double seconds() const;
  double sinceConnected() const { return shot_.sinceConnected(seconds()); }
  /// How long to wait for a submap list if a whole map can be drawn instead.
  double listWithin() const;

  const bool automatic_;  // the user did not choose what to draw
  SnapshotOptions options_;
  std::shared_ptr<work::Workers> workers_;
  session::Session session_;
  MapRequest map_;
  ui::shot::LayerSubscription live_layers_;
  CommandStart start_;
  ui::shot::MapShot shot_;
  Ground ground_ = Ground::AsAsked;
  std::shared_ptr<Cloud> cloud_;             // null = not asked for
  replay::ReplayRobot* replayed_ = nullptr;  // null = a live robot
  std::optional<ui::shot::Recall> recall_;   // of a bag
  std::optional<RegionSnapshot> region_;
  std::optional<Choice> chosen_;
  std::unique_ptr<ui::shot::Picture> picture_;
  std::shared_ptr<SnapshotBoard> board_ = std::make_shared<SnapshotBoard>();
  QTimer timer_;
  geometry::ViewTransform view_;
  double first_paint_s_ = -1, noted_s_ = -1, note_took_s_ = 0;
  double whole_asked_s_ = 0;  // when the whole map was asked for, after connecting
  double made_ = 0;           // which share of the picture has been drawn
  QString error_;
  QString shown_instead_;
  QStringList notes_;
};

}  // namespace mapwright::app
