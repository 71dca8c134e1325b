// Edits overlays on the map: selects, moves, turns, drags vertices, and draws new ones.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scene/map_scene.h"
#include "ui/overlays/overlay_editing.h"
#include "ui/overlays/overlay_snapping.h"
#include "ui/overlays/overlays_on_map.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

enum class OverlayMode { Select, Point, Line, Polygon, Rectangle, Circle };
inline constexpr int kOverlayModes = 6;
/// What is drawn in it; None: nothing.
overlays::Shape shapeOf(OverlayMode mode);

class OverlayTool : public MapTool {
  Q_OBJECT
 public:
  /// How far from what it turns the handle is.
  static constexpr double kHandlePx = 34;
  /// Of a feature with more, no vertices are shown.
  static constexpr std::size_t kMostVertices = 2'000;

  /// All must outlive this.
  OverlayTool(OverlayEditing* editing, const scene::MapScene* scene, const OverlaysOnMap* on_map,
              OverlaySnapping* snapping, QObject* parent = nullptr);

  OverlayMode mode() const { return mode_; }
  void setMode(OverlayMode mode);
  /// The type of new ones of that shape.
  int newType(overlays::Shape shape) const { return types_[std::size_t(shape)]; }
  void setNewType(overlays::Shape shape, int type);
  /// Of new circles: a click makes one. 0: as it is dragged.
  double circleRadius() const { return circle_radius_m_; }
  void setCircleRadius(double metres);
  /// As if the map were clicked there: the next point of what is being drawn, or else a new point with that
  /// heading.
  void addPlace(const Eigen::Vector2d& at_m, double yaw_deg);
  /// Why nothing can be edited at present; empty = it can.
  void setWhyNot(const QString& sentence);

  QString name() const override { return QStringLiteral("overlays"); }
  QCursor cursor() const override;
  void activate() override { Q_EMIT activated(); }
  void deactivate() override;
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  void clicked(const MapPoint& at) override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint& at) override;
  bool claims(const MapKeyPress& press) const override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  std::vector<QRectF> covered() const override;
  QString hint() const override;

  /// Where the handle is that turns what is selected, in viewport pixels; nullopt: there is none.
  std::optional<QPointF> handle() const;
  /// The vertex that Delete is about.
  const std::optional<overlays::Vertex>& vertex() const { return vertex_; }

 Q_SIGNALS:
  void activated();
  void modeChanged();
  /// It is impossible; a sentence.
  void refused(const QString& why);
  void copyWanted();
  void cutWanted();
  /// In its place, or around another.
  void pasteWanted(std::optional<Eigen::Vector2d> at_m);

 private:
  enum class Drag { None, Move, Turn, Vertex, Frame, Rectangle, Circle };
  using Rings = std::vector<std::vector<Eigen::Vector2d>>;

  QPointF px(const Eigen::Vector2d& world_m) const;
  /// Of the only selected one as it is drawn; empty: its vertices are not shown.
  const Rings& rings() const;
  std::optional<overlays::Vertex> vertexAt(const QPointF& px) const;
  /// The vertex before the side whose middle is there.
  std::optional<overlays::Vertex> middleAt(const QPointF& px) const;
  bool onHandle(const QPointF& px) const;
  void turn(const MapPoint& at);
  void dropVertex();
  void lookAnew();
  bool drawing() const { return mode_ != OverlayMode::Select; }
  void addCorner(const Eigen::Vector2d& at_m);
  /// Where a click at a place adds the next point.
  Eigen::Vector2d caught(const MapPoint& at);
  /// What is moved from `anchor_m_` to there.
  Eigen::Vector2d shiftTo(const MapPoint& at);
  Eigen::Vector2d anchorNear(const Eigen::Vector2d& at_m, FeatureKey key) const;
  void finishShape();
  bool nudge(const MapKeyPress& press);
  std::vector<Eigen::Vector2d> rectangle() const;
  void removeVertex();
  void paintSelected(QPainter& painter) const;
  void paintMany(QPainter& painter, const std::set<FeatureKey>& keys) const;
  /// Where they moved what I moved, too.
  void paintTheirs(QPainter& painter) const;
  void paintVertices(QPainter& painter) const;
  void paintShape(QPainter& painter) const;

  OverlayEditing* editing_;
  const scene::MapScene* scene_;
  const OverlaysOnMap* on_map_;
  OverlaySnapping* snapping_;
  OverlayMode mode_ = OverlayMode::Select;
  std::array<int, 5> types_{};
  QString why_not_;
  Drag drag_ = Drag::None;
  bool pressed_on_one_ = false;
  Eigen::Vector2d press_m_{0, 0};
  Eigen::Vector2d anchor_m_{0, 0};  // the point of what is moved that snaps
  overlays::Snapped landing_;       // where the hand is caught
  double circle_radius_m_ = 0;
  QPointF press_px_, now_px_;
  std::optional<Feature> grabbed_;          // with the vertex that is dragged
  std::optional<overlays::Vertex> vertex_;  // that is chosen
  std::optional<FeatureKey> vertex_of_;     // whose it is
  std::vector<Eigen::Vector2d> corners_;    // of what is being drawn
  std::optional<Eigen::Vector2d> hand_;     // world metres
  std::optional<FeatureKey> hovered_;
  OverlayEditing::Gesture nudging_ = 0;
  std::set<FeatureKey> nudged_;
  mutable std::optional<Rings> rings_;  // made when they are asked for
};

}  // namespace mapwright::window
