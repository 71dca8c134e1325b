#include "app/stop_signals.h"

#include <csignal>
#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace mapwright::app {
namespace {

sigset_t stopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

void holdStopSignals() {
  const sigset_t signals = stopSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

StopSignals::StopSignals() {
  const sigset_t signals = stopSignals();
  fd_ = ::signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
  if (fd_ < 0) {
    // Otherwise they end the program as usual: the file then ends with the last chunk.
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    return;
  }
  notifier_ = std::make_unique<QSocketNotifier>(fd_, QSocketNotifier::Read);
  connect(notifier_.get(), &QSocketNotifier::activated, this, [this] {
    signalfd_siginfo info{};
    while (::read(fd_, &info, sizeof info) == ssize_t(sizeof info)) {
    }
    Q_EMIT came();
  });
}

StopSignals::~StopSignals() {
  notifier_.reset();
  if (fd_ >= 0) ::close(fd_);
}

}  // namespace mapwright::app

#include "moc_stop_signals.cpp"
