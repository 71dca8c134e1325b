// What of the edited overlays is drawn on the map, and which of them is at a point.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <vector>

#include <QObject>

#include "edit/overlays/overlay_editing.h"
#include "overlays/overlay_shapes.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/map_scene.h"

namespace mapwright::ui {

/// While more of them are moved at once, the scene draws only the others, and the tool marks these.
inline constexpr std::size_t kMostDrawnInHand = 100;

class OverlaysOnMap : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  OverlaysOnMap(edit::OverlayEditing* editing, scene::MapScene* scene, QObject* parent = nullptr);

  /// Whose overlays they are. `robots`: the robot is in that map.
  void setMap(const map::MapKey& map, bool robots);
  /// The topmost one.
  std::optional<FeatureKey> at(const Eigen::Vector2d& world_m, double reach_px) const;
  /// What is drawn of it, in world metres; null: nothing.
  const std::vector<map::OverlayFeature>* partsOf(FeatureKey key) const;
  geometry::WorldRect boundsOf(const std::set<FeatureKey>& keys) const;
  /// The same of all.
  void eachShape(const std::function<void(FeatureKey, const std::vector<overlays::Path>& paths)>& with) const;
  /// Those that lie in a rectangle of the viewport completely.
  std::set<FeatureKey> within(const QRectF& frame_px) const;

 private:
  struct Drawn {
    std::optional<Feature> feature;  // nullopt: it is not there
    std::vector<map::OverlayFeature> parts;
    std::size_t first = 0;  // of its parts among all
  };
  void draw();
  /// False: it has another number of parts now.
  bool updateDrawn(FeatureKey key);
  void drawPreview();
  void drawLifted();

  edit::OverlayEditing* editing_;
  scene::MapScene* scene_;
  map::MapKey map_;
  bool robots_ = false;
  std::vector<Drawn> drawn_;              // by key; kept while its feature is the same
  std::vector<FeatureKey> keys_;          // of what the scene has
  scene::DrawnOverlays all_;              // what it has
  std::set<FeatureKey> of_preview_ = {};  // that are drawn as they would be
  bool lifted_ = false;                   // the scene has none of them: there are too many to draw all anew
};

}  // namespace mapwright::ui
