#include "overlays/overlay_shapes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace mapwright::overlays {
namespace {

using Eigen::Vector2d;

constexpr int kDeepestCollection = 8;  // as far as edits move it
constexpr std::size_t kMostShown = 60;

class ShapeReading {
 public:
  explicit ShapeReading(Shapes& out) : out_(out) {}

  void read(const JsonValue& geometry, int depth) {
    const auto type_value = geometry.member("type");
    const std::string type = type_value ? type_value->string() : std::string();
    if (type == "GeometryCollection") {
      const auto parts = geometry.member("geometries");
      if (!parts || depth == 0) return;
      for (const JsonValue& part : parts->children()) read(part, depth - 1);
      return;
    }
    constexpr std::string_view kMulti = "Multi";
    const bool multi = type.starts_with(kMulti);
    const std::string of = multi ? type.substr(kMulti.size()) : type;
    if (of != "Point" && of != "LineString" && of != "Polygon") {
      if (!out_.unknown && geometry.kind() != JsonKind::Null)
        out_.unknown = type.empty() ? std::string(geometry.text().substr(0, kMostShown)) : type;
      return;
    }
    const auto coordinates = geometry.member("coordinates");
    if (!coordinates) return noteBad(geometry);
    if (!multi) return add(of, *coordinates);
    for (const JsonValue& part : coordinates->children()) add(of, part);
  }

 private:
  void add(const std::string& type, const JsonValue& coordinates) {
    if (type == "Point") {
      Path path;
      if (const auto at = pointOf(coordinates)) path.points.push_back(*at);
      out_.paths.push_back(std::move(path));
    } else if (type == "LineString") {
      out_.paths.push_back({Shape::Line, pointsOf(coordinates)});
    } else if (type == "Polygon") {
      const int number = ++polygons_;
      const auto rings = coordinates.children();
      if (rings.empty()) out_.paths.push_back({Shape::Polygon, {}, number});
      for (const JsonValue& ring : rings) {
        std::vector<Vector2d> points = pointsOf(ring);
        if (points.size() > 1 && points.front() == points.back()) points.pop_back();
        out_.paths.push_back({Shape::Polygon, std::move(points), number});
      }
    }
  }

  std::vector<Vector2d> pointsOf(const JsonValue& list) {
    std::vector<Vector2d> points;
    for (const JsonValue& one : list.children()) {
      if (const auto at = pointOf(one)) points.push_back(*at);
    }
    return points;
  }

  std::optional<Vector2d> pointOf(const JsonValue& written) {
    const auto numbers = written.isArray() ? written.children() : std::vector<JsonValue>();
    const Vector2d at = numbers.size() >= 2 ? Vector2d(numbers[0].number(), numbers[1].number())
                                            : Vector2d(HUGE_VAL, HUGE_VAL);
    const bool high = numbers.size() > 2 && !(std::abs(numbers[2].number()) <= kFarthestM);
    if (std::abs(at.x()) <= kFarthestM && std::abs(at.y()) <= kFarthestM && !high) return at;
    noteBad(written);
    return std::nullopt;
  }

  void noteBad(const JsonValue& written) {
    if (!out_.bad) out_.bad = std::string(written.text().substr(0, kMostShown));
  }

  Shapes& out_;
  int polygons_ = -1;
};

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// On which side of the line from a to b; 0 on it.
int sideOf(const Vector2d& a, const Vector2d& b, const Vector2d& point) {
  const double side = cross(b - a, point - a);
  return side > 0 ? 1 : side < 0 ? -1 : 0;
}

/// Two sides of an outline, which may have a corner in common.
std::optional<Vector2d> crossingOf(const Vector2d& a, const Vector2d& b, const Vector2d& c,
                                   const Vector2d& d) {
  const int c_side = sideOf(a, b, c), d_side = sideOf(a, b, d);
  if (c_side == 0 && d_side == 0) {
    // On one line: they overlap if they have more than a point in common.
    const Vector2d along = b - a;
    const auto at = [&](const Vector2d& point) { return (point - a).dot(along); };
    const double low = std::max(0.0, std::min(at(c), at(d)));
    const double high = std::min(at(b), std::max(at(c), at(d)));
    if (!(low < high)) return std::nullopt;
    return Vector2d(a + along * (low / along.squaredNorm()));
  }
  if (c_side * d_side >= 0 || sideOf(c, d, a) * sideOf(c, d, b) >= 0) return std::nullopt;
  return Vector2d(a + (b - a) * (cross(c - a, d - c) / cross(b - a, d - c)));
}

}  // namespace

std::optional<Vector2d> Shapes::somewhere() const {
  for (const Path& path : paths) {
    if (!path.points.empty()) return path.points.front();
  }
  return std::nullopt;
}

Shapes shapesOf(const Feature& feature) {
  Shapes shapes;
  if (const auto geometry = feature.root().member("geometry"))
    ShapeReading(shapes).read(*geometry, kDeepestCollection);
  return shapes;
}

std::optional<double> yawOf(const Feature& feature) {
  const auto yaw = feature.property("yaw");
  if (!yaw) return std::nullopt;
  double degrees = yaw->number();
  if (yaw->kind() == JsonKind::String) {
    const std::string written = yaw->string();
    const char* const end = written.data() + written.size();
    const auto [read_to, problem] = std::from_chars(written.data(), end, degrees);
    if (problem != std::errc() || read_to != end) return std::nullopt;
  }
  return std::isfinite(degrees) ? std::optional(degrees) : std::nullopt;
}

double doubleArea(const std::vector<Vector2d>& ring) {
  double area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return area;
}

std::optional<Vector2d> selfCrossing(const std::vector<Vector2d>& ring) {
  struct Side {
    Vector2d from, to;
    double left, right;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d &from = ring[i], &to = ring[(i + 1) % ring.size()];
    if (from != to) sides.push_back({from, to, std::min(from.x(), to.x()), std::max(from.x(), to.x())});
  }
  // From left to right: only sides above one another are compared.
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.left < b.left; });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size() && sides[k].left <= sides[i].right; ++k) {
      const auto at = crossingOf(sides[i].from, sides[i].to, sides[k].from, sides[k].to);
      if (at) return at;
    }
  }
  return std::nullopt;
}

}  // namespace mapwright::overlays
