// A field on the map for the name of a waypoint. What is typed while it is open goes there and nowhere else:
// letters are commands of the window, so only the user's own hand takes the focus away.
#pragma once

#include <functional>

#include <QLineEdit>

namespace mapwright::ui {

class NameEditor : public QLineEdit {
  Q_OBJECT
 public:
  explicit NameEditor(QWidget* map);
  /// Offers `name` for editing beside `at` (viewport pixels). What is typed goes to `then` while it is typed,
  /// and with Enter or when the user goes elsewhere; after Esc, and where nothing is left, it gets `name`.
  void ask(const QPointF& at, const QString& name, std::function<void(const QString&)> then);
  /// Its object has moved; typing continues.
  void follow(const QPointF& at);
  /// Applies the text typed so far.
  void finish();
  /// Its object is gone, not by the user: nothing is renamed any more, but whoever is typing goes on typing
  /// here, until a key or a click ends it.
  void loseObject();
  bool isOpen() const { return bool(then_); }

 Q_SIGNALS:
  void closed();  // by a key: nothing has the focus

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void customEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  struct Marked {
    int from = -1, count = 0, cursor = 0;
  };
  void close(bool keep);
  void focusAgain();
  void rememberFocus();
  bool isOnObject(const QPointF& viewport_px) const;

  std::function<void(const QString&)> then_;
  QString offered_;
  QPointF object_px_;
  Marked marked_;               // before the focus went
  bool by_hand_ = false;        // the user's key or click is being handled
  bool pressed_away_ = false;   // by a press that has not arrived yet
  bool back_after_it_ = false;  // that press was on its own waypoint
};

}  // namespace mapwright::ui
