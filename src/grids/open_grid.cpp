// Reads a picture into a pyramid.
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <functional>
#include <mutex>
#include <unistd.h>
#include <utility>

#include "grids/band_builder.h"
#include "grids/faults.h"
#include "grids/grid_pyramid.h"
#include "grids/growing_pyramid.h"
#include "grids/picture_rows.h"
#include "grids/row_cells.h"
#include "grids/rows_missing.h"
#include "grids/sidecar.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kProgressEvery = std::chrono::milliseconds(50);

std::unique_ptr<BandBuilder> builderOf(const PixelFormat& format, CellCode code, Reduction reduction,
                                       const Resources& resources) {
  return std::make_unique<BandBuilder>(format.width, format.height, code, reduction,
                                       GridReducer(code, reduction), resources);
}

/// Files can rot, be truncated or be overwritten. If a tile turns out to be damaged, the thread that asked
/// for it reads the picture again, into memory; from then on that pyramid is used. What is shown is either
/// right or missing, and then trouble() says so.
class KeptPyramid final : public GridPyramid, public MayEndEarly {
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
  int missingRows() const override { return rowsMissing(*kept_); }
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
  return faultText("grids",
                   "The cached copy is damaged and the picture can no longer be read: parts of "
                   "it are missing. Open it again.");
}

/// Reads the whole picture again into memory. Null: its bytes are no longer available.
KeptPyramid::Again readAgain(const ByteSource& bytes, const GridOptions& options, CellCode code) {
  return
      [source = std::make_shared<ByteSource>(bytes.again()), reading = options.reading, code,
       reduction = options.reduction, resources = options.resources]() -> std::shared_ptr<const GridPyramid> {
        auto rows = openPicture(std::move(*source));
        if (!rows) return nullptr;
        RowCells cells((*rows)->format(), reading);
        const auto builder = builderOf((*rows)->format(), code, reduction, resources);
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
        builder_(builderOf(rows_->format(), code, options.reduction, options.resources)),
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
      return Fault{
          faultText("grids", "It is %1 pixels and all rows are present, but %2. Some of it may be wrong."),
          {size},
          {problem}};
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

/// Cells as the rows of a gray picture.
class RowsOfCells final : public PictureRows {
 public:
  RowsOfCells(map::OccupancyCells cells, int width, int height) : cells_(std::move(cells)), left_(height) {
    format_.width = width;
    format_.height = height;
    format_.indexed = format_.gray = true;
    for (std::size_t cell = 0; cell < format_.table.size(); ++cell) {
      const std::uint8_t gray = std::uint8_t(cell);
      format_.table[cell] = {gray, gray, gray, 255};
    }
  }
  const PixelFormat& format() const override { return format_; }
  const std::uint8_t* next() override {
    if (left_ == 0) return nullptr;
    return reinterpret_cast<const std::uint8_t*>(cells_->data()) + std::size_t(--left_) * format_.rowBytes();
  }

 private:
  map::OccupancyCells cells_;
  PixelFormat format_;
  int left_;
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
  auto rows = openPicture(bytes.again());
  if (!rows) return tl::unexpected(std::move(rows.error()));
  const PixelFormat& format = (*rows)->format();
  const SidecarKey key(options, format.width, format.height);
  if (auto finished = openSidecar(key, options.resources.unpacked)) {
    const CellCode code = finished->code();
    return std::make_unique<FinishedReading>(std::make_shared<KeptPyramid>(
        std::move(finished), key.path(), readAgain(bytes, options, code), options.damaged));
  }
  CellCode code = options.code.value_or(codeOf(options.reading));
  if (isGray(code) && !options.code) {
    code = glimpsedCode(**rows, options.reading);
    if (!(*rows)->rewind()) {
      rows = openPicture(bytes.again());
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

tl::expected<std::unique_ptr<GridReading>, Fault> openGrid(const map::OccupancyCells& cells, int width,
                                                           int height, const GridOptions& options) {
  if (!cells || width < 1 || height < 1 || cells->size() / std::size_t(width) < std::size_t(height))
    return tl::unexpected(Fault(fault::PictureEmpty));
  if (auto problem = notThisSizeReason(std::uint64_t(width), std::uint64_t(height)))
    return tl::unexpected(std::move(*problem));
  GridOptions of_cells = options;
  of_cells.reading = {map::CellReading::Mode::Raw};
  of_cells.fingerprint.clear();
  return std::make_unique<PictureReading>(std::make_unique<RowsOfCells>(cells, width, height),
                                          CellCode::Occupancy, ByteSource(nullptr), of_cells);
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
