// The picture of a snapshot in progress: drawn beside the main thread, written when it is complete or when
// the time is over.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "app/snapshot.h"
#include "clouds/cloud_store.h"
#include "geometry/view_transform.h"
#include "regions/region_map.h"
#include "render/compositor.h"
#include "render/sample_grid.h"
#include "scene/track.h"
#include "session/session.h"
#include "work/workers.h"

namespace mapwright::app {

/// What to draw. The session must not change after this was chosen.
struct SnapshotContent {
  geometry::ViewTransform view;
  bool submaps = false, whole = false;
  std::vector<render::PlacedTexture> textures;  // of a raw picture of submaps
  regions::RegionMap* regions = nullptr;        // a part of a map by regions; null = none
  std::shared_ptr<const scene::Track> track;    // of a whole bag; null = none
  std::optional<clouds::CloudPiece> cloud;      // of the map; nullopt = none came
  std::optional<render::PlacedGrid> grid;       // of a raw picture of a whole map; nullopt = none came
};

class SnapshotPicture : public QObject {
  Q_OBJECT
 public:
  virtual void start() = 0;
  /// Remarks about the picture, known as soon as drawing starts.
  virtual QStringList notes() const { return {}; }
  /// Which share of the picture is drawn, 0..1.
  virtual double made() const = 0;
  /// Writes what has been drawn; the rest stays empty. The error is a sentence.
  virtual std::optional<QString> write(const QString& path) = 0;

 Q_SIGNALS:
  void finished();  // all of it is made
};

/// Draws the window's scene with all its layers.
std::unique_ptr<SnapshotPicture> makeScenePicture(const SnapshotOptions& options, session::Session& session,
                                                  const SnapshotContent& content,
                                                  std::shared_ptr<work::Workers> workers);
/// Draws only the cells: gray = intensity, alpha 0 = not observed (docs/command-line.md, "mapwright
/// snapshot"). Gray pictures of whole maps keep their gray levels, even those that mean "unknown".
std::unique_ptr<SnapshotPicture> makeRawPicture(const SnapshotContent& content,
                                                std::shared_ptr<work::Workers> workers);

}  // namespace mapwright::app
