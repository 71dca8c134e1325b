#include "grids/kept_pyramid.h"

#include <unistd.h>
#include <utility>

#include "grids/faults.h"

namespace mapwright::grids {

KeptPyramid::KeptPyramid(std::shared_ptr<const GridPyramid> kept, std::string path, Again again,
                         std::function<void(GridDamage)> told)
    : kept_(std::move(kept)), path_(std::move(path)), again_(std::move(again)), told_(std::move(told)) {}

std::size_t KeptPyramid::bytes() const {
  return kept_->bytes() + (state_.load(std::memory_order_acquire) == State::Mended ? mended_->bytes() : 0);
}

void KeptPyramid::mend() const {
  ::unlink(path_.c_str());  // the next time the picture is read at once
  auto again = std::exchange(again_, nullptr)();
  const bool same = again && again->complete() && again->width() == width() && again->height() == height() &&
                    again->code() == code() && again->reduction() == reduction();
  if (same) mended_ = std::move(again);
  state_.store(same ? State::Mended : State::Lost, std::memory_order_release);
  if (told_) told_(same ? GridDamage::Mended : GridDamage::Lost);
}

std::optional<GridTile> KeptPyramid::tile(int level, int tile_x, int tile_y) const {
  if (state_.load(std::memory_order_acquire) == State::Mended) return mended_->tile(level, tile_x, tile_y);
  auto found = kept_->tile(level, tile_x, tile_y);
  if (!found || !found->damaged) return found;
  std::call_once(once_, [this] { mend(); });
  return state_.load(std::memory_order_acquire) == State::Mended ? mended_->tile(level, tile_x, tile_y)
                                                                 : found;
}

std::optional<GridTile> KeptPyramid::tileAtHand(int level, int tile_x, int tile_y) const {
  if (state_.load(std::memory_order_acquire) == State::Mended) return mended_->tile(level, tile_x, tile_y);
  auto found = kept_->tile(level, tile_x, tile_y);
  if (found && found->damaged) return std::nullopt;
  return found;
}

Fault KeptPyramid::trouble() const {
  if (state_.load(std::memory_order_acquire) != State::Lost) return {};
  return fault::CacheCopyLost;
}

}  // namespace mapwright::grids
