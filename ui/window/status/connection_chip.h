// The robot and its link, always visible at the left of the tool bar; opens the menu of robots.
#pragma once

#include <QToolButton>

#include "window/status/status_text.h"

namespace mapwright::window {

class ConnectionChip : public QToolButton {
  Q_OBJECT
 public:
  explicit ConnectionChip(QWidget* parent = nullptr);
  /// `name` may come from a robot: plain text. `detail` is for the tooltip.
  void setRobot(const QString& name, Mark mark, const QString& word, const QString& detail);
  QString name() const { return name_; }
  QString word() const { return word_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString name_, word_;
  Mark mark_ = Mark::Neutral;
};

}  // namespace mapwright::window
