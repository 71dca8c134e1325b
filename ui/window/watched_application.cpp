#include "ui/window/watched_application.h"

#include <chrono>

#include <QAbstractEventDispatcher>
#include <QThread>

namespace mapwright::ui {
namespace {

StallMeter::Time sinceStart() { return std::chrono::steady_clock::now().time_since_epoch(); }

}  // namespace

WatchedApplication::WatchedApplication(int& argc, char** argv) : QApplication(argc, argv) {
  const QAbstractEventDispatcher* const loop = eventDispatcher();
  connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] { meter_.waits(sinceStart()); });
  connect(loop, &QAbstractEventDispatcher::awake, this, [this] { meter_.wakes(sinceStart()); });
}

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  const QThread* const here = QThread::currentThread();
  if (here != thread()) return QApplication::notify(receiver, event);
  // Asked before: the event may end the receiver.
  const Busy busy{receiver->metaObject()->className(), int(event->type())};
  if (!meter_.begins(here->loopLevel(), sinceStart(), busy)) return QApplication::notify(receiver, event);
  const bool handled = QApplication::notify(receiver, event);
  meter_.ends(sinceStart());
  return handled;
}

const Stalls* WatchedApplication::stalls() {
  const auto* const watched = dynamic_cast<const WatchedApplication*>(QCoreApplication::instance());
  return watched ? &watched->meter_.stalls() : nullptr;
}

}  // namespace mapwright::ui
