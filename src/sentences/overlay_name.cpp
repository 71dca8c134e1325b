#include "sentences/overlay_name.h"

#include <algorithm>
#include <span>

#include <QCoreApplication>

namespace mapwright::sentences {
namespace {

using map::OverlayShape;

/// What a type of the maker's is called.
struct TypeName {
  int type;
  const char* name;
};

constexpr TypeName kPoints[] = {
    {3, QT_TRANSLATE_NOOP("Overlay", "Other place")},
    {6, QT_TRANSLATE_NOOP("Overlay", "Elevator")},
    {9, QT_TRANSLATE_NOOP("Overlay", "Charger")},
    {10, QT_TRANSLATE_NOOP("Overlay", "Standby point")},
    {11, QT_TRANSLATE_NOOP("Overlay", "Table")},
    {19, QT_TRANSLATE_NOOP("Overlay", "Reception")},
    {25, QT_TRANSLATE_NOOP("Overlay", "Waypoint")},
    {27, QT_TRANSLATE_NOOP("Overlay", "Exchange point")},
    {28, QT_TRANSLATE_NOOP("Overlay", "Wait for elevator")},
    {29, QT_TRANSLATE_NOOP("Overlay", "Dispatch point")},
    {34, QT_TRANSLATE_NOOP("Overlay", "Rack point")},
    {36, QT_TRANSLATE_NOOP("Overlay", "Docking point")},
    {37, QT_TRANSLATE_NOOP("Overlay", "Barcode")},
    {39, QT_TRANSLATE_NOOP("Overlay", "Landmark")},
};

constexpr TypeName kLines[] = {
    {1, QT_TRANSLATE_NOOP("Overlay", "Virtual track")},
    {2, QT_TRANSLATE_NOOP("Overlay", "Virtual wall")},
    {3, QT_TRANSLATE_NOOP("Overlay", "Guide line")},
    {4, QT_TRANSLATE_NOOP("Overlay", "Patrol path")},
};

constexpr TypeName kRegions[] = {
    {1, QT_TRANSLATE_NOOP("Overlay", "Forbidden region")},
    {2, QT_TRANSLATE_NOOP("Overlay", "Slow zone")},
    {3, QT_TRANSLATE_NOOP("Overlay", "Elevator")},
    {4, QT_TRANSLATE_NOOP("Overlay", "Automatic gate")},
    {5, QT_TRANSLATE_NOOP("Overlay", "Automatic door")},
    {6, QT_TRANSLATE_NOOP("Overlay", "Drop risk")},
    {7, QT_TRANSLATE_NOOP("Overlay", "Slope")},
    {8, QT_TRANSLATE_NOOP("Overlay", "LiDAR deceitful area")},
    {9, QT_TRANSLATE_NOOP("Overlay", "Narrow passage")},
    {10, QT_TRANSLATE_NOOP("Overlay", "Exclusive region")},
    {12, QT_TRANSLATE_NOOP("Overlay", "Free space")},
    {13, QT_TRANSLATE_NOOP("Overlay", "Charging region")},
    {15, QT_TRANSLATE_NOOP("Overlay", "Depth restricted")},
    {16, QT_TRANSLATE_NOOP("Overlay", "Along centre line")},
    {17, QT_TRANSLATE_NOOP("Overlay", "Rack zone")},
};

std::span<const TypeName> typesOf(OverlayShape shape) {
  if (shape == OverlayShape::Point) return kPoints;
  if (shape == OverlayShape::Line) return kLines;
  return kRegions;
}

QString translated(const char* name) { return QCoreApplication::translate("Overlay", name); }

}  // namespace

QString nameOf(OverlayShape shape, int type) {
  const std::span<const TypeName> types = typesOf(shape);
  const char* any = QT_TRANSLATE_NOOP("Overlay", "Region");
  if (shape == OverlayShape::Point) any = QT_TRANSLATE_NOOP("Overlay", "Point");
  if (shape == OverlayShape::Line) any = QT_TRANSLATE_NOOP("Overlay", "Line");
  const auto known =
      std::find_if(types.begin(), types.end(), [type](const TypeName& each) { return each.type == type; });
  if (known != types.end()) return translated(known->name);
  return type == 0 ? translated(any) : QStringLiteral("%1 %2").arg(translated(any)).arg(type);
}

std::vector<int> knownTypes(OverlayShape shape) {
  std::vector<int> types;
  for (const TypeName& each : typesOf(shape)) types.push_back(each.type);
  return types;
}

}  // namespace mapwright::sentences
