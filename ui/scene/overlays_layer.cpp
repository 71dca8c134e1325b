// The overlays of a map: walls, regions and places.
#include <algorithm>

#include <QHashFunctions>
#include <QPainterPath>
#include <QStyleOptionGraphicsItem>

#include "map/live_topics.h"
#include "sentences/overlay_name.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

QColor regionColor(const MapTheme& theme, int type) {
  switch (type) {
    case 1:   // forbidden
    case 6:   // drop risk
    case 10:  // exclusive
      return theme.bad;
    case 2:  // slow
    case 7:  // slope
    case 8:  // deceitful
    case 9:  // narrow
    case 15:
      return theme.warn;
    case 12:  // free space
    case 13:  // charging
      return theme.good;
    default:
      return theme.region;
  }
}

QColor lineColor(const MapTheme& theme, int type) {
  return type == 2 ? theme.bad : type == 1 ? theme.path : theme.region;
}

QColor pointColor(const MapTheme& theme, int type) {
  switch (type) {
    case 9:
    case 36:
      return theme.good;
    case 37:
    case 39:
      return theme.constraint;
    default:
      return theme.place;
  }
}

constexpr double kFeatureReachPx = 24;  // nothing of a feature is farther from its outline

/// Also an area without width or height, of an upright or level line, and one that is no number.
bool meets(const QRectF& area, const QRectF& wanted) {
  return !(area.left() > wanted.right() || area.right() < wanted.left() || area.top() > wanted.bottom() ||
           area.bottom() < wanted.top());
}

/// Walls, regions and places, read-only.
class OverlaysLayer : public CrowdLayer {
 public:
  using CrowdLayer::CrowdLayer;
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::OverlayFeature& feature : context_.of(*of()).overlays) {
      for (const auto& part : feature.parts) bounds.extend(boundsOf(part));
    }
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    using map::OverlayShape;
    std::uint64_t index = 0;
    for (const map::OverlayFeature& feature : context_.of(*of()).overlays) {
      ++index;
      const std::uint64_t id = feature.id.empty() ? index : qHash(QByteArrayView(feature.id));
      if (feature.shape == OverlayShape::Line || feature.parts.empty() || feature.parts[0].empty()) continue;
      if (feature.shape == OverlayShape::Point) {
        labelPlace(labels, context_, feature.parts[0][0], feature.yaw_rad, LabelRank::Waypoint, id,
                   nameOf(feature));
        continue;
      }
      // The first ring is the outer one.
      const QRectF bounds = toPolygon(context_.view, feature.parts[0]).boundingRect();
      // What lies in it still finds room around it.
      constexpr double kRegionSymbolPx = 40;
      if (!labels.fits(nameOf(feature), bounds)) keepSmallClear(labels, bounds, kRegionSymbolPx);
      if (!labels.named(bounds)) continue;
      labels.add(LabelWish::Position::Within, LabelRank::Region, bounds, id, nameOf(feature),
                 regionColor(context_.theme, feature.type));
    }
  }

 private:
  static QString nameOf(const map::OverlayFeature& feature) {
    return feature.name.empty() ? sentences::nameOf(feature.shape, feature.type) : shortName(feature.name);
  }

  std::size_t count() const override { return context_.of(*of()).overlays.size(); }
  void paintThings(QPainter& painter, const QRectF& exposed) const override {
    using map::OverlayShape;
    const QRectF wanted =
        exposed.adjusted(-kFeatureReachPx, -kFeatureReachPx, kFeatureReachPx, kFeatureReachPx);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const OverlayShape shape : {OverlayShape::Polygon, OverlayShape::Line, OverlayShape::Point}) {
      for (const map::OverlayFeature& feature : context_.of(*of()).overlays) {
        if (feature.shape != shape) continue;
        if (shape == OverlayShape::Polygon) paintRegion(painter, feature, wanted);
        if (shape == OverlayShape::Line) paintLine(painter, feature, wanted);
        if (shape == OverlayShape::Point && !feature.parts.empty() && !feature.parts[0].empty() &&
            wanted.contains(toPoint(context_.view.pixelFromWorld(feature.parts[0][0])))) {
          drawPlace(painter, context_, feature.parts[0][0], feature.yaw_rad,
                    overlayColor(context_.theme, feature));
        }
      }
    }
  }

  void paintRegion(QPainter& painter, const map::OverlayFeature& feature, const QRectF& wanted) const {
    if (std::ranges::none_of(
            feature.parts, [&](const auto& ring) { return meets(pixelBounds(context_.view, ring), wanted); }))
      return;
    QPainterPath path;
    for (const auto& ring : feature.parts) path.addPolygon(toPolygon(context_.view, ring));
    path.closeSubpath();
    if (!inView(context_.view, path.boundingRect())) return;
    path.setFillRule(Qt::OddEvenFill);
    const QColor color = overlayColor(context_.theme, feature);
    painter.setPen(QPen(color, 1.5));
    painter.setBrush(translucent(color, 34));
    painter.drawPath(path);
    if (feature.type == 1) {  // forbidden: hatched as well, not only coloured
      painter.setPen(Qt::NoPen);
      painter.setBrush(QBrush(translucent(color, 110), Qt::BDiagPattern));
      painter.drawPath(path);
    }
  }

  void paintLine(QPainter& painter, const map::OverlayFeature& feature, const QRectF& wanted) const {
    const bool wall = feature.type == 2;
    const QColor color = overlayColor(context_.theme, feature);
    for (const auto& part : feature.parts) {
      // All of it or nothing: the dashes of a piece would begin elsewhere.
      if (!meets(pixelBounds(context_.view, part), wanted)) continue;
      for (const QPolygonF& line : visibleLines(context_.view, part, 6)) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(
            QPen(context_.theme.text_halo, wall ? 5 : 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        painter.setPen(
            QPen(color, wall ? 3 : 2, wall ? Qt::SolidLine : Qt::DashLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
      }
    }
  }
};

void seeOverlays(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  std::vector<std::span<const Eigen::Vector2d>> parts;
  const std::vector<map::OverlayFeature>& features = context.of(of).overlays;
  for (std::size_t i = 0; i < features.size(); ++i) {
    parts.assign(features[i].parts.begin(), features[i].parts.end());
    if (parts.empty() || parts[0].empty()) continue;
    const auto form = features[i].shape == map::OverlayShape::Point  ? ObjectForm::Point
                      : features[i].shape == map::OverlayShape::Line ? ObjectForm::Line
                                                                     : ObjectForm::Area;
    see(i, form, parts);
  }
}

std::string keyOfOverlay(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const map::OverlayFeature& feature = context.of(of).overlays[number];
  return feature.id.empty() ? feature.name : feature.id;
}

MapObject describeOverlay(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const map::OverlayFeature& feature = context.of(of).overlays[number];
  MapObject object;
  object.kind = sentences::nameOf(feature.shape, feature.type);
  object.name = shortName(feature.name);
  object.look = feature.type;
  object.yaw_rad = feature.yaw_rad;
  Properties known;
  known.add(ObjectText::tr("Id"), feature.id)
      .add(ObjectText::tr("Type"), feature.type == 0 ? QString() : QString::number(feature.type));
  if (of == FeaturesOf::Robot) {
    object.topic = map::topicIndex<map::MapInfo>();
    if (const auto& info = context.live->map_info) {
      known.add(ObjectText::tr("Map"), info->name);
      if (info->map_version) known.add(ObjectText::tr("Map version"), QString::number(*info->map_version));
      if (info->overlays_version)
        known.add(ObjectText::tr("Overlays version"), QString::number(*info->overlays_version));
    }
  }
  object.properties = known;
  return object;
}

constexpr LayerObjects kOverlays{seeOverlays, describeOverlay, keyOfOverlay};

void sampleOverlay(LegendSample& sample, ObjectForm form, std::int64_t look) {
  map::OverlayFeature feature;
  feature.type = int(look);
  switch (form) {
    case ObjectForm::Point:
      feature.shape = map::OverlayShape::Point;
      feature.parts = {{LegendSample::at(0, 0)}};
      break;
    case ObjectForm::Line:
      feature.shape = map::OverlayShape::Line;
      feature.parts = {sample.line()};
      break;
    case ObjectForm::Area:
      feature.shape = map::OverlayShape::Polygon;
      feature.parts = {sample.wideBox(7)};
      break;
  }
  sample.context.of(FeaturesOf::WholeMap).overlays = {feature};
}

/// One row for all types that look the same.
void addOverlays(Legend& legend, ObjectForm form, map::OverlayShape shape, const QString& others) {
  struct Look {
    QImage image;
    int first = 0;
    QStringList names;
    bool others = false;
  };
  std::vector<Look> looks;
  std::vector<int> types = sentences::knownTypes(shape);
  types.push_back(0);  // one without a type, or with one that is not known
  for (const int type : types) {
    const QImage image = legend.lookOf(form, type);
    auto look = std::find_if(looks.begin(), looks.end(), [&](const Look& l) { return l.image == image; });
    if (look == looks.end()) look = looks.insert(looks.end(), {image, type, {}, false});
    look->others |= type == 0;
    look->names << sentences::nameOf(shape, type);
  }
  std::stable_partition(looks.begin(), looks.end(), [](const Look& look) { return !look.others; });
  for (const Look& look : looks) {
    const QString text = look.others ? others : look.names.join(LegendText::tr(", "));
    legend.addThing(text, form, look.first);
  }
}

void overlaysLegend(Legend& legend) {
  addOverlays(legend, ObjectForm::Area, map::OverlayShape::Polygon, LegendText::tr("Other regions"));
  addOverlays(legend, ObjectForm::Line, map::OverlayShape::Line, LegendText::tr("Other lines"));
  addOverlays(legend, ObjectForm::Point, map::OverlayShape::Point, LegendText::tr("Other points"));
}

}  // namespace

QColor overlayColor(const MapTheme& theme, const map::OverlayFeature& feature) {
  switch (feature.shape) {
    case map::OverlayShape::Point:
      return pointColor(theme, feature.type);
    case map::OverlayShape::Line:
      return lineColor(theme, feature.type);
    case map::OverlayShape::Polygon:
      return regionColor(theme, feature.type);
  }
  return {};
}

template <>
LayerSpec layerSpec<Layer::Overlays>() {
  return {.name = "overlays",
          .title = QT_TRANSLATE_NOOP("scene", "Overlays"),
          .group = LayerGroup::Annotations,
          .sets = LayerSet::Navigation | LayerSet::Report,
          .streams = {map::Stream::MapInfo},
          .follows_robot = false,
          .why_empty = noMapFeaturesReason,
          .items = itemForEachMap<OverlaysLayer>,
          .objects = &kOverlays,
          .sample = sampleOverlay,
          .legend = overlaysLegend};
}

}  // namespace mapwright::ui::scene
