#include "picture/tidy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace mapwright::picture {

namespace {

constexpr int kBlock = 2'048;

/// A block of cells, of which a part is judged: the rest is context.
struct Block {
  CellRect core, whole;
  cv::Mat kinds;  // Kind as bytes, of `whole`
  CellRect coreInBlock() const { return core.moved(-whole.left, -whole.top); }
};

cv::Mat kindsIn(Canvas& canvas, const CellRect& rect, const std::array<Kind, 256>& kinds) {
  cv::Mat mat(rect.height(), rect.width(), CV_8U);
  for (int row = 0; row < mat.rows; ++row) {
    std::uint8_t* const cells = mat.ptr(row);
    canvas.getRow(rect.top + row, rect.left, rect.right, cells);
    std::transform(cells, cells + mat.cols, cells,
                   [&](std::uint8_t cell) { return std::uint8_t(kinds[cell]); });
  }
  return mat;
}

/// Calls judge(block, wanted) for each block: it writes the new kinds of cells into `wanted` (as large as the
/// block, initially kNothing). Those in the core are then painted.
constexpr std::uint8_t kNothing = 255;
template <typename Judge>
Tidied eachBlock(Canvas& canvas, const CellRect& within, int margin, const std::atomic<bool>* cancelled,
                 Judge judge) {
  // The thread pool already uses the processors; a second one would compete with it.
  cv::setNumThreads(1);
  Tidied tidied;
  const CellRect inside = within.intersected(canvas.all());
  const std::array<Kind, 256> kinds = kindsOf(canvas.code());
  // Judged before anything is painted: a block must not see changes in its neighbour.
  struct Found {
    int row, from, to;
    Kind kind;
  };
  std::vector<Found> found;
  for (int top = inside.top; top < inside.bottom; top += kBlock) {
    for (int left = inside.left; left < inside.right; left += kBlock) {
      if (cancelled && cancelled->load(std::memory_order_relaxed)) return {};
      Block block;
      block.core = CellRect{left, top, left + kBlock, top + kBlock}.intersected(inside);
      block.whole = block.core.grown(margin).intersected(canvas.all());
      block.kinds = kindsIn(canvas, block.whole, kinds);
      cv::Mat wanted(block.kinds.size(), CV_8U, cv::Scalar(kNothing));
      tidied.pieces += judge(block, wanted);
      const CellRect core = block.coreInBlock();
      for (int v = core.top; v < core.bottom; ++v) {
        const std::uint8_t* const row = wanted.ptr(v);
        for (int u = core.left; u < core.right; ++u) {
          if (row[u] == kNothing) continue;
          const int from = u;
          while (u + 1 < core.right && row[u + 1] == row[from]) ++u;
          found.push_back(
              {v + block.whole.top, from + block.whole.left, u + 1 + block.whole.left, Kind(row[from])});
        }
      }
    }
  }
  for (const Found& run : found) {
    const auto byte = byteOf(run.kind, canvas.code());
    if (!byte) continue;
    canvas.paintRow(run.row, run.from, run.to, {*byte, {}});
    tidied.cells += run.to - run.from;
  }
  return tidied;
}

/// Small ones are squares: the disc of three cells is a cross, which removes corners.
cv::Mat disc(int across) {
  return cv::getStructuringElement(across > 3 ? cv::MORPH_ELLIPSE : cv::MORPH_RECT, {across, across});
}

/// A line of `cells` cells. A disc would not work: it gets around the ends of a thin wall.
constexpr int kDirections = 8;
cv::Mat stroke(int cells, int direction) {
  const double angle = direction * CV_PI / kDirections;
  const double across = std::cos(angle), along = std::sin(angle);
  // Diagonal ones have as many cells along the longer side: gaps of that length are closed.
  const double unit = std::max(std::abs(across), std::abs(along));
  const int x = int(std::lround((cells - 1) * across / unit)),
            y = int(std::lround((cells - 1) * along / unit));
  cv::Mat kernel(std::abs(y) + 1, std::abs(x) + 1, CV_8U, cv::Scalar(0));
  cv::line(kernel, {x < 0 ? -x : 0, y < 0 ? -y : 0}, {x < 0 ? 0 : x, y < 0 ? 0 : y}, cv::Scalar(1));
  return kernel;
}

/// OpenCV dilates and erodes over the same offsets, which moves what is closed by a kernel that has no
/// middle. So the second of the two looks the other way. Beyond the border there is nothing, and room for
/// what comes of the first of the two.
cv::Mat thereAndBack(const cv::Mat& inside, const cv::Mat& kernel, bool close) {
  cv::Mat mask, back, first, second;
  cv::copyMakeBorder(inside, mask, kernel.rows, kernel.rows, kernel.cols, kernel.cols, cv::BORDER_CONSTANT,
                     cv::Scalar(0));
  cv::flip(kernel, back, -1);
  const cv::Point at(0, 0), other(kernel.cols - 1, kernel.rows - 1);
  if (close) {
    cv::dilate(mask, first, kernel, at);
    cv::erode(first, second, back, other);
  } else {
    cv::erode(mask, first, kernel, at);
    cv::dilate(first, second, back, other);
  }
  return second(cv::Rect(kernel.cols, kernel.rows, inside.cols, inside.rows)).clone();
}

}  // namespace

Tidied removeSpecks(Canvas& canvas, const CellRect& within, int most_cells,
                    const std::atomic<bool>* cancelled) {
  const int most = std::clamp(most_cells, 1, kLargestSpeck);
  // A group that is small enough is within this distance of any of its cells.
  const int margin = most + 1;
  return eachBlock(canvas, within, margin, cancelled, [most](const Block& block, cv::Mat& wanted) {
    const cv::Mat occupied = block.kinds == std::uint8_t(Kind::Occupied);
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(occupied, labels, stats, centres, 8, CV_32S);
    const CellRect core = block.coreInBlock();
    std::int64_t pieces = 0;
    for (int label = 1; label < count; ++label) {
      const int* const stat = stats.ptr<int>(label);
      if (stat[cv::CC_STAT_AREA] > most) continue;
      const CellRect box{stat[cv::CC_STAT_LEFT], stat[cv::CC_STAT_TOP],
                         stat[cv::CC_STAT_LEFT] + stat[cv::CC_STAT_WIDTH],
                         stat[cv::CC_STAT_TOP] + stat[cv::CC_STAT_HEIGHT]};
      if (box.intersected(core).empty()) continue;
      const CellRect around = box.grown(1).intersected({0, 0, labels.cols, labels.rows});
      std::array<int, kKinds> seen{};
      bool counted = false;
      for (int v = around.top; v < around.bottom; ++v) {
        for (int u = around.left; u < around.right; ++u) {
          if (labels.at<int>(v, u) == label) {
            // Each group belongs to one block: the one with its first cell.
            if (!counted && core.contains(u, v)) ++pieces;
            counted = true;
          } else {
            ++seen[block.kinds.at<std::uint8_t>(v, u)];
          }
        }
      }
      const Kind becomes =
          seen[std::size_t(Kind::Free)] >= seen[std::size_t(Kind::Unknown)] ? Kind::Free : Kind::Unknown;
      for (int v = box.top; v < box.bottom; ++v) {
        for (int u = box.left; u < box.right; ++u) {
          if (labels.at<int>(v, u) == label) wanted.at<std::uint8_t>(v, u) = std::uint8_t(becomes);
        }
      }
    }
    return pieces;
  });
}

Tidied closeGaps(Canvas& canvas, const CellRect& within, int most_cells, const std::atomic<bool>* cancelled) {
  const int most = std::clamp(most_cells, 1, kWidestGap);
  return eachBlock(canvas, within, 2 * most + 4, cancelled, [most](const Block& block, cv::Mat& wanted) {
    const cv::Mat occupied = block.kinds == std::uint8_t(Kind::Occupied);
    cv::Mat closed = occupied.clone();
    for (int direction = 0; direction < kDirections; ++direction) {
      closed |= thereAndBack(occupied, stroke(most + 1, direction), true);
    }
    wanted.setTo(std::uint8_t(Kind::Occupied), closed & ~occupied);
    return std::int64_t(0);
  });
}

Tidied smoothFree(Canvas& canvas, const CellRect& within, int cells, const std::atomic<bool>* cancelled) {
  const int across = std::clamp(cells, 1, kWidestGap) + 1;
  return eachBlock(canvas, within, 4 * across, cancelled, [across](const Block& block, cv::Mat& wanted) {
    const cv::Mat free = block.kinds == std::uint8_t(Kind::Free);
    const cv::Mat occupied = block.kinds == std::uint8_t(Kind::Occupied);
    // Walls count as free here, and free cells next to them stay: a disc does not reach into corners.
    const cv::Mat solid = free | occupied;
    const cv::Mat smooth = thereAndBack(thereAndBack(solid, disc(across), false), disc(across), true);
    cv::Mat at_walls;
    cv::dilate(occupied, at_walls,
               cv::getStructuringElement(cv::MORPH_RECT, {2 * across + 1, 2 * across + 1}));
    wanted.setTo(std::uint8_t(Kind::Unknown), free & ~smooth & ~at_walls);
    wanted.setTo(std::uint8_t(Kind::Free), smooth & ~solid);
    return std::int64_t(0);
  });
}

}  // namespace mapwright::picture
