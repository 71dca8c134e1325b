// SIGINT and SIGTERM as a Qt event, for commands that should end cleanly.
#pragma once

#include <memory>

#include <QObject>
#include <QSocketNotifier>

namespace mapwright::app {

/// Blocks the signals for the whole process; call it before any thread starts.
void holdStopSignals();

class StopSignals : public QObject {
  Q_OBJECT
 public:
  /// After holdStopSignals(), with an application.
  StopSignals();
  ~StopSignals() override;

 Q_SIGNALS:
  void came();

 private:
  int fd_;
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace mapwright::app
