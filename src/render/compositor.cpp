#include "render/compositor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "render/block_painter.h"

namespace mapwright::render {
namespace {

constexpr int kNodeEdge = 32;  // pixels; nodes are aligned with the infinite raster, so cuts do not matter
constexpr int kDeepestSplit = 40;  // halvings of a pixel, for absurdly small cells
constexpr double kRoundingOfRatio = 1e-6;

struct PixelMean {
  double intensity = 128;
  std::int32_t flags = 0;
};

// Composes one window node by node: a node is split into four until one block of samples covers it. Its
// sampling density depends only on the node and the textures under it.
class WindowComposer {
 public:
  WindowComposer(const PixelGrid& grid, std::span<const Placement> placements, Quality quality,
                 DenseCache& cache, Kernel kernel, const std::atomic<bool>* cancelled)
      : grid_(grid),
        placements_(placements),
        exact_(quality == Quality::Exact),
        painter_(cache, kernel, placements.size()),
        cancelled_(cancelled) {}

  bool composeInto(Composition& out) {
    out_ = &out;
    const std::int64_t last_column = grid_.first_column + grid_.width_px - 1;
    const std::int64_t last_row = grid_.first_row + grid_.height_px - 1;
    std::vector<std::uint32_t> in_row, in_node;
    for (std::int64_t row = alignDown(grid_.first_row); row <= last_row; row += kNodeEdge) {
      in_row.clear();
      for (std::size_t i = 0; i < placements_.size(); ++i) {
        if (placements_[i].first_row <= double(row + kNodeEdge) && placements_[i].last_row >= double(row)) {
          in_row.push_back(std::uint32_t(i));
        }
      }
      if (in_row.empty()) continue;
      for (std::int64_t column = alignDown(grid_.first_column); column <= last_column; column += kNodeEdge) {
        composeNode(column, row, kNodeEdge, in_row, 0);
        if (stopped()) return false;
      }
    }
    return true;
  }

 private:
  static std::int64_t alignDown(std::int64_t pixel) {
    const std::int64_t rest = pixel % kNodeEdge;
    return pixel - (rest < 0 ? rest + kNodeEdge : rest);
  }

  bool stopped() const { return cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed); }

  std::vector<std::uint32_t>& candidatesAt(std::size_t depth) {
    while (candidates_.size() <= depth) candidates_.push_back(std::make_unique<std::vector<std::uint32_t>>());
    return *candidates_[depth];
  }

  // The candidates of `from` that may touch the square, and their finest resolution.
  double narrow(const PixelSquare& square, const std::vector<std::uint32_t>& from,
                std::vector<std::uint32_t>& to) {
    to.clear();
    double finest_m = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : from) {
      if (!placements_[i].touches(square)) continue;
      to.push_back(i);
      finest_m = std::min(finest_m, placements_[i].resolution_m);
    }
    return finest_m;
  }

  // Samples along one edge of a square, at least 1.
  double samplesAlong(double edge_px, double finest_m) const {
    return exact_ ? std::max(1.0, std::ceil(edge_px * grid_.scale_m_per_px / finest_m - kRoundingOfRatio))
                  : 1.0;
  }

  void composeNode(std::int64_t column, std::int64_t row, int edge, const std::vector<std::uint32_t>& from,
                   std::size_t depth) {
    const std::int64_t x = column - grid_.first_column, y = row - grid_.first_row;
    if (x >= grid_.width_px || y >= grid_.height_px || x + edge <= 0 || y + edge <= 0 || stopped()) return;
    const PixelSquare square{double(column), double(row), double(edge)};
    auto& candidates = candidatesAt(depth);
    const double finest_m = narrow(square, from, candidates);
    if (candidates.empty()) return;
    const double per_pixel = samplesAlong(1.0, finest_m);
    if (per_pixel * edge <= kBlockEdge) {
      const int k = int(per_pixel);
      if (painter_.paint(square, edge * k, placements_, candidates)) storeNode(int(x), int(y), edge, k);
    } else if (edge > 1) {
      const int half = edge / 2;
      for (const int dy : {0, half}) {
        for (const int dx : {0, half}) composeNode(column + dx, row + dy, half, candidates, depth + 1);
      }
    } else {
      const PixelMean mean = meanOf(square, from, depth, 0);
      const std::size_t at = std::size_t(y) * std::size_t(grid_.width_px) + std::size_t(x);
      out_->intensity[at] = std::uint8_t(mean.intensity + 0.5);
      out_->flags[at] = std::uint16_t(mean.flags);
    }
  }

  // The area average of a square inside one pixel, by quarters until a block of samples suffices.
  PixelMean meanOf(const PixelSquare& square, const std::vector<std::uint32_t>& from, std::size_t depth,
                   int split) {
    auto& candidates = candidatesAt(depth);
    const double finest_m = narrow(square, from, candidates);
    if (candidates.empty() || stopped()) return {};
    const double wanted = samplesAlong(square.edge, finest_m);
    if (wanted <= kBlockEdge || split == kDeepestSplit) {
      const int samples = int(std::min<double>(wanted, kBlockEdge));
      return painter_.paint(square, samples, placements_, candidates) ? meanOfBlock(samples) : PixelMean{};
    }
    const double half = square.edge / 2;
    PixelMean sum{0, 0};
    for (const double dy : {0.0, half}) {
      for (const double dx : {0.0, half}) {
        const PixelMean part =
            meanOf({square.column + dx, square.row + dy, half}, candidates, depth + 1, split + 1);
        sum.intensity += part.intensity / 4;
        sum.flags = united(sum.flags | part.flags, std::max(sum.flags, part.flags));
      }
    }
    return sum;
  }

  PixelMean meanOfBlock(int samples) const {
    PixelMean sum{0, 0};
    std::int32_t highest = 0;
    const SampleBlock& block = painter_.block();
    for (int j = 0; j < samples; ++j) {
      for (int i = 0; i < samples; ++i) {
        sum.intensity += double(block.intensity[j * kBlockEdge + i]);
        sum.flags |= block.flags[j * kBlockEdge + i];
        highest = std::max(highest, block.flags[j * kBlockEdge + i]);
      }
    }
    sum.flags = united(sum.flags, highest);
    sum.intensity /= double(samples) * samples;
    return sum;
  }

  /// See united(). As short as they are, processors without AVX compare them quickly.
  struct FlagSums {
    alignas(32) std::int16_t all[kBlockEdge];
    alignas(32) std::int16_t highest[kBlockEdge];
  };

  // Reduces the block to the node's pixels, k x k samples each, inside the window.
  void storeNode(int x, int y, int edge, int k) {
    const SampleBlock& block = painter_.block();
    const int i0 = std::max(0, -x), i1 = std::min(edge, grid_.width_px - x);
    const int j0 = std::max(0, -y), j1 = std::min(edge, grid_.height_px - y);
    const float share = 1.0F / float(k * k);
    alignas(32) float sums[kBlockEdge];
    FlagSums flags;
    for (int j = j0; j < j1; ++j) {
      const std::size_t at = std::size_t(y + j) * std::size_t(grid_.width_px) + std::size_t(x + i0);
      std::uint8_t* const intensity_out = out_->intensity.data() + at;
      std::uint16_t* const flags_out = out_->flags.data() + at;
      if (k == 1) {
        const float* const intensity_in = block.intensity + j * kBlockEdge + i0;
        const std::int32_t* const flags_in = block.flags + j * kBlockEdge + i0;
        for (int i = 0; i < i1 - i0; ++i) intensity_out[i] = std::uint8_t(int(intensity_in[i] + 0.5F));
        for (int i = 0; i < i1 - i0; ++i) flags_out[i] = std::uint16_t(flags_in[i]);
        continue;
      }
      addRows(block, j * k, k, edge * k, sums, flags);
      for (int i = i0; i < i1; ++i) {
        float sum = 0;
        int all = 0, highest = 0;
        for (int s = i * k; s < (i + 1) * k; ++s) {
          sum += sums[s];
          all |= flags.all[s];
          highest = std::max<int>(highest, flags.highest[s]);
        }
        intensity_out[i - i0] = std::uint8_t(int(sum * share + 0.5F));
        flags_out[i - i0] = std::uint16_t(united(all, highest));
      }
    }
  }

  static void addRows(const SampleBlock& block, int first, int rows, int columns, float* sums,
                      FlagSums& flags) {
    std::copy_n(block.intensity + first * kBlockEdge, columns, sums);
    std::copy_n(block.flags + first * kBlockEdge, columns, flags.all);
    std::copy_n(flags.all, columns, flags.highest);
    for (int r = first + 1; r < first + rows; ++r) {
      const float* const intensity_in = block.intensity + r * kBlockEdge;
      const std::int32_t* const flags_in = block.flags + r * kBlockEdge;
      for (int i = 0; i < columns; ++i) sums[i] += intensity_in[i];
      for (int i = 0; i < columns; ++i) {
        const auto in = std::int16_t(flags_in[i]);
        flags.all[i] |= in;
        flags.highest[i] = std::max(flags.highest[i], in);
      }
    }
  }

  const PixelGrid& grid_;
  std::span<const Placement> placements_;
  bool exact_;
  BlockPainter painter_;
  const std::atomic<bool>* cancelled_;
  Composition* out_ = nullptr;
  std::vector<std::unique_ptr<std::vector<std::uint32_t>>> candidates_;  // by depth
};

bool usable(const PixelGrid& grid) {
  constexpr std::int64_t kFarthest = std::int64_t(1) << 52;  // doubles count pixels exactly up to here
  return grid.width_px > 0 && grid.height_px > 0 && std::isfinite(grid.scale_m_per_px) &&
         grid.scale_m_per_px > 0 && std::isfinite(grid.rotation_rad) && std::isfinite(grid.origin_m.x()) &&
         std::isfinite(grid.origin_m.y()) && std::abs(grid.first_column) < kFarthest &&
         std::abs(grid.first_row) < kFarthest;
}

}  // namespace

bool kernelAvailable(Kernel kernel) {
  if (kernel != Kernel::Avx2) return true;
#if defined(__x86_64__) || defined(__i386__)
  static const bool has_avx2 =
      avx2Compiled() && __builtin_cpu_supports("avx2") != 0 && !std::getenv("MAPWRIGHT_PORTABLE");
  return has_avx2;
#else
  return false;
#endif
}

Eigen::Vector2d PixelGrid::worldFromPixel(double column, double row) const {
  const double c = std::cos(rotation_rad), s = std::sin(rotation_rad);
  const double right = (column + double(first_column)) * scale_m_per_px;
  const double up = -(row + double(first_row)) * scale_m_per_px;
  return {origin_m.x() + c * right + s * up, origin_m.y() - s * right + c * up};
}

geometry::WorldRect PixelGrid::bounds() const {
  geometry::WorldRect rect;
  for (const int column : {0, width_px}) {
    for (const int row : {0, height_px}) rect.extend(worldFromPixel(column, row));
  }
  return rect;
}

geometry::WorldRect boundsOf(const PlacedTexture& placed) {
  geometry::WorldRect rect;
  if (!placed.texture) return rect;
  const double cell = placed.texture->resolutionM();
  const double columns = placed.texture->width() * cell, rows = placed.texture->height() * cell;
  for (const double x : {cell, -rows - cell}) {
    for (const double y : {cell, -columns - cell}) rect.extend(placed.world_from_texture.apply({x, y}));
  }
  return rect;
}

Composition compose(const PixelGrid& grid, std::span<const PlacedTexture> textures, Quality quality,
                    DenseCache& cache, Kernel kernel, const std::atomic<bool>* cancelled) {
  if (!usable(grid)) return {};
  Composition out;
  out.width_px = grid.width_px;
  out.height_px = grid.height_px;
  const std::size_t pixels = std::size_t(grid.width_px) * std::size_t(grid.height_px);
  out.intensity.assign(pixels, 128);
  out.flags.assign(pixels, 0);
  const std::vector<Placement> placements = placeTextures(grid, textures, quality);
  if (!WindowComposer(grid, placements, quality, cache, kernel, cancelled).composeInto(out)) return {};
  return out;
}

}  // namespace mapwright::render
