// What the robot, its plans and its sensor data look like in the legend.
#include <cmath>
#include <memory>

#include <QCoreApplication>

#include "scene/legend.h"

namespace mapwright::scene {
namespace {

class LiveLegendText {
  Q_DECLARE_TR_FUNCTIONS(LiveLegend)
};

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
  legend.addThing(LiveLegendText::tr("Robot; the tip is its front"), ObjectForm::Point);
}

void footprintLegend(Legend& legend) { footprints(legend, LiveLegendText::tr("Outline of the robot")); }

void expandedFootprintLegend(Legend& legend) {
  footprints(legend, LiveLegendText::tr("The outline with its safety margin"));
}

void trailLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Where the robot was"), ObjectForm::Line);
}

void pathLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Planned path to the target"), ObjectForm::Line);
}

void localPathLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Next part of the path, as wide as the robot"), ObjectForm::Line);
}

void trajectoryLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Path along which the map was made"), ObjectForm::Line);
}

void targetLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Target, with its heading"), ObjectForm::Point);
}

void nearbyRobotsLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Other robot; dotted: where it is going"), ObjectForm::Point);
}

void constraintsLegend(Legend& legend) {
  legend.addThing(LiveLegendText::tr("Constraint"), ObjectForm::Line, 0);
  legend.addThing(LiveLegendText::tr("Residual: the error that remains"), ObjectForm::Line, 1);
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
  const Legend::Fill whole = [](LegendSample& sample) {
    fillSample(sample, Layer::Track, ObjectForm::Line, 0);
  };
  switch (TrackChoice(legend.style().choice)) {
    case TrackChoice::Time:
      return legend.addSampleScale(LiveLegendText::tr("start"), LiveLegendText::tr("end of the bag"), whole);
    case TrackChoice::Speed:
      return legend.addSampleScale(LiveLegendText::tr("standing"), LiveLegendText::tr("fastest"), whole);
    case TrackChoice::Quality:
      break;
  }
  constexpr int kGood = 10, kFair = 5, kPoor = 1, kUnknown = 0;
  legend.addThing(LiveLegendText::tr("Localization: good"), ObjectForm::Line, kGood);
  legend.addThing(LiveLegendText::tr("Localization: fair"), ObjectForm::Line, kFair);
  legend.addThing(LiveLegendText::tr("Localization: poor or lost"), ObjectForm::Line, kPoor);
  legend.addThing(LiveLegendText::tr("Localization: unknown"), ObjectForm::Line, kUnknown);
}

}  // namespace mapwright::scene
