// A tree view that tells when Enter is pressed on a row and leaves single letters to the shortcuts of the
// map.
#pragma once

#include <QKeyEvent>
#include <QTreeView>

namespace mapwright::window {

class TreeView : public QTreeView {
  Q_OBJECT
 public:
  using QTreeView::QTreeView;

 Q_SIGNALS:
  void enterPressed();

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
      Q_EMIT enterPressed();
      event->accept();
      return;
    }
    QTreeView::keyPressEvent(event);
  }
  // Jumping to a row by typing is what the filter field is for.
  void keyboardSearch(const QString&) override {}
};

}  // namespace mapwright::window
