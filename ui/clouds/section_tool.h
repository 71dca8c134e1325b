// Draws a line on the map along which a cloud is cut.
#pragma once

#include <optional>

#include "ui/view/drag_tool.h"

namespace mapwright::ui {

/// Drag from one end to the other. Esc removes the line, the next one leaves the tool.
class SectionTool : public DragTool {
  Q_OBJECT
 public:
  struct Line {
    Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
  };
  using DragTool::DragTool;

  QString name() const override { return QStringLiteral("cloudSection"); }
  void deactivate() override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  /// Of the strip drawn around the line.
  void setWidth(double metres);
  void forget();
  /// The one that is drawn, or else the last one.
  std::optional<Line> line() const;
  /// The position on the line under the cursor elsewhere, metres from its start.
  void setMark(std::optional<double> along_m);

 Q_SIGNALS:
  void lineDrawn(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
  void lineGone();

 private:
  void finish(const MapPoint& at) override;
  bool stepBack() override;

  std::optional<Line> line_;
  std::optional<double> mark_;
  double width_m_ = 0.5;
};

}  // namespace mapwright::ui
