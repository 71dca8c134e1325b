// A line on the map by two clicks or a drag: it snaps, and with Shift it turns in steps of 15 degrees.
#pragma once

#include <optional>

#include "ui/view/drag_tool.h"
#include "ui/waypoints/waypoint_snapping.h"

namespace mapwright::ui {

class TwoPointTool : public DragTool {
  Q_OBJECT
 public:
  /// Both must outlive this.
  TwoPointTool(const scene::MapScene* scene, WaypointSnapping* snapping, QObject* parent = nullptr);

  void deactivate() override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint&) override { return true; }  // two clicks, and the map stays
  void paint(QPainter& painter) override;
  virtual void forget();  // begins anew

 protected:
  struct Line {
    Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
    double length() const { return (to_m - from_m).norm(); }
    double heading() const;
  };
  /// As far as it is drawn.
  const std::optional<Line>& line() const { return line_; }
  /// Both ends are set.
  bool ended() const { return ended_; }
  virtual void lineMoved() {}
  virtual void lineDrawn() = 0;

  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override { follow(at); }
  void finish(const MapPoint& at) override { end(at); }
  void cancel() override;
  void click(const MapPoint& at) override;
  bool stepBack() override;

 private:
  Eigen::Vector2d caught(const MapPoint& at);
  void follow(const MapPoint& at);
  void end(const MapPoint& at);

  WaypointSnapping* snapping_;
  std::optional<Line> line_;
  bool ended_ = false;
  bool begins_ = false;  // the press that is held, or was clicked, set the first end
  placing::SnappedPlace landing_;
};

}  // namespace mapwright::ui
