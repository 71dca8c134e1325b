// Warnings about the waypoints of the open list, on the map under them: follows both, and checks only what
// has changed, on the thread pool. GUI thread.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <QObject>

#include "geometry/rect.h"
#include "placing/warnings.h"
#include "ui/waypoints/waypoint_editing.h"
#include "work/workers.h"

namespace mapwright::ui {

class WaypointWarnings : public QObject {
  Q_OBJECT
 public:
  /// `editing` must outlive this.
  WaypointWarnings(WaypointEditing* editing, std::shared_ptr<work::Workers> workers,
                   QObject* parent = nullptr);
  ~WaypointWarnings() override;

  /// The map under them; without cells there is none.
  void setMap(const placing::PlacedMap& map);
  /// Some of its cells have changed.
  void cellsChanged(const geometry::WorldRect& where);
  /// Warns of walls that are closer; 0 = of none.
  void setRadius(double radius_m);
  double radius() const { return radius_m_; }
  /// Those stored with a zero quaternion, unless they have been turned since.
  void setZeroTurns(std::set<edit::Key> keys);

  /// Most severe first; empty = none, or not checked yet.
  const placing::Warnings& of(const edit::Key& key) const;
  std::size_t count() const { return all_.size(); }  // of waypoints
  /// The next one with a warning after `key`, starting over at the end; empty = there is none.
  edit::Key next(const edit::Key& key) const;
  placing::GroundState ground() const { return ground_; }
  bool looking() const { return groups_left_ > 0 || !waiting_.empty() || preview_waits_; }

 Q_SIGNALS:
  /// Those of these may have changed; without keys only ground() has.
  void changed(const std::vector<std::string>& keys);

 private:
  void begin();
  void onChanged(const edit::DocumentChange& change);
  void onPreview();
  void lookSoon();
  void look();
  struct Batch {
    std::vector<edit::Key> keys;
    std::vector<Eigen::Vector2d> places_m;  // of keys
  };
  void onGround(const Batch& batch, const placing::GroundWarnings& found);
  void endLook();
  void everythingAnew();
  /// Looks for names that several have; adds to `touched` the waypoints for which that has changed.
  void lookForNames(std::set<std::string>& touched);
  /// Updates those of one waypoint; true if they have changed.
  bool settle(const edit::Key& key);
  void emitChanged(const std::set<std::string>& keys);

  WaypointEditing* editing_;
  placing::PlacedMap map_;
  double radius_m_ = 0;
  std::set<edit::Key> zero_turns_;
  std::set<std::string> twice_;  // names that several have
  placing::GroundState ground_ = placing::GroundState::None;
  std::unordered_map<edit::Key, placing::Warnings> of_ground_;  // where there are any
  std::map<edit::Key, placing::Warnings> all_;                  // likewise
  std::set<edit::Key> waiting_;                                 // to be looked at
  std::vector<edit::Key> previewed_;                            // what a hand moves
  bool preview_waits_ = false;                                  // and where it has moved it to
  std::size_t groups_left_ = 0;                                 // that are being looked at
  bool soon_ = false, other_ground_ = false;
  std::set<std::string> touched_;  // by the groups that are in
  quint64 state_ = 0;  // counts maps, radii and lists: what was looked at in another one is worth nothing
  std::shared_ptr<std::atomic<bool>> cancelled_;
  work::Tasks share_;
};

}  // namespace mapwright::ui
