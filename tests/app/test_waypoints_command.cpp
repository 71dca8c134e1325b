// `mapwright waypoints …` on a folder of maps: what a script sees, and what lies on the disk afterwards.
#include <cmath>
#include <memory>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_waypoints_command {

using namespace mapwright;

namespace {

using Outcome = tests::Ended;

const char* const kTwo = R"({"type": "FeatureCollection", "features": [
  {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1, 2]},
   "properties": {"id": "w1", "name": "Door", "yaw_rad": 0.5, "tags": ["a"], "mine": "stays"}},
  {"type": "Feature", "geometry": {"type": "Point", "coordinates": [3, 4]},
   "properties": {"id": "w2", "name": "Dock"}}
]}
)";

}  // namespace

class WaypointsCommandTest : public QObject {
  Q_OBJECT
  std::unique_ptr<tests::Program> program_;

  Outcome run(const QStringList& words, const QByteArray& input = {}) const {
    return program_->run(QStringList{QStringLiteral("waypoints")} + words, input);
  }
  /// Words that hold no blank, on hall.yaml.
  Outcome at(const QString& line) const {
    return run(line.split(QLatin1Char(' ')) +
               QStringList{QStringLiteral("--robot"), QStringLiteral("hall.yaml")});
  }
  QByteArray read(const char* name) const {
    QFile file(program_->path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("there is none");
  }
  void put(const char* name, const QByteArray& bytes) const { program_->put(name, bytes); }
  QByteArray kept() const { return read("hall.waypoints.geojson"); }
  void putMap(const char* name) const {
    put(qPrintable(QLatin1String(name) + QStringLiteral(".pgm")), "P5\n4 4\n255\n" + QByteArray(16, '\xfe'));
    put(qPrintable(QLatin1String(name) + QStringLiteral(".yaml")),
        "image: " + QByteArray(name) +
            ".pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
            "free_thresh: 0.25\n");
  }
  static QStringList namesOf(const QJsonArray& rows) {
    QStringList names;
    for (const QJsonValue& row : rows) names << row.toObject()[QStringLiteral("name")].toString();
    return names;
  }

  /// 4 m x 3 m at 5 cm: free, a wall of 25 cm along its left edge, a corner that nobody knows.
  void putHall() const {
    QByteArray cells;
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 80; ++x) cells += x < 5 ? '\x00' : x > 70 && y < 10 ? '\x80' : '\xfe';
    }
    put("hall.pgm", "P5\n80 60\n255\n" + cells);
    put("many.csv",
        "id,name,x,y\nin,In,0.1,1\nout,Out,9,9\nnear,Near,0.35,1\nfree,Free,2,1\none,Twin,2.5,1\n"
        "two,Twin,3,1\ndark,Dark,3.9,2.9\n");
    QFile::remove(program_->path(QStringLiteral("hall.waypoints.geojson")));
    QCOMPARE(at(QStringLiteral("import many.csv")).code, 0);
  }
  static QMap<QString, QStringList> kindsOf(const QJsonArray& rows) {
    QMap<QString, QStringList> kinds;
    for (const QJsonValue& row : rows) {
      QStringList& of = kinds[row[QStringLiteral("name")].toString()];
      for (const QJsonValue& warning : row[QStringLiteral("warnings")].toArray())
        of << warning[QStringLiteral("kind")].toString();
    }
    return kinds;
  }

 private Q_SLOTS:
  void init() {
    program_ = std::make_unique<tests::Program>();
    putMap("hall");
    put("hall.waypoints.geojson", kTwo);
  }

  void aListIsInTheStableShape() {
    const Outcome list = at(QStringLiteral("list --json"));
    QVERIFY2(list.code == 0 && list.err.isEmpty(), qPrintable(list.err));
    const QJsonArray rows = list.array();
    QCOMPARE(rows.size(), 2);
    const QJsonObject door = rows[0].toObject();
    const QStringList members{QStringLiteral("frame"), QStringLiteral("id"),     QStringLiteral("map"),
                              QStringLiteral("name"),  QStringLiteral("tags"),   QStringLiteral("x"),
                              QStringLiteral("y"),     QStringLiteral("yaw_rad")};
    QCOMPARE(door.keys(), members);
    QCOMPARE(door[QStringLiteral("id")].toString(), QStringLiteral("w1"));
    QCOMPARE(door[QStringLiteral("x")].toDouble(), 1.0);
    QCOMPARE(door[QStringLiteral("yaw_rad")].toDouble(), 0.5);
    QCOMPARE(door[QStringLiteral("tags")].toArray(), QJsonArray{QStringLiteral("a")});
    QVERIFY(rows[1].toObject()[QStringLiteral("yaw_rad")].isNull());
    QVERIFY(at(QStringLiteral("list")).out.contains(QStringLiteral("Dock")));
    QFile::remove(program_->path(QStringLiteral("hall.waypoints.geojson")));
    QCOMPARE(at(QStringLiteral("list --json")).array().size(), 0);
    QCOMPARE(at(QStringLiteral("list")).code, 0);
  }

  void whatIsDoubtfulIsToldBesideEach() {
    putHall();
    const Outcome list = at(QStringLiteral("list --warnings --json"));
    QVERIFY2(list.code == 0 && list.err.isEmpty(), qPrintable(list.err));
    const auto kinds = kindsOf(list.array());
    const auto is = [&](const char* name, const QStringList& wanted) {
      return kinds[QLatin1String(name)] == wanted;
    };
    QVERIFY(is("In", {QStringLiteral("in_wall")}));
    QVERIFY(is("Out", {QStringLiteral("outside_map")}));
    QVERIFY(is("Near", {QStringLiteral("near_wall")}));  // closer than the usual 30 cm
    QVERIFY(is("Free", {}));
    QVERIFY(is("Twin", {QStringLiteral("name_twice"), QStringLiteral("name_twice")}));
    QVERIFY(is("Dark", {QStringLiteral("on_unknown")}));
    for (const QJsonValue& row : list.array()) {
      if (row[QStringLiteral("name")] != QStringLiteral("Near")) continue;
      const QJsonObject near = row[QStringLiteral("warnings")].toArray().first().toObject();
      QVERIFY(std::abs(near[QStringLiteral("distance_m")].toDouble() - 0.1) < 0.001);
      QCOMPARE(near[QStringLiteral("radius_m")].toDouble(), 0.3);
      QVERIFY(near[QStringLiteral("sentence")].toString().contains(QStringLiteral("0.10 m from a wall")));
    }
    QVERIFY(
        kindsOf(at(QStringLiteral("list --warnings --json --radius 0.05")).array())[QStringLiteral("Near")]
            .isEmpty());
    const Outcome table = at(QStringLiteral("list --warnings"));
    QVERIFY(table.code == 0 && table.out.contains(QStringLiteral("WARNINGS")) &&
            table.out.contains(QStringLiteral("It is in a wall.")));
    QVERIFY(
        !at(QStringLiteral("list --json")).array().first().toObject().contains(QStringLiteral("warnings")));
    for (const char* word : {"-1", "11", "far", "nan"})
      QCOMPARE(at(QStringLiteral("list --warnings --radius %1").arg(QLatin1String(word))).code, 2);
  }

  void withoutItsMapTheRestIsDoubtfulAllTheSame() {
    putHall();
    put("hall.pgm", "no picture");
    const Outcome list = at(QStringLiteral("list --warnings --json"));
    QCOMPARE(list.code, 1);
    QVERIFY2(list.err.contains(QStringLiteral("Picture hall.pgm")), qPrintable(list.err));
    const auto kinds = kindsOf(list.array());
    QVERIFY(kinds[QStringLiteral("In")].isEmpty());
    QCOMPARE(kinds[QStringLiteral("Twin")].size(), 2);
  }

  void aPlanTellsWhatWillBeDoubtful() {
    putHall();
    put("wanted.csv", "id,name,x,y\nin,In,1,1\nfree,Free,0.1,1\n,New,8,1\n");
    const Outcome plan = at(QStringLiteral("plan wanted.csv --json"));
    QVERIFY2(plan.code == 0, qPrintable(plan.err));
    const auto kinds = kindsOf(plan.object()[QStringLiteral("warnings")].toArray());
    QCOMPARE(kinds.keys(), (QStringList{QStringLiteral("Free"), QStringLiteral("New")}));
    QCOMPARE(kinds[QStringLiteral("Free")], QStringList{QStringLiteral("in_wall")});
    QCOMPARE(kinds[QStringLiteral("New")], QStringList{QStringLiteral("outside_map")});
    const Outcome table = at(QStringLiteral("plan wanted.csv"));
    QVERIFY(table.code == 0 && table.out.contains(QStringLiteral("It is outside the map.")));
  }

  void oneIsToldByItsIdOrItsName() {
    QCOMPARE(at(QStringLiteral("get w2 --json")).object()[QStringLiteral("name")].toString(),
             QStringLiteral("Dock"));
    QCOMPARE(at(QStringLiteral("get Dock --json")).object()[QStringLiteral("id")].toString(),
             QStringLiteral("w2"));
    QCOMPARE(at(QStringLiteral("rename w1 Dock")).code, 0);
    const Outcome twice = at(QStringLiteral("get Dock"));
    QCOMPARE(twice.code, 2);
    QVERIFY2(twice.err.contains(QStringLiteral("w1, w2")), qPrintable(twice.err));
    const Outcome none = at(QStringLiteral("get Nowhere"));
    QVERIFY2(none.code == 4 && none.err.count(QLatin1Char('\n')) == 1, qPrintable(none.err));
  }

  void oneIsCreatedChangedAndDeleted() {
    const Outcome made =
        run({QStringLiteral("create"), QStringLiteral("Tür \"1\"\u202e"), QStringLiteral("--at"),
             QStringLiteral("-1.5,2,90"), QStringLiteral("--tags"), QStringLiteral("a,\"b,c\""),
             QStringLiteral("--json"), QStringLiteral("--robot"), QStringLiteral("hall.yaml")});
    QVERIFY2(made.code == 0, qPrintable(made.err));
    const QString id = made.object()[QStringLiteral("id")].toString();
    QVERIFY(!id.isEmpty());
    QCOMPARE(made.object()[QStringLiteral("name")].toString(), QStringLiteral("Tür \"1\"\u202e"));
    QVERIFY(std::abs(made.object()[QStringLiteral("yaw_rad")].toDouble() - 1.5707963) < 1e-6);
    QCOMPARE(made.object()[QStringLiteral("tags")].toArray(),
             (QJsonArray{QStringLiteral("a"), QStringLiteral("b,c")}));
    // Of the terminal no name takes control.
    QVERIFY(!at(QStringLiteral("list")).out.contains(QChar(0x202e)));
    QVERIFY(!at(QStringLiteral("list --json")).out.contains(QChar(0x202e)));

    const Outcome renamed = at(QStringLiteral("rename %1 Gate").arg(id));
    QCOMPARE(renamed.out, QStringLiteral("%1  Gate\n").arg(id));
    const QJsonObject moved = at(QStringLiteral("move Gate --at 7,8 --json")).object();
    QCOMPARE(moved[QStringLiteral("x")].toDouble(), 7.0);
    QVERIFY(moved[QStringLiteral("yaw_rad")].toDouble() > 1.5);  // it stays turned
    const QJsonObject tagged = at(QStringLiteral("tag Gate --add c --remove a --json")).object();
    QCOMPARE(tagged[QStringLiteral("tags")].toArray(),
             (QJsonArray{QStringLiteral("b,c"), QStringLiteral("c")}));
    QVERIFY(
        at(QStringLiteral("tag Gate --clear --json")).object()[QStringLiteral("tags")].toArray().isEmpty());
    QVERIFY(kept().contains("stays"));  // what is not understood is not lost
    QCOMPARE(at(QStringLiteral("delete Gate w2 --yes")).code, 0);
    QCOMPARE(namesOf(at(QStringLiteral("list --json")).array()), QStringList{QStringLiteral("Door")});
  }

  void whatMakesNoSenseIsRefusedAndNothingIsWritten_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("code");
    for (const auto& [line, code] : {std::pair{"create New --at 1", 2},
                                     {"create New --at nan,2", 2},
                                     {"create New --at 1,2,3,4", 2},
                                     {"create New --at 1e9,2", 2},
                                     {"create New --at 1,2 --tags a,\"", 2},
                                     {"move w1 --at x,y", 2},
                                     {"tag w1", 2},
                                     {"tag w1 --set a --add b", 2},
                                     {"tag w1 --add a --remove a", 2},
                                     {"delete w1", 2},
                                     {"delete nobody --yes", 4},
                                     {"rename nobody New", 4},
                                     {"rename w1", 2},
                                     {"list --map other.yaml", 2},
                                     {"import nothing.csv", 2},
                                     {"import hall.pgm", 2},
                                     {"plan nothing.csv", 2},
                                     {"apply nothing.json", 2},
                                     {"apply hall.waypoints.geojson", 2},
                                     {"export -o hall.txt", 2},
                                     {"list --timeout 0", 2},
                                     {"delete w1 --yes --go-on --stop-at-failure", 2}}) {
      QTest::newRow(line) << QString::fromLatin1(line) << code;
    }
  }
  void whatMakesNoSenseIsRefusedAndNothingIsWritten() {
    QFETCH(QString, line);
    QFETCH(int, code);
    const Outcome outcome = at(line);
    QVERIFY2(outcome.code == code && outcome.out.isEmpty(), qPrintable(outcome.err));
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
    QCOMPARE(kept(), QByteArray(kTwo));
  }

  void aNameIsOneLineOfText() {
    for (const char* name : {"  ", "two\nlines", "\x1b[31mred"}) {
      const Outcome outcome = run({QStringLiteral("rename"), QStringLiteral("w1"), QString::fromUtf8(name),
                                   QStringLiteral("--robot"), QStringLiteral("hall.yaml")});
      QVERIFY2(outcome.code == 2 && outcome.err.count(QLatin1Char('\n')) == 1, qPrintable(outcome.err));
    }
    QCOMPARE(kept(), QByteArray(kTwo));
  }

  void aDryRunSendsNothing() {
    const Outcome preview = at(QStringLiteral("move Door --at 5,6 --dry-run --json"));
    QVERIFY2(preview.code == 0, qPrintable(preview.err));
    const QJsonObject change = preview.object()[QStringLiteral("changes")].toArray().first().toObject();
    QCOMPARE(change[QStringLiteral("kind")].toString(), QStringLiteral("move"));
    QCOMPARE(change[QStringLiteral("id")].toString(), QStringLiteral("w1"));
    QCOMPARE(preview.object()[QStringLiteral("calls")].toArray().size(), 1);
    QVERIFY(preview.object()[QStringLiteral("conflicts")].toArray().isEmpty());
    QCOMPARE(at(QStringLiteral("create New --at 5,6 --dry-run")).code, 0);
    QCOMPARE(at(QStringLiteral("delete w1 --dry-run")).code, 0);
    QCOMPARE(kept(), QByteArray(kTwo));
  }

  void whatIsExportedIsImportedElsewhere() {
    putMap("copy");
    for (const char* name : {"out.csv", "out.geojson"}) {
      QFile::remove(program_->path(QStringLiteral("copy.waypoints.geojson")));
      const QString file = QLatin1String(name);
      QCOMPARE(at(QStringLiteral("export -o %1").arg(file)).code, 0);
      const Outcome imported = run({QStringLiteral("import"), file, QStringLiteral("--json"),
                                    QStringLiteral("--robot"), QStringLiteral("copy.yaml")});
      QVERIFY2(imported.code == 0, qPrintable(imported.err));
      QCOMPARE(imported.object()[QStringLiteral("applied")].toInt(), 2);
      QVERIFY(imported.object()[QStringLiteral("complete")].toBool());
      const Outcome copy = run({QStringLiteral("list"), QStringLiteral("--json"), QStringLiteral("--robot"),
                                QStringLiteral("copy.yaml")});
      QCOMPARE(copy.array(), at(QStringLiteral("list --json")).array());
      const Outcome again =
          run({QStringLiteral("import"), file, QStringLiteral("--robot"), QStringLiteral("copy.yaml")});
      QVERIFY2(again.code == 0 && again.out.contains(QStringLiteral("nothing to change")),
               qPrintable(again.out));
    }
    QVERIFY(at(QStringLiteral("export -o - --format csv")).out.startsWith(QStringLiteral("id,name,x,y,")));
    QVERIFY(at(QStringLiteral("export -o -")).object().contains(QStringLiteral("features")));
  }

  void anExportDoesNotReplaceWhatItIsReadFrom() {
    const Outcome refused = at(QStringLiteral("export -o hall.waypoints.geojson"));
    QVERIFY2(refused.code == 2 && refused.err.contains(QStringLiteral("--force")), qPrintable(refused.err));
    QCOMPARE(kept(), QByteArray(kTwo));
    QCOMPARE(at(QStringLiteral("export -o hall.waypoints.geojson --force")).code, 0);
    QVERIFY(kept() != QByteArray(kTwo));
    QCOMPARE(at(QStringLiteral("list --json")).array().size(), 2);
  }

  void aPlanIsMadeAndApplied() {
    put("wanted.csv", "id,name,x,y\nw1,Gate,1,2\n,New,9,9\n");
    const Outcome planned = at(QStringLiteral("plan wanted.csv -o plan.json --force"));
    QVERIFY2(planned.code == 0, qPrintable(planned.err));
    QVERIFY(planned.out.contains(QStringLiteral("rename")) && planned.out.contains(QStringLiteral("Dock")));
    QCOMPARE(kept(), QByteArray(kTwo));
    const QJsonObject told = at(QStringLiteral("plan wanted.csv --json")).object();
    QStringList kinds;
    for (const QJsonValue& change : told[QStringLiteral("changes")].toArray())
      kinds << change.toObject()[QStringLiteral("kind")].toString();
    kinds.sort();
    QCOMPARE(kinds,
             (QStringList{QStringLiteral("create"), QStringLiteral("delete"), QStringLiteral("rename")}));

    // Somebody turns the door meanwhile: that goes together.
    QCOMPARE(at(QStringLiteral("tag w1 --set b")).code, 0);
    const Outcome applied = at(QStringLiteral("apply plan.json --json"));
    QVERIFY2(applied.code == 0, qPrintable(applied.err));
    QCOMPARE(applied.object()[QStringLiteral("applied")].toInt(), 3);
    QVERIFY(applied.object()[QStringLiteral("complete")].toBool());
    const QJsonArray rows = at(QStringLiteral("list --json")).array();
    QStringList names = namesOf(rows);
    names.sort();
    QCOMPARE(names, (QStringList{QStringLiteral("Gate"), QStringLiteral("New")}));
    QCOMPARE(at(QStringLiteral("get w1 --json")).object()[QStringLiteral("tags")].toArray(),
             QJsonArray{QStringLiteral("b")});
    // Once more changes nothing: what is there is not created twice.
    const Outcome again = at(QStringLiteral("apply plan.json --json"));
    QVERIFY2(again.code == 0 && again.object()[QStringLiteral("applied")].toInt() == 0,
             qPrintable(again.err));
    QCOMPARE(at(QStringLiteral("list --json")).array(), rows);
  }

  void aPlanThatDeletesMoreThanItKeepsWantsAYes() {
    put("wanted.csv", "id,name,x,y\n,New,9,9\n");
    QCOMPARE(at(QStringLiteral("plan wanted.csv -o plan.json --force")).code, 0);
    const Outcome refused = at(QStringLiteral("apply plan.json"));
    QCOMPARE(refused.code, 2);
    QVERIFY2(refused.err.contains(QStringLiteral("deletes 2 of the 2 waypoints")) &&
                 refused.err.contains(QStringLiteral("--yes")),
             qPrintable(refused.err));
    QCOMPARE(kept(), QByteArray(kTwo));
    QCOMPARE(at(QStringLiteral("apply plan.json --dry-run")).code, 0);
    QCOMPARE(at(QStringLiteral("apply plan.json --yes")).code, 0);
    QCOMPARE(at(QStringLiteral("list --json")).array().size(), 1);
  }

  void whatOthersChangedIsAConflict() {
    put("wanted.csv", "id,name,x,y\nw1,Gate,1,2\nw2,Pier,3,4\n");
    QCOMPARE(at(QStringLiteral("plan wanted.csv -o plan.json --force")).code, 0);
    QCOMPARE(at(QStringLiteral("rename w1 Entry")).code, 0);
    const QByteArray before = kept();
    for (const char* line : {"apply plan.json --json", "apply plan.json --json --dry-run"}) {
      const Outcome apart = at(QLatin1String(line));
      QVERIFY2(apart.code == 4 && apart.err.count(QLatin1Char('\n')) == 1, qPrintable(apart.err));
      QVERIFY2(apart.err.contains(QStringLiteral("Door")), qPrintable(apart.err));
      const QJsonArray conflicts = apart.object()[QStringLiteral("conflicts")].toArray();
      QCOMPARE(conflicts.size(), 1);
      const QJsonObject theirs = conflicts[0].toObject()[QStringLiteral("theirs")].toObject();
      QCOMPARE(theirs[QStringLiteral("name")].toString(), QStringLiteral("Entry"));
      QCOMPARE(kept(), before);
    }
  }

  void theStandardInputIsAFileLikeAnyOther() {
    const QStringList import{QStringLiteral("import"), QStringLiteral("-"), QStringLiteral("--robot"),
                             QStringLiteral("hall.yaml")};
    const Outcome csv = run(import, "id,name,x,y\n,Gate,5,6\n");
    QVERIFY2(csv.code == 0, qPrintable(csv.err));
    QVERIFY(kept().contains("Gate"));
    QByteArray moved = kTwo;
    moved.replace("[3, 4]", "[7, 8]");
    const Outcome json = run(import, moved);
    QVERIFY2(json.code == 0, qPrintable(json.err));
    const QJsonArray rows = at(QStringLiteral("list --json")).array();
    QCOMPARE(rows.size(), 3);
    const Outcome none = run(import, "neither");
    QCOMPARE(none.code, 2);
    QVERIFY2(none.err.contains(QStringLiteral("The standard input")), qPrintable(none.err));
  }

  void filesOfOtherProgramsAreImported() {
    put("poses.yaml",
        "waypoints:\n- orientation: {w: 0.7071, x: 0.0, y: 0.0, z: 0.7071}\n"
        "  position: {x: 1.25, y: -4.5, z: 0.5}\n  speed: 2\n");
    put("bare.csv", "x;y;yaw\n1,5;2,5;90\n");
    put("degrees.geojson",
        R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:4326"}}, "features": [)"
        R"({"type": "Feature", "properties": {"name": "A"}, "geometry": {"type": "Point", "coordinates": [24.9, 60.2]}}]})");
    const Outcome poses = at(QStringLiteral("import poses.yaml"));
    QVERIFY2(poses.code == 0, qPrintable(poses.err));
    // All that was left out, in one line.
    for (const char* word : {"(z)", "speed", "numbered"})
      QVERIFY2(poses.err.contains(QLatin1String(word)), qPrintable(poses.err));
    const Outcome bare = at(QStringLiteral("import bare.csv"));
    QVERIFY2(bare.code == 0 && bare.err.contains(QLatin1String("--angles")), qPrintable(bare.err));
    const QJsonObject turned = at(QStringLiteral("list --json")).array().last().toObject();
    QVERIFY(std::abs(turned[QStringLiteral("yaw_rad")].toDouble() - 1.5707963) < 1e-6);
    QCOMPARE(turned[QStringLiteral("x")].toDouble(), 1.5);
    // The same file once more changes nothing.
    QVERIFY(at(QStringLiteral("import bare.csv --angles degrees"))
                .out.contains(QLatin1String("nothing to change")));
    QVERIFY(at(QStringLiteral("import poses.yaml")).out.contains(QLatin1String("nothing to change")));
    const QByteArray before = kept();
    for (const char* line : {"import degrees.geojson", "plan degrees.geojson",
                             "import bare.csv --angles turns", "import bare.csv --format xml"}) {
      const Outcome refused = at(QLatin1String(line));
      QVERIFY2(refused.code == 2 && refused.out.isEmpty(), qPrintable(refused.err));
    }
    QCOMPARE(kept(), before);
  }

  void theReportTellsWhatBecameOfEachChange() {
    const auto report = [this] {
      return QJsonDocument::fromJson(read("r.json")).object()[QStringLiteral("waypoints")].toObject();
    };
    QCOMPARE(at(QStringLiteral("move w2 --at 9,9 --report r.json")).code, 0);
    const QJsonObject moved = report();
    QCOMPARE(moved[QStringLiteral("applied")].toInt(), 1);
    QVERIFY(moved[QStringLiteral("complete")].toBool());
    const QJsonObject change = moved[QStringLiteral("changes")].toArray().at(0).toObject();
    QCOMPARE(change[QStringLiteral("id")].toString(), QStringLiteral("w2"));
    QCOMPARE(change[QStringLiteral("kind")].toString(), QStringLiteral("move"));
    QCOMPARE(change[QStringLiteral("state")].toString(), QStringLiteral("applied"));
    QCOMPARE(change[QStringLiteral("x")].toDouble(), 9.0);
    QCOMPARE(at(QStringLiteral("delete w1 --dry-run --report r.json")).code, 0);
    QVERIFY(report()[QStringLiteral("dry_run")].toBool());
    QCOMPARE(report()[QStringLiteral("changes")].toArray().size(), 1);
    // Nothing else is printed where the report goes.
    const Outcome printed = at(QStringLiteral("create Gate --at 1,1 --report -"));
    QVERIFY2(printed.code == 0, qPrintable(printed.err));
    QCOMPARE(printed.object()[QStringLiteral("waypoints")].toObject()[QStringLiteral("applied")].toInt(), 1);
  }

  void aPlanBelongsToItsMap() {
    putMap("copy");
    put("wanted.csv", "id,name,x,y\nw1,Gate,1,2\n");
    QCOMPARE(at(QStringLiteral("plan wanted.csv -o plan.json --force")).code, 0);
    const Outcome elsewhere = run({QStringLiteral("apply"), QStringLiteral("plan.json"),
                                   QStringLiteral("--robot"), QStringLiteral("copy.yaml")});
    QVERIFY2(elsewhere.code == 2 && elsewhere.err.contains(QStringLiteral("--force")),
             qPrintable(elsewhere.err));
  }

  void aListThatCannotBeWrittenIsSaid() {
    if (geteuid() == 0) {
      // Nothing is closed to root, but a folder is no file.
      QFile::remove(program_->path(QStringLiteral("hall.waypoints.geojson")));
      QVERIFY(QDir(program_->folder()).mkdir(QStringLiteral("hall.waypoints.geojson")));
    } else {
      QFile(program_->folder()).setPermissions(QFile::ReadOwner | QFile::ExeOwner);
    }
    const Outcome outcome = at(QStringLiteral("create New --at 1,2"));
    QFile(program_->folder()).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    QVERIFY2(outcome.code == 2 && outcome.err.count(QLatin1Char('\n')) == 1, qPrintable(outcome.err));
  }

  void newerAgibotRobotsKeepThemOnWholePixels() {
    for (const bool centimetres : {false, true}) {
      simulator::Options options;
      options.paused = true;
      options.aimdk = {true, centimetres};
      simulator::Simulator robot(options);
      QVERIFY(!robot.start());
      const auto agibot = [&](const char* words) {
        return run(QString::fromLatin1(words).split(QLatin1Char(' ')) +
                   QStringList{QStringLiteral("--robot"), QString::fromStdString(robot.aimdkAddress())});
      };
      for (const char* words :
           {"create New --at 1.513,-2.04,30", "move New --at 3.02,1", "rename New Dock"}) {
        const Outcome done = agibot(words);
        QVERIFY2(done.code == 0 && done.err.contains(QStringLiteral("not confirmed")), qPrintable(done.err));
      }
      const QJsonObject kept = agibot("get Dock --json").object();
      QVERIFY(std::abs(kept[QStringLiteral("x")].toDouble() - 3.02) < 0.03);
      QVERIFY(std::abs(kept[QStringLiteral("y")].toDouble() - 1) < 0.03);
      QVERIFY(std::abs(kept[QStringLiteral("yaw_rad")].toDouble() - 0.5236) < 0.001);
      const Outcome deleted = agibot("delete Dock --yes");
      QVERIFY2(deleted.code == 4 && deleted.err.contains(QStringLiteral("cannot be deleted")),
               qPrintable(deleted.err));
      const Outcome tagged = agibot("tag Dock --add quiet");
      QVERIFY2(tagged.code == 4 && tagged.err.contains(QStringLiteral("cannot have tags")),
               qPrintable(tagged.err));
      // That the maker does not confirm it belongs to a failure, too.
      QVERIFY2(
          deleted.err.contains(QStringLiteral("not confirmed")) && deleted.err.count(QLatin1Char('\n')) == 1,
          qPrintable(deleted.err));
      // What would come back on its pixel is no change: neither of a plan nor of a command.
      const double x = kept[QStringLiteral("x")].toDouble(), y = kept[QStringLiteral("y")].toDouble();
      put("wanted.csv", QStringLiteral("id,x,y\n%1,%2,%3\n")
                            .arg(kept[QStringLiteral("id")].toString())
                            .arg(x + 0.02)
                            .arg(y)
                            .toUtf8());
      const Outcome plan = agibot("plan wanted.csv --json");
      QVERIFY2(plan.code == 0 && plan.object()[QStringLiteral("changes")].toArray().isEmpty(),
               qPrintable(plan.out + plan.err));
      QVERIFY2(
          plan.err.contains(QStringLiteral("half a pixel")) || plan.err.contains(QStringLiteral("more;")),
          qPrintable(plan.err));
      const auto requests = robot.requestLog().size();
      const Outcome moved = agibot(qPrintable(QStringLiteral("move Dock --at %1,%2").arg(x + 0.02).arg(y)));
      QVERIFY2(moved.code == 0, qPrintable(moved.err));
      for (std::size_t i = requests; i < robot.requestLog().size(); ++i)
        QVERIFY(robot.requestLog()[i].target.find("SetNaviPoint") == std::string::npos);
    }
  }

  void aRobotThatCanOnlyBeReadIsNotChanged() {
    simulator::Options options;
    options.paused = true;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const QStringList address{QStringLiteral("--robot"), QString::fromStdString(robot.aimdkAddress())};
    const Outcome list = run(QStringList{QStringLiteral("list"), QStringLiteral("--json")} + address);
    QVERIFY2(list.code == 0 && !list.array().isEmpty(), qPrintable(list.err));
    put("wanted.csv", "name,x,y\nNew,1,2\n");
    const QString id = list.array()[0].toObject()[QStringLiteral("id")].toString();
    for (const QStringList& words : {QStringList{QStringLiteral("rename"), id, QStringLiteral("New")},
                                     QStringList{QStringLiteral("delete"), id, QStringLiteral("--yes")},
                                     QStringList{QStringLiteral("import"), QStringLiteral("wanted.csv")},
                                     QStringList{QStringLiteral("plan"), QStringLiteral("wanted.csv")}}) {
      const Outcome refused = run(words + address);
      QVERIFY2(refused.code == 4, qPrintable(refused.err));
      QVERIFY2(refused.err.contains(QStringLiteral("offers no editing")), qPrintable(refused.err));
    }
    const Outcome none =
        run({QStringLiteral("list"), QStringLiteral("--robot"), QString::fromStdString(robot.address())});
    QVERIFY2(none.code == 4 && none.err.count(QLatin1Char('\n')) == 1, qPrintable(none.err));
  }
};

}  // namespace test_waypoints_command

MAPWRIGHT_TEST(test_waypoints_command, WaypointsCommandTest, Core)
#include "test_waypoints_command.moc"
