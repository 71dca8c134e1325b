#include "align/furniture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace mapwright::align {
namespace {

/// The cells of each piece.
std::vector<std::vector<Eigen::Vector2d>> piecesOf(const Plan& plan) {
  constexpr double kSmallest_m = 0.3, kLargest_m = 2.5;
  cv::Mat_<std::uint8_t> walls(plan.height, plan.width, std::uint8_t(0));
  for (int row = 0; row < plan.height; ++row) {
    for (int column = 0; column < plan.width; ++column)
      walls(row, column) = plan.at(column, row) == Ground::Wall ? 255 : 0;
  }
  // Sides of a piece may be seen with gaps between them.
  cv::Mat_<std::uint8_t> joined;
  cv::dilate(walls, joined, cv::Mat());
  cv::Mat_<int> labels, stats;
  cv::Mat centroids;
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centroids, 8, CV_32S);
  std::vector<std::vector<Eigen::Vector2d>> pieces(std::size_t(std::max(count, 0)));
  for (int row = 0; row < plan.height; ++row) {
    for (int column = 0; column < plan.width; ++column) {
      if (walls(row, column) != 0)
        pieces[std::size_t(labels(row, column))].push_back(plan.centreOf(column, row));
    }
  }
  for (int piece = 1; piece < count; ++piece) {
    const double larger_m =
        plan.resolution_m * (std::max(stats(piece, cv::CC_STAT_WIDTH), stats(piece, cv::CC_STAT_HEIGHT)) - 2);
    if (larger_m < kSmallest_m || larger_m > kLargest_m) pieces[std::size_t(piece)].clear();
  }
  std::erase_if(pieces, [](const auto& cells) { return cells.empty(); });
  return pieces;
}

enum class Place { Unseen, Wall, Other };

/// What is within 10 cm of a place; a cell at least.
Place placeAt(const Plan& plan, const Eigen::Vector2d& at_m) {
  constexpr double kSame_m = 0.1;
  const int reach = std::max(1, int(kSame_m / plan.resolution_m + 1e-6));
  const Eigen::Vector2d cell = (at_m - plan.corner_m) / plan.resolution_m;
  if (!(cell.x() > -reach && cell.y() > -reach && cell.x() < plan.width + reach &&
        cell.y() < plan.height + reach))
    return Place::Unseen;
  const int x = int(std::floor(cell.x())), y = int(std::floor(cell.y()));
  for (int row = std::max(y - reach, 0); row <= std::min(y + reach, plan.height - 1); ++row) {
    for (int column = std::max(x - reach, 0); column <= std::min(x + reach, plan.width - 1); ++column) {
      if (plan.at(column, row) == Ground::Wall) return Place::Wall;
    }
  }
  const bool inside = x >= 0 && y >= 0 && x < plan.width && y < plan.height;
  return inside && plan.at(x, y) != Ground::Unknown ? Place::Other : Place::Unseen;
}

void count(Furniture& found, const Plan& from, const Plan& to, const geometry::Pose2& pose) {
  constexpr double kSeen = 0.9, kSame = 0.75;
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(pose.yaw_rad).toRotationMatrix();
  const Eigen::Vector2d by(pose.x_m, pose.y_m);
  for (const std::vector<Eigen::Vector2d>& cells : piecesOf(from)) {
    std::size_t seen = 0, same = 0;
    for (const Eigen::Vector2d& cell : cells) {
      const Place place = placeAt(to, turn * cell + by);
      seen += place != Place::Unseen;
      same += place == Place::Wall;
    }
    if (double(seen) < kSeen * double(cells.size())) continue;
    ++found.pieces;
    found.again += double(same) > kSame * double(cells.size());
  }
}

}  // namespace

bool Furniture::allDiffers() const { return pieces >= 20 && 20 * again <= pieces; }
bool Furniture::mostDiffers() const { return pieces >= 4 && 5 * again <= 2 * pieces; }

Furniture furnitureOf(const Plan& old_map, const Plan& new_map, const geometry::Pose2& pose) {
  Furniture found;
  count(found, old_map, new_map, pose);
  count(found, new_map, old_map, pose.inverse());
  return found;
}

}  // namespace mapwright::align
