// Places waypoints along a line, with a preview of the result.
#pragma once

#include <vector>

#include "placing/arrange.h"
#include "ui/waypoints/two_point_tool.h"

namespace mapwright::ui {

class LineTool : public TwoPointTool {
  Q_OBJECT
 public:
  static constexpr double kLeastSpacingM = 0.05, kMostSpacingM = 100;

  using TwoPointTool::TwoPointTool;

  QString name() const override { return QStringLiteral("waypointLine"); }
  void activate() override;
  void deactivate() override;
  void forget() override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  double spacing() const { return spacing_m_; }
  void setSpacing(double spacing_m);
  /// The waypoints for the present line; empty = none, or too many.
  std::vector<placing::Spot> spots() const;
  /// Both ends are set.
  bool ready() const { return line() && ended(); }
  double length() const { return line() ? line()->length() : 0; }

 Q_SIGNALS:
  void activated(bool active);
  void lineChanged();
  void lineEnded();   // by the hand: its second end is set
  void madeWanted();  // Enter

 private:
  void lineMoved() override { Q_EMIT lineChanged(); }
  void lineDrawn() override { Q_EMIT lineEnded(); }

  double spacing_m_ = 1;
};

}  // namespace mapwright::ui
