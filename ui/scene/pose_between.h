// Where the robot is drawn between two samples of a replay: for the eye alone, no part of the live state.
#pragma once

#include <optional>

#include <QObject>

#include "geometry/pose.h"
#include "scene/map_scene.h"

namespace mapwright::scene {

class PoseBetween : public QObject {
  Q_OBJECT
 public:
  /// That of this scene; lives as long as it.
  static PoseBetween& of(const MapScene& scene);
  /// The scene makes one for itself.
  explicit PoseBetween(MapScene* scene);

  /// Drawn in the place of the session's pose, world metres; nullopt: that one. Without a session's pose
  /// nothing is drawn. It is let go with the session.
  void show(const std::optional<geometry::Pose2>& pose);
  const std::optional<geometry::Pose2>& pose() const { return pose_; }

 Q_SIGNALS:
  void changed();

 private:
  std::optional<geometry::Pose2> pose_;
};

/// Where the robot is drawn now, if anywhere.
std::optional<geometry::Pose2> poseDrawn(const MapScene& scene);

}  // namespace mapwright::scene
