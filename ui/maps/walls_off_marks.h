// Walls of the reference map and of the map on screen that are far from those of the other one, as marks on
// the map: a bent corridor is seen by them. Found on a thread beside the pool. GUI thread.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <QColor>
#include <QObject>

#include "align/walls_off.h"
#include "geometry/pose.h"
#include "render/sample_grid.h"
#include "ui/scene/map_scene.h"
#include "work/workers.h"

namespace mapwright::ui {

/// How far walls may be off before they are marked otherwise.
inline constexpr std::array<double, 3> kOffSteps_m{0.1, 0.3, 1};
/// The look of a step: colours differ in lightness, and marks in size.
QColor offColor(std::size_t step);
inline constexpr std::array<double, 3> kOffMarks_px{3, 5, 8};

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
  const std::vector<align::OffWall>& shown() const;

 Q_SIGNALS:
  void found();

 private:
  class Item;
  void start();

  scene::MapScene* scene_;
  std::optional<Subject> wanted_, made_;
  std::shared_ptr<const align::WallsOff> walls_;  // of the maps of made_
  bool running_ = false;
  std::unique_ptr<Item> item_;
  std::atomic<bool> over_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
