// The unsaved changes of a map's picture, as bytes: each changed tile before and after. Pure functions, any
// thread.
#pragma once

#include <optional>
#include <vector>

#include <QByteArray>

#include "edit/drafts.h"
#include "picture/merge.h"

namespace mapwright::window {

/// "picture": the kind of these drafts (edit::DraftIdentity).
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
/// nullopt: not such a draft, or damaged. Contains nothing larger than a tile.
std::optional<PictureDraft> pictureDraftFrom(const QByteArray& bytes);

/// The draft applied to a grid of its size and code: its cells where they differ from those saved at that
/// time.
struct TakenDraft {
  picture::Patch patch;
  std::int64_t cells = 0;      // that become others
  std::int64_t elsewhere = 0;  // of these, the ones that others have changed differently since
};
std::optional<TakenDraft> takeDraft(const PictureDraft& draft, const picture::EditedGrid& grid);

}  // namespace mapwright::window
