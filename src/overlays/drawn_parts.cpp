#include "overlays/drawn_parts.h"

#include <charconv>
#include <numbers>
#include <utility>

#include "overlays/faults.h"
#include "overlays/overlay_edits.h"
#include "overlays/overlay_shapes.h"

namespace mapwright::overlays {
namespace {

map::OverlayShape drawnShape(Shape shape) {
  return shape == Shape::Line      ? map::OverlayShape::Line
         : shape == Shape::Polygon ? map::OverlayShape::Polygon
                                   : map::OverlayShape::Point;
}

int typeAs(const Feature& feature, Shape shape) {
  const auto value = feature.property(typeProperty(shape));
  if (!value) return 0;
  const std::string written =
      value->kind() == JsonKind::String ? value->string() : std::string(value->text());
  int type = 0;
  std::from_chars(written.data(), written.data() + written.size(), type);
  return type;
}

}  // namespace

std::vector<map::OverlayFeature> partsToDraw(const Feature& feature) {
  std::vector<map::OverlayFeature> parts;
  int polygon = -1;
  for (Path& path : shapesOf(feature).paths) {
    if (path.points.empty()) continue;
    if (path.shape == Shape::Polygon && path.polygon == polygon && !parts.empty()) {
      parts.back().parts.push_back(std::move(path.points));
      continue;
    }
    polygon = path.polygon;
    map::OverlayFeature drawn;
    drawn.shape = drawnShape(path.shape);
    drawn.type = typeAs(feature, path.shape);
    drawn.id = feature.id();
    drawn.name = feature.name();
    const auto degrees = yawOf(feature);
    if (drawn.shape == map::OverlayShape::Point && degrees) drawn.yaw_rad = *degrees * std::numbers::pi / 180;
    drawn.parts.push_back(std::move(path.points));
    parts.push_back(std::move(drawn));
  }
  return parts;
}

std::optional<map::BrokenOverlay> notDrawn(const Feature& feature) {
  const Shapes shapes = shapesOf(feature);
  const auto broken = [&](Fault why) {
    return map::BrokenOverlay{feature.id(), feature.name(), std::move(why), shapes.somewhere()};
  };
  if (!isFeature(feature)) return broken(fault::NoFeature);
  if (shapes.unknown) return broken({fault::GeometryUnknown, {*shapes.unknown}});
  if (shapes.bad) return broken({fault::BadCoordinate, {*shapes.bad}});
  const auto geometry = feature.root().member("geometry");
  if (geometry && geometry->kind() != JsonKind::Null && !shapes.somewhere()) return broken(fault::NoPoints);
  return std::nullopt;
}

}  // namespace mapwright::overlays
