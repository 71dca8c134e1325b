// What is drawn over the map besides the overlays themselves: what two versions differ in, the way of a
// robot. GUI thread.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <QIcon>
#include <QObject>

#include "edit/overlays/overlay_editing.h"
#include "overlays/overlay_document.h"
#include "overlays/overlay_merge.h"
#include "overlays/overlay_reach.h"
#include "ui/scene/drawn_waypoint.h"
#include "ui/scene/map_scene.h"

namespace mapwright::ui::scene {
struct MapTheme;
}

namespace mapwright::ui {

struct OverlayMark {
  enum class Kind { Added, Removed, Before, After, Way, Blocked, BlockedWay, State };
  Kind kind = Kind::Added;
  overlays::Shape shape = overlays::Shape::Point;
  std::vector<Eigen::Vector2d> points;  // world metres; a polygon's are closed by drawing
  scene::WaypointMark state = scene::WaypointMark::Unsaved;  // of State
};

/// What changed, where it lies: of one that changed both what it was and what it is.
std::vector<OverlayMark> marksOf(const overlays::OverlayChange& change,
                                 const overlays::OverlayDocument& before,
                                 const overlays::OverlayDocument& after);
/// As far as it is open, where it is blocked, and on from there.
std::vector<OverlayMark> marksOf(const overlays::Way& way);
/// Of those that are unsaved, in conflict or changed on the robot, with the shapes that waypoints have.
std::vector<OverlayMark> stateMarksOf(const overlays::EditingDocument& document);
/// A sample of what a change looks like on the map.
QIcon markSample(overlays::ChangeKind kind, const scene::MapTheme& theme);

class OverlayMarks : public QObject {
  Q_OBJECT
 public:
  /// `scene` must outlive this.
  explicit OverlayMarks(scene::MapScene* scene, QObject* parent = nullptr);
  ~OverlayMarks() override;

  void show(std::vector<OverlayMark> marks);
  const std::vector<OverlayMark>& shown() const;

 private:
  class Item;
  scene::MapScene* scene_;
  std::unique_ptr<Item> item_;
};

}  // namespace mapwright::ui
