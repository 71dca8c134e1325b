// Drafts of the unsaved changes of a map's picture, as bytes and applied.
#pragma once

#include <optional>
#include <vector>

#include <QByteArray>
#include <QDateTime>

#include "edit/drafts.h"
#include "grids/grid_pyramid.h"
#include "picture/merge.h"

namespace mapwright::edit {

/// The unsaved changes of a picture: each changed tile before and after.
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

QByteArray pictureDraftBytes(const DraftIdentity& of, const QDateTime& made, const picture::EditedGrid& now,
                             const picture::EditedGrid& saved);
/// nullopt: not such a draft, or damaged. Contains nothing larger than a tile.
std::optional<PictureDraft> pictureDraftFrom(const QByteArray& bytes);

/// A draft applied to a grid of its size and code: its cells where they differ from those saved at that time.
struct FittedDraft {
  picture::Patch patch;
  std::int64_t cells = 0;      // that become others
  std::int64_t elsewhere = 0;  // of these, the ones that others have changed differently since
};
std::optional<FittedDraft> fitDraft(const PictureDraft& draft, const picture::EditedGrid& grid);

}  // namespace mapwright::edit
