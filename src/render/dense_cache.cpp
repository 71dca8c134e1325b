#include "render/dense_cache.h"

#include <algorithm>
#include <functional>

#include "render/tap_cells.h"

namespace mapwright::render {
namespace {

constexpr std::size_t kMostSpares = 4;
constexpr std::size_t kLargestSpare = std::size_t(4) << 20;

}  // namespace

TapCells tapCellsOf(cells::DenseCells dense, std::vector<std::uint8_t>* given_up) {
  TapCells cells;
  const std::uint8_t* const __restrict in = dense.data.data();
  const std::size_t count = dense.data.size();
  const bool pairs = dense.layout == cells::CellLayout::Pairs;
  cells.tap_bytes = pairs ? count : 2 * count;
  // Fully written below: clearing it first would take as long as filling it.
  auto taps = std::make_unique_for_overwrite<std::uint8_t[]>(cells.tap_bytes);
  std::uint8_t* const __restrict out = taps.get();
  if (pairs) {
    std::copy_n(in, count, out);
  } else {
    const std::size_t stride = std::size_t(dense.stride);
    const std::size_t with_row_below = count > stride ? count - stride : 0;
    for (std::size_t i = 0; i < with_row_below; ++i) out[2 * i] = in[i], out[2 * i + 1] = in[i + stride];
    for (std::size_t i = with_row_below; i < count; ++i) out[2 * i] = in[i], out[2 * i + 1] = 0;
  }
  cells.taps = std::move(taps);
  if (given_up) *given_up = std::move(dense.data);
  dense.data = {};
  cells.level = std::move(dense);
  return cells;
}

// The texture is held weakly: the cache must not keep evicted submaps alive, and a new texture may get the
// address of a destroyed one, so a hit only counts if the owners agree.
struct DenseCache::Entry {
  Key key;
  std::weak_ptr<const cells::CellTexture> owner;
  std::shared_ptr<const TapCells> cells;
};

std::size_t DenseCache::KeyHash::operator()(const Key& key) const noexcept {
  return std::hash<const void*>{}(key.texture) * 31 + std::size_t(key.level);
}

DenseCache::DenseCache(std::size_t budget_bytes) : budget_(budget_bytes) {}

DenseCache::~DenseCache() = default;

std::shared_ptr<const TapCells> DenseCache::get(const std::shared_ptr<const cells::CellTexture>& texture,
                                                int level) {
  const Key key{texture.get(), level};
  {
    const std::lock_guard lock(mutex_);
    const auto found = index_.find(key);
    if (found != index_.end()) {
      const auto entry = found->second;
      if (!entry->owner.owner_before(texture) && !texture.owner_before(entry->owner)) {
        entries_.splice(entries_.begin(), entries_, entry);
        return entry->cells;
      }
      bytes_ -= entry->cells->bytes();
      entries_.erase(entry);
      index_.erase(found);
    }
  }
  // Outside the lock: expanding takes longest. If two threads do it at the same time, the later result is
  // discarded.
  std::vector<std::uint8_t> spare;
  auto cells = std::make_shared<const TapCells>(tapCellsOf(texture->expand(level, reuseSpare()), &spare));
  const std::lock_guard lock(mutex_);
  if (spares_.size() < kMostSpares && spare.capacity() <= kLargestSpare) spares_.push_back(std::move(spare));
  if (index_.contains(key)) return cells;
  entries_.push_front({key, texture, cells});
  index_.emplace(key, entries_.begin());
  bytes_ += cells->bytes();
  while (bytes_ > budget_ && !entries_.empty()) {
    bytes_ -= entries_.back().cells->bytes();
    index_.erase(entries_.back().key);
    entries_.pop_back();
  }
  return cells;
}

std::vector<std::uint8_t> DenseCache::reuseSpare() {
  const std::lock_guard lock(mutex_);
  if (spares_.empty()) return {};
  std::vector<std::uint8_t> spare = std::move(spares_.back());
  spares_.pop_back();
  return spare;
}

std::size_t DenseCache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

void DenseCache::clear() {
  const std::lock_guard lock(mutex_);
  index_.clear();
  entries_.clear();
  spares_.clear();
  bytes_ = 0;
}

}  // namespace mapwright::render
