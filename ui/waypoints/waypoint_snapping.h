// What waypoints snap to while they are moved or created: the user's rules, applied to one place at a time,
// and drawn as guides. GUI thread.
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QSettings>

#include "placing/snap.h"
#include "ui/scene/map_scene.h"
#include "ui/view/hit_list.h"

namespace mapwright::ui {

class WaypointSnapping : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  WaypointSnapping(const scene::MapScene* scene, const HitList* hits, QObject* parent = nullptr);

  bool on() const { return on_; }
  void setOn(bool on);
  const placing::SnapRules& rules() const { return rules_; }
  void setRules(const placing::SnapRules& rules);
  void recall(const QSettings& settings);
  void remember(QSettings& settings) const;

  using Ignored = std::function<bool(const Hit&)>;
  /// Ctrl: the lines of the grid on screen, whatever the rules say. Alt: no snapping. What does not snap is
  /// rounded to a millimetre.
  placing::SnappedPlace place(const Eigen::Vector2d& free_m, Qt::KeyboardModifiers modifiers,
                              const Ignored& ignored);
  /// Ctrl or Shift: the nearest multiple of 15 degrees. Alt: as it is.
  double heading(double yaw_rad, Qt::KeyboardModifiers modifiers) const;
  /// Where it has snapped, and to what, in viewport pixels.
  void paint(QPainter& painter, const placing::SnappedPlace& place) const;

 Q_SIGNALS:
  void changed();

 private:
  const scene::MapScene* scene_;
  const HitList* hits_;
  bool on_ = true;
  placing::SnapRules rules_;
  std::optional<placing::Ground> ground_;  // of the last map
};

/// What lies under the waypoints: the whole map on screen; none while it is being read.
placing::PlacedMap mapUnder(const scene::MapScene& scene);

}  // namespace mapwright::ui
