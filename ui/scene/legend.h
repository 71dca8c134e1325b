// The legend: each layer says what its colours and shapes mean. Where that is possible a symbol is a sample:
// a little made-up data that the layer itself paints, so that legend and map cannot disagree. Private to this
// room.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <QPainter>

#include "map/live_state.h"
#include "render/grid_renderer.h"
#include "render/tile_colors.h"
#include "scene/layer_item.h"
#include "scene/legend_section.h"
#include "session/session.h"

namespace mapwright::scene {

/// What a layer paints for its symbol: made-up data, in a view without rotation whose middle is (0, 0).
struct LegendSample {
  static constexpr double kMPerPx = 0.2;
  LayerContext context;
  map::LiveState live;
  /// The point so many pixels to the right of the middle and above it.
  static Eigen::Vector2d at(double right_px, double up_px) { return {right_px * kMPerPx, up_px * kMPerPx}; }
  static std::vector<Eigen::Vector2d> box(double half_width_px, double half_height_px);
  /// From the middle to the left and right, with some air.
  double reachPx() const;
};

// What of a thing tells how it looks: MapObject::look.
inline constexpr std::int64_t kOpenDoor = 0, kClosedDoor = 1, kOtherDoor = 2;
std::int64_t whichLook(const DrawnWaypoint& point);
std::int64_t whichLook(const map::AutoDoor& door);
std::int64_t whichLook(const map::GroundBox& box);
/// A thing of the layer that looks as MapObject::look says.
void fillSample(LegendSample& sample, Layer layer, ObjectForm form, std::int64_t look);

/// Collects the rows of one layer.
class Legend {
 public:
  static constexpr QSize kSymbol{44, 22}, kScale{150, 14};
  struct Source {
    const LayerContext& context;
    LayerStyle style = {};
    double opacity = 1;
    const session::Session* session = nullptr;  // null = none
    render::ColorMode colors = render::ColorMode::Normal;
    qreal pixel_ratio = 1;
  };
  using Paint = std::function<void(QPainter& painter, const QRectF& room)>;
  using Fill = std::function<void(LegendSample& sample)>;

  Legend(Layer layer, const Source& source) : layer_(layer), source_(source) {}

  const MapTheme& theme() const { return source_.context.theme; }
  const LayerContext& context() const { return source_.context; }
  const LayerStyle& style() const { return source_.style; }
  const session::Session* session() const { return source_.session; }
  render::ColorMode colors() const { return source_.colors; }

  /// A symbol on free ground.
  void add(const QString& text, const Paint& paint);
  /// The same, painted by the layer.
  void addSample(const QString& text, const Fill& fill);
  void addThing(const QString& text, ObjectForm form, std::int64_t look = 0);
  /// The whole symbol is a cell.
  void addCell(const QString& text, const QColor& color);
  /// A scale painted by the layer, from its left to its right end.
  void addSampleScale(const QString& low, const QString& high, const Fill& fill);
  void addScale(const QString& low, const QString& high, std::span<const QColor> colors,
                const QString& text = {});
  /// What the layer would paint, to find samples that look the same.
  QImage lookOf(ObjectForm form, std::int64_t look, const QSize& size = kSymbol) const;

  const std::vector<LegendRow>& rows() const { return rows_; }

 private:
  QImage painted(const QSize& size, const Paint& paint) const;
  Paint bySample(const Fill& fill) const;
  Paint byThing(ObjectForm form, std::int64_t look) const;

  Layer layer_;
  Source source_;
  std::vector<LegendRow> rows_;
};

/// The cells of a map: free, occupied, unknown.
void addCells(Legend& legend, const render::MapColors& colors);
/// A colour of a palette, which is premultiplied.
QColor cellColor(std::uint32_t premultiplied);

// Of the layers that need no data for it (feature_legends.cpp, live_legends.cpp, map_legends.cpp).
void overlaysLegend(Legend& legend);
void waypointsLegend(Legend& legend);
void landmarksLegend(Legend& legend);
void doorsLegend(Legend& legend);
void boxesLegend(Legend& legend);
void constraintsLegend(Legend& legend);
void trajectoryLegend(Legend& legend);
void pathLegend(Legend& legend);
void localPathLegend(Legend& legend);
void targetLegend(Legend& legend);
void lidarLegend(Legend& legend);
void nearbyRobotsLegend(Legend& legend);
void trailLegend(Legend& legend);
void footprintLegend(Legend& legend);
void expandedFootprintLegend(Legend& legend);
void robotLegend(Legend& legend);
void trackLegend(Legend& legend);
void submapsLegend(Legend& legend);
void outlinesLegend(Legend& legend);
void idsLegend(Legend& legend);
void gridLegend(Legend& legend);
void cloudsLegend(Legend& legend);

}  // namespace mapwright::scene
