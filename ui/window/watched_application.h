// The application of the window, which measures how long each of its events takes.
#pragma once

#include <QApplication>

#include "ui/window/stalls.h"

namespace mapwright::ui {

class WatchedApplication : public QApplication {
 public:
  using Clock = StallMeter::Time (*)();
  static StallMeter::Time sinceStart();
  WatchedApplication(int& argc, char** argv, Clock now = sinceStart);
  bool notify(QObject* receiver, QEvent* event) override;
  /// nullptr where the application is another one.
  static const Stalls* stalls();

 private:
  const Clock now_;
  StallMeter meter_;
};

}  // namespace mapwright::ui
