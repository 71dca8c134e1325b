#include "ui/view/hit_list.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace mapwright::ui {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Entry = std::pair<Point, std::string>;
constexpr std::size_t kNodeSize = 16;
using Rtree = bg::index::rtree<Entry, bg::index::quadratic<kNodeSize>>;

}  // namespace

struct PointIndex::Tree {
  Rtree tree;
  std::unordered_map<std::string, Point> places;
};

PointIndex::PointIndex() : tree_(std::make_unique<Tree>()) {}
PointIndex::~PointIndex() = default;

void PointIndex::clear() {
  tree_->tree.clear();
  tree_->places.clear();
}

void PointIndex::reset(const std::vector<std::pair<std::string, Eigen::Vector2d>>& points) {
  clear();
  std::vector<Entry> entries;
  entries.reserve(points.size());
  tree_->places.reserve(points.size());
  for (const auto& [key, world_m] : points) {
    if (!world_m.allFinite()) continue;
    const Point point(world_m.x(), world_m.y());
    if (tree_->places.emplace(key, point).second) entries.push_back({point, key});
  }
  tree_->tree = Rtree(entries);  // packed at once
}

void PointIndex::put(const std::string& key, const Eigen::Vector2d& world_m) {
  const auto known = tree_->places.find(key);
  if (known != tree_->places.end() && known->second.x() == world_m.x() && known->second.y() == world_m.y())
    return;
  remove(key);
  if (!world_m.allFinite()) return;
  const Point point(world_m.x(), world_m.y());
  tree_->places.emplace(key, point);
  tree_->tree.insert({point, key});
}

void PointIndex::remove(const std::string& key) {
  const auto known = tree_->places.find(key);
  if (known == tree_->places.end()) return;
  tree_->tree.remove({known->second, key});
  tree_->places.erase(known);
}

std::size_t PointIndex::size() const { return tree_->places.size(); }

void PointIndex::within(
    const geometry::WorldRect& area,
    const std::function<void(const std::string& key, const Eigen::Vector2d& world_m)>& found) const {
  const bg::model::box<Point> box(Point(area.min_x, area.min_y), Point(area.max_x, area.max_y));
  for (auto it = tree_->tree.qbegin(bg::index::intersects(box)); it != tree_->tree.qend(); ++it)
    found(it->second, {it->first.x(), it->first.y()});
}

std::vector<Hit> HitList::at(const Eigen::Vector2d& world_m, double reach_px) const {
  std::vector<Hit> hits;
  const double scale = scene_.view().scale_m_per_px, reach_m = reach_px * scale;
  const geometry::WorldRect area =
      geometry::WorldRect{world_m.x(), world_m.y(), world_m.x(), world_m.y()}.grown(reach_m);
  for (const Source& source : sources_) {
    if (!scene_.layerVisible(source.layer)) continue;
    source.points->within(area, [&](const std::string& key, const Eigen::Vector2d& at) {
      const double distance_m = (at - world_m).norm();
      if (distance_m <= reach_m) hits.push_back({source.layer, key, at, distance_m / scale});
    });
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tie(a.distance_px, a.key) < std::tie(b.distance_px, b.key);
  });
  return hits;
}

void HitList::within(const geometry::WorldRect& area, const std::function<void(const Hit&)>& found) const {
  if (area.empty()) return;
  for (const Source& source : sources_) {
    if (!scene_.layerVisible(source.layer)) continue;
    source.points->within(area, [&](const std::string& key, const Eigen::Vector2d& at) {
      found({source.layer, key, at, 0});
    });
  }
}

}  // namespace mapwright::ui
