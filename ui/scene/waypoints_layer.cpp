// Waypoints: saved and unsaved ones, selected ones, ten thousand of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include <QStyleOptionGraphicsItem>

#include "robot/robot.h"
#include "sentences/absence_sentence.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"
#include "words/listed.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kRadiusPx = 5;
constexpr double kMarkReachPx = 40;  // nothing of a mark is farther from its position
constexpr std::size_t kCrowd = 500;  // with this many, those that would hide each other are drawn once
constexpr double kCrowdPx = 4;
constexpr std::size_t kWaypointMarks = std::size_t(WaypointMark::Theirs) + 1;

/// An exclamation mark to the upper right of `at`, readable on any background.
void paintWarning(QPainter& painter, const MapTheme& theme, const QPointF& at) {
  const QPointF foot = at + QPointF(kRadiusPx + 3, -kRadiusPx - 1);
  for (const auto& [color, width] : {std::pair(theme.text_halo, 5.5), std::pair(theme.warn, 2.8)}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(foot + QPointF(0, -4.2), foot + QPointF(0, -9));
    painter.drawPoint(foot);
  }
}

QRectF warningArea(const QPointF& at) {
  return QRectF(at + QPointF(kRadiusPx, -kRadiusPx - 14), QSizeF(6, 16));
}

void paintRing(QPainter& painter, const MapTheme& theme, const QPointF& at) {
  painter.setBrush(Qt::NoBrush);
  for (const auto& [ring, width] : {std::pair(theme.text_halo, 4.0), std::pair(theme.accent, 2.0)}) {
    painter.setPen(QPen(ring, width));
    painter.drawEllipse(at, 10, 10);
  }
}

/// Marks as pixmaps: thousands of them are drawn quickly. The middle of each is its position.
class Sprites {
 public:
  Sprites(const MapTheme& theme, qreal ratio) : theme_(theme), ratio_(ratio) {}

  void draw(QPainter& painter, const QPointF& at, WaypointMark mark, bool selected, bool warned) {
    QImage& image = images_[std::size_t(mark)][selected][warned];
    if (image.isNull()) image = make(mark, selected, warned);
    const double half = image.width() / ratio_ / 2;
    painter.drawImage(QPointF(std::round(at.x() - half), std::round(at.y() - half)), image);
  }

 private:
  QImage make(WaypointMark mark, bool selected, bool warned) const {
    constexpr double kSide = 2 * (kRadiusPx + 14);
    const QPointF middle(kSide / 2, kSide / 2);
    const int side = int(std::ceil(kSide * ratio_));
    QImage image(QSize(side, side), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio_);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    if (selected) paintRing(painter, theme_, middle);
    paintWaypointMark(painter, middle, kRadiusPx, mark, waypointColor(theme_, mark), theme_.text_halo);
    if (warned) paintWarning(painter, theme_, middle);
    return image;
  }

  const MapTheme& theme_;
  qreal ratio_;
  std::array<std::array<std::array<QImage, 2>, 2>, kWaypointMarks> images_;
};

bool isSpecial(const DrawnWaypoint& point) { return point.selected || point.mark != WaypointMark::Saved; }

/// Waypoints with their headings.
class WaypointsLayer : public CrowdLayer {
 public:
  using CrowdLayer::CrowdLayer;
  std::size_t count() const override { return context_.of(*of()).waypoints.size(); }
  void paintThings(QPainter& painter, const QRectF& exposed) const override {
    const std::vector<DrawnWaypoint>& points = context_.of(*of()).waypoints;
    const geometry::ViewTransform& view = context_.view;
    const MapTheme& theme = context_.theme;
    const QRectF seen = QRectF(0, 0, view.width_px, view.height_px).adjusted(-220, -20, 20, 20);
    const bool crowd = points.size() > kCrowd && view.scale_m_per_px > kNameFromMPerPx;
    const QRectF wanted =
        exposed.adjusted(-kMarkReachPx, -kMarkReachPx, kMarkReachPx, kMarkReachPx).intersected(seen);
    // If many are dragged, or were just moved, headings and lines to their origins are omitted.
    std::size_t special_seen = 0;
    for (const DrawnWaypoint& point : points)
      special_seen += isSpecial(point) && seen.contains(toPoint(view.pixelFromWorld(point.position_m)));
    const bool crowd_of_special = special_seen > kCrowd;
    Sprites sprites(theme, painter.device()->devicePixelRatioF());
    std::unordered_set<std::uint64_t> taken, taken_by_special;
    painter.setRenderHint(QPainter::Antialiasing);
    // Prominent ones are drawn on top; in a crowd those with warnings are preferred.
    for (const auto& [special, warned] :
         {std::pair(false, true), std::pair(false, false), std::pair(true, true), std::pair(true, false)}) {
      const bool as_sprites = special ? crowd_of_special : crowd;
      if (special && !as_sprites && !warned) continue;  // already drawn, in their order
      for (const DrawnWaypoint& point : points) {
        if (isSpecial(point) != special) continue;
        if ((!special || as_sprites) && point.warnings.isEmpty() == warned) continue;
        const QPointF at = toPoint(view.pixelFromWorld(point.position_m));
        if (!(point.from_m ? seen : wanted).contains(at)) continue;
        if (as_sprites) {
          const auto cell = [](double px) {
            return std::uint64_t(std::uint32_t(std::int32_t(px / kCrowdPx)));
          };
          std::unordered_set<std::uint64_t>& cells = special ? taken_by_special : taken;
          // Conflicts are never omitted.
          const bool alone = point.mark == WaypointMark::Conflict || point.mark == WaypointMark::Theirs;
          if (cells.insert(cell(at.x()) << 32 | cell(at.y())).second || alone)
            sprites.draw(painter, at, point.mark, point.selected, warned);
          continue;
        }
        const QColor color = waypointColor(theme, point.mark);
        if (point.from_m) {
          painter.setPen(QPen(color, 1.2, Qt::DashLine));
          painter.drawLine(toPoint(view.pixelFromWorld(*point.from_m)), at);
        }
        if (point.selected) paintRing(painter, theme, at);
        if (point.yaw_rad && std::isfinite(*point.yaw_rad))
          drawHeading(painter, context_, at, *point.yaw_rad, color);
        paintWaypointMark(painter, at, kRadiusPx, point.mark, color, theme.text_halo);
        if (!point.warnings.isEmpty()) paintWarning(painter, theme, at);
      }
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const DrawnWaypoint& point : context_.of(*of()).waypoints) extendBy(bounds, point.position_m);
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    const std::vector<DrawnWaypoint>& points = context_.of(*of()).waypoints;
    const auto selected = std::count_if(points.begin(), points.end(),
                                        [](const DrawnWaypoint& point) { return point.selected; });
    for (const DrawnWaypoint& point : points) {
      const QPointF at = toPoint(context_.view.pixelFromWorld(point.position_m));
      if (!labels.area().contains(at)) continue;
      const double reach = point.selected ? 11 : kRadiusPx;
      const QRectF mark(at - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach));
      const bool headed = point.yaw_rad && std::isfinite(*point.yaw_rad);
      keepClear(labels, context_, mark, headed ? point.yaw_rad : std::nullopt);
      if (!point.warnings.isEmpty()) labels.symbol(warningArea(at));
      // The selected ones are named from far away, too, while they are few.
      const bool chosen = point.selected && std::size_t(selected) <= kMostChosen;
      if (!chosen && !labels.named(mark)) continue;
      labels.add(LabelWish::Position::Beside, chosen ? LabelRank::Chosen : LabelRank::Waypoint, mark,
                 qHash(QByteArrayView(point.name)), shortName(point.name), context_.theme.text);
    }
  }

 private:
  static constexpr std::size_t kMostChosen = 50;
};

QString markText(WaypointMark mark) {
  switch (mark) {
    case WaypointMark::Saved:
      return {};
    case WaypointMark::Unsaved:
      return ObjectText::tr("changed, not saved");
    case WaypointMark::Sent:
      return ObjectText::tr("sent, not confirmed");
    case WaypointMark::Conflict:
      return ObjectText::tr("in conflict: mine");
    case WaypointMark::New:
      return ObjectText::tr("new, not saved");
    case WaypointMark::Deleted:
      return ObjectText::tr("deleted, not saved");
    case WaypointMark::Theirs:
      return ObjectText::tr("in conflict: theirs");
  }
  return {};
}

void seeWaypoints(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  seePoints(context.of(of).waypoints, see);
}

std::string keyOfWaypoint(const LayerContext& context, FeaturesOf of, std::size_t number) {
  return context.of(of).waypoints[number].name;
}

/// MapObject::look.
std::int64_t lookOf(WaypointMark mark, bool warned) { return std::int64_t(mark) * 2 + (warned ? 1 : 0); }

MapObject describeWaypoint(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const DrawnWaypoint& point = context.of(of).waypoints[number];
  MapObject object;
  object.kind = ObjectText::tr("Waypoint");
  object.name = shortName(point.name);
  object.look = lookOf(point.mark, !point.warnings.isEmpty());
  object.yaw_rad = point.yaw_rad;
  Properties known;
  for (const QString& warning : point.warnings.split(QLatin1Char('\n')))
    known.add(ObjectText::tr("Warning"), warning);
  object.properties = known.add(ObjectText::tr("State"), markText(point.mark))
                          .add(ObjectText::tr("Type"), point.type)
                          .add(ObjectText::tr("Tags"), point.tags);
  return object;
}

constexpr LayerObjects kWaypoints{seeWaypoints, describeWaypoint, keyOfWaypoint};

void sampleWaypoint(LegendSample& sample, ObjectForm, std::int64_t look) {
  DrawnWaypoint point;
  point.mark = WaypointMark(look / 2);
  if (look % 2 == 1) point.warnings = QStringLiteral("!");
  sample.context.of(FeaturesOf::WholeMap).waypoints = {point};
}

void waypointsLegend(Legend& legend) {
  const auto add = [&](WaypointMark mark, const QString& text, bool warned = false) {
    legend.addThing(text, ObjectForm::Point, lookOf(mark, warned));
  };
  add(WaypointMark::Saved, LegendText::tr("Saved"));
  add(WaypointMark::Unsaved, LegendText::tr("Changed, not saved yet"));
  add(WaypointMark::New, LegendText::tr("New, not saved yet"));
  add(WaypointMark::Deleted, LegendText::tr("Deleted, not saved yet"));
  add(WaypointMark::Sent, LegendText::tr("Sent, not confirmed yet"));
  add(WaypointMark::Conflict, LegendText::tr("In conflict: mine"));
  add(WaypointMark::Theirs, LegendText::tr("In conflict: the other version"));
  legend.addSample(LegendText::tr("Selected"), [](LegendSample& sample) {
    DrawnWaypoint point;
    point.selected = true;
    sample.context.of(FeaturesOf::WholeMap).waypoints = {point};
  });
  add(WaypointMark::Saved, LegendText::tr("With a warning"), true);
}

}  // namespace

DrawnWaypoint drawnFrom(const map::Waypoint& point) {
  constexpr qsizetype kLongest = 200;
  DrawnWaypoint drawn;
  drawn.name = point.name.empty() ? point.id : point.name;
  drawn.position_m = point.position_m;
  drawn.yaw_rad = point.yaw_rad;
  drawn.type = shortName(point.type, kLongest);
  QStringList tags;
  for (const std::string& tag : point.tags) tags << shortName(tag);
  drawn.tags = words::listed(tags);
  return drawn;
}

QColor waypointColor(const MapTheme& theme, WaypointMark mark) {
  switch (mark) {
    case WaypointMark::Saved:
      return theme.place;
    case WaypointMark::Conflict:
    case WaypointMark::Theirs:
      return theme.bad;
    default:
      return theme.warn;
  }
}

void paintWaypointMark(QPainter& painter, const QPointF& at, double radius, WaypointMark mark,
                       const QColor& fill, const QColor& edge) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(edge, 1.5));
  painter.setBrush(fill);
  const QRectF square(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius);
  switch (mark) {
    case WaypointMark::Saved:
      painter.drawEllipse(at, radius, radius);
      return;
    case WaypointMark::Unsaved:
      painter.drawRect(square);
      return;
    case WaypointMark::Sent:
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(fill, 2));
      painter.drawRect(square);
      return;
    case WaypointMark::New: {
      const double r = radius * 1.35;
      painter.drawPolygon(
          QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)});
      return;
    }
    case WaypointMark::Deleted:
      for (const auto& [color, width] : {std::pair(edge, 4.5), std::pair(fill, 2.0)}) {
        painter.setPen(QPen(color, width));
        painter.drawLine(square.topLeft(), square.bottomRight());
        painter.drawLine(square.topRight(), square.bottomLeft());
      }
      return;
    case WaypointMark::Theirs:
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(fill, 2));
      [[fallthrough]];
    case WaypointMark::Conflict:
      const double r = radius * 1.4;
      painter.drawPolygon(
          QPolygonF{at + QPointF(0, -r), at + QPointF(r, r * 0.8), at + QPointF(-r, r * 0.8)});
      return;
  }
}

template <>
LayerSpec layerSpec<Layer::Waypoints>() {
  return {.name = "waypoints",
          .title = QT_TRANSLATE_NOOP("scene", "Waypoints"),
          .group = LayerGroup::Annotations,
          .sets = LayerSet::Navigation,
          .follows_robot = false,
          .why_empty =
              [](robot::Robot& robot) {
                return robot.waypointSource() || robot.waypointStore()
                           ? QString()
                           : sentences::absenceReason(robot::Capability::Waypoints,
                                                      robot.unavailableReason(robot::Capability::Waypoints));
              },
          .items = itemForEachMap<WaypointsLayer>,
          .objects = &kWaypoints,
          .sample = sampleWaypoint,
          .legend = waypointsLegend};
}

}  // namespace mapwright::ui::scene
