#include "ui/shot/picture.h"

#include <algorithm>
#include <atomic>

#include <QPainter>
#include <QTimer>
#include <spng.h>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/png_writer.h"
#include "jobs/export_map.h"
#include "render/tile_renderer.h"
#include "submap/submap_store.h"
#include "ui/scene/agreement_run.h"
#include "ui/scene/map_theme.h"
#include "work/budgets.h"

namespace mapwright::ui::shot {
namespace {

/// Of whole maps and costmaps.
bool drawsGrids(const std::set<scene::Layer>& layers) {
  using scene::Layer;
  return std::any_of(layers.begin(), layers.end(), [](Layer layer) {
    return layer == Layer::WholeMap || layer == Layer::Regions || scene::specOf(layer).grid;
  });
}

render::TileRenderer::Options exactOnly(std::shared_ptr<work::Workers> workers, bool grids) {
  render::TileRenderer::Options options;
  options.workers = std::move(workers);
  options.previews = false;
  // Whole maps do not need this, but many overlapping submaps do.
  if (!grids) {
    options.budgets.dense += options.budgets.grid_tiles + options.budgets.unpacked;
    options.budgets.grid_tiles = options.budgets.unpacked = 0;
  }
  return options;
}

}  // namespace

ScenePicture::ScenePicture(Look look, session::Session& session, std::shared_ptr<work::Workers> workers)
    : look_(std::move(look)),
      session_(session),
      clouds_(std::make_shared<clouds::CloudStore>(workers)),
      scene_(exactOnly(workers, drawsGrids(look_.layers)), clouds_) {
  if (look_.layers.contains(scene::Layer::Disagreement) || look_.layers.contains(scene::Layer::Coverage))
    agreement_ = std::make_unique<scene::AgreementRun>(std::move(workers));
}

ScenePicture::~ScenePicture() = default;

void ScenePicture::start() {
  scene_.setTheme(look_.dark ? scene::darkMapTheme() : scene::lightMapTheme());
  scene_.setColorMode(look_.colors);
  scene_.setLayersVisible(look_.layers);
  scene_.setSlicesMarked(look_.slices_marked);
  scene_.setView(look_.view);
  scene_.setSession(&session_);
  scene_.setTrack(look_.track);
  scene_.setRegions(look_.regions);
  if (look_.cloud) clouds_->add(*look_.cloud);
  if (look_.robot_anyway) scene_.setRobotWanted(true);
  connect(&scene_, &scene::MapScene::tilesSettled, this, &ScenePicture::look);
  if (agreement_) {
    connect(agreement_.get(), &scene::AgreementRun::progressed, this, &ScenePicture::showAgreement);
    agreement_fault_ = agreement_->setSubmaps(scene_.placedTextures(), agreement::Rules().tolerance_cells);
    QTimer::singleShot(0, agreement_.get(), &scene::AgreementRun::go);
  }
  QTimer::singleShot(0, this, &ScenePicture::look);
}

void ScenePicture::showAgreement() {
  const agreement::Survey& survey = agreement_->survey();
  scene_.setAgreement(std::make_shared<agreement::Tiles>(survey.made()), survey.rules().cell_m);
  agreement_shown_ = !agreement_->running();
  look();
}

double ScenePicture::made() const {
  if (settled()) return 1;
  const render::TileCounts tiles = scene_.renderer().counts();
  // Below 1: other layers may be unfinished, too.
  return tiles.visible > 0 ? std::min(0.99, double(tiles.exact) / tiles.visible) : 0;
}

QImage ScenePicture::image() {
  QImage image(look_.view.width_px, look_.view.height_px, QImage::Format_RGB32);
  if (image.isNull()) return image;
  QPainter painter(&image);
  const QRectF whole(image.rect());
  scene_.render(&painter, whole, whole);
  return image;
}

std::optional<Fault> ScenePicture::write(const QString& path) {
  const QImage made = image();
  if (!made.isNull()) return jobs::writePicture(made, path);
  return Fault(faultText("shot", "There is not enough memory for a picture of %1 x %2."),
               {std::int64_t(look_.view.width_px), std::int64_t(look_.view.height_px)});
}

bool ScenePicture::settled() const { return scene_.picturesSettled() && (!agreement_ || agreement_shown_); }

void ScenePicture::look() {
  if (settled()) Q_EMIT finished();
}

namespace {

constexpr int kBandRows = 128;
constexpr std::uint8_t kUndecided = 128;

std::optional<Fault> writeGrayAlpha(const geometry::ViewTransform& view,
                                    const std::vector<std::uint8_t>& pixels, const QString& path) {
  disk::WrittenFile file(path.toStdString());
  grids::PngWriter png{file};
  const std::size_t row_bytes = std::size_t(view.width_px) * 2;
  bool good = png.begin(view.width_px, view.height_px, grids::PngPixels::GrayAlpha, grids::PngContent::Any);
  for (std::size_t at = 0; good && at < pixels.size(); at += row_bytes)
    good = png.row(pixels.data() + at, row_bytes);
  if (!good && file.good())
    return Fault(faultText("shot", "The picture cannot be encoded: %1."),
                 {std::string(spng_strerror(png.failure))});
  const auto fault = file.place();
  return fault ? std::optional(disk::notWritten(*fault)) : std::nullopt;
}

class RawPicture : public Picture {
 public:
  RawPicture(RawContent content, std::shared_ptr<work::Workers> workers)
      : content_(std::move(content)),
        cache_(work::budgetsFrom().dense + work::budgetsFrom().tiles),  // no tiles are kept
        row_bytes_(std::size_t(content_.view.width_px) * 2),
        pixels_(row_bytes_ * std::size_t(content_.view.height_px)),
        band_made_(std::size_t((content_.view.height_px + kBandRows - 1) / kBandRows)),
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

  std::optional<Fault> write(const QString& path) override {
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

  RawContent content_;
  render::DenseCache cache_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> pixels_;  // gray and alpha
  std::vector<std::atomic<bool>> band_made_;
  work::Tasks share_;  // last member: drops waiting jobs, and waits for running ones
};

}  // namespace

RawContent rawContent(const session::Session& session, const geometry::ViewTransform& view, bool whole) {
  RawContent content;
  content.view = view;
  content.whole = whole;
  const session::MapSlot& slot = session.wholeMap();
  if (whole && slot.cells()) content.grid = render::PlacedGrid{slot.cells(), slot.reference()};
  if (whole) return content;
  for (const auto& [id, row] : session.submaps().rows()) {
    if (const auto placement = session.submaps().placement(id, session.slice()))
      content.textures.push_back({id, placement->texture, placement->world_from_texture, 0});
  }
  return content;
}

std::unique_ptr<Picture> makeRawPicture(RawContent content, std::shared_ptr<work::Workers> workers) {
  return std::make_unique<RawPicture>(std::move(content), std::move(workers));
}

}  // namespace mapwright::ui::shot

#include "moc_picture.cpp"
