#include "pbstream/submap_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cartographer/state.pb.h"
#include "pbstream/faults.h"
#include "pbstream/poses.h"
#include "pbstream/record_stream.h"
#include "pbstream/wire.h"
#include "words/figures.h"

namespace mapwright::pbstream {
namespace {

constexpr std::int64_t kMostCells = std::int64_t(64) << 20;   // as for a texture of a robot
constexpr std::size_t kMostVoxels = std::size_t(16) << 20;    // 14 bytes each
constexpr std::int64_t kMostPixels = std::int64_t(16) << 20;  // 20 bytes each
constexpr int kValues = 32'768;                               // 15 bits
constexpr std::uint16_t kValueBits = kValues - 1;  // the highest bit marks updates of unfinished grids
constexpr double kSteps = kValues - 2;
constexpr double kLeastProbability = 0.1, kMostProbability = 0.9;
constexpr double kUsualTruncationM = 0.3, kUsualMaxWeight = 10;
constexpr int kLogOdds = 0;  // cell_format

double logit(double p) { return std::log(p / (1 - p)); }

/// 1 (certainly free) .. 255 (certainly occupied).
std::uint8_t logOddsByte(double p) {
  const double low = logit(kLeastProbability), high = logit(kMostProbability);
  const double k = std::round((logit(p) - low) * 254 / (high - low)) + 1;
  return std::uint8_t(std::clamp(k, 1.0, 255.0));
}

geometry::Pose3 poseFrom(const Eigen::Isometry3d& transform) {
  const Eigen::Quaterniond turn(transform.linear());
  const Eigen::Vector3d& at = transform.translation();
  return {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()};
}

tl::unexpected<Fault> wrong(Fault why) { return tl::unexpected(std::move(why)); }

Fault poseUnusable() {
  return faultText("pbstream", "its pose is not one: a number is not finite, or it has no direction");
}

/// The bytes (value, alpha) of a texture.
void appendPair(std::string& to, int delta) {
  to.push_back(char(std::max(delta, 0)));
  to.push_back(char(delta > 0 ? 0 : std::max(-delta, 1)));
}

struct Shape {
  std::int32_t x0 = 0, y0 = 0, width = 1, height = 1;
};

/// None: a grid may have this size.
Fault sizeFault(const Grid2D& grid) {
  const std::int64_t cells = std::int64_t(grid.size_x) * grid.size_y;
  if (grid.size_x >= 1 && grid.size_y >= 1 && cells <= kMostCells) return {};
  return {faultText("pbstream", "its grid claims to have %1 cells"),
          {words::dimensions(grid.size_x, grid.size_y)}};
}

tl::expected<Shape, Fault> checkedShape(const Grid2D& grid) {
  const std::int64_t cells = std::int64_t(grid.size_x) * grid.size_y;
  if (Fault why = sizeFault(grid); why.any()) return wrong(std::move(why));
  const auto holds = [&](std::size_t count) -> std::optional<Fault> {
    if (count == std::size_t(cells)) return std::nullopt;
    return Fault(faultText("pbstream", "its grid of %1 cells holds %2 values"),
                 {words::dimensions(grid.size_x, grid.size_y), words::grouped(std::int64_t(count))});
  };
  if (auto why = holds(grid.cells.size())) return wrong(std::move(*why));
  if (grid.tsdf) {
    if (auto why = holds(grid.tsdf->weights.size())) return wrong(std::move(*why));
  }
  if (!std::isfinite(grid.resolution_m) || grid.resolution_m <= 0 || !std::isfinite(grid.max_x_m) ||
      !std::isfinite(grid.max_y_m))
    return wrong(faultText("pbstream", "the place or the cell size of its grid is not a number of metres"));
  if (!grid.known) return Shape{};
  const Grid2D::Box& box = *grid.known;
  if (box.min_x < 0 || box.min_y < 0 || box.max_x < box.min_x || box.max_y < box.min_y ||
      box.max_x >= grid.size_x || box.max_y >= grid.size_y)
    return wrong(faultText("pbstream", "the box of its known cells is not within its grid"));
  return Shape{box.min_x, box.min_y, box.max_x - box.min_x + 1, box.max_y - box.min_y + 1};
}

tl::expected<std::string, Fault> probabilityCells(const Grid2D& grid, const Shape& shape) {
  const bool usual = grid.min_cost == 0 && grid.max_cost == 0;
  const double least = usual ? kLeastProbability : double(grid.min_cost);
  const double most = usual ? kMostProbability : double(grid.max_cost);
  if (!(least >= 0) || !(most <= 1) || !(least < most))
    return wrong(faultText("pbstream", "the bounds of its probabilities are not between 0 and 1"));
  std::array<char, kValues> bytes{};
  for (int v = 1; v < kValues; ++v)
    bytes[std::size_t(v)] = char(logOddsByte(1 - (least + (v - 1) * (most - least) / kSteps)));
  std::string cells;
  cells.reserve(std::size_t(shape.width) * std::size_t(shape.height));
  for (std::int32_t y = shape.y0; y < shape.y0 + shape.height; ++y) {
    const std::uint16_t* const row = grid.cells.data() + std::size_t(grid.size_x) * std::size_t(y);
    for (std::int32_t x = shape.x0; x < shape.x0 + shape.width; ++x)
      cells.push_back(bytes[row[x] & kValueBits]);
  }
  return cells;
}

tl::expected<std::string, Fault> tsdfCells(const Grid2D& grid, const Shape& shape) {
  const double truncation_m =
      grid.tsdf->truncation_m == 0 ? kUsualTruncationM : double(grid.tsdf->truncation_m);
  const double max_weight = grid.tsdf->max_weight == 0 ? kUsualMaxWeight : double(grid.tsdf->max_weight);
  if (!(truncation_m > 0) || !(max_weight > 0) || !std::isfinite(truncation_m) || !std::isfinite(max_weight))
    return wrong(
        faultText("pbstream", "the truncation distance or the weight of its distances is not positive"));
  std::string cells;
  cells.reserve(2 * std::size_t(shape.width) * std::size_t(shape.height));
  for (std::int32_t y = shape.y0; y < shape.y0 + shape.height; ++y) {
    for (std::int32_t x = shape.x0; x < shape.x0 + shape.width; ++x) {
      const std::size_t at = std::size_t(grid.size_x) * std::size_t(y) + std::size_t(x);
      const int v = grid.cells[at] & kValueBits, w = grid.tsdf->weights[at] & kValueBits;
      if (v == 0 || w == 0) {
        cells.append(2, '\0');
        continue;
      }
      // As shares of the truncation distance and of the largest weight.
      const double distance = std::abs(-1 + (v - 1) * 2 / kSteps), weight = (w - 1) / kSteps;
      appendPair(cells, int(std::round(weight * (std::sqrt(distance) * 255 - 128))));
    }
  }
  return cells;
}

class SubmapReader {
 public:
  SubmapReader(Wire& wire, const geometry::Pose3& pose) : wire_(wire), pose_(pose) {}

  void read() {
    wire_.fields([&](int member) {
      if (member != int(RecordKind::Submap)) return false;
      wire_.message([&](int number) {
        if (number == 2) read2D();
        if (number == 3) read3D();
        return number == 2 || number == 3;
      });
      return true;
    });
  }

  Textures textures;

 private:
  bool readHead(int field) {
    if (field == 1) {
      wire_.read(local_pose_);
    } else if (field == 2) {
      textures.version = std::int32_t(wire_.varint());
    } else {
      return false;
    }
    return true;
  }

  void read2D() {
    std::optional<Grid2D> grid;
    wire_.message([&](int field) {
      if (field != 4) return readHead(field);
      grid = readGrid();
      return true;
    });
    if (!wire_.good()) return;
    if (!grid) return wire_.fail(faultText("pbstream", "it holds no grid"));
    take(sliceOf(*grid, pbstream::poseFrom(local_pose_)));
  }

  Grid2D readGrid() {
    Grid2D grid;
    cartographer_state::MapLimits limits;
    cartographer_state::CellBox box;
    bool limited = false;
    const auto most = [&] {
      return limited ? std::size_t(grid.size_x) * std::size_t(grid.size_y) : std::size_t(kMostCells);
    };
    const auto into = [&](std::vector<std::uint16_t>& values) {
      return [&, room = most()](std::uint64_t value) {
        if (values.size() >= room) return false;
        values.push_back(std::uint16_t(value));
        return true;
      };
    };
    wire_.message([&](int field) {
      switch (field) {
        case 1:
          wire_.read(limits);
          grid.resolution_m = limits.resolution();
          grid.max_x_m = limits.max().x();
          grid.max_y_m = limits.max().y();
          grid.size_x = limits.cell_limits().num_x_cells();
          grid.size_y = limits.cell_limits().num_y_cells();
          limited = true;
          if (Fault why = sizeFault(grid); wire_.good() && why.any()) wire_.fail(std::move(why));
          return true;
        case 2:
          wire_.varints(into(grid.cells));
          return true;
        case 3:
          wire_.read(box);
          grid.known = {box.min_x(), box.min_y(), box.max_x(), box.max_y()};
          return true;
        case 4:
          wire_.message([](int) { return false; });
          return true;
        case 5:
          grid.tsdf = Grid2D::Tsdf{};
          wire_.message([&](int of_tsdf) {
            if (of_tsdf == 1) grid.tsdf->truncation_m = wire_.fixed32();
            if (of_tsdf == 2) grid.tsdf->max_weight = wire_.fixed32();
            if (of_tsdf == 3) wire_.varints(into(grid.tsdf->weights));
            return of_tsdf >= 1 && of_tsdf <= 3;
          });
          return true;
        case 6:
          grid.min_cost = wire_.fixed32();
          return true;
        case 7:
          grid.max_cost = wire_.fixed32();
          return true;
        default:
          return false;
      }
    });
    return grid;
  }

  void read3D() {
    HybridGrid high, low;
    wire_.message([&](int field) {
      if (field == 4) readHybrid(high);
      if (field == 5) readHybrid(low);
      return field == 4 || field == 5 || readHead(field);
    });
    for (const HybridGrid* const grid : {&high, &low}) {
      if (!wire_.good()) return;
      auto slice = sliceOf(*grid, pose_);
      if (!slice) return wire_.fail(std::move(slice.error()));
      if (*slice) {
        textures.slices.push_back(std::move(**slice));
      } else if (grid == &high && !low.values.empty()) {
        // It keeps its number.
        map::RawSlice nothing;
        nothing.cells.assign(1, '\0');
        nothing.width = nothing.height = 1;
        nothing.resolution_m = low.resolution_m;
        textures.slices.push_back(std::move(nothing));
      }
    }
  }

  void readHybrid(HybridGrid& grid) {
    const auto signedInto = [](std::vector<std::int32_t>& values) {
      return [&values](std::uint64_t value) {
        if (values.size() >= kMostVoxels) return false;
        const auto zigzag = std::uint32_t(value);
        values.push_back(std::int32_t((zigzag >> 1) ^ (~(zigzag & 1) + 1)));
        return true;
      };
    };
    wire_.message([&](int field) {
      switch (field) {
        case 1:
          grid.resolution_m = wire_.fixed32();
          return true;
        case 3:
          wire_.varints(signedInto(grid.x));
          return true;
        case 4:
          wire_.varints(signedInto(grid.y));
          return true;
        case 5:
          wire_.varints(signedInto(grid.z));
          return true;
        case 6:
          wire_.varints([&](std::uint64_t value) {
            if (grid.values.size() >= kMostVoxels) return false;
            grid.values.push_back(std::uint16_t(value));
            return true;
          });
          return true;
        default:
          return false;
      }
    });
  }

  void take(tl::expected<map::RawSlice, Fault> slice) {
    if (!slice) return wire_.fail(std::move(slice.error()));
    textures.slices.push_back(std::move(*slice));
  }

  Wire& wire_;
  const geometry::Pose3& pose_;
  cartographer_state::Rigid3d local_pose_;
};

struct Pixel {
  std::int32_t count = 0;
  std::int32_t min_z = 0, max_z = 0;
  float sum = 0, largest = 0.5f;
};

std::uint8_t byteOf(const Pixel& pixel) {
  constexpr float kLeastHeight = 3, kFreeSpaceWeight = 0.15f;
  const float height = pixel.count > 0 ? float(pixel.max_z - pixel.min_z) : 0;
  if (height < kLeastHeight) return 0;
  const float free = kFreeSpaceWeight * std::max(height - float(pixel.count), 0.0f);
  const float p = (pixel.sum + (1 - pixel.largest) * free) / (float(pixel.count) + free);
  return logOddsByte(std::clamp(double(p), kLeastProbability, kMostProbability));
}

}  // namespace

tl::expected<map::RawSlice, Fault> sliceOf(const Grid2D& grid, const geometry::Pose3& local_pose) {
  const auto shape = checkedShape(grid);
  if (!shape) return wrong(shape.error());
  const auto local = geometry::toIsometry(local_pose);
  if (!local) return wrong(poseUnusable());
  auto cells = grid.tsdf ? tsdfCells(grid, *shape) : probabilityCells(grid, *shape);
  if (!cells) return wrong(std::move(cells.error()));
  map::RawSlice slice;
  slice.cell_format = kLogOdds;
  slice.cells = std::move(*cells);
  slice.width = shape->width;
  slice.height = shape->height;
  slice.resolution_m = grid.resolution_m;
  slice.slice_pose =
      poseFrom(local->inverse() * Eigen::Translation3d(grid.max_x_m - grid.resolution_m * shape->y0,
                                                       grid.max_y_m - grid.resolution_m * shape->x0, 0));
  return slice;
}

tl::expected<std::optional<map::RawSlice>, Fault> sliceOf(const HybridGrid& grid,
                                                          const geometry::Pose3& pose) {
  const std::size_t voxels = grid.values.size();
  if (grid.x.size() != voxels || grid.y.size() != voxels || grid.z.size() != voxels)
    return wrong(faultText("pbstream", "its cells do not all have three indices and a value"));
  if (voxels == 0) return std::nullopt;
  const float resolution = grid.resolution_m;
  if (!std::isfinite(resolution) || resolution <= 0)
    return wrong(faultText("pbstream", "the cell size of its grid is not a positive number of metres"));
  const auto world = geometry::toIsometry(pose);
  if (!world) return wrong(poseUnusable());
  // In float, as Cartographer: what lies between two cells comes to the same one.
  const Eigen::Quaternionf turn = Eigen::Quaterniond(world->linear()).cast<float>();
  const Eigen::Vector3f at = world->translation().cast<float>();
  constexpr float kOccupied = 0.501f, kFarthest = 1e6f;
  const float per_m = 1 / resolution;
  const auto probability = [](std::uint16_t value) {
    constexpr float kScale = float((kMostProbability - kLeastProbability) / kSteps);
    return float(value) * kScale + (float(kLeastProbability) - kScale);
  };
  struct Seen {
    std::int32_t x, y, z;
    float p;
  };
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < voxels; ++i) {
    const float p = probability(grid.values[i] & kValueBits);
    if (p < kOccupied) continue;
    const Eigen::Vector3f center(float(grid.x[i]) * resolution, float(grid.y[i]) * resolution,
                                 float(grid.z[i]) * resolution);
    const Eigen::Vector3f index = (turn * center + at) * per_m;
    if (!(index.cwiseAbs().maxCoeff() < kFarthest))
      return wrong(faultText("pbstream", "its cells lie too far apart, or from the origin of the map"));
    seen.push_back({std::int32_t(std::lround(index.x())), std::int32_t(std::lround(index.y())),
                    std::int32_t(std::lround(index.z())), p});
  }
  if (seen.empty()) return std::nullopt;
  std::int32_t min_x = seen[0].x, max_x = min_x, min_y = seen[0].y, max_y = min_y;
  for (const Seen& one : seen) {
    min_x = std::min(min_x, one.x);
    max_x = std::max(max_x, one.x);
    min_y = std::min(min_y, one.y);
    max_y = std::max(max_y, one.y);
  }
  const std::int64_t width = std::int64_t(max_y) - min_y + 1, height = std::int64_t(max_x) - min_x + 1;
  if (width * height > kMostPixels)
    return wrong(
        {faultText("pbstream", "its cells lie too far apart: seen from above it would have %1 cells"),
         {words::dimensions(width, height)}});
  std::vector<Pixel> pixels(std::size_t(width * height));
  for (const Seen& one : seen) {
    Pixel& pixel = pixels[std::size_t(std::int64_t(max_x - one.x) * width + (max_y - one.y))];
    pixel.min_z = pixel.count == 0 ? one.z : std::min(pixel.min_z, one.z);
    pixel.max_z = pixel.count == 0 ? one.z : std::max(pixel.max_z, one.z);
    ++pixel.count;
    pixel.sum += one.p;
    pixel.largest = std::max(pixel.largest, one.p);
  }
  map::RawSlice slice;
  slice.cell_format = kLogOdds;
  slice.cells.reserve(pixels.size());
  for (const Pixel& pixel : pixels) slice.cells.push_back(char(byteOf(pixel)));
  slice.width = std::int32_t(width);
  slice.height = std::int32_t(height);
  slice.resolution_m = resolution;
  slice.slice_pose =
      poseFrom(world->inverse() * Eigen::Translation3d(double(max_x) * resolution, double(max_y) * resolution,
                                                       world->translation().z()));
  return slice;
}

tl::expected<Textures, Fault> readTextures(const RecordFile& file, const StoredSubmap& submap,
                                           const geometry::Pose3& pose) {
  FileWindow window(file);
  RecordStream stream(window);
  stream.start(submap.record);
  Wire wire(&stream);
  SubmapReader reader(wire, pose);
  reader.read();
  if (wire.good()) stream.finish();
  // What breaks a stream breaks the message in it.
  const Fault why = stream.fault().any() ? stream.fault() : wire.fault();
  if (why.any()) return wrong(inRecord(submap.record, why));
  return std::move(reader.textures);
}

}  // namespace mapwright::pbstream
