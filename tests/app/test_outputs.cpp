// What the program writes: whole or not at all, never over what it reads, into devices and pipes as they are.
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include "program.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"
#include "test_program.h"

namespace test_outputs {

namespace {

using Outcome = mapwright::tests::EndedBytes;

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList words(const char* line) { return QString::fromLatin1(line).split(QLatin1Char(' ')); }

bool isPng(const QByteArray& bytes) { return bytes.startsWith("\x89PNG") && bytes.contains("IEND"); }

}  // namespace

class OutputsTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<mapwright::tests::Program> program_;

  QString at(const char* name) const { return program_->path(name); }
  void put(const char* name, const QByteArray& bytes) { program_->put(name, bytes); }
  /// `most_bytes`: no file may become longer. `output`: where the standard output goes.
  Outcome run(const QStringList& arguments, rlim_t most_bytes = RLIM_INFINITY, const QString& output = {},
              const QString& cache = {}) const {
    mapwright::tests::Program::Means means{.output = output};
    if (!cache.isEmpty()) means.environment[QStringLiteral("XDG_CACHE_HOME")] = cache;
    if (most_bytes != RLIM_INFINITY) {
      means.in_child = [limit = rlimit{most_bytes, most_bytes}] { ::setrlimit(RLIMIT_FSIZE, &limit); };
    }
    return program_->runForBytes(arguments, means);
  }
  /// Something of everything that commands read.
  void makeSources() const {
    program_->put("places.csv", "id,name,x,y,yaw_rad\nw1,Dock,1,1,0\n");
    program_->put("map.waypoints.geojson", R"({"type":"FeatureCollection","features":[]})");
    for (const char* overlays : {"map.overlays.geojson", "walls.geojson", "base.geojson"})
      program_->put(overlays, R"({"type":"FeatureCollection","features":[]})");
    program_->put("suite.yaml", "views:\n  - {name: view, robot: map.yaml, size: 64x64}\n");
    QCOMPARE(run(words("snapshot --robot map.yaml --size 64x64 -o one.png")).code, 0);
    QVERIFY(QFile::copy(at("one.png"), at("two.png")) &&
            QDir(program_->folder()).mkdir(QStringLiteral("report")));
    // Its overlays are version 1 of the history then.
    QCOMPARE(run(words("overlays get --robot map.yaml -o first.geojson")).code, 0);
    auto target = mapwright::recording::appendFile(at("run.mcap").toStdString(),
                                                   mapwright::recording::Existing::Replace);
    const auto writer = mapwright::recording::McapWriter::create(std::move(*target), {});
    mapwright::recording::Channel channel;
    channel.topic = "/tracked_pose";
    channel.message_encoding = "json";
    const auto id = *(*writer)->addChannel(channel);
    const std::string text = R"({"topic":"/tracked_pose","pos":[1,2],"ori":0})";
    for (std::int64_t at_ns = 1'700'000'000'000'000'000; at_ns <= 1'700'000'003'000'000'000;
         at_ns += 500'000'000)
      QVERIFY(!(*writer)->write(id, {at_ns, at_ns, 0},
                                {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    QVERIFY(!(*writer)->close());
  }

 private Q_SLOTS:
  void init() {
    program_ = std::make_unique<mapwright::tests::Program>();
    QByteArray cells(64 * 64, '\xfe');
    for (int i = 0; i < cells.size(); i += 7) cells[i] = char(0);
    put("map.pgm", "P5\n64 64\n255\n" + cells);
    put("map.yaml",
        "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
        "free_thresh: 0.25\n");
  }

  void aFullDiskLeavesWhatWasThereAndIsExitCodeTwo_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QStringList>("files");
    const auto row = [](const char* line, const QStringList& files) {
      QTest::newRow(line) << QString::fromLatin1(line) << files;
    };
    const QString png = QStringLiteral("out.png");
    row("snapshot --robot map.yaml --size 64x64 -o out.png", {png});
    row("snapshot --robot map.yaml --size 64x64 --raw -o out.png", {png});
    row("snapshot --robot map.yaml --size 64x64 -o /dev/null --report out.json",
        {QStringLiteral("out.json")});
    row("maps export --robot map.yaml --force -o out.png", {png});
    row("maps export --robot map.yaml --force -o out.yaml",
        {QStringLiteral("out.yaml"), QStringLiteral("out.pgm")});
    row("maps export --robot map.yaml --force -o out.png --world-file", {png, QStringLiteral("out.pgw")});
    row("maps diff map.yaml map.yaml --diff out.png", {png});
  }
  void aFullDiskLeavesWhatWasThereAndIsExitCodeTwo() {
    QFETCH(QString, line);
    QFETCH(QStringList, files);
    for (const QString& file : files) put(file.toLatin1().constData(), "what was there");
    const Outcome full = run(line.split(QLatin1Char(' ')), 16);
    QCOMPARE(full.code, 2);
    QVERIFY2(full.err.contains("cannot be written"), full.err.constData());
    for (const QString& file : files) QCOMPARE(read(program_->path(file)), QByteArray("what was there"));
    const Outcome roomy = run(line.split(QLatin1Char(' ')));
    QVERIFY2(roomy.code == 0, roomy.err.constData());
    for (const QString& file : files) QVERIFY(read(program_->path(file)) != "what was there");
    const QStringList left =
        QDir(program_->folder()).entryList({QStringLiteral(".*part*")}, QDir::Files | QDir::Hidden);
    QVERIFY2(left.isEmpty(), qPrintable(left.join(QLatin1Char(' '))));
  }

  void aStandardOutputThatIsFullIsExitCodeTwo_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"maps list --robot map.yaml", "maps list --robot map.yaml --json", "maps show --robot map.yaml",
          "snapshot --robot map.yaml --size 64x64 -o -", "snapshot --robot map.yaml --size 64x64 -o out.png",
          "snapshot --robot map.yaml --size 64x64 -o out.png --report -", "maps export --robot map.yaml -o -",
          "maps diff map.yaml map.yaml --diff -", "--help"}) {
      QTest::newRow(line) << QString::fromLatin1(line);
    }
  }
  void aStandardOutputThatIsFullIsExitCodeTwo() {
    QFETCH(QString, line);
    const Outcome outcome = run(line.split(QLatin1Char(' ')), RLIM_INFINITY, QStringLiteral("/dev/full"));
    QCOMPARE(outcome.code, 2);
    QVERIFY2(outcome.err.contains("standard output cannot be written"), outcome.err.constData());
  }

  void devicesAndPipesAreWrittenInto_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"snapshot --robot map.yaml --size 64x64 -o %1",
          "snapshot --robot map.yaml --size 64x64 --raw -o %1",
          "snapshot --robot map.yaml --size 64x64 -o out.png --report %1",
          "maps export --robot map.yaml --format png -o %1", "maps diff map.yaml map.yaml --diff %1"}) {
      QTest::newRow(line) << QString::fromLatin1(line);
    }
  }
  void devicesAndPipesAreWrittenInto() {
    QFETCH(QString, line);
    QCOMPARE(run(line.arg(QStringLiteral("/dev/null")).split(QLatin1Char(' '))).code, 0);
    struct stat about {};
    QVERIFY(::stat("/dev/null", &about) == 0 && S_ISCHR(about.st_mode));
    const Outcome full = run(line.arg(QStringLiteral("/dev/full")).split(QLatin1Char(' ')));
    QCOMPARE(full.code, 2);
    QVERIFY(::stat("/dev/full", &about) == 0 && S_ISCHR(about.st_mode));

    QVERIFY(::mkfifo(QFile::encodeName(at("pipe")).constData(), 0600) == 0);
    QProcess reader;
    reader.start(QStringLiteral("cat"), {at("pipe")});
    const Outcome piped = run(line.arg(at("pipe")).split(QLatin1Char(' ')));
    QVERIFY(reader.state() == QProcess::NotRunning || reader.waitForFinished(30'000));
    const QByteArray came = reader.readAllStandardOutput();
    QVERIFY2(piped.code == 0, piped.err.constData());
    QVERIFY(line.contains(QStringLiteral("--report")) ? QJsonDocument::fromJson(came).isObject()
                                                      : isPng(came));
    QVERIFY(::stat(QFile::encodeName(at("pipe")).constData(), &about) == 0 && S_ISFIFO(about.st_mode));
  }

  void minusIsTheStandardOutputAndNothingElseGoesThere() {
    for (const char* line : {"snapshot --robot map.yaml --size 64x64 -o -",
                             "snapshot --robot map.yaml --raw --size 64x64 -o /dev/stdout",
                             "maps export --robot map.yaml -o -", "maps diff map.yaml map.yaml --diff -"}) {
      const Outcome outcome = run(words(line));
      QVERIFY2(outcome.code == 0, outcome.err.constData());
      QVERIFY2(
          isPng(outcome.out) && outcome.out.startsWith("\x89PNG") && outcome.out.endsWith("\xae\x42\x60\x82"),
          line);
      QVERIFY2(outcome.err.isEmpty(), outcome.err.constData());
    }
    const Outcome report = run(words("snapshot --robot map.yaml --size 64x64 -o out.png --report -"));
    QVERIFY(QJsonDocument::fromJson(report.out).object().contains(QStringLiteral("complete")));
    QVERIFY(!QFile::exists(at("-")));
  }

  void twoThingsInOnePlaceAreRefused() {
    for (const char* line :
         {"snapshot --robot map.yaml -o - --json", "snapshot --robot map.yaml -o - --report -",
          "snapshot --robot map.yaml -o a.png --report a.png",
          "snapshot --robot map.yaml -o a.png --report ./a.png",
          "maps export --robot map.yaml -o - --format pgm", "maps export --robot map.yaml -o - --world-file",
          "maps diff map.yaml map.yaml --diff - --json"}) {
      const Outcome outcome = run(words(line));
      QVERIFY2(outcome.code == 2, line);
      QCOMPARE(outcome.err.count('\n'), 1);
      QVERIFY2(outcome.out.isEmpty(), line);
    }
    QVERIFY(!QFile::exists(at("a.png")));
  }

  void whatTheMapIsReadFromIsReplacedOnlyByForce_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"maps export --robot map.yaml -o map.yaml", "maps export --robot map.yaml -o map.pgm",
          "maps export --robot map.yaml -o link.yaml", "maps export --robot map.yaml -o hard.pgm",
          "maps export --robot map.pgm --resolution 0.05 -o map.pgm",
          "maps export map.yaml --robot . -o map.yaml", "snapshot --robot map.yaml --size 64x64 -o hard.png",
          "snapshot --robot map.yaml --size 64x64 --raw -o hard.png",
          "maps diff other.yaml map.yaml --diff hard.png", "maps diff map.yaml other.yaml --diff map.yaml"}) {
      QTest::newRow(line) << QString::fromLatin1(line);
    }
  }
  void whatTheMapIsReadFromIsReplacedOnlyByForce() {
    QFETCH(QString, line);
    put("other.pgm", read(at("map.pgm")));
    put("other.yaml", read(at("map.yaml")).replace("map.pgm", "other.pgm"));
    QVERIFY(QFile::link(at("map.yaml"), at("link.yaml")));
    QVERIFY(::link(QFile::encodeName(at("map.pgm")).constData(),
                   QFile::encodeName(at("hard.pgm")).constData()) == 0);
    QVERIFY(::link(QFile::encodeName(at("map.pgm")).constData(),
                   QFile::encodeName(at("hard.png")).constData()) == 0);
    const QByteArray yaml = read(at("map.yaml")), pgm = read(at("map.pgm"));
    const Outcome refused = run(line.split(QLatin1Char(' ')));
    QCOMPARE(refused.code, 2);
    QCOMPARE(refused.err.count('\n'), 1);
    QVERIFY2(refused.err.contains("--force"), refused.err.constData());
    QCOMPARE(read(at("map.yaml")), yaml);
    QCOMPARE(read(at("map.pgm")), pgm);
    QCOMPARE(read(at("other.pgm")), pgm);
    const Outcome forced = run(line.split(QLatin1Char(' ')) << QStringLiteral("--force"));
    QVERIFY2(forced.code == 0, forced.err.constData());
  }

  // What people edit or cannot make again is kept; pictures and reports are made anew.
  void whatIsThereIsReplacedByForceOrNeedsNone_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("kept");
    const auto row = [](const char* line, const char* file, bool kept) {
      QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(file) << kept;
    };
    row("maps export --robot map.yaml -o out.png", "out.png", true);
    row("maps export --robot map.yaml -o out.yaml", "out.yaml", true);
    row("maps export --robot map.yaml -o out.yaml", "out.pgm", true);
    row("maps export --robot map.yaml -o out.png --world-file", "out.pgw", true);
    row("waypoints export --robot map.yaml -o out.csv", "out.csv", true);
    row("waypoints plan places.csv --robot map.yaml -o out.json", "out.json", true);
    row("overlays get --robot map.yaml -o out.geojson", "out.geojson", true);
    row("overlays plan walls.geojson --base walls.geojson --robot map.yaml -o out.json", "out.json", true);
    row("overlays history show 1 -o out.geojson", "out.geojson", true);
    row("record --robot demo: --duration 1 -o out.mcap", "out.mcap", true);
    row("clouds export --robot rep130+ws://127.0.0.1:1 --all -o out.pcd", "out.pcd", true);
    row("bags export run.mcap -o out.mcap", "out.mcap", true);
    row("bags export run.mcap -o out.jsonl", "out.jsonl", true);
    row("bags track run.mcap -o out.csv", "out.csv", true);
    row("bags download run --robot axbot+http://127.0.0.1:1 -o out.bag", "out.bag", true);
    row("bags repair run.mcap -o out.mcap", "out.mcap", true);
    row("bags split run.mcap --every 1 -o out%d.mcap", "out1.mcap", true);
    row("bags merge run.mcap -o out.mcap", "out.mcap", true);
    row("maps download 1 --robot demo: -o .", "map.json", true);
    row("bags snapshot run.mcap --at 1700000001 --mode submaps -o out.png", "out.png", false);
    row("bags report run.mcap --at 1700000001 -o out.html", "out.html", false);
    row("bags film run.mcap --from 1700000001 --to 1700000002 --mode submaps -o out%d.png", "out1.png",
        false);
    row("snapshot --robot map.yaml --size 64x64 -o out.png", "out.png", false);
    row("snapshot --robot map.yaml --size 64x64 -o /dev/null --report out.json", "out.json", false);
    row("maps list --robot map.yaml --report out.json", "out.json", false);
    row("maps diff map.yaml map.yaml --diff out.png", "out.png", false);
    row("compare one.png one.png --diff out.png", "out.png", false);
    row("suite run suite.yaml --expected . --report report", "report/junit.xml", false);
    row("suite accept suite.yaml --expected .", "view.png", false);
  }
  void whatIsThereIsReplacedByForceOrNeedsNone() {
    QFETCH(QString, line);
    QFETCH(QString, file);
    QFETCH(bool, kept);
    makeSources();
    const QByteArray before = "what was there";
    put(file.toLatin1().constData(), before);
    const Outcome first = run(line.split(QLatin1Char(' ')));
    if (!kept) {
      QVERIFY2(first.code == 0 || first.code == 1, first.err.constData());
      QVERIFY(read(program_->path(file)) != before);
      return;
    }
    QCOMPARE(first.code, 2);
    QCOMPARE(first.err.count('\n'), 1);
    QVERIFY2(first.err.contains("--force"), first.err.constData());
    QCOMPARE(read(program_->path(file)), before);
    const Outcome forced = run(line.split(QLatin1Char(' ')) << QStringLiteral("--force"));
    QVERIFY2(!forced.err.contains("--force"), forced.err.constData());
    if (forced.code != 3) QVERIFY(read(program_->path(file)) != before);  // no such robot
  }

  void whatAppearsMeanwhileIsReplacedByForceAlone_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("kept");
    QTest::addColumn<QByteArray>("input");
    QTest::newRow("waypoints") << QStringLiteral("waypoints plan - --format csv --robot map.yaml -o out.json")
                               << QStringLiteral("out-1.json")
                               << QByteArray("id,name,x,y,yaw_rad\nw1,Dock,1,1,0\n");
    QTest::newRow("overlays") << QStringLiteral(
                                     "overlays plan - --base base.geojson --robot map.yaml -o out.json")
                              << QStringLiteral("out-1.json")
                              << QByteArray(R"({"type":"FeatureCollection","features":[]})");
  }
  void whatAppearsMeanwhileIsReplacedByForceAlone() {
    QFETCH(QString, line);
    QFETCH(QString, kept);
    QFETCH(QByteArray, input);
    makeSources();
    for (const bool force : {false, true}) {
      (void)QFile::remove(at("out.json"));
      QStringList arguments = line.split(QLatin1Char(' '));
      if (force) arguments << QStringLiteral("--force");
      QProcess process;
      process.setProcessEnvironment(program_->environment());
      process.setWorkingDirectory(program_->folder());
      process.start(QStringLiteral(MAPWRIGHT_PROGRAM), arguments);
      // More than a pipe holds: what has taken it reads, and has looked at the output before.
      process.write(QByteArray(1 << 20, '\n'));
      QVERIFY(QTest::qWaitFor([&] { return process.bytesToWrite() == 0; }, 60'000));
      put("out.json", "another's");
      process.write(input);
      process.closeWriteChannel();
      QVERIFY(QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, 60'000));
      const QByteArray err = process.readAllStandardError();
      QVERIFY2(process.exitCode() == (force ? 0 : 2), err.constData());
      QVERIFY2(err.contains(kept.toUtf8()) == !force, err.constData());
      QCOMPARE(read(at("out.json")) == "another's", !force);
      QVERIFY(QJsonDocument::fromJson(read(force ? at("out.json") : program_->path(kept))).isObject());
    }
  }

  void aReportReplacesNothingThatTheCommandReads_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("file");
    const auto row = [](const char* line, const char* file) {
      QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(file);
    };
    row("maps list --robot map.yaml --report map.yaml", "map.yaml");
    row("snapshot --robot map.yaml --size 64x64 -o out.png --report map.yaml", "map.yaml");
    row("maps show --robot file:map.yaml --report map.yaml", "map.yaml");
    row("maps show --robot map.yaml --report map.pgm", "map.pgm");
    row("waypoints import places.csv --robot map.yaml --report places.csv", "places.csv");
    row("waypoints list --robot map.yaml --report map.waypoints.geojson", "map.waypoints.geojson");
    row("overlays set walls.geojson --base base.geojson --robot map.yaml --report base.geojson",
        "base.geojson");
    row("bags info run.mcap --report run.mcap", "run.mcap");
    row("bags export run.mcap -o out.jsonl --report ./run.mcap", "run.mcap");
    row("bags snapshot run.mcap --at 1700000001 --mode submaps -o run.mcap", "run.mcap");
    row("bags snapshot run.mcap --at 1700000001 -o out.png --report run.mcap", "run.mcap");
    row("bags report run.mcap --at 1700000001 -o run.mcap", "run.mcap");
    row("snapshot --bag run.mcap --at 1700000001 --mode submaps -o run.mcap", "run.mcap");
    row("compare one.png two.png --diff two.png", "two.png");
  }
  void aReportReplacesNothingThatTheCommandReads() {
    QFETCH(QString, line);
    QFETCH(QString, file);
    makeSources();
    const QByteArray before = read(program_->path(file));
    QVERIFY(!before.isEmpty());
    const Outcome outcome = run(line.split(QLatin1Char(' ')));
    QCOMPARE(read(program_->path(file)), before);
    QCOMPARE(outcome.code, 2);
    QCOMPARE(outcome.err.count('\n'), 1);
  }

  void aBrokenSourceIsNotReplacedByTheReport() {
    put("broken.yaml", "nothing of use");
    QCOMPARE(run(words("snapshot --robot broken.yaml -o out.png --report broken.yaml")).code, 2);
    QCOMPARE(read(at("broken.yaml")), QByteArray("nothing of use"));
  }

  void aCacheThatCannotBeWrittenChangesNoPicture() {
    const Outcome kept = run(words("snapshot --robot demo: --size 200x150 -o kept.png --report kept.json"));
    QVERIFY2(kept.code == 0, kept.err.constData());
    for (const char* cache : {"/proc/none", "/dev/null"}) {
      const Outcome outcome = run(words("snapshot --robot demo: --size 200x150 -o out.png --report out.json"),
                                  RLIM_INFINITY, {}, QString::fromLatin1(cache));
      QVERIFY2(outcome.code == 0, outcome.err.constData());
      QCOMPARE(read(at("out.png")), read(at("kept.png")));
    }
  }
};

}  // namespace test_outputs

MAPWRIGHT_TEST(test_outputs, OutputsTest, Core)
#include "test_outputs.moc"
