// The way that the robot took through a whole bag, to lie on the map. Values, and where the scene keeps them.
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
  bool begins = false;  // nothing is drawn from the sample before to this one
  bool operator==(const TrackSample&) const = default;
};
/// By time.
using Track = std::vector<TrackSample>;

class BagTrack : public QObject {
  Q_OBJECT
 public:
  /// That of this scene; lives as long as it.
  static BagTrack& of(const MapScene& scene);
  /// The scene makes one for itself.
  explicit BagTrack(MapScene* scene);

  /// null: none. It is let go with the session.
  void show(std::shared_ptr<const Track> track);
  const std::shared_ptr<const Track>& track() const { return track_; }

 Q_SIGNALS:
  void changed();

 private:
  std::shared_ptr<const Track> track_;
};

}  // namespace mapwright::scene
