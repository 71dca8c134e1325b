// What the features of a map, and those on the ground, look like in the legend.
#include <algorithm>

#include <QCoreApplication>

#include "scene/legend.h"
#include "sentences/overlay_name.h"

namespace mapwright::scene {
namespace {

using map::OverlayShape;

class FeatureLegendText {
  Q_DECLARE_TR_FUNCTIONS(FeatureLegend)
};

Legend::Fill overlaySample(OverlayShape shape, int type) {
  return [shape, type](LegendSample& sample) {
    map::OverlayFeature feature;
    feature.shape = shape;
    feature.type = type;
    if (shape == OverlayShape::Point) feature.parts = {{LegendSample::at(0, 0)}};
    if (shape == OverlayShape::Line) feature.parts = {{LegendSample::at(-17, 0), LegendSample::at(17, 0)}};
    if (shape == OverlayShape::Polygon) feature.parts = {LegendSample::box(17, 7)};
    sample.context.of(FeaturesOf::WholeMap).overlays = {feature};
  };
}

/// One row for all types that look the same.
void addOverlays(Legend& legend, OverlayShape shape, const QString& others) {
  struct Look {
    QImage image;
    int first = 0;
    QStringList names;
    bool others = false;
  };
  std::vector<Look> looks;
  std::vector<int> types = sentences::knownTypes(shape);
  types.push_back(0);  // one without a type, or with one that is not known
  for (const int type : types) {
    const QImage image = legend.lookOf(overlaySample(shape, type));
    auto look = std::find_if(looks.begin(), looks.end(), [&](const Look& l) { return l.image == image; });
    if (look == looks.end()) look = looks.insert(looks.end(), {image, type, {}, false});
    look->others |= type == 0;
    look->names << sentences::nameOf(shape, type);
  }
  std::stable_partition(looks.begin(), looks.end(), [](const Look& look) { return !look.others; });
  for (const Look& look : looks) {
    const QString text = look.others ? others : look.names.join(FeatureLegendText::tr(", "));
    legend.addSample(text, overlaySample(shape, look.first));
  }
}

void addWaypoint(Legend& legend, const QString& text, const DrawnWaypoint& point) {
  legend.addSample(
      text, [&](LegendSample& sample) { sample.context.of(FeaturesOf::WholeMap).waypoints = {point}; });
}

}  // namespace

void overlaysLegend(Legend& legend) {
  addOverlays(legend, OverlayShape::Polygon, FeatureLegendText::tr("Other regions"));
  addOverlays(legend, OverlayShape::Line, FeatureLegendText::tr("Other lines"));
  addOverlays(legend, OverlayShape::Point, FeatureLegendText::tr("Other points"));
}

void waypointsLegend(Legend& legend) {
  const auto add = [&](WaypointMark mark, const QString& text) {
    DrawnWaypoint point;
    point.mark = mark;
    addWaypoint(legend, text, point);
  };
  add(WaypointMark::Saved, FeatureLegendText::tr("Saved"));
  add(WaypointMark::Unsaved, FeatureLegendText::tr("Changed, not saved yet"));
  add(WaypointMark::New, FeatureLegendText::tr("New, not saved yet"));
  add(WaypointMark::Deleted, FeatureLegendText::tr("Deleted, not saved yet"));
  add(WaypointMark::Sent, FeatureLegendText::tr("Sent, not confirmed yet"));
  add(WaypointMark::Conflict, FeatureLegendText::tr("In conflict: mine"));
  add(WaypointMark::Theirs, FeatureLegendText::tr("In conflict: the other version"));
  DrawnWaypoint point;
  point.selected = true;
  addWaypoint(legend, FeatureLegendText::tr("Selected"), point);
  point.selected = false;
  point.warnings = QStringLiteral("!");
  addWaypoint(legend, FeatureLegendText::tr("With a warning"), point);
}

void landmarksLegend(Legend& legend) {
  const auto add = [&](const QString& text, bool in_use) {
    legend.addSample(text, [in_use](LegendSample& sample) {
      sample.live.landmarks = {{{}, LegendSample::at(0, 0), in_use}};
    });
  };
  add(FeatureLegendText::tr("Landmark"), true);
  add(FeatureLegendText::tr("Landmark that is not in use"), false);
}

void doorsLegend(Legend& legend) {
  const auto add = [&](const QString& text, const char* state) {
    legend.addSample(text, [state](LegendSample& sample) {
      sample.live.doors = {{{}, {}, state, LegendSample::box(17, 5)}};
    });
  };
  add(FeatureLegendText::tr("Open"), "open");
  add(FeatureLegendText::tr("Closed"), "closed");
  add(FeatureLegendText::tr("Moving, or state unknown"), "");
}

void boxesLegend(Legend& legend) {
  legend.addSample(FeatureLegendText::tr("Pallet, rack or object, with its heading"),
                   [](LegendSample& sample) {
                     map::GroundBox box;
                     box.length_m = 34 * LegendSample::kMPerPx;
                     box.width_m = 14 * LegendSample::kMPerPx;
                     sample.live.seen_objects = {box};
                   });
}

}  // namespace mapwright::scene
