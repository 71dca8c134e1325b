// Pictures of maps (PNG, PGM, BMP): their rows, and the pyramid that is made of them. The first byte chooses
// how gray levels are read.
#include <atomic>
#include <cstring>
#include <memory>

#include "grids/grid_pyramid.h"
#include "grids/picture_rows.h"
#include "packed/codec.h"
#include "target.h"
#include "work/workers.h"

namespace mapwright::fuzz::picture {
namespace {

constexpr std::int64_t kMostCells = std::int64_t(1) << 20;

/// False: it is no picture, or a large one.
bool readRows(const std::shared_ptr<const std::string>& bytes) {
  const auto rows = grids::openPicture(grids::ByteSource(bytes));
  if (!rows) return false;
  const grids::PixelFormat& format = (*rows)->format();
  MUST(format.width > 0 && format.width <= grids::kMaxGridEdge);
  MUST(format.height > 0 && format.height <= grids::kMaxGridEdge);
  if (std::int64_t(format.width) * format.height > kMostCells) return false;
  int seen = 0;
  unsigned sum = 0;
  while (const std::uint8_t* row = (*rows)->next()) {
    for (std::size_t i = 0; i < format.rowBytes(); ++i) sum += row[i];
    MUST(++seen <= format.height);
  }
  use(sum);
  MUST(seen == format.height || (*rows)->problem().code.any());
  (*rows)->checkEnd();
  return true;
}

void readPyramid(const std::shared_ptr<const std::string>& bytes, const grids::GridOptions& options) {
  const auto reading = grids::openGrid(bytes, options);
  if (!reading) return;
  const auto pyramid = (*reading)->pyramid();
  const std::atomic<bool> cancelled{false};
  (*reading)->read(cancelled, [] {});
  MUST(pyramid->complete() || (*reading)->otherCode());
  for (int level = 0; level < pyramid->levels(); ++level) {
    const auto tile = pyramid->tile(level, 0, 0);
    MUST(!pyramid->complete() || (tile && tile->cells));
    if (tile) use(tile->cells.get()[256 * 256 - 1]);
  }
  use(pyramid->at(pyramid->width() - 1, pyramid->height() - 1));
}

void read(Input input) {
  static const auto workers = std::make_shared<work::Workers>(1);
  Choices from(input);
  const unsigned how = from.byte();
  const auto bytes = std::make_shared<const std::string>(textOf(from.rest()));
  if (!readRows(bytes)) return;
  grids::GridOptions options;
  options.reading.mode = map::CellReading::Mode(how & 3);
  options.reading.negate = (how & 4) != 0;
  if ((how & 8) != 0) options.reading.free_thresh = 0.9;
  options.reduction = grids::Reduction((how >> 4) & 1);
  options.resources.workers = workers;
  readPyramid(bytes, options);
  use(grids::decodeColors(bytes, kMostCells, options.resources));
  map::CellReading occupancy;
  occupancy.mode = map::CellReading::Mode(1 + how % 3);
  use(grids::decodeOccupancy(bytes, occupancy, kMostCells, options.resources));
}

}  // namespace
}  // namespace mapwright::fuzz::picture

#ifdef MAPWRIGHT_FUZZ
namespace {

/// Behind a checksum that is wrong nothing would be found.
void mendChecksums(std::uint8_t* png, std::size_t size) {
  if (size < 8 || std::memcmp(png, "\x89PNG", 4) != 0) return;
  for (std::size_t at = 8; at + 12 <= size;) {
    const std::uint8_t* const s = png + at;
    const std::size_t length =
        std::size_t(s[0]) << 24 | std::size_t(s[1]) << 16 | std::size_t(s[2]) << 8 | s[3];
    if (length > size - at - 12) return;
    const std::uint32_t sum = mapwright::packed::crc32(0, {s + 4, length + 4});
    for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = std::uint8_t(sum >> (24 - 8 * i));
    at += 12 + length;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  const std::size_t now = LLVMFuzzerMutate(data, size, most);
  if (now > 1 && seed % 16 != 0) mendChecksums(data + 1, now - 1);
  return now;
}
#endif

MAPWRIGHT_FUZZ_TARGET(picture)
