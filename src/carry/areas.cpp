#include "carry/areas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mapwright::carry {

struct Areas::Labels {
  Eigen::Vector2d corner_m;
  double resolution_m = 0;
  cv::Mat_<int> cells;
  int reach = 0;
};

Areas::Areas(const align::Plan& plan, double radius_m) {
  cv::setNumThreads(1);  // the program's own pool keeps the processors busy
  auto labels = std::make_unique<Labels>(Labels{plan.corner_m, plan.resolution_m, {}, 0});
  cv::Mat_<std::uint8_t> open(plan.height, plan.width, std::uint8_t(255));
  cv::Mat_<std::uint8_t> free(plan.height, plan.width, std::uint8_t(0));
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (plan.cells[i] == align::Ground::Wall) open.data[i] = 0;
    if (plan.cells[i] == align::Ground::Free) free.data[i] = 255;
  }
  if (!plan.cells.empty()) {
    cv::Mat_<float> distance;
    cv::distanceTransform(open, distance, cv::DIST_L2, cv::DIST_MASK_5);
    const cv::Mat drivable = (distance * plan.resolution_m > radius_m) & (free > 0);
    cv::connectedComponents(drivable, labels->cells, 8, CV_32S);
    labels->reach = int(std::ceil((radius_m + 0.5) / plan.resolution_m));
  }
  labels_ = std::move(labels);
}
Areas::Areas(Areas&&) noexcept = default;
Areas::~Areas() = default;

int Areas::at(const Eigen::Vector2d& world_m) const {
  const cv::Mat_<int>& cells = labels_->cells;
  if (cells.empty()) return 0;
  const Eigen::Vector2d cell = (world_m - labels_->corner_m) / labels_->resolution_m;
  if (!(std::abs(cell.x()) < 1e8 && std::abs(cell.y()) < 1e8)) return 0;
  const int column = int(std::floor(cell.x())), row = int(std::floor(cell.y())), reach = labels_->reach;
  int best = 0, best_square = (reach + 1) * (reach + 1);
  for (int y = std::max(row - reach, 0); y <= std::min(row + reach, cells.rows - 1); ++y) {
    for (int x = std::max(column - reach, 0); x <= std::min(column + reach, cells.cols - 1); ++x) {
      const int square = (x - column) * (x - column) + (y - row) * (y - row);
      if (square < best_square && cells(y, x) != 0) best = cells(y, x), best_square = square;
    }
  }
  return best;
}

}  // namespace mapwright::carry
