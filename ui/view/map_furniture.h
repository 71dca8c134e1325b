// The buttons on top of the map: zoom, fit and the north arrow.
#pragma once

#include <QAbstractButton>
#include <QFrame>

class QAction;
class QToolButton;

namespace mapwright::window {

/// A needle that points to the map's north (world +y) and rotates with the view; a click rotates the view
/// north up.
class NorthArrow : public QAbstractButton {
  Q_OBJECT
 public:
  explicit NorthArrow(QWidget* parent = nullptr);
  /// The view's rotation: counter-clockwise, radians.
  void setRotation(double rad);
  double rotation() const { return rotation_; }
  QSize sizeHint() const override { return {32, 32}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  double rotation_ = 0;
};

class MapFurniture : public QFrame {
  Q_OBJECT
 public:
  MapFurniture(QAction* zoom_in, QAction* zoom_out, QAction* fit, QAction* north_up,
               QWidget* parent = nullptr);
  void setRotation(double rad) { north_->setRotation(rad); }
  NorthArrow* north() const { return north_; }

 private:
  NorthArrow* north_;
};

}  // namespace mapwright::window
