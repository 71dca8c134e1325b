// SIGINT and SIGTERM as an event of Qt: a command that is to end cleanly.
#pragma once

#include <memory>

#include <QObject>
#include <QSocketNotifier>

namespace mapwright::app {

/// Holds the signals back for the whole process: before any thread is started.
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
