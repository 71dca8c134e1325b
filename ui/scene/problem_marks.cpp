#include "ui/scene/problem_marks.h"

#include <algorithm>
#include <unordered_map>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace mapwright::ui::scene {
namespace {

namespace bg = boost::geometry;
using MarkPoint = bg::model::d2::point_xy<double>;
using MarkBox = bg::model::box<MarkPoint>;
using MarkEntry = std::pair<MarkBox, map::SubmapId>;
constexpr std::size_t kMarkNodeSize = 16;

MarkBox boxOf(const geometry::WorldRect& rect) {
  return {MarkPoint(rect.min_x, rect.min_y), MarkPoint(rect.max_x, rect.max_y)};
}

}  // namespace

std::array<Eigen::Vector2d, 4> gridCorners(const map::GridReference& grid) {
  const double right = grid.width, bottom = grid.height;
  return {grid.worldFromCell({0, 0}), grid.worldFromCell({right, 0}), grid.worldFromCell({right, bottom}),
          grid.worldFromCell({0, bottom})};
}

struct SubmapMarks::Index {
  bg::index::rtree<MarkEntry, bg::index::quadratic<kMarkNodeSize>> tree;
  std::unordered_map<map::SubmapId, PlacedMark> marks;
};

geometry::WorldRect PlacedMark::bounds() const {
  geometry::WorldRect bounds;
  bounds.extend(at_m);
  if (corners) {
    for (const Eigen::Vector2d& corner : *corners) bounds.extend(corner);
  }
  return bounds;
}

SubmapMarks::SubmapMarks() : index_(std::make_unique<Index>()) {}
SubmapMarks::~SubmapMarks() = default;

bool SubmapMarks::put(map::SubmapId id, const PlacedMark& mark) {
  const auto known = index_->marks.find(id);
  if (known != index_->marks.end() && known->second == mark) return false;
  remove(id);
  index_->marks.emplace(id, mark);
  index_->tree.insert({boxOf(mark.bounds()), id});
  return true;
}

bool SubmapMarks::remove(map::SubmapId id) {
  const auto known = index_->marks.find(id);
  if (known == index_->marks.end()) return false;
  index_->tree.remove({boxOf(known->second.bounds()), id});
  index_->marks.erase(known);
  return true;
}

void SubmapMarks::clear() {
  index_->tree.clear();
  index_->marks.clear();
}

std::size_t SubmapMarks::size() const { return index_->marks.size(); }

std::optional<std::vector<SubmapMarks::Entry>> SubmapMarks::within(const geometry::WorldRect& area,
                                                                   std::size_t most) const {
  std::vector<Entry> found;
  if (area.empty()) return found;
  for (auto it = index_->tree.qbegin(bg::index::intersects(boxOf(area))); it != index_->tree.qend(); ++it) {
    if (found.size() == most) return std::nullopt;
    found.emplace_back(it->second, index_->marks.at(it->second));
  }
  std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) { return a.first < b.first; });
  return found;
}

bool SubmapMarks::any(const geometry::WorldRect& area) const {
  return index_->tree.qbegin(bg::index::intersects(boxOf(area))) != index_->tree.qend();
}

}  // namespace mapwright::ui::scene
