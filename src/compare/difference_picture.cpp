#include "compare/difference_picture.h"

#include <algorithm>
#include <array>
#include <vector>

#include "compare/faults.h"
#include "compare/picture_reading.h"
#include "disk/written_file.h"
#include "grids/png_writer.h"

namespace mapwright::compare {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kDiffers{214, 0, 110}, kBox{0, 90, 181};  // apart for colour-blind people, too
constexpr int kAway = 3, kThick = 2;                    // of a box from its cluster
constexpr int kHatch = 8;                               // from line to line

/// Light enough that what differs is seen at once, dark enough that one knows the place.
std::uint8_t paleOf(grids::Argb colour) {
  const auto part = [colour](int shift) { return int(colour >> shift & 0xff); };
  const int gray = (part(16) * 299 + part(8) * 587 + part(0) * 114) / 1000;
  const int on_white = 255 - (255 - gray) * part(24) / 255;
  return std::uint8_t(255 - (255 - on_white) * 2 / 5);
}

void drawBoxes(const std::vector<PixelBox>& boxes, int y, std::vector<std::uint8_t>& rgb) {
  const int width = int(rgb.size() / 3);
  const auto paint = [&](int from, int to) {
    for (int x = std::max(0, from); x < std::min(width, to); ++x)
      std::copy(kBox.begin(), kBox.end(), rgb.begin() + 3 * std::ptrdiff_t(x));
  };
  for (const PixelBox& box : boxes) {
    const int out = kAway + kThick;
    const int left = box.x - out, top = box.y - out, right = box.x + box.width + out,
              bottom = box.y + box.height + out;
    if (y < top || y >= bottom) continue;
    if (y < top + kThick || y >= bottom - kThick) {
      paint(left, right);
    } else {
      paint(left, left + kThick);
      paint(right - kThick, right);
    }
  }
}

}  // namespace

std::optional<Fault> writeDifference(const Comparison& comparison, const std::string& expected,
                                     const std::string& actual, const std::string& path) {
  struct Source {
    const std::string& path;
    PictureSize size;
    std::optional<PictureReading> reading = {};
  };
  // The actual one lies above.
  std::vector<Source> sources;
  if (!comparison.sameSize()) sources.push_back({expected, comparison.expected});
  sources.push_back({actual, comparison.actual});
  for (Source& source : sources) {
    auto reading = PictureReading::open(source.path);
    if (!reading) return std::move(reading.error());
    if (reading->size() != source.size) return Fault(fault::PictureNotRead, {source.path});
    source.reading.emplace(std::move(*reading));
  }
  const PictureSize size = comparison.canvas;
  disk::WrittenFile file(path);
  grids::PngWriter png{file};
  bool good = png.begin(size.width, size.height, grids::PngPixels::Rgb, grids::PngContent::Any);
  std::vector<PixelBox> boxes;
  for (const Cluster& cluster : comparison.clusters) {
    if (boxes.size() < kMostBoxes) boxes.push_back(cluster.box);
  }
  const int common_width = std::min(comparison.expected.width, comparison.actual.width);
  const int common_height = std::min(comparison.expected.height, comparison.actual.height);
  std::vector<std::uint8_t> rgb(std::size_t(size.width) * 3);
  for (int y = 0; good && y < size.height; ++y) {
    std::fill(rgb.begin(), rgb.end(), 255);
    for (Source& source : sources) {
      if (y >= source.size.height) continue;
      const grids::Argb* const row = source.reading->next();
      if (row == nullptr) return source.reading->problem();
      for (int x = 0; x < std::min(size.width, source.size.width); ++x)
        std::fill_n(rgb.begin() + 3 * std::ptrdiff_t(x), 3, paleOf(row[x]));
    }
    drawBoxes(boxes, y, rgb);
    if (!comparison.differs.empty()) {
      const std::uint8_t* const differs =
          comparison.differs.data() + std::size_t(y) * std::size_t(size.width);
      for (int x = 0; x < size.width; ++x) {
        const bool in_both = x < common_width && y < common_height;
        if (differs[x] != 0 && (in_both || (x + y) % kHatch < kHatch / 2))
          std::copy(kDiffers.begin(), kDiffers.end(), rgb.begin() + 3 * std::ptrdiff_t(x));
      }
    }
    good = png.row(rgb.data(), rgb.size());
  }
  if (!good && file.good())
    return Fault(faultText("compare", "%1: the picture of the differences cannot be encoded."), {path});
  const auto error = file.place();
  return error ? std::optional(disk::notWritten(*error)) : std::nullopt;
}

}  // namespace mapwright::compare
