// A pyramid whose tiles are in a file. Private to the picture readers. Any thread.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// Files can rot, be truncated or be overwritten. If a tile turns out to be damaged, the thread that asked
/// for it reads the picture again, into memory; from then on that pyramid is used. What is shown is either
/// right or missing, and then trouble() says so.
class KeptPyramid final : public GridPyramid {
 public:
  /// The same pyramid from the picture; null: it can no longer be read.
  using Again = std::function<std::shared_ptr<const GridPyramid>()>;
  /// `path`: the file, which is deleted if it is damaged. `told` (may be empty) is called once, on the thread
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
