#include "map/overlay.h"

namespace mapwright::map {
namespace {

const char* pointText(int type) {
  switch (type) {
    case 3:
      return "Other place";
    case 6:
      return "Elevator";
    case 9:
      return "Charger";
    case 10:
      return "Standby point";
    case 11:
      return "Table";
    case 19:
      return "Reception";
    case 25:
      return "Waypoint";
    case 27:
      return "Exchange point";
    case 28:
      return "Wait for elevator";
    case 29:
      return "Dispatch point";
    case 34:
      return "Rack point";
    case 36:
      return "Docking point";
    case 37:
      return "Barcode";
    case 39:
      return "Landmark";
    default:
      return nullptr;
  }
}

const char* lineText(int type) {
  switch (type) {
    case 1:
      return "Virtual track";
    case 2:
      return "Virtual wall";
    case 3:
      return "Guide line";
    case 4:
      return "Patrol path";
    default:
      return nullptr;
  }
}

const char* regionText(int type) {
  switch (type) {
    case 1:
      return "Forbidden region";
    case 2:
      return "Slow zone";
    case 3:
      return "Elevator";
    case 4:
      return "Automatic gate";
    case 5:
      return "Automatic door";
    case 6:
      return "Drop risk";
    case 7:
      return "Slope";
    case 8:
      return "LiDAR deceitful area";
    case 9:
      return "Narrow passage";
    case 10:
      return "Exclusive region";
    case 12:
      return "Free space";
    case 13:
      return "Charging region";
    case 15:
      return "Depth restricted";
    case 16:
      return "Along centre line";
    case 17:
      return "Rack zone";
    default:
      return nullptr;
  }
}

}  // namespace

std::string kindText(OverlayShape shape, int type) {
  const char* known = shape == OverlayShape::Point  ? pointText(type)
                      : shape == OverlayShape::Line ? lineText(type)
                                                    : regionText(type);
  if (known) return known;
  std::string text = shape == OverlayShape::Point ? "Point" : shape == OverlayShape::Line ? "Line" : "Region";
  if (type != 0) text.append(" ").append(std::to_string(type));
  return text;
}

}  // namespace mapwright::map
