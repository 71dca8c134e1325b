// A whole map with edits on top: tiles are copied on write. Why:
// docs/decisions/0015-edits-are-documents-with-drafts.md.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "grids/grid_pyramid.h"
#include "picture/patch.h"

namespace mapwright::picture {

/// Acts like any other pyramid, with the same code, size and reduction: the edited map is what is drawn,
/// exported and compared. One thread edits it, any thread reads; tiles handed out never change.
class EditedGrid final : public grids::GridPyramid {
 public:
  /// `base`: complete, never null.
  explicit EditedGrid(std::shared_ptr<const grids::GridPyramid> base);

  int width() const override { return base_->width(); }
  int height() const override { return base_->height(); }
  int levels() const override { return base_->levels(); }
  grids::CellCode code() const override { return base_->code(); }
  grids::Reduction reduction() const override { return base_->reduction(); }
  const std::array<std::uint8_t, 256>& order() const override { return base_->order(); }
  std::optional<grids::GridTile> tile(int level, int tile_x, int tile_y) const override;
  int rowsReady() const override { return base_->rowsReady(); }
  std::size_t bytes() const override;
  Fault trouble() const override { return base_->trouble(); }

  const std::shared_ptr<const grids::GridPyramid>& base() const { return base_; }
  CellRect all() const { return {0, 0, width(), height()}; }
  /// A copy of the present state: costs one pointer for each changed tile.
  std::shared_ptr<EditedGrid> snapshot() const;

  /// The changed tile, or one without cells if it is as in the base.
  TileState own(const TilePlace& place) const;
  /// The positions on level 0 of which own() has tiles.
  std::vector<TilePlace> changedTiles() const;
  /// The patch was made for the present grid (Canvas), or is the next one to undo or redo.
  void apply(const Patch& patch);
  void revert(const Patch& patch);
  /// Changes with every edit.
  std::uint64_t revision() const { return revision_; }

 private:
  struct PlaceHash {
    std::size_t operator()(const TilePlace& place) const noexcept;
  };
  using Tiles = std::unordered_map<TilePlace, TileState, PlaceHash>;
  EditedGrid(std::shared_ptr<const grids::GridPyramid> base, Tiles tiles);
  void exchange(const Patch& patch, TileState TileChange::*side);

  std::shared_ptr<const grids::GridPyramid> base_;
  mutable std::mutex mutex_;
  Tiles tiles_;
  std::uint64_t revision_ = 0;
};

}  // namespace mapwright::picture
