// Draws a line on the map along which a cloud is cut.
#pragma once

#include <optional>

#include "scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

/// Drag from one end to the other. Esc removes the line, a second Esc leaves the tool.
class SectionTool : public MapTool {
  Q_OBJECT
 public:
  struct Line {
    Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
  };
  explicit SectionTool(const scene::MapScene* scene, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("cloudSection"); }
  void deactivate() override;
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  /// Of the strip drawn around the line.
  void setWidth(double metres);
  void forget();
  const std::optional<Line>& line() const { return line_; }
  /// The position on the line under the cursor elsewhere, metres from its start.
  void setMark(std::optional<double> along_m);

 Q_SIGNALS:
  void lineDrawn(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
  void lineGone();

 private:
  const scene::MapScene* scene_;
  std::optional<Line> line_, before_;  // before_: the line replaced by an unfinished drag
  std::optional<double> mark_;
  double width_m_ = 0.5;
};

}  // namespace mapwright::window
