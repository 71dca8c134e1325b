// What the application of the window counts of its events, by a clock that the test moves.
#include <atomic>
#include <functional>
#include <memory>

#include <QAbstractEventDispatcher>
#include <QEventLoop>
#include <QTest>
#include <QThread>

#include "test_program.h"
#include "ui/window/watched_application.h"

namespace test_watched_application {

using namespace mapwright::ui;
using std::chrono::milliseconds;

namespace {

std::atomic<int> clock_ms = 0;
StallMeter::Time now() { return milliseconds(clock_ms.load()); }
void pass(int ms) { clock_ms += ms; }

}  // namespace

class Receiver : public QObject {
  Q_OBJECT
 public:
  explicit Receiver(std::function<void()> does) : does_(std::move(does)) {}
  bool event(QEvent* event) override {
    if (event->type() != QEvent::User) return QObject::event(event);
    does_();
    return true;
  }
  void post() { QCoreApplication::postEvent(this, new QEvent(QEvent::User)); }

 private:
  std::function<void()> does_;
};

class Mortal : public QObject {
  Q_OBJECT
 public:
  ~Mortal() override { pass(40); }
};

class WatchedApplicationTest : public QObject {
  Q_OBJECT

  int argc_ = 1;
  char name_[8] = "watched";
  char* argv_[2] = {name_, nullptr};
  std::unique_ptr<WatchedApplication> application_;

  /// How many events took less than Stalls::kBelowMs[below], and no less than the one before.
  static quint64 counted(std::size_t below) { return WatchedApplication::stalls()->counts()[below]; }
  /// All but the shortest: Qt's own events take no time here.
  static quint64 longOnes() {
    quint64 all = 0;
    for (std::size_t i = 1; i < Stalls::kBelowMs.size() + 1; ++i) all += counted(i);
    return all;
  }
  static QString longest() { return WatchedApplication::stalls()->duringLongest().text(); }

 private Q_SLOTS:
  void init() { application_ = std::make_unique<WatchedApplication>(argc_, argv_, now); }
  void cleanup() { application_.reset(); }

  void anEventIsCountedWithTheNameOfItsReceiver() {
    Receiver receiver([] {
      pass(40);
      QCoreApplication::quit();
    });
    receiver.post();
    QCoreApplication::exec();
    QCOMPARE(counted(2), 1U);
    QCOMPARE(longOnes(), 1U);
    QCOMPARE(longest(), QStringLiteral("User, test_watched_application::Receiver"));
  }

  void whatAnEventSendsIsPartOfIt() {
    Receiver inner([] { pass(100); });
    Receiver outer([&] {
      pass(20);
      QEvent sent(QEvent::User);
      QCoreApplication::sendEvent(&inner, &sent);
      QCoreApplication::quit();
    });
    outer.post();
    QCoreApplication::exec();
    QCOMPARE(counted(4), 1U);
    QCOMPARE(longOnes(), 1U);
  }

  void aDialogThatWaitsInAnEventIsNoStall() {
    QEventLoop dialog;
    Receiver answer([&] {
      pass(20);
      dialog.quit();
    });
    Receiver click([&] {
      pass(40);
      connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, &dialog, [&] {
        pass(60'000);
        answer.post();
      });
      dialog.exec();
      QAbstractEventDispatcher::instance()->disconnect(&dialog);
      pass(110);
      QCoreApplication::quit();
    });
    click.post();
    QCoreApplication::exec();
    QCOMPARE(counted(2), 1U);  // 40 ms until the dialog was there
    QCOMPARE(counted(1), 1U);  // 20 ms for the answer
    QCOMPARE(counted(4), 1U);  // 110 ms after it
    QCOMPARE(longOnes(), 3U);
    QVERIFY(WatchedApplication::stalls()->longest() == milliseconds(110));
  }

  void whatAnotherThreadDoesIsNoStall() {
    QThread thread;
    Receiver receiver([&] {
      pass(300);
      thread.quit();
    });
    receiver.moveToThread(&thread);
    receiver.post();
    thread.start();
    thread.wait();
    QCOMPARE(longOnes(), 0U);
  }

  void theNameOfAReceiverThatEndsIsKept() {
    (new Mortal)->deleteLater();
    Receiver last([] { QCoreApplication::quit(); });
    last.post();
    QCoreApplication::exec();
    QCOMPARE(counted(2), 1U);
    QCOMPARE(longest(), QStringLiteral("DeferredDelete, test_watched_application::Mortal"));
  }

  void beforeTheLoopNothingIsCounted() {
    Receiver receiver([] { pass(40); });
    receiver.post();
    QCoreApplication::sendPostedEvents();
    QCOMPARE(longOnes(), 0U);
  }
};

}  // namespace test_watched_application

MAPWRIGHT_TEST(test_watched_application, WatchedApplicationTest, Nothing)
#include "test_watched_application.moc"
