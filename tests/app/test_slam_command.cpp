// `slam info`, `slam closures`, `slam drop`, and pictures of state files.
#include <QtTest>

#include "../pbstream/state_bytes.h"
#include "program.h"
#include "test_program.h"

namespace test_slam_command {

using namespace mapwright;
using Outcome = mapwright::tests::Ended;
namespace state = mapwright::pbstream::tests;

class SlamCommandTest : public QObject {
  Q_OBJECT
  mapwright::tests::Program program_;

  QString write(const std::string& bytes, const char* name = "map.pbstream") const {
    QFile file(program_.path(name));
    (void)file.open(QIODevice::WriteOnly);
    file.write(bytes.data(), qint64(bytes.size()));
    return file.fileName();
  }
  QByteArray read(const QString& path) const {
    QFile file(path);
    (void)file.open(QIODevice::ReadOnly);
    return file.readAll();
  }
  Outcome slam(const char* what, const QString& robot, const QStringList& more = {}) const {
    return program_.run(
        QStringList{QStringLiteral("slam"), QLatin1String(what), QStringLiteral("--robot"), robot} + more);
  }

 private Q_SLOTS:
  void aFileSaysWhatItHolds() {
    const Outcome info = slam("info", write(state::wholeFile()), {QStringLiteral("--json")});
    QCOMPARE(info.code, 0);
    const QJsonObject json = info.object();
    QCOMPARE(json[QLatin1String("format_version")].toInt(), 2);
    QCOMPARE(json[QLatin1String("submaps")].toInt(), 3);
    QCOMPARE(json[QLatin1String("unfinished")].toInt(), 0);
    QCOMPARE(json[QLatin1String("nodes")].toInt(), 6);
    QCOMPARE(json[QLatin1String("resolution")].toDouble(), 0.05);
    QCOMPARE(json[QLatin1String("constraints")].toObject()[QLatin1String("inter")].toInt(), 2);
    const QJsonObject first = json[QLatin1String("trajectories")].toArray()[0].toObject();
    QCOMPARE(first[QLatin1String("nodes")].toInt(), 4);
    QCOMPARE(first[QLatin1String("length_m")].toDouble(), 3.0);
    QCOMPARE(first[QLatin1String("start")].toDouble(), 1'700'000'000.5);
    QCOMPARE(json[QLatin1String("records")].toObject()[QLatin1String("imu_data")].toInt(), 5);
    QCOMPARE(json[QLatin1String("warnings")].toArray().size(), 0);
    // Grids of 1 x 1 m whose upper corner is 1 m from the origin of the submap, at x 0 and 2, y 0 and 1.
    const QJsonArray bounds = json[QLatin1String("bounds")].toArray();
    const double expected[] = {0, 0, 3, 2};
    for (int i = 0; i < 4; ++i) QVERIFY(std::abs(bounds[i].toDouble() - expected[i]) < 1e-6);
  }

  void closuresAreRankedAndCanFail() {
    const QString file = write(state::wholeFile());
    const Outcome all = slam("closures", file, {QStringLiteral("--json")});
    QCOMPARE(all.code, 0);
    const QJsonArray closures = all.object()[QLatin1String("closures")].toArray();
    QCOMPARE(closures.size(), 2);
    QCOMPARE(closures[0].toObject()[QLatin1String("submap")].toString(), QStringLiteral("0-0"));
    QCOMPARE(closures[0].toObject()[QLatin1String("node")].toString(), QStringLiteral("0-3"));
    QCOMPARE(closures[0].toObject()[QLatin1String("residual_m")].toDouble(), 2.0);
    QCOMPARE(closures[0].toObject()[QLatin1String("stamp")].toDouble(), 1'700'000'003.5);
    const auto count = [&](const QStringList& words) {
      return slam("closures", file, words + QStringList{QStringLiteral("--json")})
          .object()[QLatin1String("closures")]
          .toArray()
          .size();
    };
    QCOMPARE(count({QStringLiteral("--kind"), QStringLiteral("all")}), 8);
    QCOMPARE(count({QStringLiteral("--kind"), QStringLiteral("intra")}), 6);
    QCOMPARE(count({QStringLiteral("--min"), QStringLiteral("1.5")}), 1);
    QCOMPARE(count({QStringLiteral("--top"), QStringLiteral("1")}), 1);
    const Outcome over = slam("closures", file, {QStringLiteral("--fail-over"), QStringLiteral("1.9")});
    QCOMPARE(over.code, 1);
    QVERIFY2(over.err.contains(QStringLiteral("contradict the finished map")), qPrintable(over.err));
    QCOMPARE(slam("closures", file, {QStringLiteral("--fail-over"), QStringLiteral("2.1")}).code, 0);
    QCOMPARE(slam("closures", file, {QStringLiteral("--fail-over"), QStringLiteral("-1")}).code, 2);
    QCOMPARE(slam("closures", file, {QStringLiteral("--kind"), QStringLiteral("other")}).code, 2);
  }

  void aMapWithoutClosuresSaysSo() {
    auto data = state::graphRecord();
    auto& graph = *data.mutable_pose_graph();
    graph.mutable_constraint()->DeleteSubrange(6, 2);
    const std::string bytes =
        state::header() + state::record(data) + state::record(state::submapRecord(0, 0)) +
        state::record(state::submapRecord(0, 1)) + state::record(state::submapRecord(1, 0));
    const Outcome closures = slam("closures", write(bytes));
    QCOMPARE(closures.code, 0);
    QVERIFY2(closures.out.contains(QStringLiteral("No loop was closed")), qPrintable(closures.out));
  }

  void aRobotThatOnlyDrawsItsConstraintsIsRankedByMetres() {
    const Outcome closures = slam("closures", QStringLiteral("demo:"), {QStringLiteral("--json")});
    QCOMPARE(closures.code, 0);
    const QJsonObject json = closures.object();
    QVERIFY(json[QLatin1String("inter")].toInt() > 0);
    QVERIFY(json[QLatin1String("dangling")].isNull());
    const QJsonObject first = json[QLatin1String("closures")].toArray()[0].toObject();
    QVERIFY(first[QLatin1String("submap")].isNull() && first[QLatin1String("residual_m")].toDouble() > 0);
    QVERIFY2(closures.err.contains(QStringLiteral("only draws its constraints")), qPrintable(closures.err));
  }

  void somethingIsLeftOutOfANewFile() {
    const QString file = write(state::wholeFile());
    const QString to = program_.path("new.pbstream");
    const Outcome drop = slam(
        "drop", file, {QStringLiteral("--closure"), QStringLiteral("0-0:0-3"), QStringLiteral("-o"), to});
    QVERIFY2(drop.code == 0, qPrintable(drop.err));
    QVERIFY2(drop.out.contains(QStringLiteral("No pose has changed")), qPrintable(drop.out));
    QCOMPARE(read(file).toStdString(), state::wholeFile());
    QCOMPARE(slam("closures", to, {QStringLiteral("--json")}).object()[QLatin1String("inter")].toInt(), 1);
    const auto refused = [&](const QStringList& words) {
      const Outcome outcome = slam("drop", file, words);
      return outcome.code == 2 && outcome.err.trimmed().endsWith(QLatin1Char('.'));
    };
    const QString output = QStringLiteral("-o"), other = program_.path("other.pbstream");
    QVERIFY(refused({QStringLiteral("--submap"), QStringLiteral("0-0"), output, to}));
    QVERIFY(refused({QStringLiteral("--submap"), QStringLiteral("0-0"), output, file}));
    QVERIFY(refused({QStringLiteral("--submap"), QStringLiteral("0-9"), output, other}));
    QVERIFY(refused({QStringLiteral("--submap"), QStringLiteral("zero"), output, other}));
    QVERIFY(refused({QStringLiteral("--closure"), QStringLiteral("0-0"), output, other}));
    QVERIFY(refused({QStringLiteral("--submap"), QStringLiteral("0-0"), output, QStringLiteral("-")}));
    QVERIFY(refused({output, other}));
    QVERIFY(!QFile::exists(other));
  }

  void whatHasNegativeIdsIsLeftOutToo() {
    auto graph = state::graphRecord();
    graph.mutable_pose_graph()->mutable_trajectory(1)->set_trajectory_id(-1);
    for (auto& one : *graph.mutable_pose_graph()->mutable_constraint()) {
      if (one.submap_id().trajectory_id() == 1) one.mutable_submap_id()->set_trajectory_id(-1);
      if (one.node_id().trajectory_id() == 1) one.mutable_node_id()->set_trajectory_id(-1);
    }
    const QString file =
        write(state::header() + state::record(graph) + state::record(state::optionsRecord(2)) +
              state::record(state::submapRecord(0, 0)) + state::record(state::submapRecord(0, 1)) +
              state::record(state::submapRecord(-1, 0)));
    int number = 0;
    const auto submapsWithout = [&](const char* option, const char* id) {
      const QString to = program_.path(QStringLiteral("negative%1.pbstream").arg(++number));
      const Outcome drop =
          slam("drop", file, {QLatin1String(option), QLatin1String(id), QStringLiteral("-o"), to});
      if (drop.code != 0) qWarning("%s", qPrintable(drop.err));
      return slam("info", to, {QStringLiteral("--json")}).object()[QLatin1String("submaps")].toInt(-1);
    };
    QCOMPARE(submapsWithout("--trajectory", "-1"), 2);
    QCOMPARE(submapsWithout("--submap", "-1-0"), 2);
    QCOMPARE(submapsWithout("--closure", "0-1:-1-1"), 3);
  }

  void aDamagedRecordThatIsCopiedIsTold() {
    std::string damaged = state::record(state::imuRecord(0));
    damaged[damaged.size() - 5] = char(~damaged[damaged.size() - 5]);
    const QString file = write(state::wholeFile() + damaged), to = program_.path("copied.pbstream");
    const Outcome drop = slam("drop", file,
                              {QStringLiteral("--closure"), QStringLiteral("0-0:0-3"), QStringLiteral("-o"),
                               to, QStringLiteral("--json")});
    QCOMPARE(drop.code, 1);
    QVERIFY2(drop.err.startsWith(QStringLiteral("Damaged, and copied as it is: Record 17 at byte ")),
             qPrintable(drop.err));
    QVERIFY2(drop.err.endsWith(QStringLiteral("its gzip stream is damaged.\n")), qPrintable(drop.err));
    QCOMPARE(drop.object()[QLatin1String("warnings")].toArray().size(), 1);
    QVERIFY(QFile::exists(to));
  }

  void whatHasNoUsablePlaceOrCellSizeIsNamed() {
    auto graph = state::graphRecord();
    graph.mutable_pose_graph()->mutable_trajectory(0)->mutable_submap(1)->mutable_pose()->clear_rotation();
    auto nowhere = state::submapRecord(1, 0);
    nowhere.mutable_submap()->mutable_submap_2d()->mutable_grid()->mutable_limits()->set_resolution(
        std::numeric_limits<double>::quiet_NaN());
    const QString file = write(state::header() + state::record(graph) + state::record(nowhere) +
                               state::record(state::submapRecord(0, 1)));
    const Outcome info = slam("info", file);
    QCOMPARE(info.code, 1);
    QVERIFY2(info.err.contains(QStringLiteral("(0-1)")), qPrintable(info.err));
    QVERIFY2(info.err.contains(QStringLiteral("cell size")), qPrintable(info.err));
    QVERIFY2(!info.out.contains(QStringLiteral("nan")), qPrintable(info.out));
    QVERIFY2(info.out.contains(QStringLiteral("0.05 m per cell")), qPrintable(info.out));
  }

  void constraintsThatReferToNothingCountAsNeitherKind() {
    auto graph = state::graphRecord();
    graph.mutable_pose_graph()->mutable_constraint(6)->mutable_node_id()->set_node_index(99);
    const QString file =
        write(state::header() + state::record(graph) + state::record(state::submapRecord(0, 0)));
    for (const char* command : {"info", "closures"}) {
      const QJsonObject json = slam(command, file, {QStringLiteral("--json")}).object();
      const QJsonObject counts = command[0] == 'i' ? json[QLatin1String("constraints")].toObject() : json;
      QCOMPARE(counts[QLatin1String("inter")].toInt(), 1);
      QCOMPARE(counts[QLatin1String("intra")].toInt(), 6);
      QCOMPARE(counts[QLatin1String("dangling")].toInt(), 1);
    }
    const Outcome closures = slam("closures", file);
    QVERIFY2(closures.out.contains(QStringLiteral("1 dangling")), qPrintable(closures.out));
  }

  void whatIsLeftOutIsNotWrittenWhereTheReportGoes() {
    const QString file = write(state::wholeFile()), to = program_.path("shared.pbstream");
    const Outcome refused = slam("drop", file,
                                 {QStringLiteral("--submap"), QStringLiteral("0-1"), QStringLiteral("-o"), to,
                                  QStringLiteral("--report"), to});
    QCOMPARE(refused.code, 2);
    QVERIFY2(refused.err.contains(QStringLiteral("are the same file")), qPrintable(refused.err));
    QVERIFY(!QFile::exists(to));
    const QString picture = program_.path("shared.png");
    program_.put("shared.png", "mine");
    QCOMPARE(
        slam("disagreement", file, {QStringLiteral("-o"), picture, QStringLiteral("--report"), picture}).code,
        2);
    QCOMPARE(program_.bytes("shared.png"), QByteArray("mine"));
  }

  void aFileThatIsCutIsDrawnAsFarAsItGoes() {
    const std::string whole = state::wholeFile();
    const std::string two =
        state::header() + state::record(state::graphRecord()) + state::record(state::optionsRecord(2)) +
        state::record(state::submapRecord(0, 0)) + state::record(state::submapRecord(0, 1));
    const QString picture = program_.path("map.png");
    const auto snapshot = [&](const std::string& bytes) {
      return program_.run({QStringLiteral("snapshot"), QStringLiteral("--robot"), write(bytes),
                           QStringLiteral("--json"), QStringLiteral("-o"), picture});
    };
    const Outcome drawn = snapshot(whole);
    QVERIFY2(drawn.code == 0, qPrintable(drawn.err));
    QCOMPARE(drawn.object()[QLatin1String("submaps")].toObject()[QLatin1String("drawn")].toInt(), 3);
    const Outcome cut = snapshot(whole.substr(0, two.size() + 20));
    QCOMPARE(cut.code, 1);
    QVERIFY2(cut.err.contains(QStringLiteral("The file is cut off in record 5 at byte")),
             qPrintable(cut.err));
    QCOMPARE(cut.object()[QLatin1String("submaps")].toObject()[QLatin1String("drawn")].toInt(), 2);
    QVERIFY(QFile::exists(picture));
    const Outcome info = slam("info", write(whole.substr(0, two.size() + 20)), {QStringLiteral("--json")});
    QCOMPARE(info.code, 1);
    QCOMPARE(info.object()[QLatin1String("warnings")].toArray().size(), 2);
  }

  void aRecordingIsLookedAtAtItsTimes() {
    const QString file = program_.path("drive.mcap");
    const Outcome recorded =
        program_.run({QStringLiteral("record"), QStringLiteral("--robot"), QStringLiteral("demo:"),
                      QStringLiteral("--duration"), QStringLiteral("5"), QStringLiteral("--topics"),
                      QStringLiteral("/constraint_list"), QStringLiteral("-o"), file});
    QVERIFY2(recorded.code == 0, qPrintable(recorded.out + recorded.err));
    const Outcome there =
        program_.run({QStringLiteral("slam"), QStringLiteral("closures"), QStringLiteral("--bag"), file,
                      QStringLiteral("--at"), QStringLiteral("-0.1"), QStringLiteral("--json")});
    QVERIFY2(there.code == 0, qPrintable(there.out + there.err));
    QVERIFY(there.object()[QLatin1String("inter")].toInt() > 0);
    for (const char* const what : {"closures", "disagreement", "coverage"}) {
      const Outcome live = slam(what, file);
      QCOMPARE(live.code, 2);
      QVERIFY2(live.err.contains(QStringLiteral("is a recording")), qPrintable(live.err));
    }
    QCOMPARE(program_
                 .run({QStringLiteral("snapshot"), QStringLiteral("--robot"), file, QStringLiteral("-o"),
                       program_.path("x.png")})
                 .code,
             2);
  }

  void twoStateFilesAreCompared() {
    const QString file = write(state::wholeFile());
    const auto differs = [&](const QString& other) {
      return program_.run({QStringLiteral("maps"), QStringLiteral("diff"), file, other}).code;
    };
    QCOMPARE(differs(write(state::wholeFile(), "again.pbstream")), 0);
    const QString less = program_.path("less.pbstream");
    QCOMPARE(
        slam("drop", file, {QStringLiteral("--submap"), QStringLiteral("0-1"), QStringLiteral("-o"), less})
            .code,
        0);
    QCOMPARE(differs(less), 1);
  }

  void whatIsNoStateFileIsRefused() {
    for (const char* const what : {"info", "closures"}) {
      const Outcome outcome = slam(what, write("hello", "x.pbstream"));
      QCOMPARE(outcome.code, 2);
      QVERIFY2(outcome.err.contains(QStringLiteral("is not a Cartographer state file")),
               qPrintable(outcome.err));
    }
    QCOMPARE(slam("info", QStringLiteral("demo:")).code, 2);
    QCOMPARE(slam("info", QStringLiteral("nowhere.pbstream")).code, 2);
  }
};

}  // namespace test_slam_command

MAPWRIGHT_TEST(test_slam_command, SlamCommandTest, Core)
#include "test_slam_command.moc"
