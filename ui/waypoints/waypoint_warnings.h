// What is doubtful about the waypoints of the open list, on the map under them: follows both, and looks anew
// at what changed alone, on the crew. GUI thread.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <QObject>

#include "geometry/rect.h"
#include "placing/names.h"
#include "placing/warnings.h"
#include "ui/waypoints/waypoint_editing.h"
#include "work/workers.h"

namespace mapwright::window {

class WaypointWarnings : public QObject {
  Q_OBJECT
 public:
  /// `editing` must outlive this.
  WaypointWarnings(WaypointEditing* editing, std::shared_ptr<work::Workers> workers,
                   QObject* parent = nullptr);
  ~WaypointWarnings() override;

  /// What lies under them; without cells nothing does.
  void setMap(const placing::PlacedMap& map);
  /// Some of its cells have become others.
  void cellsChanged(const geometry::WorldRect& where);
  /// Walls that are closer are warned of; 0 = of none.
  void setRadius(double radius_m);
  double radius() const { return radius_m_; }
  /// Those that are kept with a quaternion of zero; one that has been turned since has another.
  void setZeroTurns(std::set<edit::Key> keys);

  /// The gravest first; empty = there are none, or it has not been looked at yet.
  const placing::Warnings& of(const edit::Key& key) const;
  std::size_t count() const { return all_.size(); }  // of waypoints
  /// The one with a warning that comes after `key` in the order of keys, and round again; empty = there is
  /// none.
  edit::Key next(const edit::Key& key) const;
  placing::GroundState ground() const { return ground_; }
  bool looking() const { return groups_left_ > 0 || !waiting_.empty() || preview_waits_; }

 Q_SIGNALS:
  /// Of these they may be others now; comes with no key when only ground() is another one.
  void changed(const std::vector<std::string>& keys);

 private:
  void begin();
  void take(const edit::DocumentChange& change);
  void takePreview();
  void lookSoon();
  void look();
  struct Asked {
    std::vector<edit::Key> keys;
    std::vector<Eigen::Vector2d> places_m;  // of keys
  };
  void takeGround(const Asked& asked, const placing::GroundWarnings& found);
  void endLook();
  void everythingAnew();
  /// What holds of it now; true when that is another thing than before.
  bool settle(const edit::Key& key);
  void tell(const std::set<std::string>& keys);

  WaypointEditing* editing_;
  placing::PlacedMap map_;
  double radius_m_ = 0;
  std::set<edit::Key> zero_turns_;
  placing::NameBook names_;
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

}  // namespace mapwright::window
