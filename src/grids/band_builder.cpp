#include "grids/band_builder.h"

#include <algorithm>
#include <cstring>

namespace mapwright::grids {

namespace {

// Even, and divisors of a band. The first strip is short, so that something is visible soon.
constexpr int kFirstStrip = 16, kStrip = 64;
constexpr std::size_t kQueuedStrips = GridPyramid::kTileEdge / kStrip;

}  // namespace

BandBuilder::BandBuilder(int width, int height, CellCode code, Reduction reduction,
                         const GridReducer& reducer, const Resources& resources)
    : pyramid_(std::make_shared<GrowingPyramid>(width, height, code, reduction, reducer, resources.unpacked)),
      tasks_(work::orOwn(resources.workers)) {
  tasks_.startLong([this] { work(); });
}

BandBuilder::~BandBuilder() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    if (!finished_) strips_.clear();
  }
  changed_.notify_all();
}

std::uint8_t* BandBuilder::nextRow() {
  if (row_ >= pyramid_->height() || finished_) return nullptr;
  if (band_ == nullptr) band_ = pyramid_->newBand();
  return band_.get() + std::size_t(row_ % GridPyramid::kTileEdge) * pyramid_->stride(0);
}

void BandBuilder::rowWritten() {
  ++row_;
  const bool strip_ends = row_ == kFirstStrip || row_ % kStrip == 0 || row_ == pyramid_->height();
  if (strip_ends) handOver();
  if (row_ % GridPyramid::kTileEdge == 0) band_.reset();
}

void BandBuilder::pushRow(std::span<const std::uint8_t> cells) {
  std::uint8_t* row = nextRow();
  if (row == nullptr) return;
  std::memcpy(row, cells.data(), std::min(cells.size(), std::size_t(pyramid_->width())));
  rowWritten();
}

void BandBuilder::handOver() {
  if (handed_over_ == row_) return;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return strips_.size() < kQueuedStrips; });
  strips_.push_back({band_, handed_over_, row_});
  handed_over_ = row_;
  lock.unlock();
  changed_.notify_all();
}

void BandBuilder::drain() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return strips_.empty() && !busy_; });
}

void BandBuilder::finish() {
  if (finished_) return;
  handOver();
  drain();
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  tasks_.waitForDone();
  finished_ = true;
  band_.reset();
  pyramid_->finish();
}

void BandBuilder::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return closed_ || !strips_.empty(); });
    if (strips_.empty()) return;
    Strip strip = std::move(strips_.front());
    strips_.pop_front();
    busy_ = true;
    lock.unlock();
    changed_.notify_all();
    pyramid_->addRows(strip.band, strip.from, strip.to);
    strip.band.reset();
    lock.lock();
    busy_ = false;
    changed_.notify_all();
  }
}

std::unique_ptr<GridBuilder> buildGrid(int width, int height, CellCode code, Reduction reduction,
                                       const Resources& resources) {
  return std::make_unique<BandBuilder>(width, height, code, reduction, GridReducer(code, reduction),
                                       resources);
}

}  // namespace mapwright::grids
