// What is dangerous or wrong with the robot, as a small field of its own: a shape, a colour and words.
#pragma once

#include <QAbstractButton>

#include "window/look/ui_colors.h"
#include "window/status/safety_text.h"

class QPainter;

namespace mapwright::window {

/// How wide paintSafety() wants to be, height aside; 0 when there is nothing to say.
int safetyWidth(const SafetyText& text, const QFont& font);
/// Words that do not fit are elided; shape and colour always stay.
void paintSafety(QPainter* painter, const QRect& rect, const SafetyText& text, const UiColors& colors);

/// The field in the status bar. Hidden while there is nothing to say.
class SafetyBadge : public QAbstractButton {
  Q_OBJECT
 public:
  explicit SafetyBadge(QWidget* parent = nullptr);
  void setSafety(const SafetyText& text);
  const SafetyText& safety() const { return text_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  SafetyText text_;
};

}  // namespace mapwright::window
