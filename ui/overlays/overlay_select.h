// Selects overlays on the map, moves and turns them, and drags their vertices.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "edit/overlays/overlay_editing.h"
#include "ui/overlays/overlay_snapping.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlays_on_map.h"
#include "ui/view/drag_tool.h"

namespace mapwright::ui {

class OverlaySelect : public DragTool {
  Q_OBJECT
 public:
  /// All must outlive this.
  OverlaySelect(edit::OverlayEditing* editing, const scene::MapScene* scene, const OverlaysOnMap* on_map,
                OverlaySnapping* snapping, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("selectOverlays"); }
  QCursor cursor() const override;
  void deactivate() override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint&) override { return true; }
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  std::vector<QRectF> covered() const override;
  QString hint() const override;

  std::optional<QPointF> handle() const;
  /// The vertex that Delete is about.
  const std::optional<overlays::Vertex>& vertex() const { return vertex_; }
  /// What is under the cursor.
  std::optional<FeatureKey> under() const { return under_; }

 Q_SIGNALS:
  void refused(const QString& why);

 private:
  enum class Drag { None, Move, Turn, Vertex, Frame };
  using Rings = std::vector<std::vector<Eigen::Vector2d>>;

  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override;
  void finish(const MapPoint& at) override;
  void cancel() override;
  void click(const MapPoint& at) override;
  bool stepBack() override;
  Drag drag() const { return hold() ? drag_ : Drag::None; }
  /// Of the only selected one as it is drawn; empty: its vertices are not shown.
  const Rings& rings() const;
  std::optional<overlays::Vertex> vertexAt(const QPointF& px) const;
  /// The vertex before the side whose middle is there.
  std::optional<overlays::Vertex> middleAt(const QPointF& px) const;
  bool onHandle(const QPointF& px) const;
  bool holdVertex(const MapPoint& at);
  void move(const MapPoint& at);
  void turn(const MapPoint& at);
  void moveVertex(const MapPoint& at);
  void dropVertex();
  void removeVertex();
  void lookAnew();
  geometry::WorldRect selectedBounds() const;
  Eigen::Vector2d anchorNear(const Eigen::Vector2d& at_m, FeatureKey key) const;
  bool nudge(const MapKeyPress& press);
  void paintVertices(QPainter& painter) const;

  edit::OverlayEditing* editing_;
  const OverlaysOnMap* on_map_;
  OverlaySnapping* snapping_;
  Drag drag_ = Drag::None;  // what the press that is held does
  bool pressed_on_one_ = false;
  Eigen::Vector2d anchor_m_{0, 0};          // the point of what is moved that snaps
  Eigen::Vector2d by_m_{0, 0};              // by how much it is moved
  overlays::Snapped landing_;               // where the hand is caught
  std::optional<Feature> grabbed_;          // with the vertex that is dragged
  std::optional<overlays::Vertex> vertex_;  // that is chosen
  std::optional<FeatureKey> vertex_of_;     // whose it is
  std::optional<FeatureKey> under_;
  edit::OverlayEditing::Gesture nudging_ = 0;
  std::set<FeatureKey> nudged_;
  // Made when they are asked for:
  mutable std::optional<Rings> rings_;
  mutable std::size_t left_out_ = 0;  // points, as there are too many
  mutable std::optional<geometry::WorldRect> bounds_;
};

}  // namespace mapwright::ui
