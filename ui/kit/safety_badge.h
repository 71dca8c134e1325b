// A small badge for safety conditions: a shape, a colour and text.
#pragma once

#include <QAbstractButton>

#include "ui/kit/safety_text.h"
#include "ui/kit/ui_colors.h"

class QPainter;

namespace mapwright::window {

/// The preferred width of paintSafety(); 0 if there is nothing to say.
int safetyWidth(const SafetyText& text, const QFont& font);
/// Text that does not fit is elided; shape and colour always stay.
void paintSafety(QPainter* painter, const QRect& rect, const SafetyText& text, const UiColors& colors);

/// The badge in the status bar. Hidden if there is nothing to say.
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
