// Finds the objects under the cursor on all layers, nearest first.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geometry/rect.h"
#include "ui/scene/layer.h"
#include "ui/scene/map_scene.h"

namespace mapwright::ui {

/// Points in the world by key, in an R-tree, so that the size of the map does not matter.
class PointIndex {
 public:
  PointIndex();
  ~PointIndex();
  void clear();
  /// Replaces all points, much faster than one by one; non-finite ones are skipped.
  void reset(const std::vector<std::pair<std::string, Eigen::Vector2d>>& points);
  /// Adds or moves. A non-finite position removes the key.
  void put(const std::string& key, const Eigen::Vector2d& world_m);
  void remove(const std::string& key);
  std::size_t size() const;
  void within(const geometry::WorldRect& area,
              const std::function<void(const std::string& key, const Eigen::Vector2d& world_m)>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

struct Hit {
  scene::Layer layer;
  std::string key;
  Eigen::Vector2d world_m{0, 0};
  double distance_px = 0;
};

class HitList {
 public:
  /// `scene` must outlive this.
  explicit HitList(const scene::MapScene& scene) : scene_(scene) {}
  /// The objects of a layer that can be hit while it is shown. Not owned; must outlive this.
  void add(scene::Layer layer, const PointIndex* points) { sources_.push_back({layer, points}); }
  /// All within `reach_px`, nearest first.
  std::vector<Hit> at(const Eigen::Vector2d& world_m, double reach_px) const;
  /// All in a rectangle, in no particular order, with distance 0.
  void within(const geometry::WorldRect& area, const std::function<void(const Hit&)>& found) const;

 private:
  struct Source {
    scene::Layer layer;
    const PointIndex* points;
  };
  const scene::MapScene& scene_;
  std::vector<Source> sources_;
};

}  // namespace mapwright::ui
