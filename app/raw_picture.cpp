// Draws only the map's cells, in bands on all cores.
#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include <QCoreApplication>
#include <spng.h>

#include "app/snapshot_picture.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/png_writer.h"
#include "sentences/fault_sentence.h"
#include "work/budgets.h"

namespace mapwright::app {
namespace {

class RawPictureText {
  Q_DECLARE_TR_FUNCTIONS(RawPicture)
};

QString notEncoded(int failure) {
  return RawPictureText::tr("The picture cannot be encoded: %1.").arg(QLatin1String(spng_strerror(failure)));
}

constexpr int kBandRows = 128;
constexpr std::uint8_t kUndecided = 128;

std::optional<QString> writeGrayAlpha(const geometry::ViewTransform& view,
                                      const std::vector<std::uint8_t>& pixels, const QString& path) {
  disk::WrittenFile file(path.toStdString());
  grids::PngWriter png{file};
  const std::size_t row_bytes = std::size_t(view.width_px) * 2;
  bool good = png.begin(view.width_px, view.height_px, grids::PngPixels::GrayAlpha, grids::PngContent::Any);
  for (std::size_t at = 0; good && at < pixels.size(); at += row_bytes)
    good = png.row(pixels.data() + at, row_bytes);
  if (!good && file.good()) return notEncoded(png.failure);
  const auto fault = file.place();
  return fault ? std::optional(sentences::wordsOf(disk::notWritten(*fault))) : std::nullopt;
}

class RawPicture : public SnapshotPicture {
 public:
  RawPicture(const SnapshotContent& content, std::shared_ptr<work::Workers> workers)
      : content_(content),
        cache_(work::budgetsFrom().dense + work::budgetsFrom().tiles),  // no tiles are kept
        row_bytes_(std::size_t(content.view.width_px) * 2),
        pixels_(row_bytes_ * std::size_t(content.view.height_px)),
        band_made_(std::size_t((content.view.height_px + kBandRows - 1) / kBandRows)),
        share_(std::move(workers)) {}

  void start() override {
    for (int top = 0; top < content_.view.height_px; top += kBandRows) {
      share_.start(work::Urgency::InView, [this, top] {
        draw(top);
        band_made_[std::size_t(top / kBandRows)].store(true);
        QMetaObject::invokeMethod(this, &RawPicture::look, Qt::QueuedConnection);
      });
    }
  }

  double made() const override { return double(bandsMade()) / double(band_made_.size()); }

  std::optional<QString> write(const QString& path) override {
    if (bandsMade() == band_made_.size()) return writeGrayAlpha(content_.view, pixels_, path);
    // Threads are still drawing into unfinished bands.
    std::vector<std::uint8_t> part(pixels_.size());
    for (std::size_t i = 0; i < part.size(); i += 2) part[i] = kUndecided;
    for (std::size_t band = 0; band < band_made_.size(); ++band) {
      if (!band_made_[band].load()) continue;
      const std::size_t from = band * kBandRows * row_bytes_;
      const std::size_t to = std::min(part.size(), from + kBandRows * row_bytes_);
      std::copy(pixels_.begin() + std::ptrdiff_t(from), pixels_.begin() + std::ptrdiff_t(to),
                part.begin() + std::ptrdiff_t(from));
    }
    return writeGrayAlpha(content_.view, part, path);
  }

 private:
  std::size_t bandsMade() const {
    return std::size_t(std::count_if(band_made_.begin(), band_made_.end(),
                                     [](const std::atomic<bool>& made) { return made.load(); }));
  }
  void look() {
    if (bandsMade() == band_made_.size()) Q_EMIT finished();
  }

  void draw(int top) {
    const geometry::ViewTransform& view = content_.view;
    render::PixelGrid band;
    band.origin_m = view.worldFromPixel({0, 0});
    band.first_row = top;
    band.scale_m_per_px = view.scale_m_per_px;
    band.rotation_rad = view.rotation_rad;
    band.width_px = view.width_px;
    band.height_px = std::min(kBandRows, view.height_px - top);
    std::uint8_t* const pairs = pixels_.data() + std::size_t(top) * row_bytes_;
    if (content_.whole) {
      drawGrid(band, pairs);
    } else {
      drawSubmaps(band, pairs);
    }
  }

  void drawSubmaps(const render::PixelGrid& band, std::uint8_t* pairs) {
    const render::Composition made = render::compose(band, content_.textures, render::Quality::Exact, cache_);
    for (std::size_t i = 0; i < made.intensity.size(); ++i) {
      pairs[2 * i] = made.intensity[i];
      pairs[2 * i + 1] = (made.flags[i] & render::kObserved) ? 255 : 0;
    }
  }

  void drawGrid(const render::PixelGrid& band, std::uint8_t* pairs) {
    if (!content_.grid) {
      for (std::size_t i = 0; i < row_bytes_ * std::size_t(band.height_px); i += 2) pairs[i] = kUndecided;
      return;
    }
    const grids::CellCode code = content_.grid->cells->code();
    const grids::CellMeaning& meaning = grids::meaningOf(code);
    const render::Composition made = render::sampleGrid(band, *content_.grid, nullptr);
    for (std::size_t i = 0; i < made.intensity.size(); ++i) {
      const std::uint8_t cell = made.intensity[i];
      const bool inside = made.flags[i] != 0;
      pairs[2 * i] = !inside ? kUndecided : grids::isGray(code) ? cell : meaning.intensity[cell];
      pairs[2 * i + 1] = render::knownIn(made, i, meaning) ? 255 : 0;
    }
  }

  SnapshotContent content_;
  render::DenseCache cache_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> pixels_;  // gray and alpha
  std::vector<std::atomic<bool>> band_made_;
  work::Tasks share_;  // last member: drops waiting jobs, and waits for running ones
};

}  // namespace

std::unique_ptr<SnapshotPicture> makeRawPicture(const SnapshotContent& content,
                                                std::shared_ptr<work::Workers> workers) {
  return std::make_unique<RawPicture>(content, std::move(workers));
}

}  // namespace mapwright::app
