// races (real | none): ThreadSanitizer with qt_order.cpp reports what two threads do at once, and nothing
// where Qt orders it.
#include <cstring>
#include <thread>

#include <QtCore/QtCore>

namespace {

int alone = 0;  // what the reports are about

void race() {
  std::thread other([] { ++alone; });
  ++alone;
  other.join();
}

void queuedCall() {
  QObject here;
  QEventLoop loop;
  int shared = 0;
  std::thread other([&] {
    shared = 5;
    QMetaObject::invokeMethod(
        &here,
        [&] {
          ++shared;
          loop.quit();
        },
        Qt::QueuedConnection);
  });
  loop.exec();
  other.join();
}

void pool() {
  QThreadPool pool;
  int shared = 0;
  pool.start([&] { ++shared; });
  pool.waitForDone();
  ++shared;
}

void thread() {
  QThread thread;
  thread.start();
  auto* const there = new QObject;
  there->moveToThread(&thread);
  QObject::connect(&thread, &QThread::finished, there, &QObject::deleteLater);
  int shared = 0;
  QMetaObject::invokeMethod(
      there, [&] { ++shared; }, Qt::BlockingQueuedConnection);
  ++shared;
  QMetaObject::invokeMethod(
      there, [&] { ++shared; }, Qt::QueuedConnection);
  thread.quit();
  thread.wait();
  ++shared;
}

}  // namespace

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc > 1 && std::strcmp(argv[1], "real") == 0) {
    race();
  } else {
    queuedCall();
    pool();
    thread();
  }
  std::printf("The end.\n");
}
