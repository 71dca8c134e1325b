// The simulated ROS robot as the public client of rosbridge (npm: roslib) sees it.
#include <QProcess>
#include <QTest>

#include "simulator/simulator.h"
#include "test_program.h"

namespace test_roslib {

using namespace mapwright;

class RoslibTest : public QObject {
  Q_OBJECT

  struct Ended {
    int code = -1;
    QString words;
  };
  static Ended run(const QString& program, const QStringList& words) {
    QProcess process;
    process.start(program, words);
    if (!process.waitForFinished(300'000)) return {-1, process.errorString()};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardError()).trimmed()};
  }

 private Q_SLOTS:
  void initTestCase() {
    constexpr int kAbsent = 77;
    const Ended installed = run(QStringLiteral(ROSLIB_SOURCES "/install"), {QStringLiteral(ROSLIB_MODULES)});
    if (installed.code == kAbsent) QSKIP(qPrintable(installed.words));
    QVERIFY2(installed.code == 0, qPrintable(installed.words));
  }

  void thePublicClientWorksWithTheSimulatedRobot_data() {
    QTest::addColumn<bool>("ros2");
    QTest::newRow("ROS 1") << false;
    QTest::newRow("ROS 2") << true;
  }
  void thePublicClientWorksWithTheSimulatedRobot() {
    QFETCH(bool, ros2);
    simulator::Options options;
    options.ros.dialect = ros2 ? simulator::RosDialect::Ros2 : simulator::RosDialect::Ros1;
    simulator::Simulator robot(options);
    const auto unavailable_reason = robot.start();
    QVERIFY2(!unavailable_reason, unavailable_reason.value_or(std::string()).c_str());
    const Ended ended = run(QStringLiteral("node"), {QStringLiteral(ROSLIB_SOURCES "/against_simulator.mjs"),
                                                     QStringLiteral("ws://127.0.0.1:%1").arg(robot.rosPort()),
                                                     ros2 ? QStringLiteral("ros2") : QStringLiteral("ros1"),
                                                     QStringLiteral(ROSLIB_MODULES)});
    QVERIFY2(ended.code == 0, qPrintable(ended.words));
  }
};

}  // namespace test_roslib

MAPWRIGHT_TEST(test_roslib, RoslibTest, Core)
#include "test_roslib.moc"
