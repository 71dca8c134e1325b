// Draws new overlays: points, lines, outlines, rectangles and circles.
#pragma once

#include <optional>
#include <vector>

#include "edit/overlays/overlay_editing.h"
#include "overlays/overlay_shapes.h"
#include "ui/overlays/overlay_snapping.h"
#include "ui/view/drag_tool.h"

namespace mapwright::ui {

enum class OverlayMode { Select, Point, Line, Polygon, Rectangle, Circle };
inline constexpr int kOverlayModes = 6;
/// What is drawn in it; None: nothing.
overlays::Shape shapeOf(OverlayMode mode);

/// One corner after the other. What is drawn is reported once.
class OverlayDraw : public DragTool {
  Q_OBJECT
 public:
  /// All must outlive this.
  OverlayDraw(OverlayMode mode, edit::OverlayEditing* editing, const scene::MapScene* scene,
              OverlaySnapping* snapping, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("drawOverlays"); }
  void deactivate() override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  /// As if the map were clicked there.
  void addCorner(const Eigen::Vector2d& at_m);

 Q_SIGNALS:
  void drawn(const std::vector<Eigen::Vector2d>& points_m);
  void refused(const QString& why);

 protected:
  using Corners = std::vector<Eigen::Vector2d>;
  /// With as many it is complete; 0: when the hand says so.
  virtual std::size_t wholeAt() const { return mode_ == OverlayMode::Point ? 1 : 0; }
  /// What is drawn by these corners.
  virtual Corners outlineOf(const Corners& corners) const { return corners; }
  virtual QString tooFew() const;
  /// The lines while it is drawn.
  virtual void paintOutline(QPainter& painter, const Corners& corners) const;
  bool grab(const MapPoint&) override { return false; }
  void click(const MapPoint& at) override { addCorner(caught(at)); }
  bool stepBack() override;

  /// Those that are set.
  const Corners& corners() const { return corners_; }
  const std::optional<Eigen::Vector2d>& hand() const { return hand_; }
  void follow(const MapPoint& at) { hand_ = caught(at); }
  void complete();
  void forget();
  /// Where a click at a place adds the next corner.
  Eigen::Vector2d caught(const MapPoint& at);
  QString snapHint() const { return OverlaySnapping::hintOf(landing_.to); }

 private:
  OverlayMode mode_;
  edit::OverlayEditing* editing_;
  OverlaySnapping* snapping_;
  Corners corners_;
  std::optional<Eigen::Vector2d> hand_;
  overlays::Snapped landing_;  // where the hand is caught
};

/// By two corners: two clicks, or a drag.
class OverlayDrawRectangle : public OverlayDraw {
  Q_OBJECT
 public:
  using OverlayDraw::OverlayDraw;
  QString hint() const override;

 protected:
  std::size_t wholeAt() const override { return 2; }
  Corners outlineOf(const Corners& corners) const override;
  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override { follow(at); }
  void finish(const MapPoint& at) override;
  void cancel() override { forget(); }
  void click(const MapPoint& at) override;
};

/// Around its centre. With a given radius a click makes it.
class OverlayDrawCircle : public OverlayDrawRectangle {
  Q_OBJECT
 public:
  using OverlayDrawRectangle::OverlayDrawRectangle;
  QString hint() const override;
  double radius() const { return radius_m_; }
  void setRadius(double metres);

 protected:
  std::size_t wholeAt() const override { return radius_m_ > 0 ? 1 : 2; }
  Corners outlineOf(const Corners& corners) const override;
  QString tooFew() const override;
  void paintOutline(QPainter& painter, const Corners& corners) const override;

 private:
  double radiusOf(const Corners& corners) const;
  double radius_m_ = 0;
};

}  // namespace mapwright::ui
