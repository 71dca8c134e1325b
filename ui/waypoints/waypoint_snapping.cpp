#include "ui/waypoints/waypoint_snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QLocale>
#include <QPainter>

#include "geometry/pose.h"
#include "grids/grid_pyramid.h"
#include "render/sample_grid.h"
#include "ui/scene/drawing.h"
#include "ui/scene/lengths.h"
#include "ui/view/map_tool.h"

namespace mapwright::ui {
namespace {

constexpr double kHeadingReach = geometry::radiansFromDegrees(3);
constexpr double kLeastM = 0.01, kMostM = 100;

// By their names in the settings.
using placing::SnapRules;
constexpr std::array<std::pair<const char*, bool SnapRules::*>, 4> kRules{
    {{"waypoints", &SnapRules::waypoints},
     {"grid", &SnapRules::grid},
     {"walls", &SnapRules::walls},
     {"headings", &SnapRules::headings}}};
constexpr std::array<std::pair<const char*, double SnapRules::*>, 2> kDistances{
    {{"grid_m", &SnapRules::grid_m}, {"wall_m", &SnapRules::wall_m}}};

double exactEnough(double metres) { return std::round(metres * 1000) / 1000; }

QString key(const char* name) { return QStringLiteral("snap/") + QLatin1String(name); }

}  // namespace

placing::PlacedMap mapUnder(const scene::MapScene& scene) {
  const auto whole = scene.wholeMap();
  if (!whole || !whole->cells || !whole->cells->complete()) return {};
  return {whole->cells, whole->reference};
}

WaypointSnapping::WaypointSnapping(const scene::MapScene* scene, const HitList* hits, QObject* parent)
    : QObject(parent), scene_(scene), hits_(hits) {}

void WaypointSnapping::setOn(bool on) {
  if (std::exchange(on_, on) != on) Q_EMIT changed();
}

void WaypointSnapping::setRules(const placing::SnapRules& rules) {
  placing::SnapRules fit = rules;
  fit.grid_m = std::clamp(fit.grid_m, kLeastM, kMostM);
  fit.wall_m = std::clamp(fit.wall_m, kLeastM, kMostM);
  if (rules_ == fit) return;
  rules_ = fit;
  Q_EMIT changed();
}

void WaypointSnapping::recall(const QSettings& settings) {
  placing::SnapRules rules;
  for (const auto& [name, rule] : kRules) rules.*rule = settings.value(key(name), rules.*rule).toBool();
  for (const auto& [name, distance] : kDistances) {
    const double value = settings.value(key(name), rules.*distance).toDouble();
    if (std::isfinite(value)) rules.*distance = value;
  }
  setRules(rules);
  setOn(settings.value(key("on"), true).toBool());
}

void WaypointSnapping::remember(QSettings& settings) const {
  settings.setValue(key("on"), on_);
  for (const auto& [name, rule] : kRules) settings.setValue(key(name), rules_.*rule);
  for (const auto& [name, distance] : kDistances) settings.setValue(key(name), rules_.*distance);
}

placing::SnappedPlace WaypointSnapping::place(const Eigen::Vector2d& free_m, Qt::KeyboardModifiers modifiers,
                                              const Ignored& ignored) {
  using placing::Caught;
  if (modifiers & Qt::ControlModifier) {
    const Eigen::Vector2d at = placing::onGrid(free_m, scene::gridSteps(scene_->view()).minor_m);
    return {at, {{Caught::GridX, at, at}, {Caught::GridY, at, at}}};
  }
  placing::SnappedPlace place{free_m, {}};
  if (on_ && !(modifiers & Qt::AltModifier)) {
    placing::SnapScene around;
    around.seen = scene_->view().visibleWorld();
    around.reach_m = MapTool::kReachPx * scene_->view().scale_m_per_px;
    around.others = [&](const geometry::WorldRect& area,
                        const std::function<void(const Eigen::Vector2d&)>& found) {
      hits_->within(area, [&](const Hit& hit) {
        if (!ignored(hit)) found(hit.world_m);
      });
    };
    const placing::PlacedMap under = rules_.walls ? mapUnder(*scene_) : placing::PlacedMap{};
    if (!ground_ || !(ground_->map() == under)) ground_.emplace(under, placing::Ground::Access::AtHand);
    around.ground = &*ground_;
    place = placing::snapped(free_m, rules_, around);
  }
  bool exact[2] = {false, false};
  for (const placing::Guide& guide : place.guides) {
    exact[0] |= guide.what == Caught::Point || guide.what == Caught::LineX || guide.what == Caught::GridX;
    exact[1] |= guide.what == Caught::Point || guide.what == Caught::LineY || guide.what == Caught::GridY;
  }
  for (const int axis : {0, 1}) {
    if (!exact[axis]) place.at_m[axis] = exactEnough(place.at_m[axis]);
  }
  return place;
}

double WaypointSnapping::heading(double yaw_rad, Qt::KeyboardModifiers modifiers) const {
  if (modifiers & (Qt::ControlModifier | Qt::ShiftModifier))
    return placing::snappedHeading(yaw_rad, geometry::radiansFromDegrees(180));
  if (!on_ || !rules_.headings || modifiers & Qt::AltModifier) return yaw_rad;
  return placing::snappedHeading(yaw_rad, kHeadingReach);
}

void WaypointSnapping::paint(QPainter& painter, const placing::SnappedPlace& place) const {
  using placing::Caught;
  if (place.guides.empty()) return;
  const scene::MapTheme& theme = scene_->theme();
  const auto px = [&](const Eigen::Vector2d& at) {
    return scene::toPoint(scene_->view().pixelFromWorld(at));
  };
  const auto line = [&](const QPointF& a, const QPointF& b, Qt::PenStyle style) {
    painter.setPen(QPen(theme.text_halo, 3));
    painter.drawLine(a, b);
    painter.setPen(QPen(theme.measure, 1.5, style));
    painter.drawLine(a, b);
  };
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const placing::Guide& guide : place.guides) {
    const QPointF from = px(guide.from_m), to = px(guide.to_m);
    line(from, to, guide.what == Caught::Wall ? Qt::SolidLine : Qt::DashLine);
    if (guide.what == Caught::LineX || guide.what == Caught::LineY) painter.drawEllipse(from, 8, 8);
    if (guide.what == Caught::Wall) {
      // The wall, as a short line across.
      const QLineF across = QLineF(from, to).normalVector().unitVector();
      const QPointF half(across.dx() * 8, across.dy() * 8);
      line(from - half, from + half, Qt::SolidLine);
      scene::drawLabel(
          painter, (from + to) / 2 + QPointF(8, -4),
          QLocale::c().toString((guide.to_m - guide.from_m).norm(), 'f', 2) + QStringLiteral(" m"), theme,
          theme.text);
    }
  }
  // A cross at the snapped position.
  const QPointF at = px(place.at_m);
  painter.setPen(QPen(theme.measure, 1.5));
  painter.drawLine(at - QPointF(14, 0), at + QPointF(14, 0));
  painter.drawLine(at - QPointF(0, 14), at + QPointF(0, 14));
  painter.restore();
}

}  // namespace mapwright::ui

#include "moc_waypoint_snapping.cpp"
