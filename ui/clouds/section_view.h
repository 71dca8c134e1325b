// A cloud seen from its side: along the line to the right, heights upwards, both in metres at the same scale.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QWidget>

#include "clouds/cloud_store.h"
#include "render/raster_tiles.h"

namespace mapwright::ui {

struct SectionBand {
  int index = 0;  // the displayed number
  double low_m = 0, high_m = 0;
  bool chosen = false;
  bool movable = false;
  bool operator==(const SectionBand&) const = default;
};

struct BandEdge {
  std::size_t at = 0;  // of the bands
  bool low = false;
};

/// The edge nearest to a height, within `reach_m`; of several that of the selected band. Only of movable
/// bands.
std::optional<BandEdge> edgeNear(const std::vector<SectionBand>& bands, double height_m, double reach_m);
/// The band with that edge at a height; its ends stay in order and apart.
SectionBand withEdgeAt(SectionBand band, bool low, double height_m);

/// Wheel: zoom at the cursor. Drag: pan; at the edge of a band: move it. Double click or F: show all. Keys:
/// arrows pan, + and - zoom.
class SectionView : public QWidget {
  Q_OBJECT
 public:
  SectionView(std::shared_ptr<work::Workers> workers, QWidget* parent = nullptr);

  /// null = none. `painter` draws it; a new one for the same section keeps the view.
  void showSection(std::shared_ptr<const clouds::Section> section, render::TilePainter painter);
  const std::shared_ptr<const clouds::Section>& section() const { return section_; }
  void fit();
  /// Height ranges shown over it.
  void setBands(std::vector<SectionBand> bands);
  const std::vector<SectionBand>& bands() const { return bands_; }
  /// Converts between (along, height) and widget positions.
  Eigen::Vector2d placeAt(const QPointF& px) const;
  QPointF pxOf(const Eigen::Vector2d& place) const;
  const geometry::ViewTransform& view() const { return view_; }
  /// The position under the cursor, if it is there, and the point nearest to it.
  struct Reading {
    Eigen::Vector2d at{0, 0};
    std::optional<Eigen::Vector2d> nearest;
  };
  const std::optional<Reading>& reading() const { return reading_; }
  bool settled() const { return tiles_.settled(); }
  /// Where the number of each band is drawn, in order, side by side if bands overlap; empty: no room, or out
  /// of sight.
  std::vector<QRectF> bandLabels() const;

  QSize sizeHint() const override { return {500, 240}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 Q_SIGNALS:
  void readingChanged();
  /// The user moved an edge of a band, given by its number.
  void bandMoved(int index, double low_m, double high_m);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRect field() const;  // the area of the section, without its axes
  void setView(const geometry::ViewTransform& view);
  void sendView();
  void read(const QPointF& px);
  void paintAxes(QPainter& painter) const;
  void paintBands(QPainter& painter) const;
  std::optional<BandEdge> edgeAt(const QPointF& px) const;

  std::shared_ptr<const clouds::Section> section_;
  render::PaintedTiles tiles_;
  geometry::ViewTransform view_;
  std::vector<SectionBand> bands_;
  std::optional<BandEdge> held_edge_;
  std::optional<QPointF> grabbed_;
  std::optional<Reading> reading_;
  bool moved_ = false;  // by the user: no longer fitted automatically
};

}  // namespace mapwright::ui
