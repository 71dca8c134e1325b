// A pyramid whose tiles lie in a file. Private to the readers of pictures. Any thread.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// Files rot, are cut short, are written over. When a tile turns out damaged, the picture itself is read once
/// more, into memory, by whoever asked for the tile; from then on that pyramid answers. What is shown is
/// either right or not there, and then trouble() says so.
class KeptPyramid final : public GridPyramid {
 public:
  /// The same pyramid from the picture; null: it cannot be had any more.
  using Again = std::function<std::shared_ptr<const GridPyramid>()>;
  /// `path`: of the file, which goes once it is damaged. `told` (may be empty) is called once, on the thread
  /// that found the damage.
  KeptPyramid(std::shared_ptr<const GridPyramid> kept, std::string path, Again again,
              std::function<void(GridDamage)> told);

  int width() const override { return kept_->width(); }
  int height() const override { return kept_->height(); }
  int levels() const override { return kept_->levels(); }
  CellCode code() const override { return kept_->code(); }
  Reduction reduction() const override { return kept_->reduction(); }
  const std::array<std::uint8_t, 256>& order() const override { return kept_->order(); }
  int rowsReady() const override { return kept_->rowsReady(); }
  std::size_t bytes() const override;
  std::optional<GridTile> tile(int level, int tile_x, int tile_y) const override;
  Fault trouble() const override;

 protected:
  std::optional<GridTile> tileAtHand(int level, int tile_x, int tile_y) const override;

 private:
  void mend() const;

  std::shared_ptr<const GridPyramid> kept_;
  std::string path_;
  mutable Again again_;
  std::function<void(GridDamage)> told_;
  mutable std::once_flag once_;
  mutable std::shared_ptr<const GridPyramid> mended_;  // behind state_
  enum class State { Whole, Mended, Lost };
  mutable std::atomic<State> state_{State::Whole};
};

}  // namespace mapwright::grids
