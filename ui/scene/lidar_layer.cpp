// Lidar points of all topics.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "map/live_topics.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kLidarPointPx = 2;

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

void seeCloud(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  std::size_t number = 0;
  for (const auto& [topic, cloud] : context.live->clouds) {
    if (!cloud) continue;
    for (const map::CloudPoint& point : *cloud) seePoint(see, number++, {point.x_m, point.y_m});
  }
}

MapObject describeCloudPoint(const LayerContext& context, FeaturesOf, std::size_t number) {
  MapObject object;
  object.kind = ObjectText::tr("Lidar point");
  for (const auto& [topic, cloud] : context.live->clouds) {
    if (!cloud) continue;
    if (number < cloud->size()) {
      const map::CloudPoint& point = (*cloud)[number];
      object.topic = map::topicIndex<map::PointCloudMessage>();
      object.properties = Properties()
                              .add(ObjectText::tr("Height"), metres(point.z_m))
                              .add(ObjectText::tr("Intensity"), QString::number(point.intensity));
      break;
    }
    number -= cloud->size();
  }
  return object;
}

constexpr LayerObjects kLidarPoints{seeCloud, describeCloudPoint, noKey, false};

void sampleLidar(LegendSample& sample, ObjectForm, std::int64_t) {
  auto points = std::make_shared<std::vector<map::CloudPoint>>();
  for (const double x : {-7.0, 0.0, 7.0}) {
    map::CloudPoint point;
    point.x_m = LegendSample::at(x, 0).x();
    points->push_back(point);
  }
  sample.live.clouds[{}] = points;
}

/// Points in a few rows from the left end of a scale to its right end. `made`: for a share of 0 to 1.
template <class Made>
void fillPoints(LegendSample& sample, double per_px, const Made& made) {
  auto points = std::make_shared<std::vector<map::CloudPoint>>();
  const double width = sample.context.view.width_px, height = sample.context.view.height_px;
  for (double x = 0; x <= width; x += per_px) {
    for (double y = 0; y <= height; y += per_px) {
      const Eigen::Vector2d at = LegendSample::at(x - width / 2, y - height / 2);
      map::CloudPoint point = made(x / width);
      point.x_m = at.x();
      point.y_m = at.y();
      points->push_back(point);
    }
  }
  sample.live.clouds[{}] = points;
}

void lidarLegend(Legend& legend) {
  switch (CloudChoice(legend.style().choice)) {
    case CloudChoice::Intensity:
      return legend.addSampleScale(LegendText::tr("weak"), LegendText::tr("strong echo"),
                                   [](LegendSample& sample) {
                                     fillPoints(sample, 1, [](double share) {
                                       map::CloudPoint point;
                                       point.intensity = std::uint8_t(std::lround(share * 255));
                                       return point;
                                     });
                                   });
    case CloudChoice::Height:
      return legend.addSampleScale(LegendText::tr("%1 m").arg(0),
                                   LegendText::tr("%1 m").arg(double(kLidarFullHeightM)),
                                   [](LegendSample& sample) {
                                     fillPoints(sample, 1, [](double share) {
                                       map::CloudPoint point;
                                       point.z_m = float(share) * kLidarFullHeightM;
                                       return point;
                                     });
                                   });
    case CloudChoice::OneColor:
      break;
  }
  legend.addSample(LegendText::tr("Lidar point"), [](LegendSample& sample) {
    fillPoints(sample, 9, [](double) { return map::CloudPoint(); });
  });
}

}  // namespace

template <>
LayerSpec layerSpec<Layer::Cloud>() {
  return {.name = "cloud",
          .title = QT_TRANSLATE_NOOP("scene", "Lidar points"),
          .group = LayerGroup::Environment,
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::Report,
          .streams = {map::Stream::Cloud},
          .topics = {map::topicIndex<map::PointCloudMessage>()},
          .lively = true,
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
          .objects = &kLidarPoints,
          .sample = sampleLidar,
          .legend = lidarLegend};
}

}  // namespace mapwright::ui::scene
