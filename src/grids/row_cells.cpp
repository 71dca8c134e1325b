#include "grids/row_cells.h"

#include <array>
#include <cstring>

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

}  // namespace mapwright::grids
