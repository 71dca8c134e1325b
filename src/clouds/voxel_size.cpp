#include "clouds/voxel_size.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mapwright::clouds {

double voxelSize(const CloudTree& tree) {
  constexpr std::size_t kSample = 60'000;
  constexpr double kLeastM = 1e-3;  // closer points are the same within float precision
  const auto points = tree.points();
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSample);
  std::map<std::int64_t, std::size_t> gaps;  // tenths of millimetres
  std::size_t all = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> places;
    for (std::size_t i = 0; i < points.size(); i += step) places.push_back(points[i][axis]);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double gap = double(places[i]) - double(places[i - 1]);
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
