#include "grids/row_cells.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace mapwright::grids {

namespace {

/// One cell from samples of 0..largest. Gray with alpha counts as three equal channels, as nav2 reads it.
std::uint8_t cellOf(const map::CellReading& reading, const std::array<int, 3>& rgb, int alpha, double largest,
                    bool gray, bool has_alpha) {
  const double opacity = has_alpha ? alpha / largest : 1.0;
  if (reading.mode == map::CellReading::Mode::Picture) {
    const double luminance = gray ? rgb[0] : (rgb[0] * 299.0 + rgb[1] * 587.0 + rgb[2] * 114.0) / 1000.0;
    return cellFromPixel(reading, luminance / largest, 1, opacity, has_alpha);
  }
  if (gray && !has_alpha) return cellFromPixel(reading, rgb[0] / largest, 1, 1.0, false);
  return cellFromPixel(reading, (rgb[0] + rgb[1] + rgb[2]) / largest, 3, opacity, has_alpha);
}

constexpr UnknownGrays kMiddle = unknownGrays(CellCode::Gray);
constexpr std::size_t kSaver = 205, kSaverFree = 254;
constexpr std::uint64_t kNearly = 100;   // one pixel in so many may have another gray level
constexpr std::uint64_t kMuch = 64;      // at least one in so many is unknown
constexpr std::uint64_t kStandsOut = 4;  // times as often as others

}  // namespace

RowCells::RowCells(const PixelFormat& format, const map::CellReading& reading)
    : format_(format), reading_(reading) {
  if (format.indexed) {
    table_.resize(256);
    identity_ = true;
    for (std::size_t byte = 0; byte < 256; ++byte) {
      table_[byte] = fromColour(format.table[byte]);
      identity_ = identity_ && table_[byte] == byte;
    }
    return;
  }
  const bool one_sample = format.channels == 1 && format.sample_bytes == 2;
  const bool gray_alpha = format.channels == 2 && format.sample_bytes == 1;
  if (!one_sample && !gray_alpha) return;
  table_.resize(65536);
  for (std::size_t n = 0; n < table_.size(); ++n) {
    const std::array<std::uint16_t, 4> samples{std::uint16_t(one_sample ? n : n >> 8),
                                               std::uint16_t(n & 0xff)};
    table_[n] = fromSamples(samples.data());
  }
}

std::uint8_t RowCells::fromColour(const PixelFormat::Colour& colour) const {
  return cellOf(reading_, {colour.r, colour.g, colour.b}, colour.a, 255.0, format_.gray, format_.has_alpha);
}

std::uint8_t RowCells::fromSamples(const std::uint16_t* samples) const {
  const bool colours = format_.channels >= 3;
  const int largest = format_.sample_max;
  const auto level = [largest](std::uint16_t sample) { return sample > largest ? largest : int(sample); };
  const std::array<int, 3> rgb{level(samples[0]), level(samples[colours ? 1 : 0]),
                               level(samples[colours ? 2 : 0])};
  int alpha = largest;
  if (format_.channels % 2 == 0) alpha = level(samples[format_.channels - 1]);
  if (format_.transparent) {
    const auto& key = *format_.transparent;
    if (samples[0] == key[0] && (!colours || (samples[1] == key[1] && samples[2] == key[2]))) alpha = 0;
  }
  return cellOf(reading_, rgb, alpha, largest, format_.gray, format_.has_alpha);
}

void RowCells::convert(const std::uint8_t* row, std::uint8_t* out) {
  const std::size_t width = std::size_t(format_.width);
  if (identity_) {
    std::memcpy(out, row, width);
  } else if (format_.indexed) {
    for (std::size_t u = 0; u < width; ++u) out[u] = table_[row[u]];
  } else if (!table_.empty()) {
    for (std::size_t u = 0; u < width; ++u) out[u] = table_[std::size_t(row[2 * u] << 8 | row[2 * u + 1])];
  } else {
    convertSamples(row, out);
  }
}

void RowCells::convertSamples(const std::uint8_t* row, std::uint8_t* out) {
  const std::size_t unit = format_.pixelBytes();
  const std::uint8_t* last = nullptr;  // maps consist of runs: one look-up per run
  for (int u = 0; u < format_.width; ++u, row += unit) {
    if (last != nullptr && std::memcmp(row, last, unit) == 0) {
      out[u] = out[u - 1];
      continue;
    }
    std::array<std::uint16_t, 4> samples{};
    for (int n = 0; n < format_.channels; ++n) {
      samples[std::size_t(n)] =
          format_.sample_bytes == 1 ? row[n] : std::uint16_t(row[2 * n] << 8 | row[2 * n + 1]);
    }
    out[u] = fromSamples(samples.data());
    last = row;
  }
}

void GrayShades::add(const std::uint8_t* grays, std::size_t count) {
  // Maps consist of runs, and incrementing the same counter repeatedly would stall.
  std::array<std::array<std::uint32_t, 256>, 4> parts{};
  while (count > 0) {
    const std::size_t some = std::min<std::size_t>(count, std::size_t(1) << 20);
    for (auto& part : parts) part.fill(0);
    std::size_t n = 0;
    for (; n + 4 <= some; n += 4) {
      ++parts[0][grays[n]];
      ++parts[1][grays[n + 1]];
      ++parts[2][grays[n + 2]];
      ++parts[3][grays[n + 3]];
    }
    for (; n < some; ++n) ++parts[0][grays[n]];
    for (std::size_t gray = 0; gray < 256; ++gray) {
      counts_[gray] += std::uint64_t(parts[0][gray]) + parts[1][gray] + parts[2][gray] + parts[3][gray];
    }
    grays += some;
    count -= some;
  }
}

CellCode GrayShades::code(bool has_alpha, bool whole) const {
  std::array<std::uint64_t, 256> counts = counts_;
  if (has_alpha) counts[kTransparentGray] = 0;
  std::uint64_t all = 0;
  for (const std::uint64_t count : counts) all += count;
  const auto first = counts.begin() + kMiddle.from, last = counts.begin() + kMiddle.to + 1;
  const std::size_t peak = std::size_t(std::max_element(first, last) - counts.begin());

  const std::uint64_t shades = counts[0] + counts[255] + counts[kSaverFree] + counts[kSaver] +
                               counts[peak - 1] + counts[peak] + counts[peak + 1];
  if ((all - shades) * kNearly <= all) return CellCode::Gray;

  std::uint64_t around = 0, between = 0, used = 0;
  for (std::size_t gray = peak - 4; gray <= peak + 4; ++gray) around += gray != peak ? counts[gray] : 0;
  for (std::size_t gray = 1; gray < kSaverFree; ++gray) {
    if (int(gray) >= kMiddle.from && int(gray) <= kMiddle.to) continue;
    between += counts[gray];
    used += counts[gray] > 0;
  }
  const bool seen = counts[peak] * kMuch >= all;
  const bool alone = counts[peak] * 8 >= kStandsOut * around;
  const bool apart = counts[peak] * std::max<std::uint64_t>(used, 1) >= kStandsOut * between;
  if (seen && alone && apart) return CellCode::ShadedGray;
  return has_alpha || !whole ? CellCode::ClearGray : CellCode::FullGray;
}

int judgedRows(const PixelFormat& format) {
  return int(std::clamp<std::int64_t>(kJudgedPixels / format.width, 1, format.height));
}

CellCode glimpsedCode(PictureRows& rows, const map::CellReading& reading) {
  constexpr std::int64_t kGlimpsedPixels = std::int64_t(1) << 20;
  const PixelFormat& format = rows.format();
  RowCells cells(format, reading);
  std::vector<std::uint8_t> grays(std::size_t(format.width));
  GrayShades shades;
  const auto most = std::clamp<std::int64_t>(kGlimpsedPixels / format.width, 1, format.height);
  for (int row = 0; row < most; ++row) {
    const std::uint8_t* const pixels = rows.next();
    if (pixels == nullptr) break;
    cells.convert(pixels, grays.data());
    shades.add(grays.data(), grays.size());
  }
  return shades.code(format.has_alpha, judgedRows(format) == format.height);
}

}  // namespace mapwright::grids
