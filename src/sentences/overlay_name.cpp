#include "sentences/overlay_name.h"

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using map::OverlayShape;

class OverlayText {
  Q_DECLARE_TR_FUNCTIONS(Overlay)
};

QString pointName(int type) {
  switch (type) {
    case 3:
      return OverlayText::tr("Other place");
    case 6:
      return OverlayText::tr("Elevator");
    case 9:
      return OverlayText::tr("Charger");
    case 10:
      return OverlayText::tr("Standby point");
    case 11:
      return OverlayText::tr("Table");
    case 19:
      return OverlayText::tr("Reception");
    case 25:
      return OverlayText::tr("Waypoint");
    case 27:
      return OverlayText::tr("Exchange point");
    case 28:
      return OverlayText::tr("Wait for elevator");
    case 29:
      return OverlayText::tr("Dispatch point");
    case 34:
      return OverlayText::tr("Rack point");
    case 36:
      return OverlayText::tr("Docking point");
    case 37:
      return OverlayText::tr("Barcode");
    case 39:
      return OverlayText::tr("Landmark");
    default:
      return {};
  }
}

QString lineName(int type) {
  switch (type) {
    case 1:
      return OverlayText::tr("Virtual track");
    case 2:
      return OverlayText::tr("Virtual wall");
    case 3:
      return OverlayText::tr("Guide line");
    case 4:
      return OverlayText::tr("Patrol path");
    default:
      return {};
  }
}

QString regionName(int type) {
  switch (type) {
    case 1:
      return OverlayText::tr("Forbidden region");
    case 2:
      return OverlayText::tr("Slow zone");
    case 3:
      return OverlayText::tr("Elevator");
    case 4:
      return OverlayText::tr("Automatic gate");
    case 5:
      return OverlayText::tr("Automatic door");
    case 6:
      return OverlayText::tr("Drop risk");
    case 7:
      return OverlayText::tr("Slope");
    case 8:
      return OverlayText::tr("LiDAR deceitful area");
    case 9:
      return OverlayText::tr("Narrow passage");
    case 10:
      return OverlayText::tr("Exclusive region");
    case 12:
      return OverlayText::tr("Free space");
    case 13:
      return OverlayText::tr("Charging region");
    case 15:
      return OverlayText::tr("Depth restricted");
    case 16:
      return OverlayText::tr("Along centre line");
    case 17:
      return OverlayText::tr("Rack zone");
    default:
      return {};
  }
}

QString shapeName(OverlayShape shape) {
  switch (shape) {
    case OverlayShape::Point:
      return OverlayText::tr("Point");
    case OverlayShape::Line:
      return OverlayText::tr("Line");
    case OverlayShape::Polygon:
      break;
  }
  return OverlayText::tr("Region");
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
