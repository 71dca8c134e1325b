#include "compare/comparison.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <climits>
#include <opencv2/imgproc.hpp>

#include "compare/faults.h"
#include "compare/picture_reading.h"
#include "grids/png_header.h"
#include "words/figures.h"

namespace mapwright::compare {
namespace {

using grids::Argb;

Fault notRead(const std::string& path, Fault why) {
  return {fault::PictureNotRead, {path}, {std::move(why)}};
}

std::string textOf(PictureSize size) { return words::dimensions(size.width, size.height); }

/// The greatest difference of a channel, from 0 to 255. Less than one is one.
int differenceOf(grids::DeepArgb a, grids::DeepArgb b) {
  if (a == b) return 0;
  int most = 0;
  for (const int shift : {0, 16, 32, 48})
    most = std::max(most, std::abs(int(a >> shift & 0xffff) - int(b >> shift & 0xffff)));
  return (most + 256) / 257;
}

int grayOf(Argb colour) {
  if (colour >> 24 == 0) return 0;
  return int((colour >> 16 & 0xff) * 299 + (colour >> 8 & 0xff) * 587 + (colour & 0xff) * 114 + 500) / 1000;
}

/// Which groups (labels of `groups`) are dense.
std::vector<bool> denseGroups(const cv::Mat& differs, const cv::Mat& groups, int count) {
  std::vector<bool> dense(std::size_t(count), false);
  cv::Mat filled;
  cv::boxFilter(differs, filled, -1, {kDenseEdge, kDenseEdge}, {-1, -1}, false, cv::BORDER_CONSTANT);
  for (int y = 0; y < filled.rows; ++y) {
    const std::uint8_t* const row = filled.ptr(y);
    const int* const group = groups.ptr<int>(y);
    for (int x = 0; x < filled.cols; ++x) {
      if (2 * row[x] >= kDenseEdge * kDenseEdge) dense[std::size_t(group[x])] = true;
    }
  }
  cv::Mat pieces, stats, centroids;
  const int piece_count = cv::connectedComponentsWithStats(differs, pieces, stats, centroids, 8, CV_32S);
  for (int piece = 1; piece < piece_count; ++piece) {
    if (stats.at<int>(piece, cv::CC_STAT_AREA) < kDensePixels) continue;
    const int y = stats.at<int>(piece, cv::CC_STAT_TOP);
    const int* const row = pieces.ptr<int>(y);
    const int x = int(std::find(row, row + pieces.cols, piece) - row);
    dense[std::size_t(groups.at<int>(y, x))] = true;
  }
  dense[0] = false;
  return dense;
}

/// Gathers what differs within `within`.
void gather(Comparison& made, const PixelBox& within) {
  cv::setNumThreads(1);
  const cv::Mat all(made.canvas.height, made.canvas.width, CV_8U, made.differs.data());
  const cv::Mat differs = all({within.x, within.y, within.width, within.height});
  cv::Mat near, groups, stats, centroids;
  cv::dilate(differs, near, cv::Mat::ones(kNearPx + 1, kNearPx + 1, CV_8U));
  const int count = cv::connectedComponentsWithStats(near, groups, stats, centroids, 8, CV_32S);
  near.release();
  struct Extent {
    int left = INT_MAX, top = INT_MAX, right = -1, bottom = -1;
    std::int64_t pixels = 0;
  };
  std::vector<Extent> extents{std::size_t(count)};
  for (int y = 0; y < differs.rows; ++y) {
    const std::uint8_t* const row = differs.ptr(y);
    const int* const group = groups.ptr<int>(y);
    for (int x = 0; x < differs.cols; ++x) {
      if (row[x] == 0) continue;
      Extent& extent = extents[std::size_t(group[x])];
      extent.left = std::min(extent.left, x);
      extent.right = std::max(extent.right, x);
      extent.top = std::min(extent.top, y);
      extent.bottom = y;
      ++extent.pixels;
    }
  }
  const std::vector<bool> dense = denseGroups(differs, groups, count);
  for (int group = 1; group < count; ++group) {
    const Extent& extent = extents[std::size_t(group)];
    made.clusters.push_back({{within.x + extent.left, within.y + extent.top, extent.right - extent.left + 1,
                              extent.bottom - extent.top + 1},
                             extent.pixels,
                             dense[std::size_t(group)]});
    if (dense[std::size_t(group)]) ++made.clusters_dense;
  }
  made.clusters_in_all = std::int64_t(made.clusters.size());
  std::stable_sort(made.clusters.begin(), made.clusters.end(),
                   [](const Cluster& a, const Cluster& b) { return a.pixels > b.pixels; });
  if (made.clusters.size() > kMostClusters) made.clusters.resize(kMostClusters);
}

}  // namespace

PictureReading::PictureReading(std::string path, std::unique_ptr<grids::PictureRows> rows)
    : path_(std::move(path)), rows_(std::move(rows)), colours_(rows_->format()) {}

tl::expected<PictureReading, Fault> PictureReading::open(const std::string& path) {
  auto bytes = grids::ByteSource::open(path);
  if (!bytes) return tl::make_unexpected(notRead(path, fault::said(std::strerror(errno))));
  // Those that begin alike would be called the same.
  if (const auto png = grids::readPngHeader(*bytes); png && png->animated)
    return tl::make_unexpected(notRead(path, fault::PictureAnimated));
  auto rows = grids::openPicture(std::move(*bytes));
  if (!rows) return tl::make_unexpected(notRead(path, std::move(rows.error())));
  PictureReading reading(path, std::move(*rows));
  if (reading.size().pixels() > kMostPixels) {
    return tl::make_unexpected(
        notRead(path, {fault::PictureTooLarge, {textOf(reading.size()), words::grouped(kMostPixels)}}));
  }
  return reading;
}

bool PictureReading::endsWell() {
  rows_->checkEnd();
  return !rows_->problem().any();
}

Fault PictureReading::problem() const {
  return notRead(
      path_, came_ < size().height
                 ? Fault(fault::PictureEndsEarly, {words::grouped(came_), textOf(size())}, {rows_->problem()})
                 : rows_->problem());
}

double Comparison::percent() const {
  const PictureSize both{std::max(expected.width, actual.width), std::max(expected.height, actual.height)};
  return 100.0 * double(differing) / double(std::max<std::int64_t>(1, both.pixels()));
}

tl::expected<Comparison, Fault> comparePictures(const std::string& expected, const std::string& actual,
                                                const Allowed& allowed) {
  auto first = PictureReading::open(expected);
  if (!first) return tl::make_unexpected(std::move(first.error()));
  auto second = PictureReading::open(actual);
  if (!second) return tl::make_unexpected(std::move(second.error()));
  std::optional<PictureReading> mask;
  if (!allowed.mask.empty()) {
    auto opened = PictureReading::open(allowed.mask);
    if (!opened) return tl::make_unexpected(std::move(opened.error()));
    if (opened->size() != first->size()) {
      return tl::make_unexpected(
          Fault(fault::MaskOfOtherSize, {allowed.mask, textOf(opened->size()), textOf(first->size())}));
    }
    mask.emplace(std::move(*opened));
  }
  Comparison made;
  made.expected = first->size();
  made.actual = second->size();
  const PictureSize both{std::max(made.expected.width, made.actual.width),
                         std::max(made.expected.height, made.actual.height)};
  made.canvas = both.pixels() <= kMostPixels ? both : made.actual;
  int left = both.width, right = -1, top = -1, bottom = -1;
  const auto markDiffering = [&](int x, int y) {
    ++made.differing;
    if (x >= made.canvas.width || y >= made.canvas.height) return;
    if (made.differs.empty()) made.differs.resize(std::size_t(made.canvas.pixels()));
    made.differs[std::size_t(y) * std::size_t(made.canvas.width) + std::size_t(x)] = 1;
    left = std::min(left, x);
    right = std::max(right, x);
    if (top < 0) top = y;
    bottom = y;
  };
  for (int y = 0; y < both.height; ++y) {
    const bool in_expected = y < made.expected.height, in_actual = y < made.actual.height;
    const grids::DeepArgb* const a = in_expected ? first->nextDeep() : nullptr;
    if (a == nullptr && in_expected) return tl::make_unexpected(first->problem());
    const grids::DeepArgb* const b = in_actual ? second->nextDeep() : nullptr;
    if (b == nullptr && in_actual) return tl::make_unexpected(second->problem());
    const Argb* const allows = mask && in_expected ? mask->next() : nullptr;
    if (allows == nullptr && mask && in_expected) return tl::make_unexpected(mask->problem());
    const int expected_width = in_expected ? made.expected.width : 0;
    const int actual_width = in_actual ? made.actual.width : 0;
    const int common = std::min(expected_width, actual_width);
    for (int x = 0; x < common; ++x) {
      const int difference = differenceOf(a[x], b[x]);
      if (difference == 0) continue;
      const int masked = allows == nullptr ? 0 : grayOf(allows[x]);
      if (difference > masked) made.max = std::max(made.max, difference);
      if (difference > std::max(allowed.tolerance, masked)) markDiffering(x, y);
    }
    for (int x = common; x < std::max(expected_width, actual_width); ++x) markDiffering(x, y);
  }
  for (PictureReading* const reading : {&*first, &*second}) {
    if (!reading->endsWell()) return tl::make_unexpected(reading->problem());
  }
  if (right >= 0) gather(made, {left, top, right - left + 1, bottom - top + 1});
  made.equal =
      made.sameSize() && !(made.percent() > allowed.max_differing_percent) && made.clusters_dense == 0;
  return made;
}

}  // namespace mapwright::compare
