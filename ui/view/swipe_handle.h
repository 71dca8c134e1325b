// The handle on the divider between two compared maps.
#pragma once

#include <optional>

#include <QWidget>

namespace mapwright::ui {

/// As high as the map, a few pixels wide; dragging and the arrow keys move the divider.
class SwipeHandle : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kWidthPx = 24;
  explicit SwipeHandle(QWidget* parent);
  /// 0 (left edge of the parent) .. 1.
  void setAt(double fraction);
  double at() const { return at_; }

 Q_SIGNALS:
  void moved(double fraction);
  void escaped();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void moveTo(double fraction);

  double at_ = 0.5;
  std::optional<double> grab_px_;  // from the divider to where it was grabbed
};

}  // namespace mapwright::ui
