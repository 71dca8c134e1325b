// A range slider for heights, over a histogram of the points.
#pragma once

#include <optional>

#include <QWidget>

#include "clouds/heights.h"

namespace mapwright::ui {

/// Heights increase from left to right. The keys move one handle: Left and Right by a hundredth of the width,
/// with Shift a tenth, Home and End to the limit; Up and Down select the upper or the lower handle. Double
/// click: all.
class HeightSlider : public QWidget {
  Q_OBJECT
 public:
  explicit HeightSlider(QWidget* parent = nullptr);

  void setHeights(const clouds::Heights& heights);
  /// nullopt = all.
  void setRange(std::optional<clouds::HeightRange> range);
  const std::optional<clouds::HeightRange>& range() const { return range_; }
  /// The position of a height, pixels from the left.
  double xOf(double z_m) const;

  QSize sizeHint() const override { return {220, 72}; }
  QSize minimumSizeHint() const override { return {120, 60}; }

 Q_SIGNALS:
  void rangeChosen(std::optional<mapwright::clouds::HeightRange> range);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Handle { None, Low, High };
  bool usable() const { return heights_.points > 0 && heights_.usual_high_m > heights_.usual_low_m; }
  clouds::HeightRange shown() const;
  double zAt(double x) const;
  void moveHandle(Handle handle, double z_m);
  void updateAccessibleText();

  clouds::Heights heights_;
  std::optional<clouds::HeightRange> range_;
  Handle active_ = Handle::Low, dragged_ = Handle::None;
};

}  // namespace mapwright::ui
