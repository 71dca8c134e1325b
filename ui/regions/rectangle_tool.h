// Draws an axis-aligned rectangle on the map.
#pragma once

#include <functional>
#include <optional>

#include "geometry/rect.h"
#include "geometry/view_transform.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

/// A drag draws it; it is reported once when the button is released. Esc cancels.
class RectangleTool : public MapTool {
  Q_OBJECT
 public:
  /// `view`: the present camera. `describe`: one line about a rectangle.
  RectangleTool(std::function<geometry::ViewTransform()> view,
                std::function<QString(const geometry::WorldRect&)> describe, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("region"); }
  void deactivate() override { dragCancelled(); }
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  void drawn(const mapwright::geometry::WorldRect& rect);

 private:
  geometry::WorldRect rect() const;

  std::function<geometry::ViewTransform()> view_;
  std::function<QString(const geometry::WorldRect&)> describe_;
  std::optional<Eigen::Vector2d> from_, to_;  // world
};

}  // namespace mapwright::window
