// The robot's path through a whole bag, coloured by time, speed or localization quality.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <QString>

#include "ui/scene/layer.h"

namespace mapwright::ui::scene {

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

/// The meaning of the colours of a track.
struct TrackScale {
  TrackChoice choice = TrackChoice::Time;
  double most = 0;  // seconds, metres per second; value of the last colour. 0 = no values
  bool operator==(const TrackScale&) const = default;
};
/// "1:02:03"
QString durationText(double seconds);
/// Speeds end at a round number.
TrackScale scaleOf(const Track& track, TrackChoice choice);

constexpr int kTrackColors = 32;  // steps of a gradient
/// The colour of a sample: for a gradient 0 to kTrackColors - 1, for the quality 0 unknown, 1 lost or poor, 2
/// fair, 3 good.
int colorIndexOf(const TrackSample& sample, const TrackScale& scale);
/// By index, distinguishable for colour-blind people as well.
std::vector<QColor> trackColors(TrackChoice choice);

}  // namespace mapwright::ui::scene
