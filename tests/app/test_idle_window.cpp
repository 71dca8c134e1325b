// A window that stands still costs nothing, whatever it shows: counted are timers, calls from elsewhere,
// jumps and frames.
#include <map>

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "../robot/foxglove_recordings.h"
#include "../robot/ros_recordings.h"
#include "app/robot_factory.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/recorded/recorded_robot.h"
#include "shown_window.h"
#include "simulator/simulator.h"
#include "test_program.h"
#include "ui/replay/replay_controller.h"
#include "ui/shell/replay_clock.h"
#include "ui/view/map_view.h"
#include "ui/view/replay_state.h"
#include "ui/window/main_window.h"

namespace test_idle_window {

using namespace mapwright;
using recordings::Drive;
using recordings::Encoding;

namespace {

constexpr int kWatchedMs = 2'000;

/// What happens on the thread of the window.
class Counter : public QObject {
 public:
  Counter() { QCoreApplication::instance()->installEventFilter(this); }
  bool eventFilter(QObject* receiver, QEvent* event) override {
    QString who = QLatin1String(receiver->metaObject()->className());
    if (const QObject* const owner = receiver->parent())
      who += QStringLiteral(" of ") + QLatin1String(owner->metaObject()->className());
    if (event->type() == QEvent::Timer) add(timers, QStringLiteral("timer of ") + who);
    if (event->type() == QEvent::MetaCall) add(calls, QStringLiteral("call of ") + who);
    if (event->type() == QEvent::UpdateRequest) add(frames, QStringLiteral("frame of ") + who);
    if (event->type() == QEvent::Paint && receiver->isWidgetType()) {
      const bool of_map = qobject_cast<ui::MapView*>(receiver->parent()) != nullptr;
      add(of_map ? map_paints : paints, QStringLiteral("paint of ") + who);
    }
    return false;
  }
  QByteArray words() const {
    QStringList words;
    for (const auto& [who, count] : by_who_) words << QStringLiteral("%1 x %2").arg(count).arg(who);
    return words.join(QStringLiteral(", ")).toUtf8();
  }
  int timers = 0, calls = 0, frames = 0, paints = 0, map_paints = 0;

 private:
  void add(int& count, const QString& who) {
    ++count;
    ++by_who_[who];
  }
  std::map<QString, int> by_who_;
};

/// Plays bags and recordings, too, as the program does.
tl::expected<std::unique_ptr<robot::Robot>, QString> robotOrReplay(const QString& to) {
  const auto parsed = app::knownAddresses().parse(to);
  auto made = app::makeRobot(to, {}, app::DemoTime::Running);
  if (made && parsed && !parsed->path.isEmpty() && robot::recorded::isRecording(parsed->path))
    *made = std::make_unique<replay::ReplayRobot>(std::move(*made), robot::recorded::bagNameOf(parsed->path),
                                                  ui::followedReading());
  return made;
}

class Desk : public test::ShownWindow {
 public:
  Desk() : ShownWindow([](const QString& to, const QByteArray&) { return robotOrReplay(to); }) {
    constexpr int kToastMs = 100;  // they are waited for
    window().findChild<ui::MapOverlay*>()->toasts()->setLifetimeMs(kToastMs);
  }

  QString written(const QString& name, const std::string& bytes) {
    QFile file(filePath(name));
    if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
    file.write(bytes.data(), qint64(bytes.size()));
    return QStringLiteral("file:") + file.fileName();
  }
  replay::ReplayRobot* replay() {
    return session() ? qobject_cast<replay::ReplayRobot*>(&session()->robot()) : nullptr;
  }
  /// All that was on its way is there, and has been drawn.
  bool settles() {
    const auto there = [this] {
      if (!session()) return true;
      if (hasToasts() || session()->robot().connection().phase != robot::ConnectionPhase::Online)
        return false;
      const bool known = !replay() || (replay()->knowledge() == replay::Knowledge::Exact &&
                                       replay()->picturesUnderWay() == 0);
      return known && mapsSettled();
    };
    constexpr int kLongMs = 60'000, kQuietMs = 700;
    if (!QTest::qWaitFor(there, kLongMs)) return false;
    window().view()->setFocus();  // a caret blinks
    // Tiles, toasts and the like come after what they show.
    for (int tries = 0; tries < 40; ++tries) {
      Counter counter;
      QTest::qWait(kQuietMs);
      if (counter.frames == 0 && there()) return true;
    }
    return true;  // whoever watches will see what goes on
  }
};

struct Seen {
  int timers = 0, calls = 0, frames = 0, map_paints = 0, jumps = 0;
  std::size_t bytes = 0;
  QByteArray words;
};

Seen watched(Desk& desk, int for_ms = kWatchedMs) {
  Seen seen;
  QObject here;
  if (auto* const replay = desk.replay())
    QObject::connect(replay, &replay::ReplayRobot::jumped, &here, [&] { ++seen.jumps; });
  const std::size_t before = desk.session() ? desk.session()->counts().bytes_fetched : 0;
  Counter counter;
  QTest::qWait(for_ms);
  seen.timers = counter.timers;
  seen.calls = counter.calls;
  seen.frames = counter.frames;
  seen.map_paints = counter.map_paints;
  seen.words = counter.words();
  if (desk.session()) seen.bytes = desk.session()->counts().bytes_fetched - before;
  return seen;
}

}  // namespace

class IdleWindowTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withNothingConnectedNothingHappens() {
    Desk desk;
    QVERIFY(desk.settles());
    const Seen seen = watched(desk);
    QVERIFY2(seen.timers + seen.calls + seen.frames == 0, seen.words);
  }

  void aMapOnThisComputerCostsNothing() {
    Desk desk;
    std::string picture = "P5\n40 30\n255\n";
    picture.append(40 * 30, char(254));
    desk.written(QStringLiteral("m.pgm"), picture);
    QVERIFY(desk.connectTo(desk.written(QStringLiteral("m.yaml"),
                                        "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                        "occupied_thresh: 0.65\nfree_thresh: 0.196\n")));
    QVERIFY(desk.settles());
    const Seen seen = watched(desk);
    QVERIFY2(seen.timers <= 2 && seen.calls <= 2 && seen.frames <= 2, seen.words);
  }

  void aReplayThatStandsStillCostsNothing_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const char* name, const std::string& bytes) {
      QTest::newRow(name) << QString::fromLatin1(name) << QByteArray::fromStdString(bytes);
    };
    const auto said = Drive{12}.all();
    row("cdr.mcap", recordings::recordingOf(said, Encoding::Cdr));
    row("ros1.mcap", recordings::recordingOf(said, Encoding::Ros1));
    row("json.mcap", recordings::recordingOf(said, Encoding::Json));
    row("ros.bag", recordings::recordingOf(said, Encoding::Bag));
    row("foxglove.mcap", foxglove::drive(true));
    row("axbot.mcap", autoxing());
  }
  void aReplayThatStandsStillCostsNothing() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    Desk desk;
    QVERIFY(desk.connectTo(desk.written(name, bytes.toStdString())));
    QTRY_VERIFY(desk.replay() && desk.replay()->at());
    // At its beginning, and in its middle, where all is known.
    for (const double share : {0.0, 0.5}) {
      const replay::Chunks& chunks = desk.replay()->reading()->chunks();
      if (share > 0) {
        desk.window().findChild<ui::ReplayController*>()->clock().seek(
            chunks.start_s() + share * (chunks.end_s() - chunks.start_s()));
      }
      QVERIFY(desk.settles());
      const Seen seen = watched(desk);
      QCOMPARE(seen.jumps, 0);
      QCOMPARE(seen.bytes, std::size_t(0));
      QVERIFY2(seen.frames <= 2, seen.words);
      // A file may be written while it is played: it is looked at every other second.
      QVERIFY2(seen.timers <= 4 && seen.calls <= 6, seen.words);
    }
  }

  void aRobotThatStandsCostsNothing_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("Autoxing") << 0;
    QTest::newRow("KABAM") << 1;
    QTest::newRow("ROS") << 2;
    QTest::newRow("REP 130") << 3;
  }
  // It says many times a second what it has said before.
  void aRobotThatStandsCostsNothing() {
    QFETCH(int, kind);
    simulator::Options options;
    options.paused = true;
    options.ros.kabam = kind == 1;
    options.ros.dispatcher.there = kind == 3;
    options.ros.dispatcher.edge_m = 50;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    Desk desk;
    const std::string address = kind == 0   ? robot.address()
                                : kind == 1 ? robot.kabamAddress()
                                : kind == 2 ? robot.rosAddress()
                                            : robot.rep130Address();
    QVERIFY(desk.connectTo(QString::fromStdString(address)));
    QTRY_VERIFY_WITH_TIMEOUT(desk.session() && desk.session()->live().robot_pose, 60'000);
    QVERIFY(desk.settles());
    constexpr int kSeconds = 3;
    const Seen seen = watched(desk, kSeconds * 1000);
    QVERIFY(seen.calls > 0);  // it does speak
    QVERIFY2(seen.map_paints == 0, seen.words);
    QVERIFY2(seen.frames <= kSeconds, seen.words);  // ages are told
    QVERIFY2(seen.timers <= kSeconds, seen.words);
  }

 private:
  static std::string autoxing() {
    const auto bytes = std::make_shared<std::string>();
    const auto writer = recordings::writerInto(bytes);
    for (int i = 0; i < 200; ++i) {
      recording::Channel channel;
      channel.topic = i % 4 ? "/tracked_pose" : "/alerts";
      channel.message_encoding = "json";
      const std::string text =
          i % 4 ? R"({"topic":"/tracked_pose","pos":[)" + std::to_string(i) + R"(,2],"ori":0.5})"
                : R"({"topic":"/alerts","alerts":[]})";
      const std::int64_t at_ns = 1'717'405'200'000'000'000 + std::int64_t(i) * 50'000'000;
      writer->write(*writer->addChannel(channel), {at_ns, at_ns, 0}, recordings::bytesOf(text));
    }
    writer->close();
    return *bytes;
  }
};

}  // namespace test_idle_window

MAPWRIGHT_TEST(test_idle_window, IdleWindowTest, Widgets)
#include "test_idle_window.moc"
