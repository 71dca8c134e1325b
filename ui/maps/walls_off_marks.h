// Finds the walls of the reference map and of the map on screen that are far from those of the other one, for
// the layer that marks them. On a thread beside the pool. GUI thread.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include <QObject>

#include "align/walls_off.h"
#include "geometry/pose.h"
#include "render/sample_grid.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/walls_off.h"
#include "work/workers.h"

namespace mapwright::ui {

class WallsOffMarks : public QObject {
  Q_OBJECT
 public:
  /// `scene` must outlive this.
  WallsOffMarks(scene::MapScene* scene, std::shared_ptr<work::Workers> workers, QObject* parent = nullptr);
  ~WallsOffMarks() override;

  struct Subject {
    render::PlacedGrid reference;  // in its own coordinates
    render::PlacedGrid map;
    geometry::Pose2 pose;
    bool operator==(const Subject&) const = default;
    bool sameMaps(const Subject& other) const { return reference == other.reference && map == other.map; }
  };
  /// nullopt: nothing is marked.
  void show(const std::optional<Subject>& subject);
  bool running() const { return running_; }
  /// Null: not known.
  const std::shared_ptr<const scene::WallsOff>& shown() const { return shown_; }

 Q_SIGNALS:
  void found();

 private:
  void start();
  void hand(std::shared_ptr<const scene::WallsOff> walls);

  scene::MapScene* scene_;
  std::optional<Subject> wanted_, made_;
  std::shared_ptr<const align::WallsOff> walls_;  // of the maps of made_
  bool running_ = false;
  std::shared_ptr<const scene::WallsOff> shown_;
  std::atomic<bool> over_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
