// A whole map with changes over it: tiles that are copied when they are changed. Why:
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

/// Looks like any other pyramid, with its code, size and reduction: what is drawn, exported and compared is
/// the edited map. One thread changes it, any thread looks; what has been handed out never changes.
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
  /// As it is now, whatever becomes of this one: costs a pointer for each changed tile.
  std::shared_ptr<EditedGrid> snapshot() const;

  /// The changed tile, or one without cells where it is as in the base.
  TileState own(const TilePlace& place) const;
  /// Places of level 0 that own() has tiles of.
  std::vector<TilePlace> changedTiles() const;
  /// A patch is made for the grid as it stands (Canvas), or is the next to be undone or redone.
  void apply(const Patch& patch);
  void revert(const Patch& patch);
  /// Another one after every change.
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
