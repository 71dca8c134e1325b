// Where the keyboard focus goes when the widget that had it is disabled or deleted: to the map. Qt
// gives it to the next widget in line, often a search field, where the keys of tools would be typed then.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace mapwright::ui {

class FocusReturn : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this, but for while the window is destroyed. Widgets in other windows, such as
  /// dialogs, keep their own order.
  FocusReturn(QWidget& window, QWidget& map, QObject* parent);

 private:
  void onFocusChanged(QWidget* now);

  QWidget& window_;
  QPointer<QWidget> map_;     // it may go first
  QPointer<QWidget> had_it_;  // of the window's own widgets, the last one
  bool some_had_it_ = false;
};

}  // namespace mapwright::ui
