// `maps align`, `maps rehearse`, `waypoints carry` and `overlays carry`, as a script runs them on two maps of
// one building.
#include <QTest>

#include "../align/buildings.h"
#include "program.h"
#include "test_program.h"

namespace test_new_map_commands {

using namespace mapwright;
using mapwright::testing::Chance;
using mapwright::testing::Ground;
using mapwright::testing::Plan;
using mapwright::testing::Pose2;

namespace {

const Pose2 kTruth{4, -9, 0.7};

QByteArray pictureOf(const Plan& plan) {
  QByteArray bytes =
      QByteArray("P5\n") + QByteArray::number(plan.width) + ' ' + QByteArray::number(plan.height) + "\n255\n";
  for (int row = plan.height - 1; row >= 0; --row) {
    for (int column = 0; column < plan.width; ++column) {
      const Ground ground = plan.at(column, row);
      bytes += ground == Ground::Wall ? char(0) : ground == Ground::Free ? char(254) : char(205);
    }
  }
  return bytes;
}

QByteArray waypoint(const char* name, double x, double y) {
  return QByteArray("{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[") +
         QByteArray::number(x) + ',' + QByteArray::number(y) + "]},\"properties\":{\"name\":\"" + name +
         "\",\"yaw_rad\":0.5}}";
}

}  // namespace

class NewMapTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<tests::Program> program_;
  Plan site_;
  Eigen::Vector2d dock_{0, 0};

  tests::Ended run(const QString& line) const { return program_->run(line.split(QLatin1Char(' '))); }
  void putMap(const QByteArray& name, const Plan& plan) const {
    program_->put((name + ".pgm").constData(), pictureOf(plan));
    program_->put((name + ".yaml").constData(),
                  "image: " + name + ".pgm\nresolution: " + QByteArray::number(plan.resolution_m) +
                      "\norigin: [" + QByteArray::number(plan.corner_m.x(), 'g', 12) + ", " +
                      QByteArray::number(plan.corner_m.y(), 'g', 12) +
                      ", 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  }

  Eigen::Vector2d placeOf(double column, double row) const {
    return site_.corner_m + site_.resolution_m * Eigen::Vector2d(column, row);
  }
  /// A free aisle of 3 m, a way through it, and today a shelf right across.
  void putAisle() const {
    Plan old = site_;
    testing::fill(old, 8, 8, 70, 42, Ground::Free);
    putMap("old", old);
    testing::fill(old, 30, 1, 34, 60, Ground::Wall);
    putMap("today", testing::mappedAgain(old, kTruth, 0.05));
    QByteArray way = "stamp_s,x_m,y_m\n";
    for (int i = 0; i <= 40; ++i) {
      const Eigen::Vector2d at = placeOf(15.5 + i, 25.5);
      way += QByteArray::number(1000 + i * 0.05, 'f', 3) + ',' + QByteArray::number(at.x(), 'f', 4) + ',' +
             QByteArray::number(at.y(), 'f', 4) + '\n';
    }
    program_->put("way.csv", way);
  }

 private Q_SLOTS:
  void init() {
    program_ = std::make_unique<tests::Program>();
    Chance chance(11);
    const Plan plain = testing::building(chance);
    site_ = testing::furnished(plain, chance, 10);
    putMap("before", site_);
    putMap("after", testing::mappedAgain(site_, kTruth, 0.05));
    dock_ = site_.corner_m + Eigen::Vector2d(1.0, 1.0);
    program_->put("points.geojson", "{\"type\":\"FeatureCollection\",\"features\":[" +
                                        waypoint("Dock", dock_.x(), dock_.y()) + ',' +
                                        waypoint("Far", dock_.x() + 500, dock_.y()) + "]}");
    QCOMPARE(run(QStringLiteral("waypoints import points.geojson --robot before.yaml")).code, 0);
  }

  void whatWouldHaveNoEffectIsRefused() {
    for (const char* const command : {"maps align", "maps diff"}) {
      const tests::Ended robot =
          run(QLatin1String(command) + QStringLiteral(" before.yaml after.yaml --robot demo:"));
      QVERIFY2(robot.code == 2 && robot.err.contains(QLatin1String("--robot demo: has no effect")),
               qPrintable(robot.err));
      const tests::Ended name =
          run(QLatin1String(command) + QStringLiteral(" before.yaml after.yaml --diff d.jpg"));
      QVERIFY2(name.code == 2 && name.err.contains(QLatin1String("ends in .png")), qPrintable(name.err));
    }
    const tests::Ended picture = run(QStringLiteral("snapshot --robot before.yaml --size 64x64 -o p.jpg"));
    QVERIFY2(picture.code == 2 && picture.err.contains(QLatin1String("ends in .png")),
             qPrintable(picture.err));
  }

  void aMapOfTheSameSiteIsFound() {
    const tests::Ended found = run(QStringLiteral("maps align before.yaml after.yaml --json --diff d.png"));
    QVERIFY2(found.code == 0, qPrintable(found.err + found.out));
    const QJsonObject json = found.object();
    QVERIFY(json[QLatin1String("sure")].toBool());
    const QJsonObject transform = json[QLatin1String("transform")].toObject();
    const Pose2 pose{transform[QLatin1String("x")].toDouble(), transform[QLatin1String("y")].toDouble(),
                     transform[QLatin1String("yaw_rad")].toDouble()};
    QVERIFY((pose.apply(dock_) - kTruth.apply(dock_)).norm() < 0.1);
    QVERIFY(json[QLatin1String("walls_within_10cm")].toDouble() > 0.95);
    QVERIFY(json[QLatin1String("backwards")].toObject()[QLatin1String("walls_within_10cm")].toDouble() >
            0.95);
    QVERIFY(program_->bytes("d.png").startsWith("\x89PNG"));
  }

  void onlyThePictureNeedsAResolution() {
    const tests::Ended found = run(QStringLiteral("maps align before.yaml after.pgm --resolution 0.05"));
    QVERIFY2(found.code == 0, qPrintable(found.err + found.out));
  }

  void anotherSiteIsNotSureAndNothingIsChosen() {
    Chance chance(77);
    const Plan plain = testing::building(chance);
    putMap("other", testing::furnished(plain, chance, 10));
    const tests::Ended found = run(QStringLiteral("maps align before.yaml other.yaml --json"));
    QCOMPARE(found.code, 1);
    QVERIFY(found.object()[QLatin1String("transform")].isNull());
    QVERIFY(!found.object()[QLatin1String("sure")].toBool());
    QCOMPARE(run(QStringLiteral("waypoints carry --from before.yaml --to other.yaml -o w.geojson")).code, 1);
    QVERIFY(!QFile::exists(program_->path("w.geojson")));
  }

  void outOfTimeIsNotNotSure() {
    Chance chance(12);
    Plan large;
    large.width = large.height = 3000;
    large.resolution_m = 0.05;
    large.cells.assign(std::size_t(large.width) * std::size_t(large.height), Ground::Free);
    testing::furnish(large, chance, 4000);
    putMap("large", large);
    const tests::Ended late = run(QStringLiteral("maps align large.yaml large.yaml --timeout 0.05"));
    QVERIFY2(late.code == 3 && late.err.contains(QLatin1String("0.05 s")), qPrintable(late.err));
  }

  void twoPairsByHandAreAResult() {
    const auto typed = [&](const Eigen::Vector2d& at) {
      const Eigen::Vector2d there = kTruth.apply(at);
      return QStringLiteral(" --pair %1,%2:%3,%4").arg(at.x()).arg(at.y()).arg(there.x()).arg(there.y());
    };
    const tests::Ended found = run(QStringLiteral("maps align before.yaml after.yaml --json") + typed(dock_) +
                                   typed(dock_ + Eigen::Vector2d(12, 5)));
    QVERIFY2(found.code == 0, qPrintable(found.err));
    QCOMPARE(found.object()[QLatin1String("pairs")].toArray().size(), 2);
  }

  void aPairThatIsNoneIsRefused_data() {
    QTest::addColumn<QString>("pair");
    for (const char* pair : {"1,2", "1,2:3", "1,2:3,x", "1,2,3:4", "1,2:3,4:5,6", "1,2:3,inf"})
      QTest::newRow(pair) << QString::fromLatin1(pair);
  }
  void aPairThatIsNoneIsRefused() {
    QFETCH(QString, pair);
    const tests::Ended found = run(QStringLiteral("maps align before.yaml after.yaml --pair ") + pair);
    QCOMPARE(found.code, 2);
    QVERIFY2(found.err.contains(QLatin1String("X,Y:X,Y")), qPrintable(found.err));
  }

  void waypointsAreCarriedOverAndImported() {
    const tests::Ended carried = run(QStringLiteral(
        "waypoints carry --from before.yaml --to after.yaml -o w.geojson --report r.html --json"));
    QVERIFY2(carried.code == 1, qPrintable(carried.err));  // one is outside
    const QJsonArray items = carried.object()[QLatin1String("items")].toArray();
    QCOMPARE(items.size(), 2);
    const QJsonObject dock = items[0].toObject(), far = items[1].toObject();
    QCOMPARE(dock[QLatin1String("verdict")].toString(), QStringLiteral("kept"));
    QVERIFY(dock[QLatin1String("carried")].toBool());
    QCOMPARE(far[QLatin1String("verdict")].toString(), QStringLiteral("outside"));
    QVERIFY(!far[QLatin1String("carried")].toBool());
    QVERIFY(program_->bytes("r.html").contains("Dock") && program_->bytes("r.html").contains("outside"));
    QCOMPARE(run(QStringLiteral("waypoints import w.geojson --robot after.yaml")).code, 0);
    const QJsonArray there = run(QStringLiteral("waypoints list --robot after.yaml --json")).array();
    QCOMPARE(there.size(), 1);
    const QJsonObject point = there[0].toObject();
    const Eigen::Vector2d at(point[QLatin1String("x")].toDouble(), point[QLatin1String("y")].toDouble());
    QVERIFY((at - kTruth.apply(dock_)).norm() < 0.1);
    QVERIFY(std::abs(point[QLatin1String("yaw_rad")].toDouble() - 1.2) < 0.01);

    const tests::Ended again =
        run(QStringLiteral("waypoints carry --from before.yaml --to after.yaml --dry-run --json"));
    QVERIFY(again.object()[QLatin1String("items")][0][QLatin1String("there_already")].toBool());
  }

  void waypointsWithoutANameAreNotOneAndTheSame() {
    const Eigen::Vector2d there = kTruth.apply(dock_ + Eigen::Vector2d(1, 0));
    program_->put("before.waypoints.geojson",
                  R"({"type":"FeatureCollection","features":[)" + waypoint("", dock_.x(), dock_.y()) + "]}");
    program_->put("after.waypoints.geojson",
                  R"({"type":"FeatureCollection","features":[)" + waypoint("", there.x(), there.y()) + "]}");
    QCOMPARE(run(QStringLiteral("waypoints carry --from before.yaml --to after.yaml -o w.geojson")).code, 0);
    QCOMPARE(run(QStringLiteral("waypoints import w.geojson --robot after.yaml")).code, 0);
    QCOMPARE(run(QStringLiteral("waypoints list --robot after.yaml --json")).array().size(), 2);
  }

  void overlaysAreCarriedOverAndSet() {
    program_->put("before.overlays.geojson",
                  "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"id\":\"w\","
                  "\"geometry\":{\"type\":"
                  "\"LineString\",\"coordinates\":[[" +
                      QByteArray::number(dock_.x()) + ',' + QByteArray::number(dock_.y()) + "],[" +
                      QByteArray::number(dock_.x() + 1) + ',' + QByteArray::number(dock_.y()) +
                      "]]},\"properties\":{\"lineType\":\"2\"}}]}");
    QCOMPARE(run(QStringLiteral("overlays get --robot after.yaml -o base.geojson")).code, 0);
    const tests::Ended carried =
        run(QStringLiteral("overlays carry --from before.yaml --to after.yaml -o o.geojson"));
    QVERIFY2(carried.code == 0, qPrintable(carried.err + carried.out));
    QCOMPARE(run(QStringLiteral("overlays set o.geojson --base base.geojson --robot after.yaml")).code, 0);
    QVERIFY(program_->bytes("after.overlays.geojson").contains("\"lineType\":\"2\""));
  }

  void onSubmapsNothingLiesYet() {
    const tests::Ended from =
        run(QStringLiteral("waypoints carry --from submaps --to after.yaml --robot demo: --dry-run"));
    QVERIFY2(from.code == 2 && from.err.contains(QLatin1String("Submaps have no waypoints")),
             qPrintable(from.err));
    program_->put("before.overlays.geojson",
                  R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"a","geometry":{)"
                  R"("type":"Point","coordinates":[1,1]},"properties":{"type":25}}]})");
    const tests::Ended onto =
        run(QStringLiteral("overlays carry --from before.yaml --to submaps@demo: --transform 0,0,0 --all "
                           "-o onto.geojson"));
    QVERIFY2(onto.code <= 1, qPrintable(onto.err));
    QVERIFY(program_->bytes("onto.geojson").contains("\"id\":\"a\""));
  }

  void aTransformThatWasLookedAtIsUsed() {
    const tests::Ended carried = run(QStringLiteral(
        "waypoints carry --from before.yaml --to before.yaml --transform 1,0,0 --dry-run --json"));
    QVERIFY2(carried.code == 0, qPrintable(carried.err));  // both are there already
    const QJsonObject item = carried.object()[QLatin1String("items")][0].toObject();
    QVERIFY(std::abs(item[QLatin1String("x")].toDouble() - dock_.x() - 1) < 1e-3);
  }

  void aWayOfLastWeekThatAShelfOfTodayStandsInIsFound() {
    putAisle();
    const tests::Ended before = run(QStringLiteral("maps rehearse old.yaml way.csv"));
    QVERIFY2(before.code == 0 && before.out.contains(QLatin1String("way.csv: 2.0 m, all free.")),
             qPrintable(before.err + before.out));
    const QString line = QStringLiteral("maps rehearse today.yaml way.csv --from old.yaml");
    const tests::Ended found = run(line + QStringLiteral(" --json -o w.geojson --report r.html"));
    QVERIFY2(found.code == 1, qPrintable(found.err + found.out));
    const QJsonObject way = found.object()[QLatin1String("ways")][0].toObject();
    QVERIFY(!way[QLatin1String("free")].toBool());
    QCOMPARE(way[QLatin1String("reach")].toString(), QStringLiteral("reached"));
    const QJsonArray stretches = way[QLatin1String("stretches")].toArray();
    QCOMPARE(stretches.size(), 1);
    const QJsonObject shelf = stretches[0].toObject();
    QCOMPARE(shelf[QLatin1String("what")].toString(), QStringLiteral("obstacle"));
    const Eigen::Vector2d middle(shelf[QLatin1String("x")].toDouble(), shelf[QLatin1String("y")].toDouble());
    QVERIFY((middle - kTruth.apply(placeOf(32.5, 25.5))).norm() < 0.15);
    QVERIFY(std::abs(shelf[QLatin1String("from_s")].toDouble() - 1000.43) < 0.12);
    double length_m = 0;
    const QJsonArray lines =
        QJsonDocument::fromJson(program_->bytes("w.geojson"))[QLatin1String("features")].toArray();
    for (const QJsonValue feature : lines)
      length_m += feature[QLatin1String("properties")][QLatin1String("length_m")].toDouble();
    QCOMPARE(lines.size(), 3);
    QVERIFY(std::abs(length_m - 2) < 1e-3);
    QVERIFY(program_->bytes("r.html").contains("in an obstacle"));
    const tests::Ended table = run(line);
    QVERIFY2(
        table.out.contains(QLatin1String("MEETS")) && table.out.contains(QLatin1String("in an obstacle")),
        qPrintable(table.out));
  }

  /// Both maps have the same coordinates.
  void thePartIsRehearsedThatTheRecordingSaysIsOfTheOldMap() {
    putAisle();
    const auto part = [&](int map, const QString& name, double row, int length) {
      const Eigen::Vector2d from = placeOf(12.5, row), to = placeOf(12.5 + length, row);
      const auto at = [](const Eigen::Vector2d& place) { return QJsonArray{place.x(), place.y()}; };
      const double begun_s = 1000 * (map + 1);
      return QJsonObject{{QStringLiteral("geometry"),
                          QJsonObject{{QStringLiteral("type"), QStringLiteral("LineString")},
                                      {QStringLiteral("coordinates"), QJsonArray{at(from), at(to)}}}},
                         {QStringLiteral("properties"),
                          QJsonObject{{QStringLiteral("map"), map},
                                      {QStringLiteral("map_name"), name},
                                      {QStringLiteral("stamps_s"), QJsonArray{begun_s, begun_s + 0.5}}}}};
    };
    const QJsonObject ways{
        {QStringLiteral("features"), QJsonArray{part(0, QStringLiteral("elsewhere"), 20.5, 10),
                                                part(1, QStringLiteral("old"), 25.5, 12)}}};
    program_->put("two.geojson", QJsonDocument(ways).toJson());
    const auto way = [&](const QString& more) {
      return run(QStringLiteral("maps rehearse ") + more + QStringLiteral(" --json"))
          .object()[QLatin1String("ways")][0]
          .toObject();
    };
    const double cell_m = site_.resolution_m;
    for (const char* const line : {"today.yaml two.geojson --from old.yaml", "old.yaml two.geojson"}) {
      const QJsonObject found = way(QLatin1String(line));
      QCOMPARE(found[QLatin1String("part")].toString(), QStringLiteral("recorded"));
      QVERIFY(std::abs(found[QLatin1String("length_m")].toDouble() - 12 * cell_m) < 1e-3);
      QVERIFY(std::abs(found[QLatin1String("elsewhere_m")].toDouble() - 10 * cell_m) < 1e-3);
      QVERIFY(!found[QLatin1String("of_another_map")].toBool());
    }
    const QJsonObject guessed = way(QStringLiteral("today.yaml two.geojson --transform 0,0,0"));
    QCOMPARE(guessed[QLatin1String("part")].toString(), QStringLiteral("by_ground"));
  }

  void aTransformAndARadiusAreUsed() {
    putAisle();
    const auto crossed = [&](const char* more) {
      const tests::Ended ended =
          run(QStringLiteral("maps rehearse old.yaml way.csv --json ") + QLatin1String(more));
      return ended.object()[QLatin1String("ways")][0][QLatin1String("stretches")].toArray();
    };
    QCOMPARE(crossed("").size(), 0);
    QVERIFY(!crossed("--radius 1.5").isEmpty());
    const QJsonArray away = crossed("--transform 500,0,0");
    QCOMPARE(away.size(), 1);
    QCOMPARE(away[0][QLatin1String("what")].toString(), QStringLiteral("outside"));
  }

  void whereTheMapsDoNotFitNoWayIsRehearsed() {
    putAisle();
    Chance chance(77);
    const Plan plain = testing::building(chance);
    putMap("other", testing::furnished(plain, chance, 10));
    const tests::Ended ended =
        run(QStringLiteral("maps rehearse other.yaml way.csv --from old.yaml -o w.geojson"));
    QCOMPARE(ended.code, 1);
    QVERIFY2(ended.err.contains(QLatin1String("Nothing was rehearsed.")), qPrintable(ended.err));
    QVERIFY(!QFile::exists(program_->path("w.geojson")));
  }

  void aRecordingIsReadAsItsTrackIs() {
    QCOMPARE(run(QStringLiteral("record --robot demo: --duration 3 -o run.mcap")).code, 0);
    QCOMPARE(run(QStringLiteral("maps export --robot demo: -o demo.yaml")).code, 0);
    for (const char* suffix : {"csv", "geojson", "tum"}) {
      const QString file = QStringLiteral("run.") + QLatin1String(suffix);
      QCOMPARE(run(QStringLiteral("bags track run.mcap -o ") + file).code, 0);
      const tests::Ended both =
          run(QStringLiteral("maps rehearse demo.yaml run.mcap ") + file + QStringLiteral(" --json"));
      QVERIFY2(both.code == 0 || both.code == 1, qPrintable(both.err));
      const QJsonValue ways = both.object()[QLatin1String("ways")];
      const double length_m = ways[0][QLatin1String("length_m")].toDouble();
      QVERIFY(length_m > 0.1);
      QVERIFY(std::abs(ways[1][QLatin1String("length_m")].toDouble() - length_m) < 1e-3);
      QCOMPARE(ways[1][QLatin1String("stretches")].toArray().size(),
               ways[0][QLatin1String("stretches")].toArray().size());
    }
  }

  void whatIsNoWayIsRefused_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* words, const char* said) {
      QTest::newRow(words) << QString::fromLatin1(words) << QString::fromLatin1(said);
    };
    row("old.yaml none.csv", "none.csv cannot be read");
    row("old.yaml none.mcap", "none.mcap");
    row("old.yaml points.geojson", "points.geojson is no track");
    row("old.yaml head.csv", "head.csv: It has no position of the robot.");
    row("old.yaml broken.csv", "broken.csv is no track: line 2 cannot be read.");
    row("old.yaml broken.mcap", "broken.mcap");
    row("old.yaml way.csv none.csv -o w.geojson", "none.csv cannot be read");
    row("none.yaml way.csv", "none.yaml");
    row("old.yaml way.csv --radius x", "--radius");
    row("old.yaml way.csv --pair 1,2:3,4", "--from");
    row("old.yaml way.csv --transform 1,2", "--transform");
    row("old.yaml way.csv -o way.csv", "way.csv");
    row("old.yaml way.csv -o way.csv --force", "way.csv");
    row("old.yaml", "ways");
  }
  void whatIsNoWayIsRefused() {
    QFETCH(QString, words);
    QFETCH(QString, said);
    putAisle();
    const QByteArray way = program_->bytes("way.csv");
    program_->put("head.csv", "stamp_s,x_m,y_m\n");
    program_->put("broken.csv", "stamp_s,x_m,y_m\n1,2\n");
    program_->put("broken.mcap", "\x89MCAP0\r\n, and then nothing");
    const tests::Ended ended = run(QStringLiteral("maps rehearse ") + words);
    QVERIFY2(ended.code == 2 && ended.out.isEmpty() && ended.err.contains(said), qPrintable(ended.err));
    QVERIFY(!QFile::exists(program_->path("w.geojson")));
    QCOMPARE(program_->bytes("way.csv"), way);
  }

  void positionsThatAreNoNumbersAreSaid() {
    putAisle();
    program_->put("odd.csv", program_->bytes("way.csv") + "1002,nan,3\n");
    const tests::Ended ended = run(QStringLiteral("maps rehearse old.yaml odd.csv"));
    QVERIFY2(ended.out.contains(QLatin1String("because they are no numbers: 1.")), qPrintable(ended.out));
    program_->put("nothing.csv", "stamp_s,x_m,y_m\n1002,nan,3\n");
    QCOMPARE(run(QStringLiteral("maps rehearse old.yaml nothing.csv")).code, 2);
  }

  void noReportReplacesWhatWouldHaveBeenRead_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"before.yaml", "before.pgm", "before.waypoints.geojson", "after.pgm",
                             "after.overlays.geojson", "after.waypoints.geojson"})
      QTest::newRow(file) << QString::fromLatin1(file);
  }
  void noReportReplacesWhatWouldHaveBeenRead() {
    QFETCH(QString, file);
    const QByteArray name = file.toUtf8();
    if (!QFile::exists(program_->path(name.constData()))) program_->put(name.constData(), "{}");
    const QByteArray before = program_->bytes(name.constData());
    const tests::Ended ended = run(
        QStringLiteral("waypoints carry --from before.yaml --to after.yaml --dry-run --pair none --report ") +
        file);
    QCOMPARE(ended.code, 2);
    QCOMPARE(program_->bytes(name.constData()), before);
  }

  void whatContradictsItselfIsRefused_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {"", "--dry-run -o w.geojson", "--dry-run --transform 1,2",
                             "--dry-run --transform 1,2,3 --pair 1,2:3,4", "-o points.geojson", "-o w.csv",
                             "-o w.geojson --report w.geojson", "--dry-run --radius x"})
      QTest::newRow(line) << QString::fromLatin1(line);
  }
  void whatContradictsItselfIsRefused() {
    QFETCH(QString, line);
    const tests::Ended ended =
        run((QStringLiteral("waypoints carry --from before.yaml --to after.yaml ") + line).trimmed());
    QVERIFY2(ended.code == 2 && ended.out.isEmpty() && !ended.err.isEmpty(), qPrintable(ended.err));
    QVERIFY(!QFile::exists(program_->path("w.geojson")));
  }
};

}  // namespace test_new_map_commands

MAPWRIGHT_TEST(test_new_map_commands, NewMapTest, Core)
#include "test_new_map_commands.moc"
