// Two pictures of the same place over each other, with a divider between them.
#pragma once

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include "ui/view/swipe_handle.h"

namespace mapwright::ui {

/// One is seen left of the divider, the other one right of it. The divider is dragged, or moved by Left,
/// Right, Home and End. Pictures of different sizes share their upper left corners. They are made smaller to
/// fit, never larger.
class PictureSwipe : public QWidget {
  Q_OBJECT
 public:
  PictureSwipe(QImage left, QImage right, const QString& left_name, const QString& right_name,
               QWidget* parent);
  SwipeHandle& handle() { return handle_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QSize canvas() const { return left_.size().expandedTo(right_.size()); }
  void paintHalf(QPainter& painter, const QRect& half, const QPixmap& picture, const QString& name,
                 Qt::Alignment side) const;

  QImage left_, right_;
  QString left_name_, right_name_;
  QWidget sheet_;  // as large as the pictures are shown; the divider's parent
  SwipeHandle handle_;
  QPixmap left_shown_, right_shown_;  // of the present size
};

}  // namespace mapwright::ui
