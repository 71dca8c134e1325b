// A picture being made beside the main thread, of a session: the map as people see it, or its cells alone. It
// is written when it is complete, or when the time for it is over.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QImage>
#include <QObject>
#include <QString>

#include "clouds/cloud_store.h"
#include "geometry/view_transform.h"
#include "regions/region_map.h"
#include "render/compositor.h"
#include "render/sample_grid.h"
#include "render/tile_colors.h"
#include "session/session.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/track.h"
#include "work/workers.h"

namespace mapwright::ui::scene {
class AgreementRun;
}

namespace mapwright::ui::shot {

class Picture : public QObject {
  Q_OBJECT
 public:
  virtual void start() = 0;
  /// Which share of the picture is drawn, 0..1.
  virtual double made() const = 0;
  /// Writes what has been drawn; the rest stays empty.
  virtual std::optional<Fault> write(const QString& path) = 0;

 Q_SIGNALS:
  void finished();  // all of it is made
};

/// What a picture shows, and how.
struct Look {
  geometry::ViewTransform view;
  std::set<scene::Layer> layers;  // all that are drawn, with those of maps
  bool dark = false;
  render::ColorMode colors = render::ColorMode::Normal;
  bool slices_marked = true;                       // MapScene::setSlicesMarked
  bool robot_anyway = false;                       // the robot is drawn also on a map that it is not in
  regions::RegionMap* regions = nullptr;           // a map by regions; null = none
  std::shared_ptr<const scene::Track> track = {};  // of a whole bag; null = none
  std::optional<clouds::CloudPiece> cloud = {};    // of the map; nullopt = none came
};

/// Draws the window's scene. What changes in the session meanwhile is drawn, too.
class ScenePicture : public Picture {
  Q_OBJECT
 public:
  ScenePicture(Look look, session::Session& session, std::shared_ptr<work::Workers> workers);
  ~ScenePicture() override;
  void start() override;
  double made() const override;
  std::optional<Fault> write(const QString& path) override;
  /// What has been drawn; null = there is not enough memory.
  QImage image();
  const Look& shown() const { return look_; }
  const scene::MapScene& scene() const { return scene_; }
  /// Why the layers Disagreement and Coverage stay empty, once it has started.
  const std::optional<Fault>& agreementFault() const { return agreement_fault_; }

 private:
  void look();
  void showAgreement();
  bool settled() const;

  Look look_;
  session::Session& session_;
  std::shared_ptr<clouds::CloudStore> clouds_;
  mutable scene::MapScene scene_;
  std::unique_ptr<scene::AgreementRun> agreement_;  // null: no layer shows it
  std::optional<Fault> agreement_fault_;
  bool agreement_shown_ = false;  // all of it
};

/// Cells alone.
struct RawContent {
  geometry::ViewTransform view;
  bool whole = false;                           // cells of `grid`, not of submaps
  std::vector<render::PlacedTexture> textures;  // of submaps
  std::optional<render::PlacedGrid> grid;       // nullopt = none came
};
/// Those of the whole map on screen, or of all submaps.
RawContent rawContent(const session::Session& session, const geometry::ViewTransform& view, bool whole);
/// Gray = intensity, alpha 0 = not observed (docs/command-line.md, "mapwright snapshot"). Gray pictures of
/// whole maps keep their gray levels, even those that mean "unknown".
std::unique_ptr<Picture> makeRawPicture(RawContent content, std::shared_ptr<work::Workers> workers);

}  // namespace mapwright::ui::shot
