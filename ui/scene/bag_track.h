// The robot's path through a whole bag, for the map. Values, and their place in the scene.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <QObject>

#include "scene/map_scene.h"

namespace mapwright::scene {

struct TrackSample {
  Eigen::Vector2d position_m{0, 0};  // world
  double at_s = 0;                   // since the start of the bag
  double speed_m_s = 0;
  int quality = 0;      // 0 unknown, 1 lost, 3 poor, 8 good, 10 excellent
  bool begins = false;  // there is no line from the previous sample to this one
  bool operator==(const TrackSample&) const = default;
};
/// By time.
using Track = std::vector<TrackSample>;

class BagTrack : public QObject {
  Q_OBJECT
 public:
  /// The one of this scene; lives as long as it.
  static BagTrack& of(const MapScene& scene);
  /// Made by the scene itself.
  explicit BagTrack(MapScene* scene);

  /// null: none. Dropped with the session.
  void show(std::shared_ptr<const Track> track);
  const std::shared_ptr<const Track>& track() const { return track_; }

 Q_SIGNALS:
  void changed();

 private:
  std::shared_ptr<const Track> track_;
};

}  // namespace mapwright::scene
