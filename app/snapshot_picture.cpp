#include "app/snapshot_picture.h"

#include <algorithm>
#include <atomic>

#include <QImage>
#include <QPainter>
#include <QTimer>
#include <spng.h>

#include "app/command_text.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/png_writer.h"
#include "jobs/export_map.h"
#include "scene/map_scene.h"
#include "sentences/fault_sentence.h"
#include "work/budgets.h"

namespace mapwright::app {
namespace {

/// Of whole maps and costmaps.
bool drawsGrids(const SnapshotOptions& options, const SnapshotContent& content) {
  return content.whole || content.regions ||
         std::any_of(options.layers.begin(), options.layers.end(),
                     [](scene::Layer layer) { return scene::specOf(layer).grid.has_value(); });
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

class ScenePicture : public SnapshotPicture {
 public:
  ScenePicture(const SnapshotOptions& options, session::Session& session, const SnapshotContent& content,
               const std::shared_ptr<work::Workers>& workers)
      : options_(options),
        session_(session),
        content_(content),
        clouds_(std::make_shared<clouds::CloudStore>(workers)),
        scene_(exactOnly(workers, drawsGrids(options, content)), clouds_) {}

  void start() override {
    scene_.setTheme(options_.dark ? scene::darkMapTheme() : scene::lightMapTheme());
    scene_.setColorMode(options_.colors);
    for (const scene::Layer layer : scene::allLayers()) {
      scene_.setLayerVisible(layer, options_.layers.contains(layer));
    }
    scene_.setLayerVisible(scene::Layer::Submaps, content_.submaps);
    scene_.setLayerVisible(scene::Layer::WholeMap, content_.whole);
    scene_.setLayerVisible(scene::Layer::Regions, content_.regions != nullptr);
    // A submap without the chosen slice is complete: its picture stays the same unless the marks are asked
    // for.
    scene_.setSlicesMarked(options_.named.contains(scene::Layer::Problems));
    scene_.setView(content_.view);
    scene_.setSession(&session_);
    scene_.setTrack(content_.track);
    scene_.setRegions(content_.regions);
    if (content_.cloud) clouds_->add(*content_.cloud);
    if (options_.robot_anyway) scene_.setRobotWanted(true);
    connect(&scene_, &scene::MapScene::tilesSettled, this, &ScenePicture::look);
    QTimer::singleShot(0, this, &ScenePicture::look);
  }

  QStringList notes() const override {
    QStringList of_robot;
    for (const scene::Layer layer : scene::allLayers()) {
      if (scene_.layerVisible(layer) && scene::specOf(layer).follows_robot)
        of_robot << scene::layerName(layer);
    }
    if (of_robot.isEmpty() || !session_.robot().liveTopics()) return {};
    const scene::RobotPlace& place = scene_.robotPlace();
    const QString names = of_robot.join(QStringLiteral(", "));
    if (place.drawn == scene::ScreenPart::None) {
      return {Text::tr("The robot is not in this map. Left out: %1. Pass --robot-anyway to draw them.")
                  .arg(names)};
    }
    if (place.by_choice) {
      return {Text::tr("The robot is not in this map. Drawn anyway: %1.").arg(names)};
    }
    if (place.where == map::Whereabouts::Unknown && session_.live().robot_pose) {
      return {
          Text::tr("The robot does not report which map it is in. It may not be this one: %1.").arg(names)};
    }
    return {};
  }

  double made() const override {
    if (scene_.picturesSettled()) return 1;
    const render::TileCounts tiles = scene_.renderer().counts();
    // Below 1: other layers may be unfinished, too.
    return tiles.visible > 0 ? std::min(0.99, double(tiles.exact) / tiles.visible) : 0;
  }

  std::optional<QString> write(const QString& path) override {
    QImage image(options_.size_px, QImage::Format_RGB32);
    if (image.isNull()) {
      return Text::tr("There is not enough memory for a picture of %1 x %2.")
          .arg(options_.size_px.width())
          .arg(options_.size_px.height());
    }
    QPainter painter(&image);
    const QRectF whole(QPointF(0, 0), QSizeF(options_.size_px));
    scene_.render(&painter, whole, whole);
    painter.end();
    const auto problem = jobs::writePicture(image, path);
    return problem ? std::optional(sentences::wordsOf(*problem)) : std::nullopt;
  }

 private:
  void look() {
    if (scene_.picturesSettled()) Q_EMIT finished();
  }

  const SnapshotOptions& options_;
  session::Session& session_;
  SnapshotContent content_;
  std::shared_ptr<clouds::CloudStore> clouds_;
  mutable scene::MapScene scene_;
};

QString notEncoded(int failure) {
  return Text::tr("The picture cannot be encoded: %1.").arg(QLatin1String(spng_strerror(failure)));
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
  std::shared_ptr<clouds::CloudStore> clouds_;
  render::DenseCache cache_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> pixels_;  // gray and alpha
  std::vector<std::atomic<bool>> band_made_;
  work::Tasks share_;  // last member: drops waiting jobs, and waits for running ones
};

}  // namespace

std::unique_ptr<SnapshotPicture> makeScenePicture(const SnapshotOptions& options, session::Session& session,
                                                  const SnapshotContent& content,
                                                  std::shared_ptr<work::Workers> workers) {
  return std::make_unique<ScenePicture>(options, session, content, std::move(workers));
}

std::unique_ptr<SnapshotPicture> makeRawPicture(const SnapshotContent& content,
                                                std::shared_ptr<work::Workers> workers) {
  return std::make_unique<RawPicture>(content, std::move(workers));
}

}  // namespace mapwright::app

#include "moc_snapshot_picture.cpp"
