#include "overlays/overlay_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "overlays/faults.h"
#include "overlays/overlay_reach.h"
#include "overlays/overlay_shapes.h"
#include "overlays/overlay_types.h"

namespace mapwright::overlays {
namespace {

using Eigen::Vector2d;
using placing::Cell;

constexpr std::array<std::string_view, std::size_t(kLastRule) + 1> kRuleNames{
    "duplicate_id",     "duplicate_name", "self_intersection", "zero_area",
    "too_few_points",   "outside_map",    "in_wall",           "charger_without_dock",
    "door_without_mac", "bad_number",     "unreachable",       "unreadable"};

constexpr double kNoAreaM2 = 1e-6;
constexpr double kChargerDepthM = 0.5;  // chargers stand against walls, or in them

std::string textIn(const Feature& feature, std::string_view property) {
  const auto value = feature.property(property);
  if (!value) return {};
  if (value->kind() == JsonKind::String) return value->string();
  return value->kind() == JsonKind::Number ? std::string(value->text()) : std::string();
}

int differentPoints(std::vector<Vector2d> points) {
  const auto less = [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), less);
  return int(std::unique(points.begin(), points.end()) - points.begin());
}

class Checking {
 public:
  Checking(const OverlayDocument& document, const CheckOptions& options)
      : features_(document.features()),
        document_(document),
        options_(options),
        ground_(options.map, placing::Ground::Access::Wait),
        known_(ground_.there() && !ground_.allUnknown()) {}

  std::vector<Flaw> flaws() {
    for (const Feature& feature : features_) shapes_.push_back(shapesOf(feature));
    std::map<std::string, int> met_ids;
    std::map<std::pair<Shape, std::string>, int> met_names;
    for (index_ = 0; index_ < features_.size(); ++index_) {
      const Feature& feature = features_[index_];
      if (!isFeature(feature)) add(Rule::Unreadable, fault::NoFeature);
      if (!feature.root().isObject()) continue;
      checkReadable();
      const std::string id = feature.id(), name = feature.name();
      if (!id.empty() && met_ids[id]++ > 0)
        add(Rule::DuplicateId, {faultText("overlays", "Another feature has the same id, %1."), {id}});
      if (!name.empty() && met_names[{feature.shape(), name}]++ > 0)
        add(Rule::DuplicateName,
            {faultText("overlays", "Another feature of this kind has the same name, \"%1\"."), {name}});
      checkNumbers();
      checkOutlines();
      checkKind();
      checkGround();
    }
    checkReach();
    std::stable_sort(flaws_.begin(), flaws_.end(),
                     [](const Flaw& a, const Flaw& b) { return a.feature < b.feature; });
    return std::move(flaws_);
  }

 private:
  const Feature& feature() const { return features_[index_]; }
  const Shapes& shapes() const { return shapes_[index_]; }

  void add(Rule rule, Fault why) { add(rule, std::move(why), shapes().somewhere()); }
  void add(Rule rule, Fault why, std::optional<Vector2d> at_m) {
    if (!options_.off.contains(rule)) flaws_.push_back({rule, index_, std::move(why), at_m});
  }

  void checkReadable() {
    if (shapes().unknown) add(Rule::Unreadable, {fault::GeometryUnknown, {*shapes().unknown}});
    const JsonValue root = feature().root();
    for (const auto& object : {std::optional(root), root.member("geometry"), root.member("properties")}) {
      std::set<std::string> met;
      if (!object || !object->isObject()) continue;
      for (const JsonValue& member : object->children()) {
        if (!met.insert(member.key()).second)
          return add(Rule::Unreadable, {fault::MemberTwice, {member.key()}});
      }
    }
  }

  void checkNumbers() {
    if (shapes().bad) add(Rule::BadNumber, {fault::BadCoordinate, {*shapes().bad}});
    const auto yaw = feature().property("yaw");
    const std::string written = textIn(feature(), "yaw");
    const bool empty =
        !yaw || yaw->kind() == JsonKind::Null || (yaw->kind() == JsonKind::String && written.empty());
    if (!empty && !yawOf(feature()))
      add(Rule::BadNumber, {faultText("overlays", "This is not a usable yaw: %1"),
                            {written.empty() ? std::string(yaw->text()) : written}});
  }

  void checkOutlines() {
    for (const Path& path : shapes().paths) {
      const int different = differentPoints(path.points);
      if (path.shape == Shape::Line && different < 2)
        return add(Rule::TooFewPoints, faultText("overlays", "A line needs at least two different points."));
      if (path.shape != Shape::Polygon) continue;
      if (different < 3)
        return add(Rule::TooFewPoints,
                   faultText("overlays", "An outline needs at least three different points."));
    }
    for (const Path& path : shapes().paths) {
      if (path.shape != Shape::Polygon) continue;
      // All on one line, there and back.
      const bool flat = flatness(path.points) <= kNoAreaM2;
      if (flat) return add(Rule::ZeroArea, fault::NoArea);
      if (const auto at = selfCrossing(path.points))
        return add(Rule::SelfIntersection, faultText("overlays", "Its outline crosses itself."), at);
      if (std::abs(doubleArea(path.points)) / 2 <= kNoAreaM2) return add(Rule::ZeroArea, fault::NoArea);
    }
  }

  /// The area of the largest triangle from the first side that has a length.
  static double flatness(const std::vector<Vector2d>& points) {
    const auto far = std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      return (a - points[0]).squaredNorm() < (b - points[0]).squaredNorm();
    });
    double most = 0;
    for (const Vector2d& point : points) {
      most = std::max(most, std::abs(doubleArea({points[0], *far, point})) / 2);
    }
    return most;
  }

  void checkKind() {
    const Shape shape = feature().shape();
    const int type = feature().type();
    if (shape == Shape::Point && type == kCharger) {
      const std::string dock = textIn(feature(), "dockingPointId");
      if (dock.empty()) {
        add(Rule::ChargerWithoutDock, faultText("overlays", "This charger names no docking point."));
      } else if (!isDock(dock)) {
        add(Rule::ChargerWithoutDock,
            {faultText("overlays", "The docking point of this charger, %1, does not exist, or is none."),
             {dock}});
      }
    }
    const bool door = (shape == Shape::Point && (type == kGate || type == kDoor)) ||
                      (shape == Shape::Polygon && (type == kGateRegion || type == kDoorRegion));
    if (door && textIn(feature(), "mac").find_first_not_of(" \t\r\n") == std::string::npos)
      add(Rule::DoorWithoutMac, faultText("overlays", "This door has no MAC address."));
  }

  bool isDock(const std::string& id) const {
    return std::any_of(features_.begin(), features_.end(), [&id](const Feature& feature) {
      return feature.id() == id && feature.shape() == Shape::Point && feature.type() == kDockingPoint;
    });
  }

  void checkGround() {
    if (!known_) return;
    for (const Path& path : shapes().paths) {
      for (const Vector2d& point : path.points) {
        if (isOutside(point))
          return add(Rule::OutsideMap, faultText("overlays", "It lies outside the map."), point);
      }
    }
    const bool charger = feature().shape() == Shape::Point && feature().type() == kCharger;
    if (!isDestination(feature()) && !charger) return;
    for (const Path& path : shapes().paths) {
      for (const Vector2d& point : path.points) {
        if (ground_.at(point) == Cell::Occupied && !(charger && freeNear(point)))
          return add(Rule::InWall, faultText("overlays", "It lies in a wall."), point);
      }
    }
  }

  /// Walls are drawn up to the edge of the map, and a little beyond it.
  bool isOutside(const Vector2d& point) const {
    const map::GridReference& grid = options_.map.reference;
    const Vector2d cell = grid.cellFromWorld(point);
    return !(cell.x() >= -1 && cell.y() >= -1 && cell.x() <= grid.width + 1 && cell.y() <= grid.height + 1);
  }

  bool freeNear(const Vector2d& point) {
    constexpr int kDirections = 16;
    constexpr double kStepM = 0.05;
    for (double reach = kStepM; reach <= kChargerDepthM; reach += kStepM) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2 * M_PI * i / kDirections;
        if (ground_.at(point + reach * Vector2d(std::cos(angle), std::sin(angle))) == Cell::Free) return true;
      }
    }
    return false;
  }

  void checkReach() {
    if (!known_ || options_.off.contains(Rule::Unreachable)) return;
    for (const std::size_t index : unreachable(document_, options_.map, options_.radius_m)) {
      index_ = index;
      // Said already, and the reason.
      const bool known = std::any_of(flaws_.begin(), flaws_.end(), [index](const Flaw& flaw) {
        return flaw.feature == index && (flaw.rule == Rule::OutsideMap || flaw.rule == Rule::InWall);
      });
      if (!known)
        add(Rule::Unreachable, faultText("overlays", "The robot cannot get here from its charger."));
    }
  }

  const std::vector<Feature>& features_;
  const OverlayDocument& document_;
  const CheckOptions& options_;
  placing::Ground ground_;
  bool known_;  // something is, of the map
  std::vector<Shapes> shapes_;
  std::size_t index_ = 0;
  std::vector<Flaw> flaws_;
};

}  // namespace

std::string_view nameOf(Rule rule) { return kRuleNames[std::size_t(rule)]; }

std::optional<Rule> ruleCalled(std::string_view name) {
  const auto* const found = std::find(kRuleNames.begin(), kRuleNames.end(), name);
  if (found == kRuleNames.end()) return std::nullopt;
  return Rule(found - kRuleNames.begin());
}

std::vector<Flaw> flawsOf(const OverlayDocument& document, const CheckOptions& options) {
  return Checking(document, options).flaws();
}

bool isDestination(const Feature& feature) {
  if (feature.shape() != Shape::Point) return false;
  const int type = feature.type();
  return type != kCharger && type != kGate && type != kDoor && type != kBarcode && type != kLandmark;
}

}  // namespace mapwright::overlays
