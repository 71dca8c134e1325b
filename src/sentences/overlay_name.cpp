#include "sentences/overlay_name.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using map::OverlayShape;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Overlay)
};

QString pointName(int type) {
  switch (type) {
    case 3:
      return Words::tr("Other place");
    case 6:
      return Words::tr("Elevator");
    case 9:
      return Words::tr("Charger");
    case 10:
      return Words::tr("Standby point");
    case 11:
      return Words::tr("Table");
    case 19:
      return Words::tr("Reception");
    case 25:
      return Words::tr("Waypoint");
    case 27:
      return Words::tr("Exchange point");
    case 28:
      return Words::tr("Wait for elevator");
    case 29:
      return Words::tr("Dispatch point");
    case 34:
      return Words::tr("Rack point");
    case 36:
      return Words::tr("Docking point");
    case 37:
      return Words::tr("Barcode");
    case 39:
      return Words::tr("Landmark");
    default:
      return {};
  }
}

QString lineName(int type) {
  switch (type) {
    case 1:
      return Words::tr("Virtual track");
    case 2:
      return Words::tr("Virtual wall");
    case 3:
      return Words::tr("Guide line");
    case 4:
      return Words::tr("Patrol path");
    default:
      return {};
  }
}

QString regionName(int type) {
  switch (type) {
    case 1:
      return Words::tr("Forbidden region");
    case 2:
      return Words::tr("Slow zone");
    case 3:
      return Words::tr("Elevator");
    case 4:
      return Words::tr("Automatic gate");
    case 5:
      return Words::tr("Automatic door");
    case 6:
      return Words::tr("Drop risk");
    case 7:
      return Words::tr("Slope");
    case 8:
      return Words::tr("LiDAR deceitful area");
    case 9:
      return Words::tr("Narrow passage");
    case 10:
      return Words::tr("Exclusive region");
    case 12:
      return Words::tr("Free space");
    case 13:
      return Words::tr("Charging region");
    case 15:
      return Words::tr("Depth restricted");
    case 16:
      return Words::tr("Along centre line");
    case 17:
      return Words::tr("Rack zone");
    default:
      return {};
  }
}

QString shapeName(OverlayShape shape) {
  switch (shape) {
    case OverlayShape::Point:
      return Words::tr("Point");
    case OverlayShape::Line:
      return Words::tr("Line");
    case OverlayShape::Polygon:
      break;
  }
  return Words::tr("Region");
}

}  // namespace

QString nameOf(OverlayShape shape, int type) {
  const QString known = shape == OverlayShape::Point  ? pointName(type)
                        : shape == OverlayShape::Line ? lineName(type)
                                                      : regionName(type);
  if (!known.isEmpty()) return known;
  return type == 0 ? shapeName(shape) : QStringLiteral("%1 %2").arg(shapeName(shape)).arg(type);
}

}  // namespace mapwright::sentences
