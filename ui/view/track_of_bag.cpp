#include "ui/view/track_of_bag.h"

#include <algorithm>

#include "replay/track.h"

namespace mapwright::ui {

std::shared_ptr<const scene::Track> trackOfBag(const replay::Reading& reading) {
  const std::vector<replay::TrackPoint> points = replay::trackOf(reading.index().digests());
  auto track = std::make_shared<scene::Track>();
  track->reserve(points.size());
  const double start_s = points.empty() ? 0 : std::min(points.front().stamp_s, reading.chunks().start_s());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const replay::TrackPoint& point = points[i];
    track->push_back({{point.pose.x_m, point.pose.y_m},
                      point.stamp_s - start_s,
                      point.speed_m_s,
                      point.quality,
                      i == 0 || points[i - 1].piece != point.piece});
  }
  return track;
}

}  // namespace mapwright::ui
