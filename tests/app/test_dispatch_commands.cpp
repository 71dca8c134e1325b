// A map dispatcher on the command line: regions of its map, files of its own, projections. The simulated one,
// seen from outside.
#include <cmath>

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "app/map_request.h"
#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_dispatch_commands {

using namespace mapwright;

namespace {

using Ran = tests::EndedBytes;

Ran run(const QStringList& words) { return tests::Program().runForBytes(words); }

QString text(const char* latin) { return QString::fromLatin1(latin); }

}  // namespace

class DispatchCommandsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<simulator::Simulator> robot_;
  QTemporaryDir folder_;

  void start(const std::function<void(simulator::Options&)>& change = {}) {
    simulator::Options options;
    options.paused = true;
    options.ros.kabam = false;
    options.ros.dispatcher.there = true;
    options.ros.dispatcher.edge_m = 1000;
    if (change) change(options);
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
  }
  Ran ask(QStringList words) const {
    return run(words << text("--robot") << QString::fromStdString(robot_->rep130Address()));
  }
  QString file(const char* name) const { return folder_.filePath(text(name)); }
  Ran exportRegion(const QString& output, const char* region) const {
    return ask(
        {text("maps"), text("export"), text("--region"), text(region), text("--force"), text("-o"), output});
  }

  /// A picture of a region and nothing on it.
  Ran picture(const char* region, const char* name) const {
    return ask({text("snapshot"), text("--region"), text(region), text("--layers"), text("none"), text("-o"),
                file(name)});
  }

 private Q_SLOTS:
  void cleanup() { robot_.reset(); }

  void aRegionIsFourNumbers() {
    const auto region = app::gridRegionFrom("10, -5,40,30.5");
    QVERIFY(region);
    QCOMPARE(region->centre_m, Eigen::Vector2d(10, -5));
    QCOMPARE(region->size_m, Eigen::Vector2d(40, 30.5));
    for (const char* wrong : {"", "1,2,3", "1,2,3,4,5", "1,2,0,4", "1,2,3,-4", "a,2,3,4", "nan,2,3,4",
                              "1,2,inf,4", "1,2,3,4,", "1e99,2,3,4"}) {
      const auto refused = app::gridRegionFrom(wrong);
      QVERIFY2(!refused, wrong);
      QVERIFY(refused.error().endsWith(QLatin1Char('.')));
    }
  }

  void aRegionIsExportedWhereItLies() {
    start();
    const Ran ran = exportRegion(file("part.yaml"), "10,-20,8,4");
    QVERIFY2(ran.code == 0, ran.err.constData());
    QFile yaml(file("part.yaml"));
    QVERIFY(yaml.open(QIODevice::ReadOnly));
    const QByteArray placed = yaml.readAll();
    QVERIFY2(placed.contains("origin: [6") && placed.contains(", -22"), placed.constData());
    const Ran png = exportRegion(file("part.png"), "10,-20,8,4");
    QVERIFY2(png.code == 0, png.err.constData());
    QCOMPARE(QImage(file("part.png")).size(), QSize(160, 80));
    const Ran shown = run({text("maps"), text("show"), text("--json"), text("--robot"), file("part.yaml")});
    QCOMPARE(QJsonDocument::fromJson(shown.out)[text("grid")][text("size")][0].toInt(), 160);
  }

  void nothingIsNoFile() {
    start();
    const Ran ran = exportRegion(file("nothing.png"), "5000,0,10,10");
    QCOMPARE(ran.code, 1);
    QCOMPARE(ran.err.count('\n'), 1);
    QVERIFY(!QFile::exists(file("nothing.png")));
  }

  void anAnswerOfAnotherRegionIsSaid() {
    start([](simulator::Options& options) { options.faults.ros.dispatcher.answer = "elsewhere"; });
    const Ran ran = exportRegion(file("elsewhere.png"), "0,0,10,10");
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains("another part"), ran.err.constData());
  }

  void whatTheRobotRefusesIsItsOwnWords() {
    start();
    const Ran ran = exportRegion(file("large.png"), "0,0,1000,1000");
    QCOMPARE(ran.code, 4);
    QVERIFY2(ran.err.contains("not enough memory"), ran.err.constData());
  }

  void theWholeMapIsHadByWhoAsksForIt() {
    start([](simulator::Options& options) { options.ros.dispatcher.edge_m = 20; });
    const Ran ran = ask({text("maps"), text("export"), text("-o"), file("whole.png")});
    QVERIFY2(ran.code == 0, ran.err.constData());
    QCOMPARE(QImage(file("whole.png")).size(), QSize(400, 400));
  }

  void aPictureOfAllOfItIsDrawnWhenThatWasSaid() {
    start([](simulator::Options& options) { options.ros.dispatcher.edge_m = 20; });
    for (const char* mode : {"whole", "grid"}) {
      const Ran ran =
          ask({text("snapshot"), text("--mode"), text(mode), text("--center"), text("0,0"), text("--scale"),
               text("0.05"), text("--size"), text("500x500"), text("--raw"), text("-o"), file("all.png")});
      QVERIFY2(ran.code == 0, ran.err.constData());
      // 400 x 400 cells, and nothing around them.
      const QImage picture = QImage(file("all.png")).convertToFormat(QImage::Format_ARGB32);
      QCOMPARE(picture.size(), QSize(500, 500));
      QVERIFY(qAlpha(picture.pixel(250, 250)) != 0);
      QCOMPARE(qAlpha(picture.pixel(20, 250)), 0);
    }
    const Ran shown = ask({text("maps"), text("show"), text("live"), text("--json")});
    QVERIFY2(shown.code == 0, shown.err.constData());
  }

  void whoDoesNotSayHowMuchIsToldOfRegions() {
    start();
    const Ran ran = ask({text("snapshot"), text("-o"), file("none.png")});
    QCOMPARE(ran.code, 4);
    QVERIFY2(ran.err.contains("--region") && ran.err.contains("--mode whole"), ran.err.constData());
    QVERIFY(!QFile::exists(file("none.png")));
  }

  void aRobotWithoutSubmapsIsNotWaitedFor() {
    start();
    const Ran ran = ask({text("snapshot"), text("--mode"), text("submaps"), text("-o"), file("all.png")});
    QCOMPARE(ran.code, 4);
    QVERIFY2(ran.err.count('\n') == 1 && ran.err.contains("submaps"), ran.err.constData());
  }

  void whatCameOfARegionIsShownThoughItLiesBeside() {
    start([](simulator::Options& options) { options.faults.ros.dispatcher.answer = "elsewhere"; });
    // The first, small question is answered a few metres to the right: that much lies in the region.
    const Ran part = picture("0,0,40,20", "part.png");
    QVERIFY2(part.code == 1, part.err.constData());
    QVERIFY2(part.err.contains("another region"), part.err.constData());
    QCOMPARE(QImage(file("part.png")).size(), QSize(800, 400));
    const Ran none = picture("0,0,6,6", "none.png");
    QCOMPARE(none.code, 3);
    QVERIFY(!QFile::exists(file("none.png")));
  }

  void pixelsSmallerThanACellAreAllObserved() {
    start();
    const Ran ran = ask({text("snapshot"), text("--raw"), text("--region"), text("0.013,0.017,2.03,1.01"),
                         text("--scale"), text("0.01"), text("-o"), file("fine.png")});
    QVERIFY2(ran.code == 0, ran.err.constData());
    const QImage picture(file("fine.png"));
    QCOMPARE(picture.size(), QSize(203, 101));
    int blank = 0;
    for (int x = 0; x < picture.width(); ++x) {
      for (int y = 0; y < picture.height(); ++y) {
        const bool edge = x == 0 || y == 0 || x + 1 == picture.width() || y + 1 == picture.height();
        blank += edge && qAlpha(picture.pixel(x, y)) == 0;
      }
    }
    QCOMPARE(blank, 0);
  }

  void cellsThatMeanNothingAreCountedOnce() {
    start([](simulator::Options& options) { options.faults.ros.dispatcher.cloud.lie = "cells"; });
    const Ran ran = ask({text("snapshot"), text("--region"), text("0,0,60,40"), text("--layers"),
                         text("none"), text("-o"), file("odd.png"), text("--report"), file("odd.json")});
    QVERIFY2(ran.code == 0, ran.err.constData());
    QFile report(file("odd.json"));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QByteArray told = report.readAll();
    QCOMPARE(told.count("outside the range of -1 to 100"), 1);
  }

  void aRobotThatGivesLittleAtOnceIsAskedInPieces_data() {
    QTest::addColumn<QByteArray>("too_much");
    for (const char* answer : {"cut", "empty", "error"}) QTest::newRow(answer) << QByteArray(answer);
  }
  void aRobotThatGivesLittleAtOnceIsAskedInPieces() {
    QFETCH(QByteArray, too_much);
    start();
    const Ran whole = picture("20,10,70,60", "whole.png");
    QVERIFY2(whole.code == 0, whole.err.constData());
    start([&](simulator::Options& options) {
      options.faults.ros.dispatcher.most_cells = 200'000;
      options.faults.ros.dispatcher.too_much = too_much.toStdString();
    });
    const Ran pieces = picture("20,10,70,60", "pieces.png");
    QVERIFY2(pieces.code == 0, pieces.err.constData());
    QVERIFY(!pieces.err.contains("smaller"));
    QCOMPARE(QImage(file("pieces.png")), QImage(file("whole.png")));
  }

  void aRegionIsOfTheLiveMapAlone() {
    start();
    const Ran ran = ask({text("maps"), text("export"), text("12"), text("--region"), text("0,0,1,1"),
                         text("-o"), file("other.png")});
    QCOMPARE(ran.code, 2);
    QCOMPARE(exportRegion(file("other.png"), "0,0,0,1").code, 2);
  }

  void aRobotWithoutOneSaysSo() {
    start([](simulator::Options& options) { options.ros.dispatcher.there = false; });
    for (const QStringList& words : {QStringList{text("maps"), text("export"), text("--region"),
                                                 text("0,0,1,1"), text("-o"), file("none.png")},
                                     QStringList{text("projections"), text("list")},
                                     QStringList{text("maps"), text("save-on-robot"), text("a.png")}}) {
      const Ran ran =
          run(QStringList(words) << text("--robot") << QString::fromStdString(robot_->rosAddress()));
      QCOMPARE(ran.code, 4);
      QCOMPARE(ran.err.count('\n'), 1);
    }
  }

  void theRobotSavesItsMap() {
    start();
    const Ran saved = ask({text("maps"), text("save-on-robot"), text("office.png")});
    QVERIFY2(saved.code == 0, saved.err.constData());
    QVERIFY(saved.out.contains("office.png"));
    const Ran refused = ask({text("maps"), text("save-on-robot"), text("office.docx")});
    QCOMPARE(refused.code, 1);  // a service that fails may have done its work
    QVERIFY2(refused.err.contains("office.docx"), refused.err.constData());
    QCOMPARE(ask({text("maps"), text("save-on-robot"), text("a\nb")}).code, 2);
  }

  void projectionsAreListed() {
    start();
    const Ran listed = ask({text("projections"), text("list"), text("--json")});
    QVERIFY2(listed.code == 0, listed.err.constData());
    const QJsonArray rows = QJsonDocument::fromJson(listed.out).array();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0][text("frame")].toString(), text("map"));
    QCOMPARE(rows[0][text("width")].toDouble(), 40.0);
    const Ran refused = ask({text("projections"), text("set"), text("--projection"), text("0,0,3,2,0,2")});
    QCOMPARE(refused.code, 4);
    QVERIFY2(refused.err.contains("only be read"), refused.err.constData());
  }

  void withoutRosapiProjectionsAreFoundOrCannotBeTold() {
    start([](simulator::Options& options) {
      options.ros.rosapi = false;
      options.ros.dispatcher.writable = true;
    });
    // Nobody tells where it is.
    const QString address = QString::fromStdString(robot_->rep130Address()) + text("?ns=/map_dispatcher");
    const auto there = [&](QStringList words) { return run(words << text("--robot") << address); };
    const Ran listed = there({text("projections"), text("list"), text("--json")});
    QVERIFY2(listed.code == 0, listed.err.constData());
    QCOMPARE(QJsonDocument::fromJson(listed.out).array().size(), 2);
    QCOMPARE(there({text("projections"), text("set"), text("--none")}).code, 0);
    const Ran unknown = there({text("projections"), text("list")});
    QCOMPARE(unknown.code, 1);
    QVERIFY2(unknown.err.contains("projections are unknown"), unknown.err.constData());
    QVERIFY(unknown.out.isEmpty());
  }

  void aCloudIsWhatWasAskedFor_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<QByteArray>("lie");
    QTest::addColumn<int>("exit_code");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("as it should be") << QByteArray() << QByteArray() << 0 << QByteArray();
    QTest::newRow("larger") << QByteArray("pad") << QByteArray() << 0
                            << QByteArray("outside the requested region");
    QTest::newRow("elsewhere") << QByteArray("elsewhere") << QByteArray() << 1
                               << QByteArray("another region");
    QTest::newRow("cut off") << QByteArray() << QByteArray("data") << 1 << QByteArray("cut off");
  }
  void aCloudIsWhatWasAskedFor() {
    QFETCH(QByteArray, answer);
    QFETCH(QByteArray, lie);
    QFETCH(int, exit_code);
    QFETCH(QByteArray, said);
    start([&](simulator::Options& options) {
      options.faults.ros.dispatcher.answer = answer.toStdString();
      options.faults.ros.dispatcher.cloud.lie = lie.toStdString();
    });
    const Ran ran = ask({text("clouds"), text("export"), text("--box"), text("0,0,1,10,8,4"), text("-o"),
                         file("part.pcd"), text("--force"), text("--json")});
    QVERIFY2(ran.code == exit_code, ran.err.constData());
    QVERIFY2(said.isEmpty() ? ran.err.isEmpty() : ran.err.contains(said), ran.err.constData());
    if (answer == "elsewhere") return;
    const QJsonObject json = QJsonDocument::fromJson(ran.out).object();
    QVERIFY(json[text("points")].toInt() > 0);
    QCOMPARE(json[text("beyond")].toInt() > 0, answer == "pad");
    QCOMPARE(json[text("missing")].toInt() > 0, lie == "data");
    QVERIFY(json[text("from")][0].toDouble() >= -5.01 && json[text("to")][0].toDouble() <= 5.01);
    QVERIFY(json[text("from")][2].toDouble() >= -1.01 && json[text("to")][2].toDouble() <= 3.01);
  }

  // The whole map may be gigabytes: commands that did not ask for it do not fetch it.
  void noCommandFetchesTheWholeMapByTheWay() {
    start([](simulator::Options& options) {
      options.ros.kabam = true;
      options.ros.dispatcher.edge_m = 20;
    });
    QFile wanted(file("wanted.csv"));
    QVERIFY(wanted.open(QIODevice::WriteOnly));
    wanted.write("name,x,y,yaw_rad\nNew,1,1,0\n");
    wanted.close();
    for (const QStringList& words :
         {QStringList{text("maps"), text("list")}, QStringList{text("maps"), text("current")},
          QStringList{text("waypoints"), text("list"), text("--warnings")},
          QStringList{text("waypoints"), text("plan"), file("wanted.csv")},
          QStringList{text("record"), text("-o"), file("a.mcap"), text("--duration"), text("2")}}) {
      const Ran ran = ask(words);
      // What lies under the waypoints is not known without the map, which makes the answer incomplete.
      QVERIFY2(ran.code == (words.contains(text("--warnings")) ? 1 : 0), ran.err.constData());
    }
    for (const simulator::RequestRecord& one : robot_->requestLog())
      QVERIFY2(!one.target.ends_with("/get_map") && one.target != "/map", one.target.c_str());
  }

  void whereThereIsOnlyAMapInSpaceItsFirstProjectionIsShown() {
    start([](simulator::Options& options) {
      options.ros.dispatcher.planar = false;
      options.ros.dispatcher.edge_m = 20;
    });
    for (const QStringList& words :
         {QStringList{text("maps"), text("show")}, QStringList{text("maps"), text("current")},
          QStringList{text("maps"), text("export"), text("-o"), file("flat.png")},
          QStringList{text("snapshot"), text("--mode"), text("whole"), text("-o"), file("view.png")}}) {
      const Ran ran = ask(words);
      QVERIFY2(ran.code == 0, ran.err.constData());
    }
    QCOMPARE(QImage(file("flat.png")).isNull(), false);
  }

  void projectionsAreSetAndWhatThenIsIsPrinted() {
    start([](simulator::Options& options) { options.ros.dispatcher.writable = true; });
    const Ran set = ask({text("projections"), text("set"), text("--projection"), text("1.04,0,3,2,4,5"),
                         text("--projection"), text("0,0,5,5,0,2,map"), text("--json")});
    QVERIFY2(set.code == 0, set.err.constData());
    const QJsonArray rows = QJsonDocument::fromJson(set.out).array();
    QCOMPARE(rows.size(), 2);
    QVERIFY(std::abs(rows[0][text("x")].toDouble() - 1) < 1e-6);  // whole decimetres
    QCOMPARE(rows[0][text("min_z")].toDouble(), 4.0);
    // What it does not do as it was told is said.
    const Ran other =
        ask({text("projections"), text("set"), text("--projection"), text("0,0,900,5,0,2"), text("--json")});
    QCOMPARE(other.code, 1);
    QCOMPARE(QJsonDocument::fromJson(other.out).array().size(), 1);
    for (const char* wrong : {"0,0,3,2,0", "0,0,0,2,0,2", "0,0,3,2,2,0", "a,0,3,2,0,2"})
      QCOMPARE(ask({text("projections"), text("set"), text("--projection"), text(wrong)}).code, 2);
    QCOMPARE(ask({text("projections"), text("set")}).code, 2);
  }
};

}  // namespace test_dispatch_commands

MAPWRIGHT_TEST(test_dispatch_commands, DispatchCommandsTest, Core)
#include "test_dispatch_commands.moc"
