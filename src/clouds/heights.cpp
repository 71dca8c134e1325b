#include "clouds/heights.h"

#include <algorithm>
#include <cmath>

#include "clouds/draw_cloud.h"
#include "clouds/walk.h"

namespace mapwright::clouds {
namespace {

/// Calls `point(z)` for every point that is shown, or one in so many.
template <class Visit>
void eachHeight(const CloudSet& set, std::uint64_t one_of, Visit visit) {
  const HeightRange all;
  std::uint64_t passed = 0;
  for (const ShownCloud& cloud : set.clouds) {
    const Meant meant(*cloud.tree, cloud.hidden, all);
    const auto points = cloud.tree->points();
    const double base = cloud.tree->origin().z();
    const auto one = [&](std::uint32_t i) {
      if (passed++ % one_of == 0) visit(base + double(points[i].z()));
    };
    walk(
        *cloud.tree, [&](const CloudNode& node) { return meant.of(node); },
        [&](const CloudNode& node) {
          for (std::uint32_t i = node.first; i < node.first + node.count; ++i) one(i);
        },
        [&](std::uint32_t i) {
          if (meant.has(points[i])) one(i);
        });
  }
}

}  // namespace

Heights heightsOf(const CloudSet& set, int bins) {
  Heights heights;
  heights.points = countShown(set, {});
  bins = std::clamp(bins, 1, 4096);
  if (heights.points == 0) return heights;
  constexpr std::uint64_t kSample = 200'000;
  std::vector<double> sample;
  const std::uint64_t one_of = std::max<std::uint64_t>(1, heights.points / kSample);
  eachHeight(set, one_of, [&](double z) { sample.push_back(z); });
  std::sort(sample.begin(), sample.end());
  heights.usual_low_m = sample[sample.size() / 1000];
  heights.usual_high_m = sample[sample.size() - 1 - sample.size() / 1000];
  heights.low_m = sample.front();
  heights.high_m = sample.back();
  heights.bins.resize(std::size_t(bins));
  const double width = heights.usual_high_m - heights.usual_low_m;
  eachHeight(set, 1, [&](double z) {
    heights.low_m = std::min(heights.low_m, z);
    heights.high_m = std::max(heights.high_m, z);
    const double part = width > 0 ? (z - heights.usual_low_m) / width : 0.5;
    ++heights.bins[std::size_t(std::clamp(part * bins, 0.0, double(bins - 1)))];
  });
  return heights;
}

}  // namespace mapwright::clouds
