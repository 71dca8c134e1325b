// Builds a pyramid from rows, on two threads. Private to the picture readers.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>

#include "grids/grid_pyramid.h"
#include "grids/growing_pyramid.h"
#include "work/workers.h"

namespace mapwright::grids {

/// The caller's thread writes rows into bands; another thread reduces and compresses them. If that one falls
/// behind by more than a band, the first waits.
class BandBuilder final : public GridBuilder {
 public:
  BandBuilder(int width, int height, CellCode code, Reduction reduction, const GridReducer& reducer,
              const Resources& resources);
  ~BandBuilder() override;

  std::shared_ptr<const GridPyramid> pyramid() const override { return pyramid_; }
  void pushRow(std::span<const std::uint8_t> cells) override;
  void finish() override;

  /// Where to write the next row (width bytes) without copying; then call rowWritten().
  std::uint8_t* nextRow();
  void rowWritten();
  int rowsPushed() const { return row_; }
  /// Waits until all rows so far are in the pyramid.
  void drain();
  TileStore& store() { return pyramid_->store(); }

 private:
  struct Strip {
    GrowingPyramid::Band band;
    int from, to;
  };
  void handOver();
  void work();

  std::shared_ptr<GrowingPyramid> pyramid_;
  GrowingPyramid::Band band_;
  int row_ = 0;  // the next one
  int handed_over_ = 0;
  bool finished_ = false;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Strip> strips_;
  bool busy_ = false, closed_ = false;
  work::Tasks tasks_;  // last member: its thread uses all of the above
};

}  // namespace mapwright::grids
