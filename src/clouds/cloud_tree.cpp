#include "clouds/cloud_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace mapwright::clouds {
namespace {

struct Point {
  std::array<float, 3> at;
  std::uint32_t index;
};

/// Where a cloud is split does not affect the result; queries for heights are less frequent than for
/// positions.
constexpr float kWeightOfZ = 0.25F;

class Builder {
 public:
  Builder(std::vector<Point>& points, const std::atomic<bool>* cancelled, std::vector<CloudNode>& nodes)
      : points_(points), cancelled_(cancelled), nodes_(nodes) {}

  void cut(std::uint32_t first, std::uint32_t count) {
    const std::size_t mine = nodes_.size();
    CloudNode node;
    node.first = first;
    node.count = count;
    node.min.fill(std::numeric_limits<float>::max());
    node.max.fill(std::numeric_limits<float>::lowest());
    for (std::uint32_t i = first; i < first + count; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.min[axis] = std::min(node.min[axis], points_[i].at[axis]);
        node.max[axis] = std::max(node.max[axis], points_[i].at[axis]);
      }
    }
    nodes_.push_back(node);
    if (count <= CloudTree::kLeafPoints || (cancelled_ && *cancelled_)) return;
    std::size_t axis = 0;
    float longest = 0;
    for (std::size_t each = 0; each < 3; ++each) {
      const float length = (node.max[each] - node.min[each]) * (each == 2 ? kWeightOfZ : 1.0F);
      if (length > longest) {
        longest = length;
        axis = each;
      }
    }
    if (longest <= 0) return;  // all at one point: no split is possible
    const std::uint32_t half = count / 2;
    const auto begin = points_.begin() + std::ptrdiff_t(first);
    std::nth_element(begin, begin + std::ptrdiff_t(half), begin + std::ptrdiff_t(count),
                     [axis](const Point& a, const Point& b) {
                       return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.index < b.index;
                     });
    cut(first, half);
    nodes_[mine].second = std::uint32_t(nodes_.size());
    cut(first + half, count - half);
  }

 private:
  std::vector<Point>& points_;
  const std::atomic<bool>* cancelled_;
  std::vector<CloudNode>& nodes_;
};

double medianSpacing(const std::vector<CloudNode>& nodes) {
  std::vector<double> spacings;
  for (const CloudNode& node : nodes) {
    if (node.second != 0 || node.count < 4) continue;
    const double width = double(node.max[0]) - node.min[0], height = double(node.max[1]) - node.min[1];
    // Seen from above a wall is a line: its points are along it.
    const double along = std::max(width, height) / node.count;
    spacings.push_back(std::max(along, std::sqrt(width * height / node.count)));
  }
  if (spacings.empty()) return 0;
  const auto middle = spacings.begin() + std::ptrdiff_t(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

std::array<float, 2> usualOf(const std::vector<float>& values) {
  constexpr std::size_t kSample = 100'000;
  if (values.empty()) return {0, 1};
  std::vector<float> sample;
  const std::size_t step = std::max<std::size_t>(1, values.size() / kSample);
  for (std::size_t i = 0; i < values.size(); i += step) sample.push_back(values[i]);
  std::sort(sample.begin(), sample.end());
  const float low = sample[sample.size() / 100], high = sample[sample.size() - 1 - sample.size() / 100];
  return {low, high > low ? high : low + 1};
}

}  // namespace

std::int64_t inParts(double value) {
  if (std::isnan(value)) return 0;
  return std::llround(std::clamp(value, -kMostOfSum, kMostOfSum) * kParts);
}

std::shared_ptr<const CloudTree> CloudTree::make(const map::SpatialCloud& cloud, std::uint64_t one_of,
                                                 const std::atomic<bool>* cancelled) {
  const auto made = std::make_shared<CloudTree>();
  made->frame_ = cloud.frame;
  made->origin_m_ = cloud.origin_m;
  made->has_z_ = cloud.has_z;
  one_of = std::max<std::uint64_t>(1, one_of);
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() - 1;
  const std::size_t came = std::min(cloud.points.size(), kMost);
  std::vector<Point> points;
  points.reserve(came / one_of + 1);
  for (std::size_t i = 0; i < came; i += one_of) {
    const Eigen::Vector3f& at = cloud.points[i];
    if (!at.allFinite()) continue;  // they should be finite: otherwise the tree would have no order
    points.push_back({{at.x(), at.y(), at.z()}, std::uint32_t(i)});
  }
  if (!points.empty()) {
    made->nodes_.reserve(4 * points.size() / kLeafPoints + 2);
    Builder(points, cancelled, made->nodes_).cut(0, std::uint32_t(points.size()));
  }
  if (cancelled && *cancelled) return nullptr;
  made->points_.reserve(points.size());
  for (const Point& point : points) made->points_.emplace_back(point.at[0], point.at[1], point.at[2]);
  if (cloud.intensity.size() == cloud.points.size()) {
    made->intensity_.reserve(points.size());
    for (const Point& point : points) made->intensity_.push_back(cloud.intensity[point.index]);
  }
  if (cloud.rgb.size() == cloud.points.size()) {
    made->rgb_.reserve(points.size());
    for (const Point& point : points) made->rgb_.push_back(cloud.rgb[point.index]);
  }
  // Children come after their parents.
  for (auto node = made->nodes_.rbegin(); node != made->nodes_.rend(); ++node) {
    if (node->second != 0) {
      const CloudNode& one = *(node.base());  // the next one in the forward order
      const CloudNode& two = made->nodes_[node->second];
      node->sum_z = one.sum_z + two.sum_z;
      node->sum_intensity = one.sum_intensity + two.sum_intensity;
      for (std::size_t i = 0; i < 3; ++i) node->sum_rgb[i] = one.sum_rgb[i] + two.sum_rgb[i];
      continue;
    }
    for (std::uint32_t i = node->first; i < node->first + node->count; ++i) {
      node->sum_z += inParts(double(made->points_[i].z()));
      if (made->hasIntensity()) node->sum_intensity += inParts(double(made->intensity_[i]));
      if (made->hasRgb()) {
        const std::uint32_t rgb = made->rgb_[i];
        node->sum_rgb[0] += rgb >> 16 & 255;
        node->sum_rgb[1] += rgb >> 8 & 255;
        node->sum_rgb[2] += rgb & 255;
      }
    }
  }
  made->spacing_m_ = medianSpacing(made->nodes_);
  made->usual_intensity_ = usualOf(made->intensity_);
  return made;
}

Box CloudTree::boundsOf(const CloudNode& node) const {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = origin_m_[axis] + double(node.min[std::size_t(axis)]);
    box.max[axis] = origin_m_[axis] + double(node.max[std::size_t(axis)]);
  }
  return box;
}

Box CloudTree::bounds() const { return nodes_.empty() ? Box{} : boundsOf(nodes_.front()); }

std::size_t CloudTree::bytes() const {
  return points_.capacity() * sizeof(points_[0]) + intensity_.capacity() * sizeof(float) +
         rgb_.capacity() * sizeof(std::uint32_t) + nodes_.capacity() * sizeof(CloudNode);
}

double voxelSize(const CloudTree& tree) {
  constexpr std::size_t kSample = 60'000;
  constexpr double kLeastM = 1e-3;  // closer points are the same within float precision
  const auto points = tree.points();
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSample);
  std::map<std::int64_t, std::size_t> gaps;  // tenths of millimetres
  std::size_t all = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> coordinates;
    for (std::size_t i = 0; i < points.size(); i += step) coordinates.push_back(points[i][axis]);
    std::sort(coordinates.begin(), coordinates.end());
    for (std::size_t i = 1; i < coordinates.size(); ++i) {
      const double gap = double(coordinates[i]) - double(coordinates[i - 1]);
      if (gap < kLeastM || gap > 1e3) continue;
      ++gaps[std::llround(gap * 1e4)];
      ++all;
    }
  }
  // Neighbouring tenths are the same gap. The smallest frequent one is the edge: others are multiples of it.
  for (auto gap = gaps.begin(); gap != gaps.end(); ++gap) {
    std::size_t near = 0;
    double sum = 0;
    for (auto other = gaps.lower_bound(gap->first); other != gaps.end() && other->first <= gap->first + 10;
         ++other) {
      near += other->second;
      sum += double(other->first) * double(other->second);
    }
    if (near * 5 >= all && near >= 2) {
      // Rounded to a plausible map resolution if that is within the noise.
      const double metres = sum / double(near) * 1e-4;
      const double round = std::round(metres * 200) / 200;
      return round > 0 && std::abs(round - metres) < 3e-4 ? round : metres;
    }
  }
  return 0;
}

}  // namespace mapwright::clouds
