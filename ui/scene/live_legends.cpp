// What the robot, its plans and its sensor data look like in the legend.
#include <array>
#include <cmath>
#include <memory>

#include <QCoreApplication>

#include "scene/legend.h"

namespace mapwright::scene {
namespace {

class LiveLegendText {
  Q_DECLARE_TR_FUNCTIONS(LiveLegend)
};

constexpr double kHalfLinePx = 18;

std::vector<Eigen::Vector2d> sampleLine() {
  return {LegendSample::at(-kHalfLinePx, 0), LegendSample::at(kHalfLinePx, 0)};
}

void footprints(Legend& legend, const QString& text) {
  legend.addSample(text, [](LegendSample& sample) {
    sample.live.robot_pose = geometry::Pose2{};
    sample.live.model.footprint = sample.live.model.expanded_footprint = LegendSample::box(16, 7);
  });
}

/// Points in a few rows from the left end of a scale to its right end. `made`: for a share of 0 to 1.
template <class Made>
void fillPoints(LegendSample& sample, double per_px, const Made& made) {
  auto points = std::make_shared<std::vector<map::CloudPoint>>();
  const double width = sample.context.view.width_px, height = sample.context.view.height_px;
  for (double x = 0; x <= width; x += per_px) {
    for (double y = 0; y <= height; y += per_px) {
      const Eigen::Vector2d at = LegendSample::at(x - width / 2, y - height / 2);
      map::CloudPoint point = made(x / width);
      point.x_m = at.x();
      point.y_m = at.y();
      points->push_back(point);
    }
  }
  sample.live.clouds[{}] = points;
}

}  // namespace

void robotLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Robot; the tip is its front"),
                   [](LegendSample& sample) { sample.live.robot_pose = geometry::Pose2{}; });
}

void footprintLegend(Legend& legend) { footprints(legend, LiveLegendText::tr("Outline of the robot")); }

void expandedFootprintLegend(Legend& legend) {
  footprints(legend, LiveLegendText::tr("The outline with its safety margin"));
}

void trailLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Where the robot was"), [](LegendSample& sample) {
    for (double x = -kHalfLinePx; x <= kHalfLinePx; x += 2)
      sample.live.trail.push_back({LegendSample::at(x, 0), x});
  });
}

void pathLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Planned path to the target"),
                   [](LegendSample& sample) { sample.live.path = sampleLine(); });
}

void localPathLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Next part of the path, as wide as the robot"),
                   [](LegendSample& sample) {
                     sample.live.local_path.points = sampleLine();
                     sample.live.local_path.width_m = 12 * LegendSample::kMPerPx;
                   });
}

void trajectoryLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Way on which the map was made"),
                   [](LegendSample& sample) { sample.live.trajectory = sampleLine(); });
}

void targetLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Target, with its heading"), [](LegendSample& sample) {
    const Eigen::Vector2d at = LegendSample::at(-3, 0);
    sample.live.planning.emplace().targets = {{at.x(), at.y(), 0}};
  });
}

void nearbyRobotsLegend(Legend& legend) {
  legend.addSample(LiveLegendText::tr("Other robot; dotted: where it is going"), [](LegendSample& sample) {
    map::NearbyRobot other;
    const Eigen::Vector2d at = LegendSample::at(-9, 0);
    other.pose = {at.x(), at.y(), 0};
    other.footprint_digest = "f";
    other.trend = {at, LegendSample::at(kHalfLinePx, 0)};
    sample.live.nearby_footprints["f"] = LegendSample::box(9, 7);
    sample.live.nearby_robots = {other};
  });
}

void constraintsLegend(Legend& legend) {
  const auto add = [&](const QString& text, const char* name) {
    legend.addSample(text, [name](LegendSample& sample) {
      sample.live.constraints.by_name[name] = {{LegendSample::at(-kHalfLinePx, 3), LegendSample::at(0, -5)},
                                               {LegendSample::at(0, -5), LegendSample::at(kHalfLinePx, 5)}};
    });
  };
  add(LiveLegendText::tr("Constraint"), "constraints");
  add(LiveLegendText::tr("Residual: the error that remains"), "residuals");
}

void lidarLegend(Legend& legend) {
  switch (CloudChoice(legend.style().choice)) {
    case CloudChoice::Intensity:
      return legend.addSampleScale(LiveLegendText::tr("weak"), LiveLegendText::tr("strong echo"),
                                   [](LegendSample& sample) {
                                     fillPoints(sample, 1, [](double share) {
                                       map::CloudPoint point;
                                       point.intensity = std::uint8_t(std::lround(share * 255));
                                       return point;
                                     });
                                   });
    case CloudChoice::Height:
      return legend.addSampleScale(LiveLegendText::tr("%1 m").arg(0),
                                   LiveLegendText::tr("%1 m").arg(double(kLidarFullHeightM)),
                                   [](LegendSample& sample) {
                                     fillPoints(sample, 1, [](double share) {
                                       map::CloudPoint point;
                                       point.z_m = float(share) * kLidarFullHeightM;
                                       return point;
                                     });
                                   });
    case CloudChoice::OneColor:
      break;
  }
  legend.addSample(LiveLegendText::tr("Lidar point"), [](LegendSample& sample) {
    fillPoints(sample, 9, [](double) { return map::CloudPoint(); });
  });
}

void trackLegend(Legend& legend) {
  if (!legend.context().track) return;
  const auto way = [](int quality, int steps) {
    return [quality, steps](LegendSample& sample) {
      const double half = sample.context.view.width_px / 2.0 - 4;
      auto track = std::make_shared<Track>();
      for (int i = 0; i <= steps; ++i) {
        const double share = double(i) / steps;
        track->push_back({LegendSample::at(half * (2 * share - 1), 0), share, share, quality, i == 0});
      }
      sample.context.track = track;
    };
  };
  constexpr int kFine = 200;
  switch (TrackChoice(legend.style().choice)) {
    case TrackChoice::Time:
      return legend.addSampleScale(LiveLegendText::tr("start"), LiveLegendText::tr("end of the bag"),
                                   way(0, kFine));
    case TrackChoice::Speed:
      return legend.addSampleScale(LiveLegendText::tr("standing"), LiveLegendText::tr("fastest"),
                                   way(0, kFine));
    case TrackChoice::Quality:
      break;
  }
  legend.addSample(LiveLegendText::tr("Localization: good"), way(10, 2));
  legend.addSample(LiveLegendText::tr("Localization: fair"), way(5, 2));
  legend.addSample(LiveLegendText::tr("Localization: poor or lost"), way(1, 2));
  legend.addSample(LiveLegendText::tr("Localization: unknown"), way(0, 2));
}

}  // namespace mapwright::scene
