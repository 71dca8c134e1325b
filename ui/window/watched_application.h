// The application of the window, which measures how long each of its events takes.
#pragma once

#include <QApplication>

#include "ui/window/stalls.h"

namespace mapwright::ui {

class WatchedApplication : public QApplication {
 public:
  WatchedApplication(int& argc, char** argv);
  bool notify(QObject* receiver, QEvent* event) override;
  /// nullptr where the application is another one.
  static const Stalls* stalls();

 private:
  StallMeter meter_;
};

}  // namespace mapwright::ui
