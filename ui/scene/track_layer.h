// Draws the robot's path through a whole bag, coloured by time, speed or localization quality. Private to
// this room.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QPolygonF>

#include "scene/bag_track.h"
#include "scene/layer_item.h"

namespace mapwright::scene {

/// The meaning of the colours of a track.
struct TrackScale {
  TrackChoice choice = TrackChoice::Time;
  double most = 0;  // seconds, metres per second; value of the last colour. 0 = no values
  bool operator==(const TrackScale&) const = default;
};
/// Speeds end at a round number.
TrackScale scaleOf(const Track& track, TrackChoice choice);

constexpr int kTrackColors = 32;  // steps of a gradient
/// The colour of a sample: for a gradient 0 to kTrackColors - 1, for the quality 0 unknown, 1 lost or poor, 2
/// fair, 3 good.
int colorIndexOf(const TrackSample& sample, const TrackScale& scale);
/// By index, distinguishable for colour-blind people as well.
std::vector<QColor> trackColors(TrackChoice choice, const MapTheme& theme);

class TrackLayer : public LayerItem {
 public:
  TrackLayer(const LayerContext& context, const std::shared_ptr<const Track>& track);
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Run {
    int color = 0;
    QPolygonF line;
    QRectF bounds;
  };
  void layOut();
  void paintLegend(QPainter& painter, const QRectF& exposed) const;

  const std::shared_ptr<const Track>& track_;
  /// What `runs_` were computed for.
  std::shared_ptr<const Track> laid_out_;
  std::optional<geometry::ViewTransform> laid_out_view_;
  TrackScale scale_;
  std::vector<Run> runs_;
};

}  // namespace mapwright::scene
