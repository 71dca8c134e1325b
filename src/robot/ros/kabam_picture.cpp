#include "robot/ros/kabam_picture.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace mapwright::robot::ros {
namespace {

constexpr int kEdge = grids::GridPyramid::kTileEdge;
constexpr int kBandRows = 16;  // divides the edge of a tile
constexpr char kTail[] = "\"}}";
constexpr qint64 kTailBytes = sizeof kTail - 1;

struct Shades {
  std::array<std::uint8_t, 256> gray{};
  std::array<bool, 256> known{};
};

Shades makeShades() {
  Shades shades;
  for (std::size_t cell = 0; cell < 256; ++cell) {
    const auto gray = shadeOf(std::uint8_t(cell));
    shades.known[cell] = gray.has_value();
    shades.gray[cell] = gray.value_or(0);
  }
  return shades;
}

std::string pgmHead(int width, int height) {
  return "P5\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
}

/// Rows `from` to `to` (exclusive) of one band of tiles, joined.
std::vector<std::uint8_t> rowsOf(const grids::GridPyramid& cells, int from, int to) {
  const std::size_t width = std::size_t(cells.width());
  std::vector<std::uint8_t> rows(width * std::size_t(to - from), grids::kUnknownOccupancy);
  for (int x = 0; x * kEdge < cells.width(); ++x) {
    const auto tile = cells.tile(0, x, from / kEdge);
    if (!tile) continue;
    const std::size_t left = std::size_t(x) * kEdge, part = std::min(std::size_t(kEdge), width - left);
    for (int row = from; row < to; ++row) {
      std::memcpy(rows.data() + std::size_t(row - from) * width + left,
                  tile->cells.get() + std::size_t(row % kEdge) * kEdge, part);
    }
  }
  return rows;
}

}  // namespace

std::optional<std::uint8_t> shadeOf(std::uint8_t cell) {
  constexpr std::uint8_t kFree = 0, kOccupied = 100;
  switch (cell) {
    case kFree:
      return std::uint8_t(254);
    case kOccupied:
      return std::uint8_t(0);
    case grids::kUnknownOccupancy:
      return std::uint8_t(205);
    default:
      return std::nullopt;
  }
}

PictureArgs::PictureArgs(const KabamMap& map, std::shared_ptr<const grids::GridPyramid> cells,
                         std::function<bool()> wanted)
    : cells_(std::move(cells)), wanted_(std::move(wanted)) {
  head_ = updateImageHead(map, cells_->width(), cells_->height());
  const std::string head = pgmHead(cells_->width(), cells_->height());
  hash_.addData(QByteArrayView(head.data(), qsizetype(head.size())));
}

qint64 PictureArgs::bytes() const {
  const qint64 cells = qint64(cells_->width()) * cells_->height();
  return head_.size() + (cells + 2) / 3 * 4 + kTailBytes;
}

/// Complete groups of three; the rest waits.
std::optional<QByteArray> PictureArgs::next() {
  if (between_ || !wanted_()) return std::nullopt;
  QByteArray text = std::exchange(began_, true) ? QByteArray() : head_;
  while (row_ < cells_->height() && text.isEmpty()) {
    if (!makeBand()) return std::nullopt;
    const bool last = row_ == cells_->height();
    const qsizetype whole = last ? shades_.size() : shades_.size() / 3 * 3;
    text = shades_.first(whole).toBase64();
    shades_.remove(0, whole);
    if (last) text += kTail;
  }
  if (row_ == cells_->height() && fingerprint_.empty()) fingerprint_ = hash_.result().toHex().toStdString();
  return text;
}

bool PictureArgs::makeBand() {
  static const Shades kShades = makeShades();
  const int to = std::min(row_ + kBandRows, cells_->height());
  const std::vector<std::uint8_t> rows = rowsOf(*cells_, row_, to);
  hash_.addData(QByteArrayView(rows.data(), qsizetype(rows.size())));
  const qsizetype held = shades_.size();
  shades_.resize(held + qsizetype(rows.size()));
  char* out = shades_.data() + held;
  for (const std::uint8_t cell : rows) {
    if (!kShades.known[cell]) {
      between_ = cell;
      return false;
    }
    *out++ = char(kShades.gray[cell]);
  }
  row_ = to;
  return true;
}

std::optional<std::int64_t> differingCells(const grids::GridPyramid& cells, const std::string& pgm) {
  const std::string head = pgmHead(cells.width(), cells.height());
  const std::size_t width = std::size_t(cells.width());
  if (!pgm.starts_with(head) || pgm.size() - head.size() != width * std::size_t(cells.height()))
    return std::nullopt;
  std::int64_t differing = 0;
  const char* shown = pgm.data() + head.size();
  for (int row = 0; row < cells.height(); row += kBandRows) {
    const std::vector<std::uint8_t> rows = rowsOf(cells, row, std::min(row + kBandRows, cells.height()));
    for (const std::uint8_t cell : rows) differing += std::uint8_t(*shown++) != cell;
  }
  return differing;
}

}  // namespace mapwright::robot::ros
