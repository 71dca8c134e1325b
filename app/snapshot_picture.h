// The picture of a snapshot on its way: made beside the main thread, written when it is whole or when the
// time is over.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "app/snapshot_options.h"
#include "geometry/view_transform.h"
#include "regions/region_map.h"
#include "render/compositor.h"
#include "render/sample_grid.h"
#include "scene/bag_track.h"
#include "scene/map_clouds.h"
#include "session/session.h"
#include "work/workers.h"

namespace mapwright::app {

/// What is drawn. The session stands still from before this was chosen.
struct SnapshotContent {
  geometry::ViewTransform view;
  bool submaps = false, whole = false;
  std::vector<render::PlacedTexture> textures;  // of a raw picture of submaps
  regions::RegionMap* regions = nullptr;        // a part of a map by regions; null = none
  std::shared_ptr<const scene::Track> track;    // of a whole bag; null = none
  std::optional<scene::CloudPiece> cloud;       // of the map; nullopt = none came
  std::optional<render::PlacedGrid> grid;       // of a raw picture of a whole map; nullopt = none came
};

class SnapshotPicture : public QObject {
  Q_OBJECT
 public:
  virtual void start() = 0;
  /// What is to be said of the picture, known as soon as it is started.
  virtual QStringList notes() const { return {}; }
  /// The share of the picture that is made, 0..1.
  virtual double made() const = 0;
  /// Writes what is made; the rest stays empty. The error is a sentence.
  virtual std::optional<QString> write(const QString& path) = 0;

 Q_SIGNALS:
  void finished();  // all of it is made
};

/// The scene of the window, with all its layers.
std::unique_ptr<SnapshotPicture> makeScenePicture(const SnapshotOptions& options, session::Session& session,
                                                  const SnapshotContent& content,
                                                  std::shared_ptr<work::Workers> workers);
/// The cells alone: gray = intensity, alpha 0 = not observed (docs/command-line.md, "mapwright snapshot"). Of
/// a whole map gray pictures keep their gray levels, also where they mean "unknown".
std::unique_ptr<SnapshotPicture> makeRawPicture(const SnapshotContent& content,
                                                std::shared_ptr<work::Workers> workers);

}  // namespace mapwright::app
