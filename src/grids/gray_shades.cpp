#include "grids/gray_shades.h"

#include <algorithm>
#include <vector>

#include "grids/row_cells.h"

namespace mapwright::grids {

namespace {

constexpr UnknownGrays kMiddle = unknownGrays(CellCode::Gray);
constexpr std::size_t kSaver = 205, kSaverFree = 254;
constexpr std::uint64_t kNearly = 100;   // one pixel in so many may have another gray level
constexpr std::uint64_t kMuch = 64;      // at least one in so many is unknown
constexpr std::uint64_t kStandsOut = 4;  // times as often as others

}  // namespace

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
