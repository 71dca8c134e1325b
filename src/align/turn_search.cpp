#include "align/turn_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "align/each.h"

namespace mapwright::align {
namespace {

constexpr double kFinest_m = 0.15;
constexpr std::size_t kPeaks = 5;    // of each heading
constexpr double kFreeWeight = 0.4;  // how much a wall on free ground counts against a place

/// Two pictures of one map: its walls, and what a wall of the other map is worth at each place (1 on a wall,
/// 0 where nothing is known, negative on free ground).
struct Pictures {
  cv::Mat_<float> walls, worth;
  Eigen::Vector2d centre_m;  // the world point at the centre of the pictures
};

Pictures picturesOf(const Plan& plan, double cell_m) {
  const double times = plan.resolution_m / cell_m;
  const int width = std::max(1, int(std::ceil(plan.width * times)));
  const int height = std::max(1, int(std::ceil(plan.height * times)));
  cv::Mat_<float> walls(height, width, 0.F), open(height, width, 0.F);
  for (int row = 0; row < plan.height; ++row) {
    const int y = std::min(height - 1, int((row + 0.5) * times));
    for (int column = 0; column < plan.width; ++column) {
      const Ground ground = plan.at(column, row);
      if (ground == Ground::Unknown) continue;
      const int x = std::min(width - 1, int((column + 0.5) * times));
      (ground == Ground::Wall ? walls : open)(y, x) += 1;
    }
  }
  // A straight wall through a cell counts as one, and so does free ground all over it.
  walls *= std::min(1.0, times);
  cv::min(walls, 1.0, walls);
  open *= std::min(1.0, times * times);
  cv::min(open, 1.0, open);
  Pictures out;
  // Full on a wall and less beside it: a post is worth as much as a cell of a long wall.
  constexpr double kBeside = 0.6, kAtCorner = 0.4;
  cv::Mat_<float> beside;
  out.worth = walls.clone();
  cv::dilate(walls, beside, cv::getStructuringElement(cv::MORPH_CROSS, cv::Size(3, 3)));
  out.worth = cv::max(out.worth, kBeside * beside);
  cv::dilate(walls, beside, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(3, 3)));
  out.worth = cv::max(out.worth, kAtCorner * beside);
  cv::Mat_<float> against;
  cv::multiply(open, 1.0 - out.worth, against);
  out.worth -= kFreeWeight * against;
  out.walls = walls;
  out.centre_m = plan.corner_m + 0.5 * cell_m * Eigen::Vector2d(width, height);
  return out;
}

/// Turned about its centre, into a square picture of that size with the centre in its middle.
cv::Mat_<float> turned(const cv::Mat_<float>& picture, double by_rad, int size) {
  const double c = std::cos(by_rad), s = std::sin(by_rad);
  const double from_x = (picture.cols - 1) / 2.0, from_y = (picture.rows - 1) / 2.0, to = (size - 1) / 2.0;
  const cv::Matx23d matrix(c, -s, to - c * from_x + s * from_y, s, c, to - s * from_x - c * from_y);
  cv::Mat_<float> out;
  cv::warpAffine(picture, out, matrix, cv::Size(size, size), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return out;
}

}  // namespace

RoughSearch roughPlaces(const Plan& old_map, const Plan& new_map, const Thoroughness& how, work::Tasks& tasks,
                        const std::function<bool(double)>& proceed) {
  RoughSearch out;
  const double side_m =
      std::max({old_map.width * old_map.resolution_m, old_map.height * old_map.resolution_m,
                new_map.width * new_map.resolution_m, new_map.height * new_map.resolution_m});
  if (!(side_m > 0)) return out;
  out.cell_m = std::max({kFinest_m, side_m / how.cells, old_map.resolution_m, new_map.resolution_m});
  const Pictures of_old = picturesOf(old_map, out.cell_m), of_new = picturesOf(new_map, out.cell_m);
  const double old_radius = std::hypot(of_old.walls.cols, of_old.walls.rows) / 2;
  const double new_radius = std::hypot(of_new.walls.cols, of_new.walls.rows) / 2;
  // Where the maps overlap enough to be aligned, shifts are so small that nothing comes round the edge.
  const int size = cv::getOptimalDFTSize(
      int(std::ceil(std::max(1.5 * (old_radius + new_radius), 2 * std::max(old_radius, new_radius)))) + 4);
  const double step = std::clamp(1.5 / std::max(1.0, std::min(old_radius, new_radius)), 0.013, 0.09);
  const int steps = int(std::ceil(2 * std::numbers::pi / step));
  out.step_rad = 2 * std::numbers::pi / steps;

  cv::Mat_<float> new_walls, new_worth;
  cv::dft(turned(of_new.walls, 0, size), new_walls);
  cv::dft(turned(of_new.worth, 0, size), new_worth);

  std::vector<std::vector<RoughPlace>> of_step;
  of_step.resize(std::size_t(steps));
  constexpr int kBatch = 16;
  for (int first = 0; first < steps; first += kBatch) {
    if (proceed && !proceed(double(first) / steps)) return {};
    each(tasks, std::min(kBatch, steps - first), [&](int i) {
      const double yaw = geometry::normalizeAngle((first + i) * out.step_rad);
      cv::Mat_<float> walls, worth, sum, part;
      cv::dft(turned(of_old.walls, yaw, size), walls);
      cv::dft(turned(of_old.worth, yaw, size), worth);
      cv::mulSpectrums(new_worth, walls, sum, 0, true);
      cv::mulSpectrums(new_walls, worth, part, 0, true);
      sum += part;
      cv::dft(sum, sum, cv::DFT_INVERSE | cv::DFT_SCALE);
      std::vector<RoughPlace>& found = of_step[std::size_t(first + i)];
      for (std::size_t peak = 0; peak < kPeaks; ++peak) {
        double value = 0;
        cv::Point at;
        cv::minMaxLoc(sum, nullptr, &value, nullptr, &at);
        if (!(value > 0)) break;
        // Beyond half of the picture: a shift to the other side.
        const double dx = at.x > size / 2 ? at.x - size : at.x, dy = at.y > size / 2 ? at.y - size : at.y;
        const Eigen::Vector2d shift = of_new.centre_m + out.cell_m * Eigen::Vector2d(dx, dy) -
                                      geometry::Pose2{0, 0, yaw}.apply(of_old.centre_m);
        found.push_back({{shift.x(), shift.y(), yaw}, value});
        cv::rectangle(sum, cv::Rect(at.x - 2, at.y - 2, 5, 5) & cv::Rect(0, 0, size, size), cv::Scalar(0),
                      cv::FILLED);
      }
    });
  }

  std::vector<RoughPlace> all;
  for (const auto& found : of_step) all.insert(all.end(), found.begin(), found.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const RoughPlace& a, const RoughPlace& b) { return a.correlation > b.correlation; });
  const Eigen::Vector2d middle = of_old.centre_m;
  for (const RoughPlace& place : all) {
    if (out.places.size() == how.most) break;
    const bool close = std::any_of(out.places.begin(), out.places.end(), [&](const RoughPlace& better) {
      return (better.transform.apply(middle) - place.transform.apply(middle)).norm() < 2.5 * out.cell_m &&
             std::abs(geometry::normalizeAngle(better.transform.yaw_rad - place.transform.yaw_rad)) <
                 2.5 * out.step_rad;
    });
    if (!close) out.places.push_back(place);
  }
  return out;
}

}  // namespace mapwright::align
