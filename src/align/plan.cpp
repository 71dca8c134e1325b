#include "align/plan.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mapwright::align {

Plan trimmed(const Plan& plan) {
  int left = plan.width, right = -1, low = plan.height, high = -1;
  for (int row = 0; row < plan.height; ++row) {
    for (int column = 0; column < plan.width; ++column) {
      if (plan.at(column, row) == Ground::Unknown) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      low = std::min(low, row);
      high = row;
    }
  }
  Plan out;
  out.resolution_m = plan.resolution_m;
  out.corner_m = plan.corner_m;
  if (right < 0) return out;
  out.width = right - left + 1;
  out.height = high - low + 1;
  out.corner_m += plan.resolution_m * Eigen::Vector2d(left, low);
  out.cells.reserve(std::size_t(out.width) * std::size_t(out.height));
  for (int row = low; row <= high; ++row) {
    const Ground* const from = plan.cells.data() + std::size_t(row) * std::size_t(plan.width) + left;
    out.cells.insert(out.cells.end(), from, from + out.width);
  }
  return out;
}

Plan seenOnly(Plan plan, double reach_m) {
  cv::Mat_<std::uint8_t> open(plan.height, plan.width, std::uint8_t(0));
  bool any = false;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (plan.cells[i] == Ground::Free) open.data[i] = 255, any = true;
  }
  if (!any) return plan;
  cv::setNumThreads(1);  // the program's own pool keeps the processors busy
  const int reach = std::max(1, int(std::ceil(reach_m / plan.resolution_m)));
  cv::dilate(open, open, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(2 * reach + 1, 2 * reach + 1)));
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (open.data[i] == 0 && plan.cells[i] == Ground::Wall) plan.cells[i] = Ground::Unknown;
  }
  return plan;
}

Plan coarser(const Plan& plan, int times) {
  if (times <= 1) return plan;
  Plan out;
  out.width = (plan.width + times - 1) / times;
  out.height = (plan.height + times - 1) / times;
  out.resolution_m = plan.resolution_m * times;
  out.corner_m = plan.corner_m;
  out.cells.assign(std::size_t(out.width) * std::size_t(out.height), Ground::Unknown);
  for (int row = 0; row < plan.height; ++row) {
    Ground* const to = out.cells.data() + std::size_t(row / times) * std::size_t(out.width);
    for (int column = 0; column < plan.width; ++column) {
      to[column / times] = std::max(to[column / times], plan.at(column, row));
    }
  }
  return out;
}

}  // namespace mapwright::align
