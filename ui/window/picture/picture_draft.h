// What of a map's picture is not saved yet, as bytes: each changed tile as it was saved and as it is. Pure
// functions, any thread.
#pragma once

#include <optional>
#include <vector>

#include <QByteArray>

#include "edit/draft.h"
#include "picture/merge.h"

namespace mapwright::window {

/// "picture": the kind of such a draft (edit::DraftIdentity).
inline const QString kPictureDraft = QStringLiteral("picture");

struct PictureDraft {
  QDateTime made;
  int width = 0, height = 0;
  grids::CellCode code = grids::CellCode::Gray;
  struct Tile {
    int x = 0, y = 0;
    QByteArray was, is;  // cells, row-major
  };
  std::vector<Tile> tiles;
};

QByteArray pictureDraftBytes(const edit::DraftIdentity& of, const QDateTime& made,
                             const picture::EditedGrid& now, const picture::EditedGrid& saved);
/// nullopt: it is no such draft, or a broken one. Nothing of it is larger than a tile.
std::optional<PictureDraft> pictureDraftFrom(const QByteArray& bytes);

/// What it makes of a grid of its size and code: its cells, where they differ from what was saved then.
struct TakenDraft {
  picture::Patch patch;
  std::int64_t cells = 0;      // that become others
  std::int64_t elsewhere = 0;  // of these, those that somebody else has changed meanwhile, differently
};
std::optional<TakenDraft> takeDraft(const PictureDraft& draft, const picture::EditedGrid& grid);

}  // namespace mapwright::window
