// The robot and its connection, always visible at the left of the tool bar; opens the menu of robots.
#pragma once

#include <QToolButton>

#include "ui/kit/safety_badge.h"
#include "ui/kit/status_text.h"

namespace mapwright::window {

class ConnectionChip : public QToolButton {
  Q_OBJECT
 public:
  explicit ConnectionChip(QWidget* parent = nullptr);
  /// `name` may come from a robot: plain text. `detail` is for the tooltip.
  void setRobot(const QString& name, Mark mark, const QString& word, const QString& detail);
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

  QString name_, word_, detail_;
  SafetyText safety_;
  Mark mark_ = Mark::Neutral;
};

}  // namespace mapwright::window
