#include "ui/window/watched_application.h"

#include <chrono>

#include <QAbstractEventDispatcher>
#include <QThread>

namespace mapwright::ui {

StallMeter::Time WatchedApplication::sinceStart() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

WatchedApplication::WatchedApplication(int& argc, char** argv, Clock now)
    : QApplication(argc, argv), now_(now) {
  const QAbstractEventDispatcher* const loop = eventDispatcher();
  connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] { meter_.waits(now_()); });
  connect(loop, &QAbstractEventDispatcher::awake, this, [this] { meter_.wakes(now_()); });
}

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  const QThread* const here = QThread::currentThread();
  if (here != thread()) return QApplication::notify(receiver, event);
  // Asked before: the event may end the receiver.
  const Busy busy{receiver->metaObject()->className(), int(event->type())};
  if (!meter_.begins(here->loopLevel(), now_(), busy)) return QApplication::notify(receiver, event);
  const bool handled = QApplication::notify(receiver, event);
  meter_.ends(now_());
  return handled;
}

const Stalls* WatchedApplication::stalls() {
  const auto* const watched = dynamic_cast<const WatchedApplication*>(QCoreApplication::instance());
  return watched ? &watched->meter_.stalls() : nullptr;
}

}  // namespace mapwright::ui
