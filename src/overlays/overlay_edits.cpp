#include "overlays/overlay_edits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <utility>

#include "overlays/overlay_merge.h"
#include "overlays/overlay_shapes.h"

namespace mapwright::overlays {
namespace {

using Eigen::Vector2d;

constexpr int kMostDecimals = 4;
constexpr int kDeepestGeometry = 8;

/// A part of a text and what is to stand there.
struct Replacement {
  std::size_t begin, end;
  std::string text;
};

Feature replaced(const Feature& feature, std::vector<Replacement> replacements) {
  std::string text = feature.text();
  std::sort(replacements.begin(), replacements.end(),
            [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
  for (const Replacement& each : replacements) text.replace(each.begin, each.end - each.begin, each.text);
  return Feature(std::move(text));
}

/// Two numbers at least.
bool isPosition(const JsonValue& value) {
  if (!value.isArray()) return false;
  const auto numbers = value.children();
  return numbers.size() >= 2 && numbers[0].kind() == JsonKind::Number &&
         numbers[1].kind() == JsonKind::Number && std::isfinite(numbers[0].number()) &&
         std::isfinite(numbers[1].number());
}

Vector2d placeOf(const JsonValue& position) {
  const auto numbers = position.children();
  return {numbers[0].number(), numbers[1].number()};
}

std::string rounded(double value) {
  const double unit = std::pow(10.0, kMostDecimals);
  std::array<char, 400> digits{};
  const auto [end, problem] =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::round(value * unit) / unit,
                    std::chars_format::fixed, kMostDecimals);
  if (problem != std::errc()) return "0";
  std::string text(digits.data(), end);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// Only the numbers that become others.
void place(std::vector<json::Rewrite>& rewrites, const JsonValue& position, const Vector2d& at) {
  const auto numbers = position.children();
  for (int axis = 0; axis < 2; ++axis) {
    const JsonValue& written = numbers[std::size_t(axis)];
    const std::string text = rounded(at[axis]);
    double now = 0;
    std::from_chars(text.data(), text.data() + text.size(), now);
    if (now != written.number() && std::abs(at[axis] - written.number()) > 1e-9)
      rewrites.push_back({written, text});
  }
}

Feature rewritten(const Feature& feature, std::vector<json::Rewrite> rewrites) {
  return rewrites.empty() ? feature : Feature(JsonText::rewritten(std::move(rewrites)));
}

void eachPosition(const JsonValue& value, int depth, const std::function<void(const JsonValue&)>& with) {
  if (isPosition(value)) return with(value);
  if (depth == 0 || !value.isArray()) return;
  for (const JsonValue& child : value.children()) eachPosition(child, depth - 1, with);
}

void eachPositionOf(const JsonValue& geometry, int depth, const std::function<void(const JsonValue&)>& with) {
  if (const auto coordinates = geometry.member("coordinates"))
    eachPosition(*coordinates, kDeepestGeometry, with);
  const auto parts = geometry.member("geometries");
  if (!parts || depth == 0) return;
  for (const JsonValue& part : parts->children()) eachPositionOf(part, depth - 1, with);
}

Feature placed(const Feature& feature, const std::function<Vector2d(const Vector2d&)>& where) {
  const auto geometry = feature.root().member("geometry");
  if (!geometry) return feature;
  std::vector<json::Rewrite> rewrites;
  eachPositionOf(*geometry, kDeepestGeometry,
                 [&](const JsonValue& position) { place(rewrites, position, where(placeOf(position))); });
  return rewritten(feature, std::move(rewrites));
}

/// The positions of one ring or line as written.
struct WrittenRing {
  std::vector<JsonValue> positions;
  bool closed = false;  // the last is the first once more
  std::size_t size() const { return positions.size() - (closed ? 1 : 0); }
};

std::vector<WrittenRing> ringsOf(const Feature& feature) {
  const Shape shape = partShapeOf(feature);
  const bool several = feature.shape() != shape;
  const auto coordinates = feature.coordinates();
  if (!coordinates || shape == Shape::None || shape == Shape::Other) return {};
  std::vector<std::vector<JsonValue>> lists;
  if (shape == Shape::Point) {
    lists.push_back(several ? coordinates->children() : std::vector<JsonValue>{*coordinates});
  } else if (shape == Shape::Line && !several) {
    lists.push_back(coordinates->children());
  } else {
    for (const JsonValue& part : coordinates->children()) {
      if (shape == Shape::Line || !several) {
        lists.push_back(part.children());
        continue;
      }
      for (const JsonValue& ring : part.children()) lists.push_back(ring.children());
    }
  }
  std::vector<WrittenRing> rings;
  for (auto& list : lists) {
    if (!std::all_of(list.begin(), list.end(), isPosition)) return {};
    WrittenRing ring{std::move(list)};
    ring.closed = shape == Shape::Polygon && ring.positions.size() > 1 &&
                  placeOf(ring.positions.front()) == placeOf(ring.positions.back());
    rings.push_back(std::move(ring));
  }
  return rings;
}

/// Its text with other numbers.
std::string likePosition(const JsonValue& position, const Vector2d& at) {
  const auto numbers = position.children();
  const std::string text(position.text());
  const auto cut = [&](std::size_t from, std::size_t to) {
    return text.substr(from - position.begin(), to - from);
  };
  return cut(position.begin(), numbers[0].begin()) + rounded(at.x()) +
         cut(numbers[0].end(), numbers[1].begin()) + rounded(at.y()) + cut(numbers[1].end(), position.end());
}

std::string asWritten(const std::optional<JsonValue>& like, const std::string& number) {
  return like && like->kind() == JsonKind::String ? json::quoted(number) : number;
}

std::string positionText(const Vector2d& at) { return '[' + rounded(at.x()) + ", " + rounded(at.y()) + ']'; }

}  // namespace

std::string coordinateText(double metres) { return rounded(metres); }

Feature movedBy(const Feature& feature, const Vector2d& by_m) {
  return placed(feature, [&](const Vector2d& at) { return Vector2d(at + by_m); });
}

Feature turnedAbout(const Feature& feature, const Vector2d& pivot_m, double by_rad) {
  const double cos = std::cos(by_rad), sin = std::sin(by_rad);
  const Feature turned = placed(feature, [&](const Vector2d& at) {
    const Vector2d arm = at - pivot_m;
    return Vector2d(pivot_m + Vector2d(cos * arm.x() - sin * arm.y(), sin * arm.x() + cos * arm.y()));
  });
  const auto yaw = yawOf(feature);
  return yaw ? withYaw(turned, *yaw + by_rad * 180 / std::numbers::pi) : turned;
}

std::vector<std::vector<Vector2d>> verticesOf(const Feature& feature) {
  std::vector<std::vector<Vector2d>> all;
  for (const WrittenRing& ring : ringsOf(feature)) {
    auto& points = all.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) points.push_back(placeOf(ring.positions[i]));
  }
  return all;
}

Feature withVertexAt(const Feature& feature, Vertex vertex, const Vector2d& at_m) {
  const auto rings = ringsOf(feature);
  if (vertex.ring >= rings.size() || vertex.index >= rings[vertex.ring].size()) return feature;
  const WrittenRing& ring = rings[vertex.ring];
  std::vector<json::Rewrite> rewrites;
  place(rewrites, ring.positions[vertex.index], at_m);
  if (ring.closed && vertex.index == 0) place(rewrites, ring.positions.back(), at_m);
  return rewritten(feature, std::move(rewrites));
}

Feature withVertexAfter(const Feature& feature, Vertex vertex, const Vector2d& at_m) {
  const auto rings = ringsOf(feature);
  if (partShapeOf(feature) == Shape::Point || vertex.ring >= rings.size() ||
      vertex.index >= rings[vertex.ring].size())
    return feature;
  const WrittenRing& ring = rings[vertex.ring];
  const JsonValue& before = ring.positions[vertex.index];
  // Separated as the ones before it are.
  const std::string& text = feature.text();
  std::string between = ", ";
  if (ring.positions.size() > 1) {
    const std::size_t from = ring.positions[0].end();
    between = text.substr(from, ring.positions[1].begin() - from);
  }
  return replaced(feature, {{before.end(), before.end(), between + likePosition(before, at_m)}});
}

std::optional<Feature> withoutVertex(const Feature& feature, Vertex vertex) {
  const auto rings = ringsOf(feature);
  const Shape shape = partShapeOf(feature);
  const std::size_t least = shape == Shape::Point ? 1 : shape == Shape::Line ? 2 : 3;
  if (vertex.ring >= rings.size()) return std::nullopt;
  const WrittenRing& ring = rings[vertex.ring];
  if (vertex.index >= ring.size() || ring.size() <= least) return std::nullopt;
  const auto& all = ring.positions;
  std::vector<Replacement> replacements;
  if (vertex.index + 1 < all.size()) {
    replacements.push_back({all[vertex.index].begin(), all[vertex.index + 1].begin(), {}});
  } else {
    replacements.push_back({all[vertex.index - 1].end(), all[vertex.index].end(), {}});
  }
  if (ring.closed && vertex.index == 0)
    replacements.push_back({all.back().begin(), all.back().end(), std::string(all[1].text())});
  return replaced(feature, std::move(replacements));
}

Feature withProperty(const Feature& feature, std::string_view name, const std::optional<std::string>& value) {
  return withPart(feature, {Part::Of::Property, std::string(name)}, value);
}

std::string_view typeProperty(Shape shape) {
  return shape == Shape::Line ? "lineType" : shape == Shape::Polygon ? "regionType" : "type";
}

Feature withType(const Feature& feature, int type) {
  const std::string_view name = typeProperty(partShapeOf(feature));
  return withProperty(feature, name, asWritten(feature.property(name), std::to_string(type)));
}

Feature withYaw(const Feature& feature, std::optional<double> degrees) {
  if (!degrees) return withProperty(feature, "yaw", std::nullopt);
  const double turned = std::remainder(*degrees, 360.0);
  return withProperty(feature, "yaw", asWritten(feature.property("yaw"), rounded(turned)));
}

std::string idOf(const IdBytes& bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string id;
  for (const std::uint8_t byte : bytes) {
    id += kDigits[byte >> 4];
    id += kDigits[byte & 15];
  }
  return id;
}

Feature newFeature(const OverlayDocument& among, Shape shape, const std::vector<Vector2d>& points, int type,
                   const std::string& id, const std::string& name) {
  // The same type tells best how it is written, the same shape well, any other a little.
  int best = -1;
  bool as_text = false, open = false;
  for (const Feature& other : among.features()) {
    const Shape its = other.shape();
    const auto written = other.property(typeProperty(its));
    if (!written) continue;
    const int rank = its != shape ? 0 : other.type() != type ? 1 : 2;
    if (rank < best) continue;
    best = rank;
    as_text = written->kind() == JsonKind::String;
    if (rank < 2 || shape != Shape::Polygon) continue;
    const auto rings = ringsOf(other);
    open = !rings.empty() && !rings.front().closed;
  }
  std::string coordinates;
  for (const Vector2d& point : points) coordinates += (coordinates.empty() ? "" : ", ") + positionText(point);
  if (shape == Shape::Polygon && !open && !points.empty()) coordinates += ", " + positionText(points.front());
  const char* const kind = shape == Shape::Point ? "Point" : shape == Shape::Line ? "LineString" : "Polygon";
  if (shape == Shape::Line) coordinates = '[' + coordinates + ']';
  if (shape == Shape::Polygon) coordinates = "[[" + coordinates + "]]";
  const std::string number = std::to_string(type);
  return Feature(R"({"id": )" + json::quoted(id) + R"(, "type": "Feature", "geometry": {"type": ")" + kind +
                 R"(", "coordinates": )" + coordinates + R"(}, "properties": {"name": )" +
                 json::quoted(name) + ", " + json::quoted(typeProperty(shape)) + ": " +
                 (as_text ? json::quoted(number) : number) + "}}");
}

Feature duplicateOf(const Feature& feature, const std::string& id, const std::string& name) {
  if (!feature.root().isObject()) return feature;
  // Usually both are there, and nothing else changes.
  const auto own = feature.root().member("id"), inner = feature.property("id"),
             old = feature.property("name");
  const auto isString = [](const auto& value) { return value && value->kind() == JsonKind::String; };
  if (isString(own) && !inner && (name.empty() || isString(old))) {
    std::vector<json::Rewrite> rewrites{{*own, json::quoted(id)}};
    if (!name.empty()) rewrites.push_back({*old, json::quoted(name)});
    return rewritten(feature, std::move(rewrites));
  }
  Feature copy = feature;
  if (feature.property("id")) copy = withProperty(copy, "id", json::quoted(id));
  if (feature.root().member("id") || !feature.property("id"))
    copy = Feature(json::withMember(copy.root(), "id", json::quoted(id)));
  return name.empty() ? copy : withProperty(copy, "name", json::quoted(name));
}

std::string freeName(const OverlayDocument& among, Shape shape, const std::string& name) {
  std::set<std::string> taken;
  for (const Feature& feature : among.features()) {
    if (feature.shape() == shape) taken.insert(feature.name());
  }
  if (name.empty() || !taken.contains(name)) return name;
  for (int number = 2;; ++number) {
    std::string next = name + ' ' + std::to_string(number);
    if (!taken.contains(next)) return next;
  }
}

}  // namespace mapwright::overlays
