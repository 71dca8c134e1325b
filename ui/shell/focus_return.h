// Where the keyboard focus goes when the widget that had it is hidden, disabled or deleted: to the map. Qt gives it
// to the next widget in line, often a search field, where the keys of tools would be typed then.
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace mapwright::window {

class FocusReturn : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this. Widgets in other windows, such as dialogs, keep their own order.
  FocusReturn(QWidget& window, QWidget& map, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void onFocusChanged(QWidget* before, QWidget* now);

  QWidget &window_, &map_;
  QPointer<QWidget> had_it_;  // in the window, when it became inactive
  bool some_had_it_ = false;
};

}  // namespace mapwright::window
