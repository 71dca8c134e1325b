#include <QTest>

#include "app/robot_factory.h"
#include "test_program.h"

namespace test_demo_query {

using namespace mapwright::app;

class DemoQueryTest : public QObject {
  Q_OBJECT
 private:
  static auto parse(const char* query, DemoTime time = DemoTime::Running) {
    return parseDemoQuery(QUrlQuery(QString::fromLatin1(query)), time);
  }

 private Q_SLOTS:
  void aFrozenDemoIsTheSameOnEveryRun() {
    const auto options = parse("", DemoTime::Frozen);
    QVERIFY(options->paused && options->start_at_s > 0);
    QVERIFY(!parse("")->paused);
  }
  void itsOptionsAreTakenOver() {
    const auto options = parse("scene=warehouse&submaps=500&seed=3&at=12.5");
    QCOMPARE(options->scene, std::string("warehouse"));
    QCOMPARE(options->submaps, 500);
    QCOMPARE(options->seed, 3u);
    QCOMPARE(options->start_at_s, 12.5);
  }
  void unknownScenesAndOptionsAreNamed() {
    QVERIFY(parse("scene=moon").error().contains(QStringLiteral("moon")));
    QVERIFY(parse("color=red").error().contains(QStringLiteral("color")));
    QVERIFY(!parse("submaps=-1"));
    QVERIFY(!parse("submaps=many"));
    QVERIFY(!parse("at=nan"));
  }
};

}  // namespace test_demo_query

MAPWRIGHT_TEST(test_demo_query, DemoQueryTest, Core)
#include "test_demo_query.moc"
