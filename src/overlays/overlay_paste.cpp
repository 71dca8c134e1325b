#include "overlays/overlay_paste.h"

#include <algorithm>
#include <utility>

#include "overlays/faults.h"
#include "overlays/overlay_shapes.h"

namespace mapwright::overlays {
namespace {

std::string typeOf(const JsonValue& value) {
  const auto type = value.isObject() ? value.member("type") : std::nullopt;
  return type ? type->string() : std::string();
}

bool isGeometry(const std::string& type) {
  constexpr std::string_view kTypes[] = {"Point",           "LineString",   "Polygon",           "MultiPoint",
                                         "MultiLineString", "MultiPolygon", "GeometryCollection"};
  return std::find(std::begin(kTypes), std::end(kTypes), type) != std::end(kTypes);
}

/// Nothing is lost when it is pasted. `number` counts from 1.
std::optional<Fault> whyNot(const JsonValue& written, const Feature& feature, std::int64_t number) {
  if (!written.isObject()) return Fault(fault::PastedNoFeature, {number});
  const auto geometry = written.member("geometry");
  if (!geometry || !geometry->isObject()) return Fault(fault::PastedWithoutPlace, {number});
  const std::string type = typeOf(*geometry);
  if (!isGeometry(type)) return Fault(fault::PastedGeometryUnknown, {number, type});
  const Shapes shapes = shapesOf(feature);
  if (shapes.bad) return Fault(fault::PastedCoordinateUnusable, {number, *shapes.bad});
  if (!shapes.somewhere()) return Fault(fault::PastedWithoutPlace, {number});
  for (const Path& path : shapes.paths) {
    const std::size_t least = path.shape == Shape::Line ? 2 : path.shape == Shape::Polygon ? 3 : 1;
    if (path.points.size() < least) return Fault(fault::PastedTooFewPoints, {number});
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::vector<Feature>, Fault> pastedFeatures(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  // Not even the beginning of one: a word or a picture, not a mistake in a text.
  if (first == std::string::npos || (text[first] != '{' && text[first] != '['))
    return tl::make_unexpected(Fault(fault::PastedNothing));
  const auto json = JsonText::read(text);
  if (!json) return tl::make_unexpected(faultOf(json.error()));
  const JsonValue root = json->root();
  const std::string type = typeOf(root);
  if (isGeometry(type)) {
    const Feature feature(R"({"type": "Feature", "geometry": )" + std::string(root.text()) +
                          R"(, "properties": {}})");
    if (const auto why = whyNot(feature.root(), feature, 1)) return tl::make_unexpected(*why);
    return std::vector<Feature>{feature};
  }
  std::vector<JsonValue> written;
  if (root.isArray()) {
    written = root.children();
  } else if (const auto list = root.member("features"); list && list->isArray()) {
    written = list->children();
  } else if (type == "Feature" || root.member("geometry")) {
    written.push_back(root);
  } else {
    return tl::make_unexpected(Fault(fault::NoCollection));
  }
  if (written.empty()) return tl::make_unexpected(Fault(fault::PastedNothing));
  if (written.size() > kMostPasted)
    return tl::make_unexpected(Fault(fault::PastedTooMany, {std::int64_t(kMostPasted)}));
  std::vector<Feature> features;
  features.reserve(written.size());
  for (const JsonValue& value : written) {
    Feature feature{std::string(value.text())};
    if (const auto why = whyNot(value, feature, std::int64_t(features.size()) + 1))
      return tl::make_unexpected(*why);
    features.push_back(std::move(feature));
  }
  return features;
}

}  // namespace mapwright::overlays
