// `maps set-pose`, `locate`, `download`, `upload`, `create` and the mapping that is extended or cancelled:
// what a script sees of what was done, was not, or may have been, and that this is what the robot holds.
#include <cmath>

#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QLockFile>
#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_map_moves {

using namespace mapwright;
using tests::Ended;

class MapMovesTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  Ended run(const simulator::Simulator& robot, const QStringList& words) const {
    return program_.run(QStringList{QStringLiteral("maps")} + words +
                        QStringList{QStringLiteral("--robot"), QString::fromStdString(robot.address())});
  }
  static int changesIn(const simulator::Simulator& robot) {
    int changes = 0;
    for (const auto& record : robot.requestLog()) changes += record.method == "GET" ? 0 : 1;
    return changes;
  }
  static simulator::Options paused(const simulator::Faults& faults = {}) {
    simulator::Options options;
    options.paused = true;
    options.pose_hz = 20;
    options.faults = faults;
    return options;
  }
  QStringList setPose(const char* at) const {
    return {QStringLiteral("set-pose"), QStringLiteral("--at"), QString::fromLatin1(at)};
  }
  QStringList download(const char* id, const char* folder) const {
    return {QStringLiteral("download"), QString::fromLatin1(id), QStringLiteral("-o"), program_.path(folder)};
  }
  static QByteArray pngOf(int width, int height) {
    QImage image(width, height, QImage::Format_Grayscale8);
    image.fill(255);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return png;
  }
  QStringList create(const char* image, const char* resolution, const char* origin) const {
    return {QStringLiteral("create"),   QStringLiteral("Hall 🏭"),       QStringLiteral("--image"),
            program_.path(image),       QStringLiteral("--resolution"), QString::fromLatin1(resolution),
            QStringLiteral("--origin"), QString::fromLatin1(origin)};
  }

 private Q_SLOTS:
  void aPoseIsSetAndReadBack() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const Ended set = run(robot, setPose("5,-3,90") + QStringList{QStringLiteral("--json")});
    QVERIFY2(set.code == 0, qPrintable(set.err));
    const QJsonObject json = set.object();
    QVERIFY(json[QLatin1String("as_set")].toBool());
    QVERIFY(json[QLatin1String("distance")].toDouble() < 0.01);
    QVERIFY(std::abs(json[QLatin1String("now")].toObject()[QLatin1String("x")].toDouble() - 5) < 0.01);
    const Ended words = run(robot, setPose("5,-3,90"));
    QVERIFY2(words.out.contains(QStringLiteral("x 5.00 m, y -3.00 m, 90.0°: 0.00 m")), qPrintable(words.out));
    QCOMPARE(changesIn(robot), 2);
  }

  void whatIsNoPoseIsNotSent() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    for (const char* at : {"1,2", "1,2,3,4", "a,b,c", "1,2,nan", "1e7,0,0"})
      QVERIFY2(run(robot, setPose(at)).code == 2, at);
    QCOMPARE(changesIn(robot), 0);
  }

  void aPoseThatWasNotSetIsNotClaimed_data() {
    QTest::addColumn<QString>("fault");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    QTest::newRow("ignored") << QStringLiteral("ignore") << 4 << QStringLiteral("still where it was before");
    QTest::newRow("dropped") << QStringLiteral("drop") << 1 << QStringLiteral("is unknown");
    QTest::newRow("lost") << QStringLiteral("lose") << 0 << QString();
    QTest::newRow("refused") << QStringLiteral("error") << 1 << QStringLiteral("is unknown");
  }
  void aPoseThatWasNotSetIsNotClaimed() {
    QFETCH(QString, fault);
    QFETCH(int, code);
    QFETCH(QString, says);
    simulator::Faults faults;
    const auto fails = [&](simulator::FaultKind kind) {
      faults.requests.push_back({kind, simulator::kWrites, 1, 0, "/chassis/pose"});
    };
    if (fault == QLatin1String("ignore")) fails(simulator::FaultKind::Ignore);
    if (fault == QLatin1String("drop")) fails(simulator::FaultKind::Drop);
    if (fault == QLatin1String("lose")) fails(simulator::FaultKind::Cut);
    if (fault == QLatin1String("error")) fails(simulator::FaultKind::Refuse);
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    const Ended set = run(robot, setPose("500,-3,90"));
    QVERIFY2(set.code == code, qPrintable(set.out + set.err));
    QVERIFY2(set.err.contains(says), qPrintable(set.err));
    QCOMPARE(changesIn(robot), 1);
  }

  void aRobotThatLooksForItselfMayAsk() {
    for (const bool asks : {false, true}) {
      simulator::Options options;
      options.positioning_asks = asks;
      simulator::Simulator robot(options);
      QVERIFY(!robot.start());
      // It drives on: how far it has come when it is looked at does not matter here.
      QVERIFY(run(robot, setPose("500,-3,90")).code <= 1);
      const Ended found = run(robot, {QStringLiteral("locate")});
      QVERIFY2(found.code == (asks ? 1 : 0), qPrintable(found.out + found.err));
      QVERIFY2((asks ? found.err : found.out)
                   .contains(asks ? QStringLiteral("maps set-pose --at") : QStringLiteral("found itself at")),
               qPrintable(found.out + found.err));
    }
  }

  void aMapIsDownloadedWholeAndUploadedToAnotherRobot() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const Ended got = run(robot, download("2", "two") + QStringList{QStringLiteral("--json")});
    QVERIFY2(got.code == 0, qPrintable(got.err));
    QVERIFY(got.object()[QLatin1String("data")].toBool() && !got.object()[QLatin1String("resumed")].toBool());
    const QDir folder(program_.path("two"));
    QCOMPARE(folder.entryList(QDir::Files, QDir::Name),
             (QStringList{QStringLiteral("map.json"), QStringLiteral("map.pbstream"),
                          QStringLiteral("map.png"), QStringLiteral("overlays.geojson")}));
    // There already: on the disk, and on the robot.
    QCOMPARE(run(robot, download("2", "two")).code, 2);
    const QStringList upload{QStringLiteral("upload"), program_.path("two")};
    const Ended same = run(robot, upload);
    QVERIFY2(same.code == 4 && same.err.contains(QStringLiteral("already has this map")),
             qPrintable(same.err));
    QVERIFY2(same.err.contains(QStringLiteral("--as-new")), qPrintable(same.err));
    QCOMPARE(changesIn(robot), 0);
    simulator::Simulator other(paused());
    QVERIFY(!other.start());
    const Ended gone = run(other, {QStringLiteral("delete"), QStringLiteral("2"), QStringLiteral("--yes")});
    QVERIFY2(gone.code == 0, qPrintable(gone.out + gone.err));
    const Ended put = run(other, upload + QStringList{QStringLiteral("--json")});
    QVERIFY2(put.code == 0 && put.object()[QLatin1String("as_sent")].toBool(), qPrintable(put.err));
    const QString id = put.object()[QLatin1String("id")].toString();
    const Ended again = run(other, download(id.toLatin1().constData(), "again"));
    QVERIFY2(again.code == 0, qPrintable(again.err));
    for (const char* file : {"map.png", "map.pbstream", "overlays.geojson"})
      QCOMPARE(program_.bytes(qPrintable(QStringLiteral("again/") + QLatin1String(file))),
               program_.bytes(qPrintable(QStringLiteral("two/") + QLatin1String(file))));
    const QStringList copy =
        upload + QStringList{QStringLiteral("--as-new"), QStringLiteral("--name"), QStringLiteral("Copy")};
    QVERIFY(run(robot, copy).code == 0);
    const Ended twice = run(robot, copy);
    QVERIFY2(twice.code == 0 && twice.err.contains(QStringLiteral("Another map has this name")),
             qPrintable(twice.err));
  }

  void aDownloadThatIsCutGoesOnUnlessTheMapHasChanged() {
    for (const bool changes : {false, true}) {
      const char* const name = changes ? "changed" : "cut";
      simulator::Faults faults;
      faults.requests.push_back({simulator::FaultKind::Truncate, simulator::kDownloads});
      simulator::Simulator robot(paused(faults));
      QVERIFY(!robot.start());
      const Ended cut = run(robot, download("1", name));
      QVERIFY2(cut.code == 3, qPrintable(cut.err));
      const QString part = QLatin1String(name) + QStringLiteral("/map.pbstream.part");
      QVERIFY(program_.bytes(qPrintable(part)).size() > 0);
      QVERIFY(
          !QFile::exists(program_.path(qPrintable(QLatin1String(name) + QStringLiteral("/map.pbstream")))));
      // A part is not taken for a map.
      const Ended early = run(robot, {QStringLiteral("upload"), program_.path(name)});
      QVERIFY2(early.code == 2 && early.err.contains(QStringLiteral("not finished")), qPrintable(early.err));
      robot.setFaults({});
      if (changes) robot.publishMapChange();
      const Ended rest = run(robot, download("1", name) + QStringList{QStringLiteral("--json")});
      QVERIFY2(rest.code == 0, qPrintable(rest.err));
      QCOMPARE(rest.object()[QLatin1String("resumed")].toBool(), !changes);
      QVERIFY(!QFile::exists(program_.path(qPrintable(part))));
      const QByteArray fresh_name = QByteArray(name) + "-fresh";
      QVERIFY(run(robot, download("1", fresh_name.constData())).code == 0);
      QCOMPARE(program_.bytes(qPrintable(QLatin1String(name) + QStringLiteral("/map.pbstream"))),
               program_.bytes((fresh_name + "/map.pbstream").constData()));
    }
  }

  void aFileThatIsDamagedIsNotUploaded() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    QVERIFY(run(robot, download("7", "seven")).code == 0);
    QByteArray data = program_.bytes("seven/map.pbstream");
    data[100] = char(data[100] ^ 1);
    program_.put("seven/map.pbstream", data);
    const Ended put = run(robot, {QStringLiteral("upload"), program_.path("seven")});
    QVERIFY2(put.code == 2 && put.err.contains(QStringLiteral("checksum")), qPrintable(put.err));
    QCOMPARE(changesIn(robot), 0);
  }

  void aMapIsMadeOfAPicture() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    program_.put("hall.png", pngOf(60, 40));
    const Ended made =
        run(robot, create("hall.png", "0.05", "-1.5,2") + QStringList{QStringLiteral("--json")});
    QVERIFY2(made.code == 0 && made.object()[QLatin1String("as_sent")].toBool(), qPrintable(made.err));
    const Ended shown = run(robot, {QStringLiteral("show"), made.object()[QLatin1String("id")].toString(),
                                    QStringLiteral("--json")});
    const QJsonObject grid = shown.object()[QLatin1String("grid")].toObject();
    QCOMPARE(grid[QLatin1String("size")].toArray(), (QJsonArray{60, 40}));
    QCOMPARE(grid[QLatin1String("resolution")].toDouble(), 0.05);
  }

  void whatCannotBeAMapIsNotSent() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const QByteArray png = pngOf(60, 40);
    program_.put("good.png", png);
    program_.put("cut.png", png.left(png.size() / 2));
    program_.put("no.png", "no picture");
    program_.put("wide.png", pngOf(20'001, 1));
    for (const char* image : {"cut.png", "no.png", "wide.png", "missing.png"}) {
      const Ended made = run(robot, create(image, "0.05", "0,0"));
      QVERIFY2(made.code == 2 && made.err.count(QLatin1Char('\n')) == 1, qPrintable(made.err));
      QVERIFY2(!made.err.contains(QStringLiteral("shown")), qPrintable(made.err));
    }
    for (const char* resolution : {"0", "-0.05", "0.0001", "50", "nan"})
      QVERIFY2(run(robot, create("good.png", resolution, "0,0")).code == 2, resolution);
    for (const char* origin : {"0", "1,2,3", "1e9,0", "a,b"})
      QVERIFY2(run(robot, create("good.png", "0.05", origin)).code == 2, origin);
    QCOMPARE(changesIn(robot), 0);
  }

  void filesOfOthersStayWhereAMapIsDownloaded() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    QVERIFY(QDir(program_.folder()).mkdir(QStringLiteral("mine")));
    program_.put("mine/map.png", "a picture of mine");
    const Ended refused = run(robot, download("2", "mine"));
    QVERIFY2(refused.code == 2 && refused.err.contains(QStringLiteral("map.png")), qPrintable(refused.err));
    QCOMPARE(program_.bytes("mine/map.png"), QByteArray("a picture of mine"));
    QVERIFY(QDir(program_.folder()).mkdir(QStringLiteral("used")));
    QLockFile other(program_.path("used/map.lock"));
    QVERIFY(other.lock());
    const Ended busy = run(robot, download("2", "used"));
    QVERIFY2(busy.code == 2 && busy.err.contains(QStringLiteral("under way")), qPrintable(busy.err));
    program_.put("file", "no folder");
    const Ended no_folder = run(robot, download("2", "file"));
    QVERIFY2(no_folder.code == 2 && !no_folder.err.contains(QStringLiteral("--force")),
             qPrintable(no_folder.err));
  }

  void whatAListThatCannotBeReadDoesNotShowIsNotConcluded() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    QCOMPARE(run(robot, download("2", "kept")).code, 0);
    QCOMPARE(run(robot, {QStringLiteral("start-mapping")}).code, 0);  // mappings are listed
    QCOMPARE(run(robot, {QStringLiteral("stop-mapping")}).code, 0);
    const int before = changesIn(robot);
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kMapList, 1, 500});
    faults.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    robot.setFaults(faults);
    // The map may be there already.
    QVERIFY(run(robot, {QStringLiteral("upload"), program_.path("kept")}).code != 0);
    QCOMPARE(changesIn(robot), before);
    const Ended deleted =
        run(robot, {QStringLiteral("delete"), QStringLiteral("7"), QStringLiteral("--yes")});
    // Only what the robot lists is deleted.
    QVERIFY2(deleted.code != 0 && deleted.err.contains(QStringLiteral("was not changed")),
             qPrintable(deleted.err));
    QCOMPARE(changesIn(robot), before);
  }

  void aMapThatWasNotAddedIsNotClaimed_data() { aPoseThatWasNotSetIsNotClaimed_data(); }
  void aMapThatWasNotAddedIsNotClaimed() {
    QFETCH(QString, fault);
    simulator::Faults faults;
    if (fault == QLatin1String("ignore"))
      faults.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    if (fault == QLatin1String("drop"))
      faults.requests.push_back({simulator::FaultKind::Drop, simulator::kWrites});
    if (fault == QLatin1String("lose"))
      faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    if (fault == QLatin1String("error"))
      faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kWrites});
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    program_.put("hall.png", pngOf(60, 40));
    const Ended made = run(robot, create("hall.png", "0.05", "0,0"));
    const bool there = run(robot, {QStringLiteral("list")}).out.contains(QStringLiteral("Hall"));
    QCOMPARE(there, fault == QLatin1String("lose"));
    const int code = fault == QLatin1String("lose") ? 0 : fault == QLatin1String("ignore") ? 4 : 1;
    QVERIFY2(made.code == code, qPrintable(made.err));
    QCOMPARE(changesIn(robot), 1);
  }

  void aMappingIsExtendedAndCancelled() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const QStringList stop{QStringLiteral("stop-mapping")};
    QCOMPARE(run(robot, stop + QStringList{QStringLiteral("--cancel")}).code, 4);
    QCOMPARE(run(robot, {QStringLiteral("start-mapping"), QStringLiteral("--continue")}).code, 0);
    QCOMPARE(run(robot, stop + QStringList{QStringLiteral("--cancel")}).code, 0);
    const QString list = run(robot, {QStringLiteral("list")}).out;
    QVERIFY2(list.contains(QStringLiteral("cancelled")), qPrintable(list));
    // It is named, so that its result can be looked at.
    const Ended started = run(robot, {QStringLiteral("start-mapping")});
    QVERIFY2(started.out.contains(QStringLiteral("mapping:")), qPrintable(started.out));
    QCOMPARE(run(robot, stop).out.section(QLatin1Char(' '), 0, 0),
             started.out.section(QLatin1Char(' '), 0, 0));
  }

  void thatNothingIsMappedIsNoSuccessOfStopping() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    QVERIFY(run(robot, {QStringLiteral("stop-mapping")}).code != 0);
  }

  void aMappingThatGoesOnIsNotSaidToHaveEnded() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    QCOMPARE(run(robot, {QStringLiteral("start-mapping")}).code, 0);
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    robot.setFaults(faults);
    for (const QStringList& words :
         {QStringList{QStringLiteral("stop-mapping")},
          QStringList{QStringLiteral("stop-mapping"), QStringLiteral("--cancel")}}) {
      const Ended ended = run(robot, words);
      QVERIFY2(ended.code == 4 && ended.err.contains(QStringLiteral("still mapping")), qPrintable(ended.err));
    }
  }

  /// The interface deletes everything on a DELETE without an id.
  void anIdThatIsNoneIsRefusedBeforeItIsPartOfAnAddress_data() {
    QTest::addColumn<QStringList>("words");
    QTest::newRow("show") << QStringList{QStringLiteral("show"), QStringLiteral("ID")};
    QTest::newRow("export") << QStringList{QStringLiteral("export"), QStringLiteral("ID"),
                                           QStringLiteral("-o"), program_.path("x.png")};
    QTest::newRow("rename") << QStringList{QStringLiteral("rename"), QStringLiteral("ID"),
                                           QStringLiteral("x")};
    QTest::newRow("load") << QStringList{QStringLiteral("load"), QStringLiteral("ID")};
    QTest::newRow("delete") << QStringList{QStringLiteral("delete"), QStringLiteral("ID"),
                                           QStringLiteral("--yes")};
    QTest::newRow("download") << QStringList{QStringLiteral("download"), QStringLiteral("ID"),
                                             QStringLiteral("-o"), program_.path("none")};
  }
  void anIdThatIsNoneIsRefusedBeforeItIsPartOfAnAddress() {
    QFETCH(QStringList, words);
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    for (const char* id : {"", ".", "..", "/", "%2f", "1?x", "1/", "mapping:", "mapping:.."}) {
      QStringList typed = words;
      typed[1] = QString::fromLatin1(id);
      const Ended refused = run(robot, typed);
      QVERIFY2(refused.code == 2, qPrintable(QString::fromLatin1(id) + refused.out + refused.err));
    }
    for (const auto& record : robot.requestLog()) {
      const std::string& target = record.target;
      const bool of_one = target.starts_with("/maps/") && target.size() > 6;
      QVERIFY2(record.method == "GET" && !of_one, target.c_str());
    }
  }
};

}  // namespace test_map_moves

MAPWRIGHT_TEST(test_map_moves, MapMovesTest, Core)
#include "test_map_moves.moc"
