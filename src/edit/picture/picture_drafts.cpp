#include "edit/picture/picture_drafts.h"

#include <set>
#include <utility>

namespace mapwright::edit {
namespace {

using picture::kEdge;
constexpr qsizetype kTileBytes = picture::kTileCells;
constexpr int kQuickly = 1;  // how hard it is packed
// The first row identifies the picture.
constexpr auto kWidth = QLatin1String("width"), kHeight = QLatin1String("height"),
               kCode = QLatin1String("code"), kX = QLatin1String("x"), kY = QLatin1String("y"),
               kWas = QLatin1String("was"), kIs = QLatin1String("is");

QString packed(const grids::GridTile& tile) {
  const auto bytes = QByteArray::fromRawData(reinterpret_cast<const char*>(tile.cells.get()), kTileBytes);
  return QString::fromLatin1(qCompress(bytes, kQuickly).toBase64());
}

/// Exactly a tile, or nothing: checks the stated size before unpacking.
std::optional<QByteArray> unpacked(const QString& text) {
  const QByteArray bytes = QByteArray::fromBase64(text.toLatin1());
  if (bytes.size() < 5) return std::nullopt;
  quint32 size = 0;
  for (int i = 0; i < 4; ++i) size = size << 8 | quint8(bytes[i]);
  if (size != quint32(kTileBytes)) return std::nullopt;
  QByteArray cells = qUncompress(bytes);
  if (cells.size() != kTileBytes) return std::nullopt;
  return cells;
}

}  // namespace

std::optional<FittedDraft> fitDraft(const PictureDraft& draft, const picture::EditedGrid& grid) {
  if (draft.width != grid.width() || draft.height != grid.height() || draft.code != grid.code())
    return std::nullopt;
  FittedDraft taken;
  picture::Canvas canvas(grid);
  for (const PictureDraft::Tile& tile : draft.tiles) {
    const picture::CellRect inside =
        canvas.all().moved(-tile.x * kEdge, -tile.y * kEdge).intersected({0, 0, kEdge, kEdge});
    for (int v = inside.top; v < inside.bottom; ++v) {
      for (int u = inside.left; u < inside.right; ++u) {
        const qsizetype at = qsizetype(v) * kEdge + u;
        const auto was = std::uint8_t(tile.was[at]), is = std::uint8_t(tile.is[at]);
        const std::uint8_t now = canvas.read(tile.x, tile.y)[at];
        if (was == is || now == is) continue;
        ++taken.cells;
        if (now != was) ++taken.elsewhere;
        canvas.write(tile.x, tile.y, {u, v, u + 1, v + 1})[at] = is;
      }
    }
  }
  taken.patch = canvas.take();
  return taken;
}

QByteArray pictureDraftBytes(const DraftIdentity& of, const QDateTime& made, const picture::EditedGrid& now,
                             const picture::EditedGrid& saved) {
  QJsonArray rows{QJsonObject{{kWidth, now.width()}, {kHeight, now.height()}, {kCode, int(now.code())}}};
  for (const auto& [key, count] : picture::DifferenceCount::between(now, saved).tiles) {
    const auto is = now.tile(0, key.x, key.y), was = saved.tile(0, key.x, key.y);
    if (!is || !was) continue;
    rows << QJsonObject{{kX, key.x}, {kY, key.y}, {kWas, packed(*was)}, {kIs, packed(*is)}};
  }
  return toBytes(DraftFrame{of, made, rows});
}

std::optional<PictureDraft> pictureDraftFrom(const QByteArray& bytes) {
  const auto frame = draftFrame(bytes);
  if (!frame || frame->changes.isEmpty()) return std::nullopt;
  const QJsonObject head = frame->changes.first().toObject();
  PictureDraft draft;
  draft.made = frame->made;
  draft.width = head.value(kWidth).toInt();
  draft.height = head.value(kHeight).toInt();
  const int code = head.value(kCode).toInt(-1);
  if (draft.width < 1 || draft.height < 1 || code < 0 || code >= grids::kCellCodes) return std::nullopt;
  draft.code = grids::CellCode(code);
  std::set<std::pair<int, int>> seen;
  for (qsizetype i = 1; i < frame->changes.size(); ++i) {
    const QJsonObject row = frame->changes.at(i).toObject();
    PictureDraft::Tile tile{row.value(kX).toInt(-1), row.value(kY).toInt(-1), {}, {}};
    const bool inside = tile.x >= 0 && tile.y >= 0 && tile.x <= (draft.width - 1) / kEdge &&
                        tile.y <= (draft.height - 1) / kEdge;
    auto was = unpacked(row.value(kWas).toString()), is = unpacked(row.value(kIs).toString());
    if (!inside || !was || !is || !seen.emplace(tile.x, tile.y).second) return std::nullopt;
    tile.was = std::move(*was);
    tile.is = std::move(*is);
    draft.tiles.push_back(std::move(tile));
  }
  return draft;
}

}  // namespace mapwright::edit
