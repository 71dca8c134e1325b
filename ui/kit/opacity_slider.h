// A slider as high as a row, showing its percentage.
#pragma once

#include <QSlider>

namespace mapwright::window {

class OpacitySlider : public QSlider {
  Q_OBJECT
 public:
  explicit OpacitySlider(QWidget* parent = nullptr);
  QSize sizeHint() const override { return {46, 18}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void follow(const QPointF& at);
};

}  // namespace mapwright::window
