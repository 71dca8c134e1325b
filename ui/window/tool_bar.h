// The tool bar: the tools of the present role, with texts beside icons where there is room.
#pragma once

#include <QList>
#include <QStringList>
#include <QToolBar>

#include "ui/window/layouts.h"

namespace mapwright::ui {

class Actions;

class ToolBar : public QToolBar {
  Q_OBJECT
 public:
  ToolBar(const Actions& actions, QWidget* parent);
  void showRole(Role role);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void giveTexts();

  QList<QAction*> all_;  // with lines and widgets, in their order
  QStringList with_text_;
};

}  // namespace mapwright::ui
