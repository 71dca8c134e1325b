#include "grids/rewrite_picture.h"

#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/byte_source.h"
#include "grids/faults.h"
#include "grids/grid_cells.h"
#include "grids/picture_rows.h"
#include "grids/png_writer.h"

namespace mapwright::grids {

namespace {

bool endsWith(const std::string& path, const char* ending) {
  const std::size_t length = std::strlen(ending);
  if (path.size() < length) return false;
  for (std::size_t i = 0; i < length; ++i) {
    if (std::tolower(static_cast<unsigned char>(path[path.size() - length + i])) != ending[i]) return false;
  }
  return true;
}

enum class Format { Pgm, Png, Other };

/// By its first bytes, like the readers.
Format formatOf(ByteSource& bytes) {
  const auto first = bytes.window(0, 2);
  if (first.size() < 2) return Format::Other;
  if (first[0] == 'P' && (first[1] == '2' || first[1] == '5')) return Format::Pgm;
  return first[0] == 0x89 && first[1] == 'P' ? Format::Png : Format::Other;
}

std::array<bool, 256> bytesIn(const GridPyramid& cells) {
  std::array<bool, 256> seen{};
  GridRows rows(cells);
  for (int y = 0; y < cells.height(); ++y) {
    const std::uint8_t* const row = rows.row(y);
    for (int x = 0; x < cells.width(); ++x) seen[row[x]] = true;
  }
  return seen;
}

/// Converts cells and the old pixels to the new pixels of a row.
class RowPixels {
 public:
  RowPixels(const PictureShades& shades, bool alpha, bool as_is)
      : shades_(shades), alpha_(alpha), as_is_(as_is) {}
  bool alpha() const { return alpha_; }
  /// `before`: indices into `grays`; null = there are none to keep.
  void convert(const std::uint8_t* cells, const std::uint8_t* before,
               const std::array<PixelFormat::Colour, 256>& grays, std::size_t width,
               std::uint8_t* out) const {
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint8_t cell = cells[x];
      std::uint8_t gray = shades_.shade_of[cell].value_or(kTransparentGray);
      if (before) {
        const std::uint8_t was = grays[before[x]].r;
        if (shades_.cell_of[was] == cell) gray = was;
      }
      if (!alpha_) {
        out[x] = gray;
        continue;
      }
      const bool clear = as_is_ ? cell == kTransparentGray : !shades_.shade_of[cell].has_value();
      out[2 * x] = gray;
      out[2 * x + 1] = clear ? 0 : 255;
    }
  }

 private:
  const PictureShades& shades_;
  bool alpha_, as_is_;
};

std::optional<Fault> readBack(const GridPyramid& cells, const std::string& path,
                              const map::CellReading& reading) {
  GridOptions options;
  options.reading = reading;
  options.code = cells.code();
  options.reduction = cells.reduction();
  const auto differs = [&path](std::vector<Fault> why = {}) {
    return Fault(faultText("grids", "The picture %1 was written, but reads back differently"), {path},
                 std::move(why));
  };
  auto opened = openGridFile(path, options);
  if (!opened) return differs({opened.error()});
  const std::atomic<bool> cancelled{false};
  if (auto error = (*opened)->read(cancelled, {})) return differs({std::move(*error)});
  const auto pyramid = (*opened)->pyramid();
  if (pyramid->width() != cells.width() || pyramid->height() != cells.height()) return differs();
  for (int y = 0; y * GridPyramid::kTileEdge < cells.height(); ++y) {
    for (int x = 0; x * GridPyramid::kTileEdge < cells.width(); ++x) {
      const auto wanted = cells.tile(0, x, y), got = pyramid->tile(0, x, y);
      if (!wanted || !got ||
          std::memcmp(wanted->cells.get(), got->cells.get(),
                      std::size_t(GridPyramid::kTileEdge) * GridPyramid::kTileEdge) != 0)
        return differs();
    }
  }
  return std::nullopt;
}

}  // namespace

bool canRewrite(const std::string& path) { return endsWith(path, ".pgm") || endsWith(path, ".png"); }

bool holdsUnknown(const map::CellReading& reading, CellCode code, const std::string& path) {
  if (code == CellCode::FullGray) return false;
  return shadesFor(reading).canBe(unknownByte(code), endsWith(path, ".png"));
}

std::optional<Fault> rewritePicture(const GridPyramid& cells, const std::string& path,
                                    const map::CellReading& reading) {
  const auto kept = [](Fault reason) { return std::move(reason).followedBy(Consequence::LeftAsItIs); };
  auto bytes = ByteSource::open(path);
  if (!bytes) return kept({fault::PictureFileNotOpened, {path}, {fault::said(std::strerror(errno))}});
  const Format format = formatOf(*bytes);
  if (format == Format::Other)
    return kept(
        {faultText("grids", "The picture %1 is neither PGM nor PNG: other formats are read-only."), {path}});
  auto before = openPicture(std::move(*bytes));
  if (!before) return kept(std::move(before.error()));
  const PixelFormat pixels = (*before)->format();
  if (pixels.width != cells.width() || pixels.height != cells.height())
    return kept({fault::PictureOfOtherSize, {path}});

  const PictureShades shades = shadesFor(reading);
  const bool as_is = reading.mode == map::CellReading::Mode::Picture;
  const std::array<bool, 256> seen = bytesIn(cells);
  if (Fault trouble = cells.trouble(); trouble.any()) return kept(std::move(trouble));
  bool alpha = as_is && format == Format::Png && pixels.has_alpha && seen[kTransparentGray];
  for (std::size_t cell = 0; cell < seen.size(); ++cell) {
    if (!seen[cell] || shades.shade_of[cell]) continue;
    alpha = true;
    if (format != Format::Png || cell != shades.transparent)
      return kept({faultText("grids", "No gray level of the picture %1 means %2 by its map.yaml."),
                   {path, std::int64_t(cell)}});
  }

  disk::WrittenFile file(path);
  PngWriter png{file};
  const std::size_t width = std::size_t(cells.width());
  if (format == Format::Pgm)
    file.write("P5\n" + std::to_string(cells.width()) + " " + std::to_string(cells.height()) + "\n255\n");
  bool good = format == Format::Pgm ||
              png.begin(cells.width(), cells.height(), alpha ? PngPixels::GrayAlpha : PngPixels::Gray);
  const bool keeps = !alpha && pixels.indexed && pixels.gray && !pixels.has_alpha;
  const RowPixels rows(shades, alpha, as_is);
  std::vector<std::uint8_t> out(width * (alpha ? 2 : 1));
  GridRows wanted(cells);
  for (int y = 0; y < cells.height() && good && file.good(); ++y) {
    rows.convert(wanted.row(y), keeps ? (*before)->next() : nullptr, pixels.table, width, out.data());
    if (format == Format::Pgm) {
      file.write(out.data(), out.size());
    } else {
      good = png.row(out.data(), out.size());
    }
  }
  if (!good && file.good()) return kept({fault::EncoderFailed, {path}});
  if (const auto fault = file.place()) return disk::notWritten(*fault);
  return readBack(cells, path, reading);
}

}  // namespace mapwright::grids
