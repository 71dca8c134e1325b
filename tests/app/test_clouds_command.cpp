// `clouds export`: what is asked for, and what is refused before anybody is asked.
#include <QtTest>

#include "app/clouds.h"
#include "program.h"
#include "test_program.h"

namespace test_clouds_command {

using namespace mapwright;
using Outcome = tests::Ended;

namespace {

app::CloudsArguments words(const std::string& box, const std::string& sphere = {}, bool all = false) {
  app::CloudsArguments made;
  made.box = box;
  made.sphere = sphere;
  made.all = all;
  return made;
}

}  // namespace

class CloudsCommandTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  Outcome run(const QStringList& arguments) const { return program_.run(arguments); }

 private Q_SLOTS:
  void aRegionIsABoxOrASphereOrAllOfIt() {
    const auto box = app::cloudRegionFrom(words("1,2,3,4,5,6"));
    QVERIFY(box && *box);
    QCOMPARE((*box)->centre_m, Eigen::Vector3d(1, 2, 3));
    QCOMPARE((*box)->size_m, Eigen::Vector3d(4, 5, 6));
    QCOMPARE((*box)->radius_m, 0.0);
    const auto sphere = app::cloudRegionFrom(words({}, "-1.5, 2,0,7"));
    QVERIFY(sphere && *sphere);
    QCOMPARE((*sphere)->centre_m, Eigen::Vector3d(-1.5, 2, 0));
    QCOMPARE((*sphere)->radius_m, 7.0);
    const auto all = app::cloudRegionFrom(words({}, {}, true));
    QVERIFY(all && !*all);
  }

  void whatIsNoRegionIsRefusedInASentence_data() {
    QTest::addColumn<QString>("box");
    QTest::addColumn<QString>("sphere");
    QTest::addColumn<bool>("all");
    QTest::newRow("nothing") << QString() << QString() << false;
    QTest::newRow("two") << QStringLiteral("0,0,0,1,1,1") << QStringLiteral("0,0,0,1") << false;
    QTest::newRow("all and a box") << QStringLiteral("0,0,0,1,1,1") << QString() << true;
    QTest::newRow("too few") << QStringLiteral("0,0,0,1,1") << QString() << false;
    QTest::newRow("no width") << QStringLiteral("0,0,0,1,0,1") << QString() << false;
    QTest::newRow("less than none") << QStringLiteral("0,0,0,1,1,-1") << QString() << false;
    QTest::newRow("no number") << QStringLiteral("0,0,x,1,1,1") << QString() << false;
    QTest::newRow("nan") << QStringLiteral("nan,0,0,1,1,1") << QString() << false;
    QTest::newRow("huge") << QStringLiteral("1e300,0,0,1,1,1") << QString() << false;
    QTest::newRow("a radius of nothing") << QString() << QStringLiteral("0,0,0,0") << false;
    QTest::newRow("a radius below") << QString() << QStringLiteral("0,0,0,-2") << false;
  }
  void whatIsNoRegionIsRefusedInASentence() {
    QFETCH(QString, box);
    QFETCH(QString, sphere);
    QFETCH(bool, all);
    const auto region = app::cloudRegionFrom(words(box.toStdString(), sphere.toStdString(), all));
    QVERIFY(!region);
    QVERIFY(region.error().endsWith(QLatin1Char('.')));
  }

  void filesOfOtherKindsAndThoseThatAreThereAreRefused() {
    const QStringList export_all{QStringLiteral("clouds"),  QStringLiteral("export"),
                                 QStringLiteral("--robot"), QStringLiteral("demo:"),
                                 QStringLiteral("--all"),   QStringLiteral("-o")};
    const Outcome odd = run(export_all + QStringList{QStringLiteral("a.las")});
    QCOMPARE(odd.code, 2);
    QVERIFY(odd.err.contains(QStringLiteral(".pcd, .ply or .csv")));
    QFile there(program_.path("there.ply"));
    QVERIFY(there.open(QIODevice::WriteOnly));
    there.close();
    const Outcome kept = run(export_all + QStringList{there.fileName()});
    QCOMPARE(kept.code, 2);
    QVERIFY(kept.err.contains(QStringLiteral("--force")));
    QCOMPARE(run(export_all + QStringList{QStringLiteral("a.ply"), QStringLiteral("--ascii")}).code, 2);
  }

  void aRobotWithoutADispatcherSaysSo() {
    const Outcome outcome = run({QStringLiteral("clouds"), QStringLiteral("export"),
                                 QStringLiteral("--robot"), QStringLiteral("demo:"), QStringLiteral("--all"),
                                 QStringLiteral("-o"), QStringLiteral("a.pcd")});
    QCOMPARE(outcome.code, 4);
    QVERIFY(outcome.err.contains(QStringLiteral("no clouds")));
    QVERIFY(!QFile::exists(program_.path("a.pcd")));
  }
};

}  // namespace test_clouds_command

MAPWRIGHT_TEST(test_clouds_command, CloudsCommandTest, Widgets)
#include "test_clouds_command.moc"
