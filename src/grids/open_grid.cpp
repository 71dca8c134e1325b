// Reads a picture into a pyramid.
#include <cerrno>
#include <chrono>
#include <cstring>

#include "grids/band_builder.h"
#include "grids/faults.h"
#include "grids/gray_shades.h"
#include "grids/grid_pyramid.h"
#include "grids/kept_pyramid.h"
#include "grids/picture_rows.h"
#include "grids/row_cells.h"
#include "grids/sidecar.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kProgressEvery = std::chrono::milliseconds(50);

std::unique_ptr<BandBuilder> builderOf(const PixelFormat& format, CellCode code, Reduction reduction,
                                       const Means& means) {
  return std::make_unique<BandBuilder>(format.width, format.height, code, reduction,
                                       GridReducer(code, reduction), means);
}

/// Reads the whole picture again into memory. Null: its bytes are no longer available.
KeptPyramid::Again readAgain(const ByteSource& bytes, const GridOptions& options, CellCode code) {
  auto again = bytes.again();
  if (!again) return [] { return nullptr; };
  return [source = std::make_shared<ByteSource>(std::move(*again)), reading = options.reading, code,
          reduction = options.reduction, means = options.means]() -> std::shared_ptr<const GridPyramid> {
    auto rows = openPicture(std::move(*source));
    if (!rows) return nullptr;
    RowCells cells((*rows)->format(), reading);
    const auto builder = builderOf((*rows)->format(), code, reduction, means);
    for (int row = 0; row < (*rows)->format().height; ++row) {
      const std::uint8_t* const pixels = (*rows)->next();
      if (pixels == nullptr) return nullptr;
      cells.convert(pixels, builder->nextRow());
      builder->rowWritten();
    }
    (*rows)->checkEnd();
    builder->finish();
    return !(*rows)->problem().any() ? builder->pyramid() : nullptr;
  };
}

class PictureReading final : public GridReading {
 public:
  PictureReading(std::unique_ptr<PictureRows> rows, CellCode code, const ByteSource& bytes,
                 const GridOptions& options)
      : rows_(std::move(rows)),
        cells_(rows_->format(), options.reading),
        code_(code),
        rows_to_judge_(isGray(code) && !options.code ? judgedRows(rows_->format()) : 0),
        builder_(builderOf(rows_->format(), code, options.reduction, options.means)),
        draft_(keyOf(options, rows_->format(), code)),
        pyramid_(builder_->pyramid()) {
    draft_.begin(builder_->store());
    if (!draft_.begun()) return;
    pyramid_ = std::make_shared<KeptPyramid>(builder_->pyramid(), draft_.path(),
                                             readAgain(bytes, options, code), options.damaged);
  }

  std::shared_ptr<const GridPyramid> pyramid() const override { return pyramid_; }
  bool complete() const override { return finished_; }
  Fault notKept() const override { return draft_.trouble(); }

  std::optional<Fault> read(const std::atomic<bool>& cancelled,
                            const std::function<void()>& progressed) override {
    if (finished_) return std::nullopt;
    const int height = rows_->format().height;
    rows_->stopWhen(cancelled);
    bool announced = false;
    auto last = Clock::now();
    while (builder_->rowsPushed() < height) {
      if (cancelled.load(std::memory_order_relaxed)) return std::nullopt;
      const std::uint8_t* row = rows_->next();
      if (row == nullptr) break;
      std::uint8_t* const cells = builder_->nextRow();
      cells_.convert(row, cells);
      if (rows_to_judge_ > 0) {
        shades_.add(cells, std::size_t(rows_->format().width));
        if (--rows_to_judge_ == 0) judge();
        if (other_code_) return std::nullopt;
      }
      builder_->rowWritten();
      if (!progressed) continue;
      const bool first = !announced && pyramid_->rowsReady() > 0;
      const auto now = Clock::now();
      if (first || (announced && now - last >= kProgressEvery)) {
        announced = true;
        last = now;
        progressed();
      }
    }
    if (cancelled.load(std::memory_order_relaxed)) return std::nullopt;
    const int came = builder_->rowsPushed();
    if (rows_to_judge_ > 0) judge();  // it ended early
    if (other_code_) return std::nullopt;
    if (came == height) rows_->checkEnd();
    builder_->finish();
    finished_ = true;
    auto problem = whatIsWrong(came);
    if (!problem) draft_.keep(builder_->store());
    if (progressed) progressed();
    return problem;
  }

  std::optional<CellCode> otherCode() const override { return other_code_; }

 private:
  void judge() {
    const PixelFormat& format = rows_->format();
    const bool whole = rows_to_judge_ == 0 && judgedRows(format) == format.height;
    rows_to_judge_ = 0;
    if (const CellCode judged = shades_.code(format.has_alpha, whole); judged != code_) other_code_ = judged;
  }

  std::optional<Fault> whatIsWrong(int came) const {
    const int height = rows_->format().height;
    const Fault& problem = rows_->problem();
    if (came == height && !problem.any()) return std::nullopt;
    const std::string size = words::dimensions(rows_->format().width, height);
    if (came == height) {
      return Fault{fault::PictureDoubtful, {size}, {problem}};
    }
    return Fault{fault::PictureEndsEarly, {words::grouped(came), size}, {problem}};
  }

  static SidecarKey keyOf(const GridOptions& options, const PixelFormat& format, CellCode code) {
    SidecarKey key(options, format.width, format.height);
    key.code = code;
    return key;
  }

  std::unique_ptr<PictureRows> rows_;
  RowCells cells_;
  CellCode code_;
  int rows_to_judge_;  // rows still to judge
  GrayShades shades_;
  std::optional<CellCode> other_code_;
  std::unique_ptr<BandBuilder> builder_;
  SidecarDraft draft_;
  std::shared_ptr<const GridPyramid> pyramid_;
  bool finished_ = false;
};

/// A picture found in the cache.
class FinishedReading final : public GridReading {
 public:
  explicit FinishedReading(std::shared_ptr<const GridPyramid> pyramid) : pyramid_(std::move(pyramid)) {}
  std::shared_ptr<const GridPyramid> pyramid() const override { return pyramid_; }
  bool complete() const override { return true; }
  std::optional<Fault> read(const std::atomic<bool>&, const std::function<void()>& progressed) override {
    if (progressed) progressed();
    return std::nullopt;
  }

 private:
  std::shared_ptr<const GridPyramid> pyramid_;
};

tl::expected<std::unique_ptr<GridReading>, Fault> openSource(ByteSource bytes, const GridOptions& options) {
  auto reader = bytes.again();
  if (!reader) return tl::unexpected(Fault(fault::NotRead, {}, {fault::said(std::strerror(errno))}));
  auto rows = openPicture(std::move(*reader));
  if (!rows) return tl::unexpected(std::move(rows.error()));
  const PixelFormat& format = (*rows)->format();
  const SidecarKey key(options, format.width, format.height);
  if (auto finished = openSidecar(key, options.means.unpacked)) {
    const CellCode code = finished->code();
    return std::make_unique<FinishedReading>(std::make_shared<KeptPyramid>(
        std::move(finished), key.path(), readAgain(bytes, options, code), options.damaged));
  }
  CellCode code = options.code.value_or(codeOf(options.reading));
  if (isGray(code) && !options.code) {
    code = glimpsedCode(**rows, options.reading);
    if (!(*rows)->rewind()) {
      auto from_the_start = bytes.again();
      if (!from_the_start) return tl::unexpected(Fault(fault::NotRead));
      rows = openPicture(std::move(*from_the_start));
      if (!rows) return tl::unexpected(std::move(rows.error()));
    }
  }
  return std::make_unique<PictureReading>(std::move(*rows), code, bytes, options);
}

}  // namespace

tl::expected<std::unique_ptr<GridReading>, Fault> openGrid(std::shared_ptr<const std::string> bytes,
                                                           const GridOptions& options) {
  return openSource(ByteSource(std::move(bytes)), options);
}

tl::expected<std::unique_ptr<GridReading>, Fault> openGridFile(const std::string& path,
                                                               const GridOptions& options) {
  auto bytes = ByteSource::open(path);
  if (!bytes) {
    return tl::unexpected(Fault(fault::PictureFileNotOpened, {path}, {fault::said(std::strerror(errno))}));
  }
  return openSource(std::move(*bytes), options);
}

}  // namespace mapwright::grids
