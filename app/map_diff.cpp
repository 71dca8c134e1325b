#include "app/map_diff.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "app/command_text.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/grid_pyramid.h"
#include "grids/png_writer.h"
#include "render/grid_palettes.h"
#include "sentences/fault_sentence.h"

namespace mapwright::app {
namespace {

constexpr int kStrip = 256;  // rows
constexpr double kMostCells = double(std::int64_t(1) << 34);

/// RGB rows of a picture, moved into place once all of them are written.
class DifferencePicture {
 public:
  DifferencePicture(const QString& path, int width, int height)
      : file_(path.toStdString()),
        png_{file_},
        good_(png_.begin(width, height, grids::PngPixels::Rgb, grids::PngContent::Any)) {}
  bool row(const std::vector<std::uint8_t>& rgb) { return good_ = good_ && png_.row(rgb.data(), rgb.size()); }
  /// nullopt = the picture is in place.
  std::optional<QString> end() {
    if (!good_ && file_.good()) return Text::tr("The picture of the differences cannot be encoded.");
    const auto fault = file_.place();
    return fault ? std::optional(sentences::wordsOf(disk::notWritten(*fault))) : std::nullopt;
  }

 private:
  disk::WrittenFile file_;
  grids::PngWriter png_;
  bool good_;
};

}  // namespace

bool MapDiff::same() const {
  using render::Difference;
  for (const Difference what :
       {Difference::Appeared, Difference::Vanished, Difference::OnlyFirst, Difference::OnlySecond}) {
    if (cells[std::size_t(what)] != 0) return false;
  }
  return levels_differ == 0;
}

tl::expected<MapDiff, QString> diffMaps(const render::PlacedGrid& first, const render::PlacedGrid& second,
                                        const QString& picture_path) {
  // The second map's corners in cells of the first.
  double left = 0, top = 0, right = first.reference.width, bottom = first.reference.height;
  for (const double x : {0.0, double(second.reference.width)}) {
    for (const double y : {0.0, double(second.reference.height)}) {
      const Eigen::Vector2d cell = first.reference.cellFromWorld(second.reference.worldFromCell({x, y}));
      left = std::min(left, std::floor(cell.x() + 1e-6));
      top = std::min(top, std::floor(cell.y() + 1e-6));
      right = std::max(right, std::ceil(cell.x() - 1e-6));
      bottom = std::max(bottom, std::ceil(cell.y() - 1e-6));
    }
  }
  if (!((right - left) * (bottom - top) <= kMostCells)) {
    return tl::make_unexpected(
        Text::tr("The two maps are too far apart or too large to be compared cell by cell."));
  }
  MapDiff diff;
  diff.width = int(right - left);
  diff.height = int(bottom - top);
  diff.cell_area_m2 = first.reference.resolution_m * first.reference.resolution_m;
  render::PixelGrid strip;
  strip.origin_m = first.reference.worldFromCell({left, top});
  strip.scale_m_per_px = first.reference.resolution_m;
  strip.rotation_rad = -first.reference.origin.yaw_rad;
  strip.width_px = diff.width;
  const grids::CellMeaning& meaning_a = grids::meaningOf(first.cells->code());
  const grids::CellMeaning& meaning_b = grids::meaningOf(second.cells->code());
  const bool comparable = grids::isGray(first.cells->code()) == grids::isGray(second.cells->code());

  const render::GridPalette palette = render::differencePalette(false);
  std::vector<std::uint8_t> rgb(std::size_t(diff.width) * 3);
  std::unique_ptr<DifferencePicture> picture;
  if (!picture_path.isEmpty())
    picture = std::make_unique<DifferencePicture>(picture_path, diff.width, diff.height);
  for (int row = 0; row < diff.height; row += kStrip) {
    strip.first_row = row;
    strip.height_px = std::min(kStrip, diff.height - row);
    const render::Composition a = render::sampleGrid(strip, first, nullptr);
    const render::Composition b = render::sampleGrid(strip, second, nullptr);
    std::size_t at = 0;
    for (int y = 0; y < strip.height_px; ++y) {
      for (int x = 0; x < strip.width_px; ++x, ++at) {
        const std::uint8_t cell_a = a.intensity[at], cell_b = b.intensity[at];
        const render::Difference what =
            render::differenceOf(render::knownIn(a, at, meaning_a), render::occupancyIn(a, at, meaning_a),
                                 render::knownIn(b, at, meaning_b), render::occupancyIn(b, at, meaning_b));
        ++diff.cells[std::size_t(what)];
        const bool alike = what == render::Difference::SameFree || what == render::Difference::SameOccupied;
        if (alike && comparable && cell_a != cell_b) ++diff.levels_differ;
        const std::uint32_t color = palette[std::size_t(what)] ? palette[std::size_t(what)] : 0xffd5dae0;
        rgb[std::size_t(x) * 3] = std::uint8_t(color >> 16);
        rgb[std::size_t(x) * 3 + 1] = std::uint8_t(color >> 8);
        rgb[std::size_t(x) * 3 + 2] = std::uint8_t(color);
      }
      if (picture && !picture->row(rgb)) return tl::make_unexpected(*picture->end());
    }
  }
  for (const render::PlacedGrid* const map : {&first, &second}) {
    if (const Fault trouble = map->cells->trouble(); trouble.any()) {
      return tl::make_unexpected(sentences::wordsOf(trouble));
    }
  }
  if (picture) {
    if (auto problem = picture->end()) return tl::make_unexpected(std::move(*problem));
  }
  return diff;
}

}  // namespace mapwright::app
