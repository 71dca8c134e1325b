// The interpolated pose of the robot between two samples of a replay: for display only, not part of the live
// state.
#pragma once

#include <optional>

#include <QObject>

#include "geometry/pose.h"
#include "scene/map_scene.h"

namespace mapwright::scene {

class PoseBetween : public QObject {
  Q_OBJECT
 public:
  /// The one of this scene; lives as long as it.
  static PoseBetween& of(const MapScene& scene);
  /// Made by the scene itself.
  explicit PoseBetween(MapScene* scene);

  /// Drawn instead of the session's pose, world metres; nullopt: the session's. Without a session's pose
  /// nothing is drawn. Dropped with the session.
  void show(const std::optional<geometry::Pose2>& pose);
  const std::optional<geometry::Pose2>& pose() const { return pose_; }

 Q_SIGNALS:
  void changed();

 private:
  std::optional<geometry::Pose2> pose_;
};

/// Where the robot is drawn at present, if anywhere.
std::optional<geometry::Pose2> poseDrawn(const MapScene& scene);

}  // namespace mapwright::scene
