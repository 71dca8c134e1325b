#include "map/map_part.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mapwright::map {
namespace {

constexpr double kFarthestProjectionM = 1e7;
constexpr double kGridStepM = 0.25;  // a cell or two of any grid

bool isAlike(const Projection& a, const Projection& b) {
  return (a.corner_m - b.corner_m).cwiseAbs().maxCoeff() <= kGridStepM &&
         (a.size_m - b.size_m).cwiseAbs().maxCoeff() <= kGridStepM &&
         std::abs(a.min_z_m - b.min_z_m) <= kGridStepM && std::abs(a.max_z_m - b.max_z_m) <= kGridStepM;
}

}  // namespace

ProjectionFlaw flawOf(const Projection& projection) {
  const std::array numbers{projection.corner_m.x(), projection.corner_m.y(), projection.size_m.x(),
                           projection.size_m.y(),   projection.min_z_m,      projection.max_z_m};
  for (const double number : numbers) {
    if (!std::isfinite(number)) return ProjectionFlaw::NotFinite;
    if (std::abs(number) > kFarthestProjectionM) return ProjectionFlaw::TooFar;
  }
  if (!(projection.size_m.x() > 0) || !(projection.size_m.y() > 0)) return ProjectionFlaw::WithoutSize;
  if (!(projection.min_z_m < projection.max_z_m)) return ProjectionFlaw::HeightsCrossed;
  return ProjectionFlaw::None;
}

int differing(const std::vector<Projection>& wanted, const std::vector<Projection>& told) {
  int count = 0;
  for (std::size_t i = 0; i < std::max(wanted.size(), told.size()); ++i) {
    if (i >= wanted.size() || i >= told.size() || !isAlike(wanted[i], told[i])) ++count;
  }
  return count;
}

}  // namespace mapwright::map
