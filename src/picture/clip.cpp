#include "picture/clip.h"

#include <algorithm>
#include <cstring>

namespace mapwright::picture {

namespace {

/// Maps the bytes of one code to another, by kind.
std::array<std::uint8_t, 256> translated(grids::CellCode from, grids::CellCode to) {
  const std::array<Kind, 256> kinds = kindsOf(from);
  std::array<std::uint8_t, 256> bytes{};
  for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
    bytes[byte] = from == to ? std::uint8_t(byte) : byteOf(kinds[byte], to).value_or(grids::unknownByte(to));
  }
  return bytes;
}

}  // namespace

std::optional<Clip> copyCells(Canvas& canvas, const CellRect& rect) {
  const CellRect inside = rect.intersected(canvas.all());
  if (inside.empty() || inside.area() > kMostClippedCells) return std::nullopt;
  Clip clip{inside.width(), inside.height(), {}, canvas.code()};
  clip.cells.resize(std::size_t(inside.area()));
  for (int tile_y = inside.top / Canvas::kEdge; tile_y * Canvas::kEdge < inside.bottom; ++tile_y) {
    for (int tile_x = inside.left / Canvas::kEdge; tile_x * Canvas::kEdge < inside.right; ++tile_x) {
      const CellRect part = inside.intersected(
          CellRect{0, 0, Canvas::kEdge, Canvas::kEdge}.moved(tile_x * Canvas::kEdge, tile_y * Canvas::kEdge));
      const std::uint8_t* const cells = canvas.read(tile_x, tile_y);
      for (int row = part.top; row < part.bottom; ++row) {
        std::memcpy(
            clip.cells.data() + std::size_t(row - inside.top) * std::size_t(clip.width) +
                std::size_t(part.left - inside.left),
            cells + std::size_t(row % Canvas::kEdge) * Canvas::kEdge + std::size_t(part.left % Canvas::kEdge),
            std::size_t(part.width()));
      }
    }
  }
  return clip;
}

void putClip(Canvas& canvas, const Clip& clip, int left, int top) {
  const std::array<std::uint8_t, 256> bytes = translated(clip.code, canvas.code());
  std::vector<std::uint8_t> row(std::size_t(std::max(clip.width, 0)));
  for (int v = 0; v < clip.height; ++v) {
    const std::uint8_t* const cells = clip.cells.data() + std::size_t(v) * row.size();
    std::transform(cells, cells + row.size(), row.begin(), [&](std::uint8_t cell) { return bytes[cell]; });
    canvas.putRow(top + v, left, left + clip.width, row.data());
  }
}

}  // namespace mapwright::picture
