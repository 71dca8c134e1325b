#include "align/sheet.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mapwright::align {
namespace {

constexpr double kMargin_m = 1.0;  // around the plan

/// Wall cells beside free ones; all wall cells of a map without any such.
std::vector<Eigen::Vector2d> seenWalls(const Plan& plan) {
  std::vector<Eigen::Vector2d> seen, all;
  for (int row = 0; row < plan.height; ++row) {
    for (int column = 0; column < plan.width; ++column) {
      if (plan.at(column, row) != Ground::Wall) continue;
      bool beside_free = false;
      for (int y = std::max(row - 1, 0); y <= std::min(row + 1, plan.height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, plan.width - 1); ++x) {
          beside_free = beside_free || plan.at(x, y) == Ground::Free;
        }
      }
      (beside_free ? seen : all).push_back(plan.centreOf(column, row));
    }
  }
  return seen.empty() ? all : seen;
}

}  // namespace

Sheet::Sheet(const Plan& plan)
    : resolution_m_(plan.resolution_m > 0 ? plan.resolution_m : 1), walls_(seenWalls(plan)) {
  const int margin = int(std::ceil(kMargin_m / resolution_m_)) + 1;
  corner_m_ = plan.corner_m - resolution_m_ * Eigen::Vector2d(margin, margin);
  const cv::Size size(plan.width + 2 * margin, plan.height + 2 * margin);
  cv::Mat_<std::uint8_t> open(size, 255);
  known_ = cv::Mat_<std::uint8_t>(size, 0);
  bool walls = false;
  for (int row = 0; row < plan.height; ++row) {
    for (int column = 0; column < plan.width; ++column) {
      const Ground ground = plan.at(column, row);
      if (ground == Ground::Unknown) continue;
      known_(row + margin, column + margin) = 255;
      if (ground == Ground::Wall) open(row + margin, column + margin) = 0, walls = true;
    }
  }
  if (walls) {
    cv::distanceTransform(open, distance_, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
    distance_ *= resolution_m_;
  } else {
    distance_ = cv::Mat_<float>(size, float(kMargin_m * 100));
  }
  const int reach = std::max(1, int(std::lround(kReach_m / resolution_m_)));
  cv::dilate(known_, near_,
             cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * reach + 1, 2 * reach + 1)));
}

std::vector<Eigen::Vector2d> Sheet::someWalls(std::size_t most) const {
  if (walls_.size() <= most) return walls_;
  std::vector<Eigen::Vector2d> some;
  some.reserve(most);
  for (std::size_t i = 0; i < most; ++i) some.push_back(walls_[i * walls_.size() / most]);
  return some;
}

std::optional<Sheet::Distance> Sheet::distanceAt(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d cell = cellAt(world_m) - Eigen::Vector2d(0.5, 0.5);
  const double column = std::floor(cell.x()), row = std::floor(cell.y());
  if (!(column >= 0 && row >= 0 && column + 1 < distance_.cols && row + 1 < distance_.rows))
    return std::nullopt;
  const int x = int(column), y = int(row);
  const double u = cell.x() - column, v = cell.y() - row;
  if (near_(y + (v >= 0.5), x + (u >= 0.5)) == 0) return std::nullopt;
  const double d00 = distance_(y, x), d01 = distance_(y, x + 1);
  const double d10 = distance_(y + 1, x), d11 = distance_(y + 1, x + 1);
  Distance out;
  out.metres = (d00 * (1 - u) + d01 * u) * (1 - v) + (d10 * (1 - u) + d11 * u) * v;
  // Where nothing is known a wall may be missing because nobody saw it.
  if (out.metres > kReach_m && known_(y + (v >= 0.5), x + (u >= 0.5)) == 0) return std::nullopt;
  out.slope =
      Eigen::Vector2d((d01 - d00) * (1 - v) + (d11 - d10) * v, (d10 - d00) * (1 - u) + (d11 - d01) * u) /
      resolution_m_;
  return out;
}

bool Sheet::knownAt(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d cell = cellAt(world_m);
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < known_.cols && cell.y() < known_.rows)) return false;
  return known_(int(cell.y()), int(cell.x())) != 0;
}

bool Sheet::freeAt(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d cell = cellAt(world_m);
  return knownAt(world_m) && distance_(int(cell.y()), int(cell.x())) > 0;
}

}  // namespace mapwright::align
