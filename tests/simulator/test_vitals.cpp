// How the simulated robot is: battery, wheels and alerts agree with each other, and do as they are told.
#include <QSet>

#include "listening.h"
#include "test_program.h"

namespace test_vitals {

using mapwright::simulator::Options;

namespace {

QSet<int> codesOf(const QJsonObject& alerts) {
  QSet<int> codes;
  for (const QJsonValue& alert : alerts[QLatin1String("alerts")].toArray())
    codes << alert[QLatin1String("code")].toInt();
  return codes;
}

}  // namespace

class TestVitals : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theBatteryIsCalledLowWhenItIsLow() {
    int low = 0, charging = 0;
    for (int minute = 0; minute < 60; minute += 2) {
      Options options;
      options.paused = true;
      options.start_at_s = 60 * minute + 12;
      Listening robot(options);
      const QJsonObject battery = robot.of("/battery_state");
      const double level = battery[QLatin1String("percentage")].toDouble();
      const bool charges = battery[QLatin1String("power_supply_status")] == QLatin1String("charging");
      QVERIFY(level > 0 && level < 1);
      QCOMPARE(charges, battery[QLatin1String("current")].toDouble() < 0);
      QCOMPARE(codesOf(robot.of("/alerts")).contains(8501), level < 0.2 && !charges);
      low += level < 0.2 ? 1 : 0;
      charging += charges ? 1 : 0;
    }
    QVERIFY(low > 0 && charging > 0);  // the hour has all of it
  }

  void theWheelsDoAsTheyAreTold() {
    Options options;
    options.paused = true;
    Listening robot(options);
    QCOMPARE(robot.of("/wheel_state")[QLatin1String("control_mode")].toString(), QStringLiteral("auto"));
    QVERIFY(!robot.of("/wheel_state")[QLatin1String("emergency_stop_pressed")].toBool(true));
    const std::string services = "/services/wheel_control/";
    QCOMPARE(robot.send("POST", services + "set_control_mode", R"({"control_mode":"manual"})").status, 200);
    QCOMPARE(robot.send("POST", services + "set_emergency_stop", R"({"enable":true})").status, 200);
    QTRY_VERIFY(robot.last("/wheel_state")[QLatin1String("emergency_stop_pressed")].toBool());
    QCOMPARE(robot.last("/wheel_state")[QLatin1String("control_mode")].toString(), QStringLiteral("manual"));
    QCOMPARE(robot.send("POST", services + "set_emergency_stop", R"({"enable":false})").status, 200);
    QTRY_VERIFY(!robot.last("/wheel_state")[QLatin1String("emergency_stop_pressed")].toBool(true));
  }

  void posesComeTenTimesASecondAsRobotsSendThem() { QCOMPARE(Options().pose_hz, 10.0); }
};

}  // namespace test_vitals

MAPWRIGHT_TEST(test_vitals, TestVitals, Core)
#include "test_vitals.moc"
