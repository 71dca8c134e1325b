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

/// One row for all types that look the same.
void addOverlays(Legend& legend, ObjectForm form, OverlayShape shape, const QString& others) {
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
    const QImage image = legend.lookOf(form, type);
    auto look = std::find_if(looks.begin(), looks.end(), [&](const Look& l) { return l.image == image; });
    if (look == looks.end()) look = looks.insert(looks.end(), {image, type, {}, false});
    look->others |= type == 0;
    look->names << sentences::nameOf(shape, type);
  }
  std::stable_partition(looks.begin(), looks.end(), [](const Look& look) { return !look.others; });
  for (const Look& look : looks) {
    const QString text = look.others ? others : look.names.join(FeatureLegendText::tr(", "));
    legend.addThing(text, form, look.first);
  }
}

}  // namespace

void overlaysLegend(Legend& legend) {
  addOverlays(legend, ObjectForm::Area, OverlayShape::Polygon, FeatureLegendText::tr("Other regions"));
  addOverlays(legend, ObjectForm::Line, OverlayShape::Line, FeatureLegendText::tr("Other lines"));
  addOverlays(legend, ObjectForm::Point, OverlayShape::Point, FeatureLegendText::tr("Other points"));
}

void waypointsLegend(Legend& legend) {
  const auto add = [&](WaypointMark mark, const QString& text, const QString& warnings = {}) {
    DrawnWaypoint point;
    point.mark = mark;
    point.warnings = warnings;
    legend.addThing(text, ObjectForm::Point, whichLook(point));
  };
  add(WaypointMark::Saved, FeatureLegendText::tr("Saved"));
  add(WaypointMark::Unsaved, FeatureLegendText::tr("Changed, not saved yet"));
  add(WaypointMark::New, FeatureLegendText::tr("New, not saved yet"));
  add(WaypointMark::Deleted, FeatureLegendText::tr("Deleted, not saved yet"));
  add(WaypointMark::Sent, FeatureLegendText::tr("Sent, not confirmed yet"));
  add(WaypointMark::Conflict, FeatureLegendText::tr("In conflict: mine"));
  add(WaypointMark::Theirs, FeatureLegendText::tr("In conflict: the other version"));
  legend.addSample(FeatureLegendText::tr("Selected"), [](LegendSample& sample) {
    DrawnWaypoint point;
    point.selected = true;
    sample.context.of(FeaturesOf::WholeMap).waypoints = {point};
  });
  add(WaypointMark::Saved, FeatureLegendText::tr("With a warning"), QStringLiteral("!"));
}

void landmarksLegend(Legend& legend) {
  legend.addThing(FeatureLegendText::tr("Landmark"), ObjectForm::Point, 1);
  legend.addThing(FeatureLegendText::tr("Landmark that is not in use"), ObjectForm::Point, 0);
}

void doorsLegend(Legend& legend) {
  legend.addThing(FeatureLegendText::tr("Open"), ObjectForm::Area, kOpenDoor);
  legend.addThing(FeatureLegendText::tr("Closed"), ObjectForm::Area, kClosedDoor);
  legend.addThing(FeatureLegendText::tr("Moving, or state unknown"), ObjectForm::Area, kOtherDoor);
}

void boxesLegend(Legend& legend) {
  legend.addThing(FeatureLegendText::tr("Pallet, rack or object, with its heading"), ObjectForm::Area, -1);
}

}  // namespace mapwright::scene
