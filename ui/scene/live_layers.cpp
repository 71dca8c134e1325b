// Layers of the robot's sensor data and plans, from its live topics.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <QCoreApplication>

#include "map/live_topics.h"
#include "scene/layer_bounds.h"
#include "scene/layer_item.h"
#include "scene/legend.h"

namespace mapwright::scene {
namespace {

constexpr double kPathPx = 3, kTrajectoryPx = 2, kLidarPointPx = 2;

/// Lidar points of all topics.
class CloudLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Points have arrived: repaints their old and new areas.
  void liveChanged() override;
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const auto& [topic, cloud] : context_.live->clouds) {
      if (!cloud) continue;
      for (const map::CloudPoint& point : *cloud) extendBy(bounds, {point.x_m, point.y_m});
    }
    return bounds;
  }

 private:
  struct Key {
    geometry::ViewTransform view;
    std::map<std::string, std::shared_ptr<const std::vector<map::CloudPoint>>> clouds;
    LayerStyle style;
    bool dark = false;
    qreal ratio = 1;
    bool operator==(const Key&) const = default;
  };
  Key keyNow() const;
  void splat();

  Key key_;
  QImage image_;
  QRect painted_;  // area of image_ with points, in device pixels
  qreal ratio_ = 1;
};

CloudLayer::Key CloudLayer::keyNow() const {
  return {context_.view, context_.live->clouds, style(), context_.theme.dark, ratio_};
}

void CloudLayer::liveChanged() {
  if (!isVisible()) return;
  const auto toLogical = [this](const QRect& rect) {
    return QRectF(QPointF(rect.topLeft()) / ratio_, QSizeF(rect.size()) / ratio_).adjusted(-1, -1, 1, 1);
  };
  update(toLogical(painted_));
  splat();
  update(toLogical(painted_));
}

void CloudLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  ratio_ = painter->device()->devicePixelRatioF();
  if (!(keyNow() == key_)) splat();
  if (painted_.isEmpty()) return;
  const QRectF target(QPointF(painted_.topLeft()) / ratio_, QSizeF(painted_.size()) / ratio_);
  painter->drawImage(target, image_, painted_);
}

// Points are written directly into an image: thirty thousand of them take a fraction of a millisecond there
// and ten with the painter.
void CloudLayer::splat() {
  key_ = keyNow();
  const geometry::ViewTransform& view = context_.view;
  const QSize size(int(std::ceil(view.width_px * ratio_)), int(std::ceil(view.height_px * ratio_)));
  if (image_.size() != size) {
    image_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
    image_.fill(Qt::transparent);
  } else if (!painted_.isEmpty()) {
    for (int y = painted_.top(); y <= painted_.bottom(); ++y) {
      auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
      std::fill(line + painted_.left(), line + painted_.right() + 1, 0);
    }
  }
  painted_ = {};
  if (image_.isNull() || context_.live->clouds.empty()) return;

  const auto choice = CloudChoice(style().choice);
  const QColor one = colorOr(context_.theme.cloud);
  std::array<QRgb, 256> colors;
  for (int i = 0; i < 256; ++i) {
    colors[std::size_t(i)] =
        choice == CloudChoice::OneColor ? one.rgb() : QColor::fromHsv(240 - i * 240 / 255, 220, 230).rgb();
  }
  const int edge = std::max(1, int(std::lround(sizeOr(kLidarPointPx) * ratio_)));
  const double c = std::cos(view.rotation_rad), s = std::sin(view.rotation_rad);
  const double per_m = ratio_ / view.scale_m_per_px;
  const double half_w = view.width_px * ratio_ / 2, half_h = view.height_px * ratio_ / 2;
  int left = size.width(), top = size.height(), right = -1, bottom = -1;
  std::vector<QRgb*> rows(std::size_t(size.height()));
  for (int y = 0; y < size.height(); ++y) rows[std::size_t(y)] = reinterpret_cast<QRgb*>(image_.scanLine(y));
  for (const auto& [topic, cloud] : context_.live->clouds) {
    if (!cloud) continue;
    for (const map::CloudPoint& point : *cloud) {
      const double dx = (point.x_m - view.center_m.x()) * per_m, dy = (point.y_m - view.center_m.y()) * per_m;
      const double px = half_w + c * dx - s * dy - edge / 2.0, py = half_h - (s * dx + c * dy) - edge / 2.0;
      if (!(px > -edge && py > -edge && px < size.width() && py < size.height())) continue;
      const int x0 = std::max(0, int(std::floor(px + 0.5))), y0 = std::max(0, int(std::floor(py + 0.5)));
      const int x1 = std::min(size.width(), int(std::floor(px + 0.5)) + edge);
      const int y1 = std::min(size.height(), int(std::floor(py + 0.5)) + edge);
      if (x0 >= x1 || y0 >= y1) continue;
      std::size_t index = point.intensity;
      if (choice == CloudChoice::Height)
        index = std::size_t(std::clamp(point.z_m / kLidarFullHeightM, 0.0F, 1.0F) * 255);
      for (int y = y0; y < y1; ++y)
        std::fill(rows[std::size_t(y)] + x0, rows[std::size_t(y)] + x1, colors[index]);
      left = std::min(left, x0);
      top = std::min(top, y0);
      right = std::max(right, x1 - 1);
      bottom = std::max(bottom, y1 - 1);
    }
  }
  if (right >= left) painted_ = QRect(QPoint(left, top), QPoint(right, bottom));
}

/// Lines through the world.
class LinesLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;

 protected:
  void paintLines(QPainter& painter, const QColor& color, double width,
                  std::span<const Eigen::Vector2d> world, const QRectF& exposed) const {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const QPainterPath lines = pathOf(visibleLines(context_.view, world, width + 2, exposed));
    for (const auto& [pen_color, pen_width] :
         {std::pair(context_.theme.text_halo, width + 2), std::pair(color, width)}) {
      painter.setPen(QPen(pen_color, pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(lines);
    }
  }
};

class PathLayer : public LinesLayer {
 public:
  using LinesLayer::LinesLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    markPainted();
    paintLines(*painter, colorOr(context_.theme.path), sizeOr(kPathPx), context_.live->path,
               option->exposedRect);
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.live->path); }

 protected:
  QRectF reach() const override { return reachOf(context_.live->path, sizeOr(kPathPx) + 2); }
};

/// Of the robot, or of an opened map.
class TrajectoryLayer : public LinesLayer {
 public:
  using LinesLayer::LinesLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    markPainted();
    const auto paint_one = [&](std::span<const Eigen::Vector2d> line) {
      paintLines(*painter, colorOr(context_.theme.trajectory), sizeOr(kTrajectoryPx), line,
                 option->exposedRect);
    };
    if (of() == FeaturesOf::Robot) return paint_one(context_.live->trajectory);
    for (const auto& line : context_.of(*of()).trajectories) paint_one(line);
  }
  geometry::WorldRect contentBounds() const override {
    if (of() == FeaturesOf::Robot) return boundsOf(context_.live->trajectory);
    geometry::WorldRect bounds;
    for (const auto& line : context_.of(*of()).trajectories) bounds.extend(boundsOf(line));
    return bounds;
  }

 protected:
  QRectF reach() const override {
    const double margin = sizeOr(kTrajectoryPx) + 2;
    if (of() == FeaturesOf::Robot) return reachOf(context_.live->trajectory, margin);
    QRectF reach;
    for (const auto& line : context_.of(*of()).trajectories) reach |= reachOf(line, margin);
    return reach;
  }
};

/// Many short, thin segments.
class ConstraintsLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const auto& sets = context_.live->constraints.by_name;
    const QSizeF viewport(context_.view.width_px, context_.view.height_px);
    const QRectF seen(QPointF(0, 0), viewport);
    for (const auto& [name, segments] : sets) {
      QList<QLineF> lines;
      for (const auto& [from, to] : segments) {
        const QLineF line(toPoint(context_.view.pixelFromWorld(from)),
                          toPoint(context_.view.pixelFromWorld(to)));
        if (QRectF(line.p1(), line.p2()).normalized().adjusted(-1, -1, 1, 1).intersects(seen)) lines << line;
      }
      if (lines.isEmpty()) continue;
      // Residuals are remaining errors; other constraints are only there.
      const bool residual = name.find("esidual") != std::string::npos;
      const QColor color = colorOr(residual ? context_.theme.bad : context_.theme.constraint);
      sheet_.paint(*painter, viewport, 0.8, [&](QPainter& on_sheet) {
        on_sheet.setPen(QPen(color, 0));
        on_sheet.drawLines(lines);
      });
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const auto& [name, segments] : context_.live->constraints.by_name) {
      for (const auto& [from, to] : segments) {
        extendBy(bounds, from);
        extendBy(bounds, to);
      }
    }
    return bounds;
  }

 private:
  LineSheet sheet_;
};

/// The local path as a band of the robot's width.
class LocalPathLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    markPainted();
    const map::LocalPathMessage& path = context_.live->local_path;
    if (path.points.size() < 2) return;
    QColor color = translucent(colorOr(context_.theme.path), 90);
    if (path.rgba && !style().color.isValid()) {
      color = QColor(int(*path.rgba >> 24 & 255), int(*path.rgba >> 16 & 255), int(*path.rgba >> 8 & 255),
                     std::max(60, int(*path.rgba & 255)));
    }
    const double width = widthPx();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter->drawPath(pathOf(visibleLines(context_.view, path.points, width, option->exposedRect)));
  }

 protected:
  QRectF reach() const override { return reachOf(context_.live->local_path.points, widthPx()); }

 private:
  double widthPx() const {
    return std::clamp(context_.live->local_path.width_m / context_.view.scale_m_per_px, 3.0, 4000.0);
  }
  geometry::WorldRect contentBounds() const override { return boundsOf(context_.live->local_path.points); }
};

/// The robot's goal.
class TargetLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
    const auto& planning = context_.live->planning;
    if (!planning) return;
    const QColor color = colorOr(context_.theme.target);
    const QRectF near_view(-kReachPx, -kReachPx, context_.view.width_px + 2 * kReachPx,
                           context_.view.height_px + 2 * kReachPx);
    for (const geometry::Pose2& target : planning->targets) {
      const QPointF at = toPoint(context_.view.pixelFromWorld({target.x_m, target.y_m}));
      if (!near_view.contains(at)) continue;
      const double heading = target.yaw_rad + context_.view.rotation_rad;
      if (planning->targets.size() > kFew) {  // a cloud of them
        painter->setPen(QPen(color, 1.5));
        painter->drawLine(at, at + QPointF(std::cos(heading), -std::sin(heading)) * 7);
        continue;
      }
      painter->setRenderHint(QPainter::Antialiasing);
      painter->setBrush(Qt::NoBrush);
      for (const auto& [pen_color, width] :
           {std::pair{context_.theme.text_halo, 5.0}, std::pair{color, 2.0}}) {
        painter->setPen(QPen(pen_color, width, Qt::SolidLine, Qt::RoundCap));
        painter->drawEllipse(at, 9, 9);
        painter->drawLine(at, at + QPointF(std::cos(heading), -std::sin(heading)) * 16);
      }
      painter->setBrush(color);
      painter->drawEllipse(at, 2, 2);
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    if (!context_.live->planning) return bounds;
    for (const geometry::Pose2& target : context_.live->planning->targets)
      extendBy(bounds, {target.x_m, target.y_m});
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    const auto& planning = context_.live->planning;
    if (!planning || planning->targets.size() > kFew) return;
    for (const geometry::Pose2& target : planning->targets) {
      const QPointF at = toPoint(context_.view.pixelFromWorld({target.x_m, target.y_m}));
      keepClear(labels, context_, QRectF(at - QPointF(11, 11), QSizeF(22, 22)), target.yaw_rad);
    }
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    if (const auto& planning = context_.live->planning) {
      for (const geometry::Pose2& target : planning->targets) points.emplace_back(target.x_m, target.y_m);
    }
    return reachOf(points, kReachPx);
  }

 private:
  static constexpr std::size_t kFew = 50;
  static constexpr double kReachPx = 20;
};

/// Other robots, with their footprints and where they are headed.
class NearbyRobotsLayer : public SmallLayer {
 public:
  using SmallLayer::SmallLayer;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    markPainted();
    const QColor color = colorOr(context_.theme.other_robot);
    painter->setRenderHint(QPainter::Antialiasing);
    for (const map::NearbyRobot& other : context_.live->nearby_robots) {
      painter->setBrush(Qt::NoBrush);
      painter->setPen(QPen(translucent(color, 150), 2, Qt::DotLine));
      for (const QPolygonF& line : visibleLines(context_.view, other.trend, 4)) painter->drawPolyline(line);
      const auto outline = context_.live->nearby_footprints.find(other.footprint_digest);
      if (outline != context_.live->nearby_footprints.end() && outline->second.size() >= 3) {
        QPolygonF polygon;
        for (const Eigen::Vector2d& corner : outline->second) {
          polygon << toPoint(context_.view.pixelFromWorld(other.pose.apply(corner)));
        }
        painter->setBrush(translucent(color, 70));
        painter->setPen(QPen(color, 1.5));
        painter->drawPolygon(polygon);
      }
      drawPlace(*painter, context_, {other.pose.x_m, other.pose.y_m}, other.pose.yaw_rad, color);
    }
  }
  geometry::WorldRect contentBounds() const override {
    geometry::WorldRect bounds;
    for (const map::NearbyRobot& other : context_.live->nearby_robots)
      extendBy(bounds, {other.pose.x_m, other.pose.y_m});
    return bounds;
  }
  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    for (const map::NearbyRobot& other : context_.live->nearby_robots) {
      labelPlace(labels, context_, {other.pose.x_m, other.pose.y_m}, other.pose.yaw_rad, LabelRank::Robot,
                 qHash(QByteArrayView(other.uid)), shortName(other.uid));
    }
  }

 protected:
  QRectF reach() const override {
    std::vector<Eigen::Vector2d> points;
    for (const map::NearbyRobot& other : context_.live->nearby_robots) {
      points.insert(points.end(), other.trend.begin(), other.trend.end());
      points.emplace_back(other.pose.x_m, other.pose.y_m);
      const auto outline = context_.live->nearby_footprints.find(other.footprint_digest);
      if (outline == context_.live->nearby_footprints.end()) continue;
      for (const Eigen::Vector2d& corner : outline->second) points.push_back(other.pose.apply(corner));
    }
    return reachOf(points, 20);
  }
};

}  // namespace

template <>
LayerSpec layerSpec<Layer::Constraints>() {
  return {.name = "constraints",
          .title = QT_TRANSLATE_NOOP("scene", "Constraints"),
          .shown = false,
          .streams = {map::Stream::Constraints},
          .topics = {map::topicIndex<map::ConstraintsMessage>()},
          .traits = [] { return lineTraits(1); },
          .items = oneItem<ConstraintsLayer>,
          .legend = constraintsLegend};
}

template <>
LayerSpec layerSpec<Layer::Trajectory>() {
  return {.name = "trajectory",
          .title = QT_TRANSLATE_NOOP("scene", "Trajectory"),
          .shown = false,
          .streams = {map::Stream::Trajectory},
          .topics = {map::topicIndex<map::TrajectoryMessage>()},
          .traits = [] { return lineTraits(kTrajectoryPx); },
          .why_empty = noMapFeaturesReason,
          .items = itemForEachMap<TrajectoryLayer>,
          .legend = trajectoryLegend};
}

template <>
LayerSpec layerSpec<Layer::Path>() {
  return {.name = "path",
          .title = QT_TRANSLATE_NOOP("scene", "Path"),
          .group = LayerGroup::Robot,
          .streams = {map::Stream::Path},
          .topics = {map::topicIndex<map::PathMessage>()},
          .topic_chosen = true,
          .traits = [] { return lineTraits(kPathPx); },
          .items = oneItem<PathLayer>,
          .legend = pathLegend};
}

template <>
LayerSpec layerSpec<Layer::LocalPath>() {
  return {.name = "local-path",
          .title = QT_TRANSLATE_NOOP("scene", "Local path"),
          .group = LayerGroup::Robot,
          .streams = {map::Stream::LocalPath},
          .topics = {map::topicIndex<map::LocalPathMessage>()},
          .topic_chosen = true,
          .traits = [] { return LayerTraits{.color = true}; },
          .items = oneItem<LocalPathLayer>,
          .legend = localPathLegend};
}

template <>
LayerSpec layerSpec<Layer::Target>() {
  return {.name = "target",
          .title = QT_TRANSLATE_NOOP("scene", "Target"),
          .group = LayerGroup::Robot,
          .streams = {map::Stream::Planning},
          .topics = {map::topicIndex<map::PlanningState>()},
          .topic_chosen = true,
          .traits = [] { return LayerTraits{.color = true}; },
          .items = oneItem<TargetLayer>,
          .legend = targetLegend};
}

template <>
LayerSpec layerSpec<Layer::Cloud>() {
  return {.name = "cloud",
          .title = QT_TRANSLATE_NOOP("scene", "Lidar points"),
          .group = LayerGroup::Environment,
          .streams = {map::Stream::Cloud},
          .topics = {map::topicIndex<map::PointCloudMessage>()},
          .traits =
              [] {
                return LayerTraits{.color = true,
                                   .size_px = std::pair(1.0, 8.0),
                                   .default_size_px = kLidarPointPx,
                                   .size_title = QCoreApplication::translate("scene", "Point size"),
                                   .choice_title = QCoreApplication::translate("scene", "Colour"),
                                   .choices = {QCoreApplication::translate("scene", "One colour"),
                                               QCoreApplication::translate("scene", "By intensity"),
                                               QCoreApplication::translate("scene", "By height")}};
              },
          .items = oneItem<CloudLayer>,
          .legend = lidarLegend};
}

template <>
LayerSpec layerSpec<Layer::NearbyRobots>() {
  return {.name = "robots",
          .title = QT_TRANSLATE_NOOP("scene", "Nearby robots"),
          .group = LayerGroup::Environment,
          .streams = {map::Stream::NearbyRobots, map::Stream::NearbyFootprints},
          .topics = {map::topicIndex<map::NearbyRobotsMessage>(),
                     map::topicIndex<map::NearbyFootprintsMessage>()},
          .traits = [] { return LayerTraits{.color = true}; },
          .items = oneItem<NearbyRobotsLayer>,
          .legend = nearbyRobotsLegend};
}

}  // namespace mapwright::scene
