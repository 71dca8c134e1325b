#include <algorithm>

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QTimer>

#include "app/snapshot_picture.h"
#include "jobs/write_picture.h"
#include "scene/map_scene.h"
#include "sentences/fault_sentence.h"

namespace mapwright::app {
namespace {

class ScenePictureText {
  Q_DECLARE_TR_FUNCTIONS(ScenePicture)
};

/// Of whole maps and costmaps.
bool drawsGrids(const SnapshotOptions& options, const SnapshotContent& content) {
  using scene::Layer;
  return content.whole || content.regions ||
         std::any_of(options.layers.begin(), options.layers.end(), [](Layer layer) {
           return layer == Layer::CostmapLow || layer == Layer::CostmapHigh || layer == Layer::Incremental ||
                  layer == Layer::EnvMatch || layer == Layer::EnvSymmetry;
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
    scene_.setLayerVisible(scene::Layer::Submaps, content_.submaps && !options_.without_submaps);
    scene_.setLayerVisible(scene::Layer::WholeMap, content_.whole);
    scene_.setLayerVisible(scene::Layer::Regions, content_.regions != nullptr);
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
      if (scene_.layerVisible(layer) && scene::followsRobot(layer)) of_robot << scene::layerName(layer);
    }
    if (of_robot.isEmpty() || !session_.robot().liveTopics()) return {};
    const scene::RobotPlace& place = scene_.robotPlace();
    const QString names = of_robot.join(QStringLiteral(", "));
    if (place.drawn == scene::ScreenPart::None) {
      return {ScenePictureText::tr(
                  "The robot is not in this map. Left out: %1. Pass --robot-anyway to draw them.")
                  .arg(names)};
    }
    if (place.by_choice) {
      return {ScenePictureText::tr("The robot is not in this map. Drawn anyway: %1.").arg(names)};
    }
    if (place.where == map::Whereabouts::Unknown && session_.live().robot_pose) {
      return {
          ScenePictureText::tr("The robot does not report which map it is in. It may not be this one: %1.")
              .arg(names)};
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
      return ScenePictureText::tr("There is not enough memory for a picture of %1 x %2.")
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

}  // namespace

std::unique_ptr<SnapshotPicture> makeScenePicture(const SnapshotOptions& options, session::Session& session,
                                                  const SnapshotContent& content,
                                                  std::shared_ptr<work::Workers> workers) {
  return std::make_unique<ScenePicture>(options, session, content, std::move(workers));
}

}  // namespace mapwright::app
