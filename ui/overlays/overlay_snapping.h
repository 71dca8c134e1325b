// What overlays snap to while they are drawn and dragged: the user's choice, applied to one place at a time,
// and drawn beside the cursor. GUI thread.
#pragma once

#include <optional>
#include <set>

#include <QObject>
#include <QSettings>

#include "overlays/overlay_snap.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlays_on_map.h"
#include "ui/scene/map_scene.h"

class QPainter;

namespace mapwright::ui {

class OverlaySnapping : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this.
  OverlaySnapping(edit::OverlayEditing* editing, const scene::MapScene* scene, const OverlaysOnMap* on_map,
                  QObject* parent = nullptr);

  bool on() const { return on_; }
  void setOn(bool on);
  const overlays::SnapKinds& kinds() const { return kinds_; }
  void setKinds(const overlays::SnapKinds& kinds);
  void recall(const QSettings& settings);
  void remember(QSettings& settings) const;

  /// Alt: as it is. `ignored`: what the hand holds. `arms_m`: the points from which
  /// angles are counted: steps of 15 degrees from the last one, of 90 from neighbours.
  overlays::Snapped place(const Eigen::Vector2d& free_m, Qt::KeyboardModifiers modifiers,
                          const std::set<FeatureKey>& ignored, std::vector<Eigen::Vector2d> arms_m = {},
                          double angle_step_deg = 15);
  /// Where it has snapped, and to what, in viewport pixels.
  void paint(QPainter& painter, const overlays::Snapped& place) const;
  /// "Snapped to a point (Alt: not). "; empty: to nothing.
  static QString hintOf(overlays::SnapTo to);

 Q_SIGNALS:
  void changed();

 private:
  const overlays::SnapIndex& index();

  edit::OverlayEditing* editing_;
  const scene::MapScene* scene_;
  const OverlaysOnMap* on_map_;
  bool on_ = true;
  overlays::SnapKinds kinds_;
  std::optional<overlays::SnapIndex> index_;  // of the document as it is; made when it is asked for
  std::optional<placing::Ground> ground_;     // of the last map
};

}  // namespace mapwright::ui
