// Short messages about what succeeded (or did not), in the corner of the map; they go by themselves.
#pragma once

#include <functional>

#include <QFrame>
#include <QString>
#include <QWidget>

#include "window/status/status_text.h"

class QVBoxLayout;

namespace mapwright::window {

/// What can be done about it; empty words = nothing.
struct ToastOffer {
  QString words = {};
  std::function<void()> take = {};
};

class ToastStack : public QWidget {
  Q_OBJECT
 public:
  explicit ToastStack(QWidget* parent = nullptr);
  /// Plain text; one that is there already is counted. Good ones go after `lifetime_ms`, warnings, errors and
  /// those with an offer after three times that, or by a click.
  void add(Mark mark, const QString& text, ToastOffer offer = {});
  void setLifetimeMs(int ms) { lifetime_ms_ = ms; }
  /// What is shown at present, oldest first.
  QStringList texts() const;

 Q_SIGNALS:
  void changed();  // place me anew

 private:
  QVBoxLayout* column_;
  int lifetime_ms_ = 4'000;
};

}  // namespace mapwright::window
