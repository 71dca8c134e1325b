// The robot and its connection, always visible at the left of the tool bar; opens the menu of robots.
#pragma once

#include <QColor>
#include <QToolButton>

#include "ui/kit/safety_badge.h"
#include "ui/kit/status_text.h"

namespace mapwright::ui {

class ConnectionChip : public QToolButton {
  Q_OBJECT
 public:
  explicit ConnectionChip(QWidget* parent = nullptr);
  /// `name` may come from a robot: plain text. `detail` is for the tooltip.
  void setRobot(const QString& name, Mark mark, const QString& word, const QString& detail);
  /// The one that the user gave it, beside the name; invalid = none.
  void setColor(const QColor& color);
  QColor color() const { return color_; }
  /// Shown next to the name while it lasts; `text` with Mark::None shows nothing.
  void setSafety(const SafetyText& text);
  const SafetyText& safety() const { return safety_; }
  QString name() const { return name_; }
  QString word() const { return word_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();
  int colorRoom() const;

  QString name_, word_, detail_;
  SafetyText safety_;
  Mark mark_ = Mark::Neutral;
  QColor color_;
};

}  // namespace mapwright::ui
