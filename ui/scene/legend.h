// The legend: each layer says what its colours and shapes mean. Where that is possible a symbol is a sample:
// a little made-up data that the layer itself paints, so that legend and map cannot disagree. Private to this
// room.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <QCoreApplication>
#include <QPainter>

#include "map/live_state.h"
#include "render/grid_renderer.h"
#include "render/tile_colors.h"
#include "session/session.h"
#include "ui/scene/layer_item.h"
#include "ui/scene/legend_section.h"

namespace mapwright::ui::scene {

/// What a layer paints for its symbol: made-up data, in a view without rotation whose middle is (0, 0).
struct LegendSample {
  static constexpr double kMPerPx = 0.2;
  LayerContext context;
  map::LiveState live;
  /// The point so many pixels to the right of the middle and above it.
  static Eigen::Vector2d at(double right_px, double up_px) { return {right_px * kMPerPx, up_px * kMPerPx}; }
  static std::vector<Eigen::Vector2d> box(double half_width_px, double half_height_px);
  /// From the middle to the left and right, with some air.
  double reachPx() const { return context.view.width_px / 2.0 - 4; }
  /// As far as that.
  std::vector<Eigen::Vector2d> line() const { return {at(-reachPx(), 0), at(reachPx(), 0)}; }
  std::vector<Eigen::Vector2d> wideBox(double half_height_px) const {
    return box(reachPx() - 1, half_height_px);
  }
};

class LegendText {
  Q_DECLARE_TR_FUNCTIONS(Legend)
};

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

}  // namespace mapwright::ui::scene
