// Edits overlays on the map. Each mode is a tool of its own; here is which one, and what they share.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include <QColor>

#include "ui/overlays/overlay_draw.h"
#include "ui/overlays/overlay_select.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/kept_picture.h"

namespace mapwright::ui {

class OverlayTool : public MapTool {
  Q_OBJECT
 public:
  /// All must outlive this.
  OverlayTool(edit::OverlayEditing* editing, const scene::MapScene* scene, const OverlaysOnMap* on_map,
              OverlaySnapping* snapping, QObject* parent = nullptr);

  OverlayMode mode() const { return mode_; }
  void setMode(OverlayMode mode);
  /// The type of new ones of that shape.
  int newType(overlays::Shape shape) const { return types_[std::size_t(shape)]; }
  void setNewType(overlays::Shape shape, int type);
  /// Of new circles: a click makes one. 0: as it is dragged.
  double circleRadius() const { return circle_->radius(); }
  void setCircleRadius(double metres);
  /// As if the map were clicked there: the next point of what is being drawn, or else a new point with that
  /// heading.
  void addPlace(const Eigen::Vector2d& at_m, double yaw_deg);
  /// Why nothing can be edited at present; empty = it can.
  void setUnavailableReason(const QString& sentence);

  QString name() const override { return QStringLiteral("overlays"); }
  QCursor cursor() const override { return hand().cursor(); }
  void activate() override { Q_EMIT activated(); }
  void deactivate() override;
  bool pressed(const MapPoint& at) override { return hand().pressed(at); }
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override { hand().released(at); }
  void dragCancelled() override { hand().dragCancelled(); }
  void clicked(const MapPoint& at) override { hand().clicked(at); }
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint& at) override { return hand().doubleClicked(at); }
  bool claims(const MapKeyPress& press) const override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  std::vector<QRectF> covered() const override { return hand().covered(); }
  QString hint() const override;

  /// Where the handle is that turns what is selected, in viewport pixels; nullopt: there is none.
  std::optional<QPointF> handle() const { return drawing() ? std::nullopt : select_->handle(); }
  /// The vertex that Delete is about.
  const std::optional<overlays::Vertex>& vertex() const { return select_->vertex(); }

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
  DragTool& hand() const { return *modes_[std::size_t(mode_)]; }
  bool drawing() const { return mode_ != OverlayMode::Select; }
  bool editKey(const MapKeyPress& press);
  QPointF px(const Eigen::Vector2d& world_m) const;
  void eachLine(FeatureKey key, const std::function<void(const QPointF&)>& point,
                const std::function<void(const QPolygonF&)>& line, const QRectF& exposed) const;
  void paintSelected(QPainter& painter);
  void paintMany(QPainter& painter, const std::set<FeatureKey>& keys, const QRectF& exposed) const;
  /// Where they moved what I moved, too.
  void paintTheirs(QPainter& painter) const;

  edit::OverlayEditing* editing_;
  const scene::MapScene* scene_;
  const OverlaysOnMap* on_map_;
  OverlaySelect* select_;
  OverlayDrawCircle* circle_;
  std::array<DragTool*, kOverlayModes> modes_;  // by OverlayMode
  OverlayMode mode_ = OverlayMode::Select;
  std::array<int, 5> types_{};
  QString unavailable_reason_;
  std::optional<Eigen::Vector2d> cursor_m_;
  scene::KeptPicture many_;  // of those that are selected
  std::uint64_t many_revision_ = 0;
  std::set<FeatureKey> many_keys_;
  QColor many_color_;
};

}  // namespace mapwright::ui
