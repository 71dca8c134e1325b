// `slam disagreement` and `slam coverage`: that table, files, picture and JSON say the same, what is refused,
// and how missing submaps are told.
#include <algorithm>
#include <cmath>
#include <functional>

#include <QImage>
#include <QtTest>

#include "program.h"
#include "test_program.h"

namespace test_slam_agreement {

using namespace mapwright;
using Outcome = tests::Ended;

namespace {

constexpr const char* kDemo = "demo:?submaps=30";

QList<QStringList> rowsOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QList<QStringList> rows;
  for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
    rows << line.split(QLatin1Char(','));
  return rows;
}

/// Pixels whose colour `is` accepts.
int countOf(const QImage& picture, const std::function<bool(QColor)>& is) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) count += is(picture.pixelColor(x, y)) ? 1 : 0;
  }
  return count;
}

}  // namespace

class SlamAgreementTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  Outcome run(const char* words) const {
    return program_.run(QString::fromLatin1(words)
                            .replace(QStringLiteral("DEMO"), QLatin1String(kDemo))
                            .split(QLatin1Char(' ')));
  }

 private Q_SLOTS:
  void disagreementIsTheSameInJsonCsvAndPicture() {
    const Outcome ended = run("slam disagreement --robot DEMO -o d.png --csv d.csv --world-file --json");
    QCOMPARE(ended.code, 0);
    QCOMPARE(ended.err, QString());
    const QJsonObject json = ended.object();
    QCOMPARE(json[QStringLiteral("tolerance_cells")].toInt(), 4);
    QCOMPARE(json[QStringLiteral("cell_m")].toDouble(), 0.05);
    QCOMPARE(json[QStringLiteral("complete")].toBool(), true);
    const int contradicted = json[QStringLiteral("contradicted_cells")].toInt();
    QCOMPARE(json[QStringLiteral("share")].toDouble(),
             contradicted / json[QStringLiteral("occupied_cells")].toDouble());
    QVERIFY(contradicted > 0);
    const QJsonArray places = json[QStringLiteral("places")].toArray();
    const auto rows = rowsOf(program_.path("d.csv"));
    QCOMPARE(rows.size(), places.size() + 1);
    QCOMPARE(rows[0].join(QLatin1Char(',')), QStringLiteral("x,y,cells,submaps"));
    int sum = 0, before = contradicted;
    for (qsizetype at = 0; at < places.size(); ++at) {
      const QJsonObject place = places[at].toObject();
      const int cells = place[QStringLiteral("cells")].toInt();
      QVERIFY(cells <= before);
      sum += before = cells;
      QVERIFY(place[QStringLiteral("submaps")].toArray().size() >= 2);
      // Each cell is held occupied by one of them at least, and was seen free by one.
      QJsonArray named;
      int occupied = 0, free = 0;
      for (const QJsonValue& part : place[QStringLiteral("parts")].toArray()) {
        named << part[QStringLiteral("submap")];
        occupied += part[QStringLiteral("occupied_cells")].toInt();
        free += part[QStringLiteral("free_cells")].toInt();
      }
      QCOMPARE(named, place[QStringLiteral("submaps")].toArray());
      QVERIFY(occupied >= cells && free >= cells);
      QCOMPARE(rows[at + 1][0].toDouble(), place[QStringLiteral("x")].toDouble());
      QCOMPARE(rows[at + 1][2].toInt(), cells);
      QCOMPARE(rows[at + 1][3].split(QLatin1Char(' ')).size(),
               place[QStringLiteral("submaps")].toArray().size());
    }
    QCOMPARE(sum, contradicted);
    const QImage picture(program_.path("d.png"));
    QCOMPARE(countOf(picture, [](QColor c) { return c.alpha() == 255 && c.red() > c.blue() + 40; }),
             contradicted);
    QCOMPARE(countOf(picture, [](QColor c) { return c == QColor(120, 120, 120); }),
             json[QStringLiteral("occupied_cells")].toInt() - contradicted);
    QCOMPARE(picture.text(QStringLiteral("resolution")), QStringLiteral("0.05"));
    // The worst place lies where the picture says that it does.
    const auto world = rowsOf(program_.path("d.pgw"));
    QCOMPARE(world.size(), 6);
    const QJsonObject worst = places[0].toObject();
    const auto pixel = [&](double x, double y) {
      return QPoint(int(std::lround((x - world[4][0].toDouble()) / 0.05)),
                    int(std::lround((world[5][0].toDouble() - y) / 0.05)));
    };
    const double x = worst[QStringLiteral("x")].toDouble(), y = worst[QStringLiteral("y")].toDouble();
    const QImage square = picture.copy(QRect(pixel(x - 0.475, y + 0.475), QSize(20, 20)));
    QCOMPARE(countOf(square, [](QColor c) { return c == QColor(140, 0, 20); }),
             worst[QStringLiteral("cells")].toInt());
  }

  void coverageIsTheSameInJsonCsvAndPicture() {
    const Outcome ended = run("slam coverage --robot DEMO -o c.png --csv c.csv --json");
    QCOMPARE(ended.code, 0);
    const QJsonObject json = ended.object();
    int seen = 0;
    for (const QJsonValue& row : json[QStringLiteral("seen_by")].toArray())
      seen += row.toObject()[QStringLiteral("cells")].toInt();
    QCOMPARE(seen, json[QStringLiteral("seen_cells")].toInt());
    const int once = json[QStringLiteral("seen_once_cells")].toInt();
    QVERIFY(once > 0 && once < seen);
    int csv_seen = 0, csv_once = 0;
    for (const QStringList& row : rowsOf(program_.path("c.csv")).mid(1))
      csv_seen += row[2].toInt(), csv_once += row[3].toInt();
    QCOMPARE(csv_seen, seen);
    QCOMPARE(csv_once, once);
    const QImage picture(program_.path("c.png"));
    QCOMPARE(countOf(picture, [](QColor c) { return c.alpha() != 0; }), seen);
    QCOMPARE(countOf(picture, [](QColor c) { return c.red() > c.blue() && c.alpha() != 0; }), once);
    const int lines = countOf(picture, [](QColor c) { return c == QColor(0x8a, 0x5a, 0); });
    QVERIFY(lines > once / 8 && lines < once / 2);  // hatched
  }

  void aSmallerToleranceFindsMore() {
    int before = -1;
    for (const char* tolerance : {"4", "1", "0"}) {
      const Outcome ended =
          program_.run({QStringLiteral("slam"), QStringLiteral("disagreement"), QStringLiteral("--robot"),
                        QLatin1String(kDemo), QStringLiteral("--tolerance"), QLatin1String(tolerance),
                        QStringLiteral("--json")});
      const int found = ended.object()[QStringLiteral("contradicted_cells")].toInt();
      QVERIFY(found > before);
      before = found;
    }
  }

  void failOverIsExitCodeOne() {
    const Outcome above = run("slam disagreement --robot DEMO --fail-over 0 --json");
    QCOMPARE(above.code, 1);
    QVERIFY(above.err.contains(QStringLiteral("--fail-over")));
    QCOMPARE(above.err.count(QLatin1Char('\n')), 1);
    QCOMPARE(above.object()[QStringLiteral("complete")].toBool(), true);
    QCOMPARE(run("slam disagreement --robot DEMO --fail-over 0.9").code, 0);
  }

  void pictureOrTableButNotBothOnStandardOutput() {
    const Outcome table = run("slam coverage --robot DEMO");
    QVERIFY(table.out.contains(QStringLiteral("SUBMAPS")));
    const Outcome rows = run("slam disagreement --robot DEMO --csv -");
    QCOMPARE(rows.code, 0);
    QVERIFY(rows.out.startsWith(QStringLiteral("x,y,cells,submaps\n")));
    QVERIFY(!rows.out.contains(QStringLiteral("tolerance")));
    QCOMPARE(run("slam disagreement --robot DEMO --csv - --json").code, 2);
  }

  void whatMakesNoSenseIsRefused_data() {
    QTest::addColumn<QString>("words");
    for (const char* words :
         {"disagreement --cell 0", "disagreement --cell 2", "disagreement --tolerance -1",
          "disagreement --tolerance 41", "disagreement --fail-over 5", "disagreement -o heat.jpg",
          "coverage -o same.png --csv same.png", "coverage --world-file",
          "coverage -o no/such/folder/heat.png", "coverage --tolerance 1"})
      QTest::newRow(words) << QString::fromLatin1(words);
  }
  void whatMakesNoSenseIsRefused() {
    QFETCH(QString, words);
    const Outcome ended = run(qPrintable(QStringLiteral("slam %1 --robot DEMO").arg(words)));
    QCOMPARE(ended.code, 2);
    QCOMPARE(ended.out, QString());
    QVERIFY2(ended.err.count(QLatin1Char('\n')) == 1, qPrintable(ended.err));
  }

  void aRobotWithoutSubmapsSaysSo() {
    QFile yaml(program_.path("map.yaml"));
    QVERIFY(yaml.open(QIODevice::WriteOnly));
    yaml.write(
        "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
        "negate: 0\n");
    yaml.close();
    QFile pgm(program_.path("map.pgm"));
    QVERIFY(pgm.open(QIODevice::WriteOnly));
    pgm.write("P5\n2 1\n255\n\xfe\x01");
    pgm.close();
    const Outcome ended = run("slam disagreement --robot map.yaml");
    QVERIFY(ended.code == 2 || ended.code == 4);
    QVERIFY2(ended.err.contains(QStringLiteral("submaps")), qPrintable(ended.err));
  }

  void recordedSubmapsAreComparedAtATime() {
    QCOMPARE(run("record --robot DEMO -o run.mcap --duration 2").code, 0);
    const Outcome ended = run("slam coverage --bag run.mcap --at -0 --json");
    QCOMPARE(ended.code, 0);
    QVERIFY(ended.object()[QStringLiteral("seen_cells")].toInt() > 10'000);
    QCOMPARE(run("slam coverage --bag run.mcap").code, 2);
    const Outcome over = run("slam coverage --bag run.mcap --at -0 --csv run.mcap");
    QCOMPARE(over.code, 2);
    QVERIFY2(!over.err.contains(QStringLiteral("--force")), qPrintable(over.err));
    QCOMPARE(run("slam coverage --bag run.mcap --at -0 --json").code, 0);  // it is still there
  }

  void missingSubmapsAreTold() {
    QProcess robot;
    robot.setProcessEnvironment(program_.environment());
    robot.start(QStringLiteral(MAPWRIGHT_PROGRAM),
                {QStringLiteral("simulate"), QStringLiteral("--submaps"), QStringLiteral("20"),
                 QStringLiteral("--wrong-size-rate"), QStringLiteral("0.3")});
    QVERIFY(QTest::qWaitFor([&] { return robot.canReadLine(); }, 60'000));
    const QString address =
        QJsonDocument::fromJson(robot.readLine()).object()[QStringLiteral("axbot")].toString();
    const Outcome ended = program_.run({QStringLiteral("slam"), QStringLiteral("disagreement"),
                                        QStringLiteral("--robot"), address, QStringLiteral("--json"),
                                        QStringLiteral("--fail-over"), QStringLiteral("0.9")});
    QCOMPARE(ended.code, 1);
    QVERIFY2(ended.err.startsWith(QStringLiteral("Incomplete.")), qPrintable(ended.err));
    QCOMPARE(ended.object()[QStringLiteral("complete")].toBool(true), false);
    QVERIFY(!ended.object()[QStringLiteral("warnings")].toArray().isEmpty());
    QVERIFY(ended.object()[QStringLiteral("occupied_cells")].toInt() > 0);
    robot.terminate();
    robot.waitForFinished();
  }
};

}  // namespace test_slam_agreement

MAPWRIGHT_TEST(test_slam_agreement, SlamAgreementTest, Core)
#include "test_slam_agreement.moc"
