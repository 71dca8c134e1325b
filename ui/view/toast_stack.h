// Short messages about results in the corner of the map; they disappear by themselves.
#pragma once

#include <functional>

#include <QFrame>
#include <QString>
#include <QWidget>

#include "ui/kit/status_text.h"

class QVBoxLayout;

namespace mapwright::ui {

/// An action for it; empty text = none.
struct ToastOffer {
  QString words = {};
  std::function<void()> accept = {};
};

class ToastStack : public QWidget {
  Q_OBJECT
 public:
  explicit ToastStack(QWidget* parent = nullptr);
  /// Plain text; repeated ones are counted. Good ones disappear after `lifetime_ms`, warnings, errors and
  /// those with an action after three times that, or on a click. `about`: the deed whose result it is; it
  /// takes the place of earlier results of that.
  void add(Mark mark, const QString& text, ToastOffer offer = {}, const QString& about = {});
  /// Takes it away before its time, if it is still there.
  void withdraw(const QString& text);
  void setLifetimeMs(int ms) { lifetime_ms_ = ms; }
  /// The present messages, oldest first.
  QStringList texts() const;

 Q_SIGNALS:
  void changed();  // lay me out anew

 private:
  QVBoxLayout* column_;
  int lifetime_ms_ = 4'000;
};

}  // namespace mapwright::ui
