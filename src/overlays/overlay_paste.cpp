#include "overlays/overlay_paste.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "overlays/faults.h"
#include "overlays/overlay_edits.h"
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

constexpr std::size_t kShapes = std::size_t(Shape::Other) + 1;

/// Nothing is lost when it is pasted. `number` counts from 1.
std::optional<Fault> unavailableReason(const JsonValue& written, const Feature& feature,
                                       std::int64_t number) {
  if (!written.isObject())
    return Fault(faultText("overlays", "number %1 in the list is no feature"), {number});
  const auto geometry = written.member("geometry");
  // RFC 7946 has features without a place, or with empty coordinates; they are kept as they are.
  if (geometry ? geometry->kind() == JsonKind::Null : typeOf(written) == "Feature") return std::nullopt;
  if (!geometry || !geometry->isObject()) return Fault(fault::PastedWithoutPlace, {number});
  const std::string type = typeOf(*geometry);
  if (!isGeometry(type))
    return Fault(faultText("overlays", "the geometry of feature %1 is of an unknown type, \"%2\""),
                 {number, type});
  const Shapes shapes = shapesOf(feature);
  if (shapes.bad)
    return Fault(faultText("overlays", "feature %1 has a coordinate that cannot be used: %2"),
                 {number, *shapes.bad});
  if (!shapes.somewhere()) return std::nullopt;
  for (const Path& path : shapes.paths) {
    const std::size_t least = path.shape == Shape::Line ? 2 : path.shape == Shape::Polygon ? 3 : 1;
    if (path.points.size() < least)
      return Fault(faultText("overlays", "feature %1 has too few points"), {number});
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
    if (const auto why = unavailableReason(feature.root(), feature, 1)) return tl::make_unexpected(*why);
    if (!shapesOf(feature).somewhere()) return tl::make_unexpected(Fault(fault::PastedWithoutPlace, {1}));
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
    return tl::make_unexpected(
        Fault(faultText("overlays", "it contains more than %1 features"), {std::int64_t(kMostPasted)}));
  std::vector<Feature> features;
  features.reserve(written.size());
  for (const JsonValue& value : written) {
    Feature feature{JsonText::of(value)};
    if (const auto why = unavailableReason(value, feature, std::int64_t(features.size()) + 1))
      return tl::make_unexpected(*why);
    features.push_back(std::move(feature));
  }
  return features;
}

std::vector<Feature> madeFree(const OverlayDocument& among, const std::vector<Feature>& features,
                              const std::function<std::string()>& new_id) {
  std::unordered_set<std::string> ids;
  ids.reserve(among.features().size() + features.size());
  std::array<std::unordered_set<std::string>, kShapes> names;
  for (auto& taken : names) taken.reserve(ids.bucket_count() / kShapes);
  for (const Feature& feature : among.features()) {
    ids.insert(feature.id());
    names[std::size_t(feature.shape())].insert(feature.name());
  }
  std::unordered_map<std::string, std::string> renewed;
  std::array<std::unordered_map<std::string, int>, kShapes> last;  // number of a name
  std::vector<Feature> free;
  free.reserve(features.size());
  for (const Feature& feature : features) {
    const std::string before = feature.id();
    const std::string own_name = feature.name();
    std::string name = own_name;
    const auto shape = std::size_t(feature.shape());
    auto& taken = names[shape];
    if (!name.empty() && !taken.insert(name).second) {
      int& number = last[shape].try_emplace(name, 1).first->second;
      std::string next;
      do next = name + ' ' + std::to_string(++number);
      while (!taken.insert(next).second);
      name = next;
    }
    const bool keeps = !before.empty() && ids.insert(before).second;
    const std::string id = keeps ? before : new_id();
    if (!keeps && !before.empty()) renewed.emplace(before, id);
    if (keeps) {
      free.push_back(name == own_name ? feature : withProperty(feature, "name", json::quoted(name)));
    } else {
      free.push_back(duplicateOf(feature, id, name));
    }
  }
  for (Feature& feature : free) {
    if (renewed.empty()) break;
    const auto dock = feature.property("dockingPointId");
    const auto to = dock ? renewed.find(dock->string()) : renewed.end();
    if (to != renewed.end()) feature = withProperty(feature, "dockingPointId", json::quoted(to->second));
  }
  return free;
}

}  // namespace mapwright::overlays
