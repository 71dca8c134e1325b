// A field for typing a name, on the map next to its object.
#pragma once

#include <functional>

#include <QLineEdit>

namespace mapwright::window {

class NameEditor : public QLineEdit {
  Q_OBJECT
 public:
  explicit NameEditor(QWidget* map);
  /// Offers `name` for editing beside `at` (viewport pixels). What is typed goes to `then` while it is typed,
  /// and with Enter or when the focus goes elsewhere; after Esc, and where nothing is left, it gets `name`.
  void ask(const QPointF& at, const QString& name, std::function<void(const QString&)> then);
  /// Its object has moved; typing continues.
  void follow(const QPointF& at);
  /// Applies the text typed so far.
  void finish();

 Q_SIGNALS:
  void closed();  // by a key: nothing has the focus

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void close(bool take);
  std::function<void(const QString&)> then_;
  QString offered_;
};

}  // namespace mapwright::window
