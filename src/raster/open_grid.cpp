// Reading a picture into a pyramid.
#include <cerrno>
#include <chrono>
#include <cstring>

#include "raster/band_builder.h"
#include "raster/cell_sentences.h"
#include "raster/grid_pyramid.h"
#include "raster/picture_rows.h"
#include "raster/row_cells.h"
#include "raster/sidecar.h"

namespace mapwright::raster {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kProgressEvery = std::chrono::milliseconds(50);

class PictureReading final : public GridReading {
 public:
  PictureReading(std::unique_ptr<PictureRows> rows, const GridOptions& options)
      : rows_(std::move(rows)),
        cells_(rows_->format(), options.reading),
        builder_(rows_->format().width, rows_->format().height, codeOf(options.reading), options.reduction,
                 GridReducer(codeOf(options.reading), options.reduction)),
        draft_(SidecarKey(options, rows_->format().width, rows_->format().height)) {
    draft_.begin(builder_.store());
  }

  std::shared_ptr<const GridPyramid> pyramid() const override { return builder_.pyramid(); }
  bool complete() const override { return finished_; }

  std::optional<GridError> read(const std::atomic<bool>& cancelled,
                                const std::function<void()>& progressed) override {
    if (finished_) return std::nullopt;
    const int height = rows_->format().height;
    const auto pyramid = builder_.pyramid();
    rows_->stopWhen(cancelled);
    bool announced = false;
    auto last = Clock::now();
    while (builder_.rowsPushed() < height) {
      if (cancelled.load(std::memory_order_relaxed)) return std::nullopt;
      const std::uint8_t* row = rows_->next();
      if (row == nullptr) break;
      cells_.convert(row, builder_.nextRow());
      builder_.rowWritten();
      if (!progressed) continue;
      const bool first = !announced && pyramid->rowsReady() > 0;
      const auto now = Clock::now();
      if (first || (announced && now - last >= kProgressEvery)) {
        announced = true;
        last = now;
        progressed();
      }
    }
    if (cancelled.load(std::memory_order_relaxed)) return std::nullopt;
    const int came = builder_.rowsPushed();
    if (came == height) rows_->checkEnd();
    builder_.finish();
    finished_ = true;
    auto problem = whatIsWrong(came);
    if (!problem) draft_.keep(builder_.store());
    if (progressed) progressed();
    return problem;
  }

 private:
  std::optional<GridError> whatIsWrong(int came) const {
    const int height = rows_->format().height;
    const std::string& problem = rows_->problem();
    if (came == height && problem.empty()) return std::nullopt;
    const std::string size = dimensions(rows_->format().width, height);
    if (came == height) {
      return GridError{"It is " + size + " pixels and all rows are there, but " + problem +
                       ". Some of it may be wrong."};
    }
    return GridError{"It says that it is " + size + " pixels, but " + problem + " after " + grouped(came) +
                     (came == 1 ? " row" : " rows") + ". The rest is shown as unknown."};
  }

  std::unique_ptr<PictureRows> rows_;
  RowCells cells_;
  BandBuilder builder_;
  SidecarDraft draft_;
  bool finished_ = false;
};

/// A picture that was read before.
class FinishedReading final : public GridReading {
 public:
  explicit FinishedReading(std::shared_ptr<const GridPyramid> pyramid) : pyramid_(std::move(pyramid)) {}
  std::shared_ptr<const GridPyramid> pyramid() const override { return pyramid_; }
  bool complete() const override { return true; }
  std::optional<GridError> read(const std::atomic<bool>&, const std::function<void()>& progressed) override {
    if (progressed) progressed();
    return std::nullopt;
  }

 private:
  std::shared_ptr<const GridPyramid> pyramid_;
};

tl::expected<std::unique_ptr<GridReading>, GridError> openSource(ByteSource bytes,
                                                                 const GridOptions& options) {
  auto rows = openPicture(std::move(bytes));
  if (!rows) return tl::unexpected(std::move(rows.error()));
  const PixelFormat& format = (*rows)->format();
  if (auto finished = openSidecar(SidecarKey(options, format.width, format.height))) {
    return std::make_unique<FinishedReading>(std::move(finished));
  }
  return std::make_unique<PictureReading>(std::move(*rows), options);
}

}  // namespace

tl::expected<std::unique_ptr<GridReading>, GridError> openGrid(std::shared_ptr<const std::string> bytes,
                                                               const GridOptions& options) {
  return openSource(ByteSource(std::move(bytes)), options);
}

tl::expected<std::unique_ptr<GridReading>, GridError> openGridFile(const std::string& path,
                                                                   const GridOptions& options) {
  auto bytes = ByteSource::open(path);
  if (!bytes) {
    return tl::unexpected(GridError{"The file " + path + " cannot be opened: " + std::strerror(errno) + "."});
  }
  return openSource(std::move(*bytes), options);
}

}  // namespace mapwright::raster
