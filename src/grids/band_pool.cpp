#include "grids/band_pool.h"

#include <atomic>
#include <mutex>
#include <vector>

namespace mapwright::grids {

struct BandPool::Shelf {
  std::size_t buffer_bytes;
  std::mutex mutex;
  std::vector<std::unique_ptr<std::uint8_t[]>> idle;
  std::atomic<std::size_t> buffers{0};
  bool closed = false;  // buffers are no longer taken back
};

BandPool::BandPool(std::size_t buffer_bytes) : shelf_(std::make_shared<Shelf>()) {
  shelf_->buffer_bytes = buffer_bytes;
}

BandPool::~BandPool() {
  const std::lock_guard lock(shelf_->mutex);
  shelf_->closed = true;
  shelf_->buffers -= shelf_->idle.size();
  shelf_->idle.clear();
}

std::shared_ptr<std::uint8_t[]> BandPool::take() {
  std::unique_ptr<std::uint8_t[]> buffer;
  {
    const std::lock_guard lock(shelf_->mutex);
    if (!shelf_->idle.empty()) {
      buffer = std::move(shelf_->idle.back());
      shelf_->idle.pop_back();
    }
  }
  if (buffer == nullptr) {
    buffer = std::make_unique_for_overwrite<std::uint8_t[]>(shelf_->buffer_bytes);
    ++shelf_->buffers;
  }
  const auto give_back = [shelf = shelf_](std::uint8_t* bytes) {
    std::unique_ptr<std::uint8_t[]> returned(bytes);
    const std::lock_guard lock(shelf->mutex);
    if (shelf->closed) {
      --shelf->buffers;
    } else {
      shelf->idle.push_back(std::move(returned));
    }
  };
  return std::shared_ptr<std::uint8_t[]>(buffer.release(), give_back);
}

std::size_t BandPool::bytes() const { return shelf_->buffers * shelf_->buffer_bytes; }

}  // namespace mapwright::grids
