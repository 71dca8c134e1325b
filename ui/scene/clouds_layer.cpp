#include "ui/scene/clouds_layer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "clouds/draw_cloud.h"
#include "sentences/absence_sentence.h"
#include "ui/scene/legend.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kPointPx = 2;

clouds::CloudColor colorOf(int choice) {
  switch (DispatchedCloudChoice(choice)) {
    case DispatchedCloudChoice::Intensity:
      return clouds::CloudColor::Intensity;
    case DispatchedCloudChoice::Rgb:
      return clouds::CloudColor::Rgb;
    case DispatchedCloudChoice::OneColor:
      return clouds::CloudColor::OneColor;
    case DispatchedCloudChoice::Height:
      break;
  }
  return clouds::CloudColor::Height;
}

/// With all heights.
clouds::CloudLook lookOf(const clouds::CloudStore& clouds, const LayerStyle& style, const MapTheme& theme,
                         double ratio) {
  const QColor one = style.color.isValid() ? style.color : theme.cloud;
  const auto& range = clouds.heightRange();
  clouds::CloudLook look;
  look.color = colorOf(style.choice);
  look.one = one.rgb() & 0xffffff;
  const double size_px = style.size > 0 ? style.size : kPointPx;
  look.size_px = int(std::lround(std::clamp(size_px * ratio, 1.0, double(clouds::kLargestPoint))));
  look.low_z_m = range ? range->low_m : clouds.heights().usual_low_m;
  look.high_z_m = range ? range->high_m : clouds.heights().usual_high_m;
  if (clouds.set()) {
    look.low_intensity = double(clouds.set()->usual_intensity[0]);
    look.high_intensity = double(clouds.set()->usual_intensity[1]);
  }
  return look;
}

render::TilePainter painterOf(std::shared_ptr<const clouds::CloudSet> set, const clouds::CloudLook& look) {
  return [set = std::move(set), look](const render::PixelGrid& grid, const std::atomic<bool>& cancelled) {
    const clouds::Raster raster{grid.origin_m,  grid.scale_m_per_px, grid.rotation_rad, grid.width_px,
                                grid.height_px, grid.first_column,   grid.first_row};
    const clouds::CloudPixels pixels = clouds::drawClouds(raster, *set, look, &cancelled);
    if (pixels.argb.empty()) return QImage();
    QImage image(pixels.width_px, pixels.height_px, QImage::Format_ARGB32_Premultiplied);
    for (int row = 0; row < pixels.height_px; ++row) {
      std::copy_n(pixels.argb.data() + std::size_t(row) * std::size_t(pixels.width_px), pixels.width_px,
                  reinterpret_cast<std::uint32_t*>(image.scanLine(row)));
    }
    return image;
  };
}

class CloudsLayer : public DeviceLayer {
 public:
  explicit CloudsLayer(const LayerContext& context)
      : DeviceLayer(context), clouds_(*context.clouds), tiles_(context.rasters) {
    using clouds::CloudStore;
    QObject::connect(&tiles_, &render::PaintedTiles::tilesChanged, &tiles_, [this] { update(); });
    QObject::connect(&tiles_, &render::PaintedTiles::settledChanged, &tiles_, context.settled_changed);
    QObject::connect(&clouds_, &CloudStore::settledChanged, &tiles_, context.settled_changed);
    QObject::connect(&clouds_, &CloudStore::changed, &tiles_, [this] { lookChanged(); });
  }
  void lookChanged() override { tiles_.setPainter(cloudPainter(clouds_, style(), context_.theme, ratio_)); }
  void setActive(bool active) override { tiles_.setActive(active); }
  bool settled() const override { return clouds_.settled() && tiles_.settled(); }
  std::size_t cacheBytes() const override { return tiles_.cacheBytes(); }
  geometry::WorldRect contentBounds() const override { return clouds_.bounds(); }

 protected:
  void onViewChanged(const geometry::ViewTransform& device_view) override {
    // Points have a size in window pixels.
    const double ratio = context_.view.scale_m_per_px / device_view.scale_m_per_px;
    if (std::exchange(ratio_, ratio) != ratio) lookChanged();
    tiles_.setView(device_view);
  }
  void paintPixels(QPainter& painter, const QRectF& exposed) override {
    drawRaster(painter, exposed, tiles_.drawing());
  }

 private:
  clouds::CloudStore& clouds_;
  double ratio_ = 1;
  render::PaintedTiles tiles_;
};

void cloudsLegend(Legend& legend) {
  const auto ramp = [&](const QString& low, const QString& high) {
    std::vector<QColor> colors;
    for (const std::uint32_t shade : clouds::shades()) colors.emplace_back(QRgb(shade | 0xff000000));
    legend.addScale(low, high, colors);
  };
  switch (DispatchedCloudChoice(legend.style().choice)) {
    case DispatchedCloudChoice::Height:
      return ramp(LegendText::tr("low"), LegendText::tr("high"));
    case DispatchedCloudChoice::Intensity:
      return ramp(LegendText::tr("weak"), LegendText::tr("strong echo"));
    case DispatchedCloudChoice::Rgb:
      return;  // their own colours need no words
    case DispatchedCloudChoice::OneColor:
      break;
  }
  const QColor own = legend.style().color;
  const QColor color = own.isValid() ? own : legend.theme().cloud;
  legend.add(LegendText::tr("Point of the map"), [&](QPainter& painter, const QRectF& room) {
    for (double x = 5; x < room.width(); x += 9) {
      for (double y = 3; y < room.height(); y += 7) painter.fillRect(QRectF(x, y, 2, 2), color);
    }
  });
}

}  // namespace

std::optional<CloudScale> cloudScale(const clouds::CloudStore& clouds, const LayerStyle& style,
                                     const MapTheme& theme) {
  if (!clouds.set() || clouds.heights().points == 0) return std::nullopt;
  const clouds::CloudLook now = lookOf(clouds, style, theme, 1);
  const clouds::Shades& all = clouds::shades();
  CloudScale made{CloudScale::Of::Height, now.low_z_m, now.high_z_m, {all.begin(), all.end()}};
  if (now.color == clouds::CloudColor::Height) return made;
  if (now.color != clouds::CloudColor::Intensity || !clouds.set()->has_intensity) return std::nullopt;
  made.of = CloudScale::Of::Intensity;
  made.low = now.low_intensity;
  made.high = now.high_intensity;
  return made;
}

render::TilePainter cloudPainter(const clouds::CloudStore& clouds, const LayerStyle& style,
                                 const MapTheme& theme, double ratio) {
  if (!clouds.set()) return {};
  clouds::CloudLook look = lookOf(clouds, style, theme, ratio);
  look.heights = clouds.heightRange().value_or(clouds::HeightRange{});
  return painterOf(clouds.set(), look);
}

render::TilePainter sectionPainter(const std::shared_ptr<const clouds::Section>& section,
                                   const clouds::CloudStore& clouds, const LayerStyle& style,
                                   const MapTheme& theme, double ratio) {
  if (!section) return {};
  // The cut has already selected the heights.
  return painterOf({section, &section->set}, lookOf(clouds, style, theme, ratio));
}

template <>
LayerSpec layerSpec<Layer::DispatchedCloud>() {
  return {.name = "dispatched-cloud",
          .title = QT_TRANSLATE_NOOP("scene", "Point cloud of the map"),
          .left_alone = LayerSet::Navigation | LayerSet::Mapping | LayerSet::MapOnly,
          .follows_robot = false,
          .in_all = false,
          .not_in_all_reason = QT_TRANSLATE_NOOP("scene", "may be large"),
          .in_fit = true,
          .traits =
              [] {
                return LayerTraits{.color = true,
                                   .size_px = std::pair(1.0, 8.0),
                                   .default_size_px = kPointPx,
                                   .size_title = QCoreApplication::translate("scene", "Point size"),
                                   .choice_title = QCoreApplication::translate("scene", "Colour"),
                                   .choices = {QCoreApplication::translate("scene", "By height"),
                                               QCoreApplication::translate("scene", "By intensity"),
                                               QCoreApplication::translate("scene", "Own colour"),
                                               QCoreApplication::translate("scene", "One colour")}};
              },
          .why_empty =
              [](robot::Robot& robot) {
                return robot.mapDispatch()
                           ? QString()
                           : sentences::absenceReason(robot::Capability::Dispatch,
                                                      robot.unavailableReason(robot::Capability::Dispatch));
              },
          .items = oneItem<CloudsLayer>,
          .legend = cloudsLegend};
}

}  // namespace mapwright::ui::scene
