// The program as a script sees it: exit codes, one line on stderr, files.
#include <csignal>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include "program.h"
#include "test_program.h"

namespace test_command_line {

namespace {

using Outcome = mapwright::tests::Ended;

}  // namespace

class CommandLineTest : public QObject {
  Q_OBJECT
 private:
  mapwright::tests::Program program_;

  Outcome run(const QStringList& arguments, const QMap<QString, QString>& more = {}) const {
    return program_.run(arguments, {.environment = more});
  }
  QString at(const char* name) const { return program_.path(name); }

 private Q_SLOTS:
  void helpAndVersionAreThereOnEveryLevel() {
    QCOMPARE(run({QStringLiteral("--help")}).code, 0);
    QVERIFY(
        run({QStringLiteral("snapshot"), QStringLiteral("--help")}).out.contains(QStringLiteral("--settle")));
    QVERIFY(run({QStringLiteral("simulate"), QStringLiteral("--help")})
                .out.contains(QStringLiteral("--corrupt-rate")));
    QVERIFY(run({QStringLiteral("--version")}).out.startsWith(QStringLiteral("mapwright ")));
  }

  void theVersionIsAlsoJson() {
    const Outcome told = run({QStringLiteral("--version"), QStringLiteral("--json")});
    QCOMPARE(told.code, 0);
    const QString version = told.object()[QLatin1String("version")].toString();
    QCOMPARE(run({QStringLiteral("--version")}).out, QStringLiteral("mapwright %1\n").arg(version));
    QCOMPARE(told.object()[QLatin1String("qt")][QLatin1String("running")].toString(),
             QString::fromLatin1(qVersion()));
    QCOMPARE(run({QStringLiteral("--json")}).code, 2);
  }

  void aCrashIsSaidWithTheCallsThatLedToIt() {
    QProcess process;
    process.setProcessEnvironment(program_.environment());
    process.start(QStringLiteral(MAPWRIGHT_PROGRAM),
                  {QStringLiteral("simulate"), QStringLiteral("--port=0")});
    QVERIFY(QTest::qWaitFor([&] { return process.bytesAvailable() > 0; }, 60'000));  // its address
    ::kill(pid_t(process.processId()), SIGABRT);
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    QCOMPARE(process.exitCode(), SIGABRT);
    const QByteArray said = process.readAllStandardError();
    QVERIFY2(said.contains("mapwright crashed."), said.constData());
    QVERIFY2(said.count('\n') > 3 && said.contains("libc.so"), said.constData());
  }

  void wrongUsageIsOneLineAndExitCodeTwo_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"nonsense", "snapshot", "snapshot --output p.png",
          "snapshot --robot demo: --output p.png --size big", "snapshot --robot rep131+ws://h --output p.png",
          "snapshot --robot demo:?scene=moon --output p.png",
          "snapshot --robot demo: --output /no/such/folder/p.png", "simulate --scene moon",
          "simulate --drop-rate 2", "snapshot --robot demo: --secret-file /no/such/file --output p.png",
          "maps", "maps list", "maps list --robot /no/such/map.yaml",
          "maps export --robot demo: --output map.tiff", "maps diff a.yaml b.yaml",
          "snapshot --robot /no/such/map.yaml --output p.png",
          // Options that say nothing, or no number.
          "snapshot --robot demo: --output p.png --layers ", "snapshot --robot demo: --output p.png --mode ",
          "snapshot --robot demo: --output p.png --map ", "snapshot --robot  --output p.png",
          "snapshot --robot demo: --output p.png --rotate nan",
          "snapshot --robot demo: --output p.png --rotate 1e999",
          "snapshot --robot demo: --output p.png --rotate 0x10",
          "snapshot --robot demo: --output p.png --rotate 5deg",
          "snapshot --robot demo: --output p.png --scale 0",
          "snapshot --robot demo: --output p.png --center 0,0 --scale 0",
          "snapshot --robot demo: --output p.png --center 0,0 --scale inf",
          "snapshot --robot demo: --output p.png --slice 1.5",
          "snapshot --robot demo: --output p.png --slice -1",
          "snapshot --robot demo: --output p.png --timeout 0",
          "snapshot --robot demo: --output p.png --timeout nan",
          "snapshot --robot demo: --output p.png --settle 61", "simulate --speed nan",
          "simulate --port 70000", "simulate --seed -1", "simulate --submaps 1e9", "simulate --points many",
          "maps list --robot demo: --timeout inf", "maps list --robot demo: --timeout -1",
          "maps show  --robot demo:",
          // Options that contradict each other, or could have no effect.
          "snapshot --robot demo: --output p.png --resolution 0.1",
          "snapshot --robot demo: --output p.png --origin 1,2",
          "snapshot --robot demo: --output p.png --mode submaps --average",
          "snapshot --robot demo: --output p.png --mode whole --slice 1",
          "snapshot --robot demo: --output p.png --mode whole --colors active",
          "snapshot --robot demo: --output p.png --raw --theme dark",
          "snapshot --robot demo: --output p.png --raw --layers robot",
          "maps list --robot demo: --resolution 0.1", "maps show --robot demo: --origin 1,2",
          "maps export 1 --robot demo: --resolution 0.1 --output map.png",
          "maps export submaps --robot demo: --origin 1,2 --output map.png",
          "maps export submaps --robot demo: --resolution 0 --output map.png",
          "maps export --robot demo: --format pgm --output map.png",
          "maps diff 1 2 --robot demo: --resolution 0.1"}) {
      QTest::newRow(line) << QString::fromLatin1(line);
    }
  }
  void wrongUsageIsOneLineAndExitCodeTwo() {
    QFETCH(QString, line);
    const Outcome outcome = run(line.split(QLatin1Char(' ')));
    QCOMPARE(outcome.code, 2);
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
    QVERIFY(outcome.out.isEmpty());
  }

  void aWrongWordIsNamedWithTheNearestRightOne_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* line, const char* sentence) {
      QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(sentence);
    };
    row("overlays vlidate", "vlidate: no such subcommand of overlays. Did you mean validate?");
    row("overlays val", "val: no such subcommand of overlays. Did you mean validate?");
    row("maps zzzzzz", "zzzzzz: no such subcommand of maps.");
    row("snapshot --robt x", "--robt: no such option of snapshot. Did you mean --robot?");
    row("snapshot --robt=x", "--robt: no such option of snapshot. Did you mean --robot?");
    row("snapshot --robot demo: -o p.png --szie 4x4",
        "--szie: no such option of snapshot. Did you mean --size?");
    row("maps list --robot demo: --jsn", "--jsn: no such option of maps list. Did you mean --json?");
    row("maps list --qqqqqqqqq", "--qqqqqqqqq: no such option of maps list.");
    row("maps list http://127.0.0.1:8090",
        "http://127.0.0.1:8090 is an address: put --robot in front of it.");
    row("maps list one two", "one: one word too many for maps list. Quote a name that has blanks in it.");
    row("--robo demo:", "--robo: no such option of mapwright. Did you mean --robot?");
    row("snapshto", "snapshto is neither a subcommand nor an existing file. Did you mean snapshot?");
    row("play nosuch.mcap", "nosuch.mcap: there is no such file.");
    row("nosuch.bag", "nosuch.bag: there is no such file.");
    row("snapshot", "--output is required (see mapwright snapshot --help)");
    row("snapshot -o", "--output needs a value (see mapwright snapshot --help)");
    row("snapshot --robot demo: -o p.png --slice 1.5",
        "--slice: 1.5 is not a number that fits (see mapwright snapshot --help)");
    row("simulate --points many", "--points: \"many\" is not a number (see mapwright simulate --help)");
    row("simulate --port 70000", "--port: 70000 is not a number that fits (see mapwright simulate --help)");
    row("maps list --secret-file-for demo:",
        "--secret-file-for needs ADDRESS FILE (see mapwright maps list --help)");
    row("slam closures --kind x",
        "--kind: x is not one of inter, intra, all (see mapwright slam closures --help)");
    row("--json", "--json goes only with --version (see mapwright --help)");
    row("snapshot -o x.png -o y.png", "--output is given more than once (see mapwright snapshot --help)");
    row("maps list --robot demo: --robot demo:",
        "--robot is given more than once (see mapwright maps list --help)");
    // What every command has may stand before it and behind it.
    row("--log-file a.log maps list --log-file b.log --robot demo:", "--log-file is given more than once.");
    row("--log net maps list --log all --robot demo:", "--log is given more than once.");
    row("--language en maps list --language system --robot demo:", "--language is given more than once.");
    row("--version --log-file a.log",
        "--log-file has no effect beside --version, which only prints the version.");
    row("--version maps list", "maps has no effect beside --version, which only prints the version.");
    row("maps list --robot demo: --log-file -",
        "--log-file needs the name of a file. Without it, --log all writes to standard error.");
    row("snapshot --robot demo: -o x.png --log-file ./x.png",
        "x.png and ./x.png are the same file. Choose two different ones.");
  }
  void aWrongWordIsNamedWithTheNearestRightOne() {
    QFETCH(QString, line);
    QFETCH(QString, sentence);
    const Outcome outcome = run(line.split(QLatin1Char(' ')));
    QCOMPARE(outcome.err, sentence + QLatin1Char('\n'));
    QCOMPARE(outcome.code, 2);
    QVERIFY(outcome.out.isEmpty());
    QVERIFY2(!QFile::exists(at("a.log")) && !QFile::exists(at("b.log")), "nothing is begun");
  }

  void aNameThatIsNotUtf8IsSaid() {
    QProcess shell;
    shell.setProcessEnvironment(program_.environment());
    shell.setWorkingDirectory(program_.folder());
    shell.start(
        QStringLiteral("bash"),
        {QStringLiteral("-c"), QStringLiteral("touch $'caf\\xe9.mcap'; \"$0\" bags info $'caf\\xe9.mcap'"),
         QStringLiteral(MAPWRIGHT_PROGRAM)});
    QVERIFY(shell.waitForFinished());
    QCOMPARE(
        QString::fromUtf8(shell.readAllStandardError()),
        QStringLiteral("caf\uFFFD.mcap is not in UTF-8, and a file of that name cannot be opened. Rename it, "
                       "for example with convmv.\n"));
    QCOMPARE(shell.exitCode(), 2);
  }

  void aCommandWithoutItsSubcommandListsThem() {
    const Outcome outcome = run({QStringLiteral("overlays")});
    QCOMPARE(outcome.code, 2);
    QVERIFY2(outcome.err.startsWith(QLatin1String("overlays needs a subcommand: get, set, ")),
             qPrintable(outcome.err));
  }

  void whoStopsReadingHearsNothingOfIt() {
    QProcess shell;
    shell.start(QStringLiteral("bash"),
                {QStringLiteral("-c"), QStringLiteral("set -o pipefail; \"$0\" --help-all | head -1"),
                 QStringLiteral(MAPWRIGHT_PROGRAM)});
    QVERIFY(shell.waitForFinished());
    QCOMPARE(shell.readAllStandardError(), QByteArray());
    QCOMPARE(shell.exitCode(), 0);
  }

  void aRobotThatIsNotThereIsExitCodeThree() {
    const Outcome outcome =
        run({QStringLiteral("snapshot"), QStringLiteral("--robot"),
             QStringLiteral("axbot+http://127.0.0.1:1"), QStringLiteral("--output"), at("p.png")});
    QCOMPARE(outcome.code, 3);
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
    QVERIFY2(outcome.err.contains(QStringLiteral("127.0.0.1:1")), qPrintable(outcome.err));
    QVERIFY(!QFile::exists(at("p.png")));
  }

  void withoutADisplayTheWindowSaysSoAndTheDemoBecomesAPicture() {
    QCOMPARE(run({}).code, 2);
    const Outcome outcome = run({QStringLiteral("demo")});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.err));
    QVERIFY(outcome.out.contains(QStringLiteral("mapwright-demo.png")));
    QVERIFY(outcome.err.contains(QStringLiteral("no display")));
    QVERIFY(QFile::exists(at("mapwright-demo.png")));
  }

  void mapsAreListedExportedReadBackAndCompared() {
    const auto maps = [&](const QString& line) { return run(line.split(QLatin1Char(' '))); };
    const Outcome list = maps(QStringLiteral("maps list --robot demo: --json"));
    QVERIFY2(list.code == 0, qPrintable(list.err));
    const QJsonArray rows = QJsonDocument::fromJson(list.out.toUtf8()).array();
    QVERIFY(rows.size() >= 3);
    QString current;
    for (const QJsonValue& row : rows) {
      if (row.toObject()[QLatin1String("current")].toBool())
        current = row.toObject()[QLatin1String("id")].toString();
    }
    QVERIFY(!current.isEmpty());
    QVERIFY(maps(QStringLiteral("maps current --robot demo:")).out.startsWith(current));

    const Outcome exported =
        maps(QStringLiteral("maps export %1 --robot demo: --world-file -o one.yaml").arg(current));
    QVERIFY2(exported.code == 0, qPrintable(exported.err));
    QVERIFY(QFile::exists(at("one.pgm")) && QFile::exists(at("one.wld")));
    // How many cells it has is known when its picture is opened.
    const Outcome files = maps(QStringLiteral("maps list --robot one.yaml --json"));
    const QJsonObject grid =
        QJsonDocument::fromJson(files.out.toUtf8()).array().at(0)[QLatin1String("grid")].toObject();
    QVERIFY(grid[QLatin1String("size")].isNull() && grid[QLatin1String("resolution")].isDouble());
    const Outcome again = maps(QStringLiteral("maps export --robot one.yaml -o two.yaml"));
    QVERIFY2(again.code == 0, qPrintable(again.err));
    const Outcome same = maps(QStringLiteral("maps diff one.yaml two.yaml --json"));
    QVERIFY2(same.code == 0, qPrintable(same.err + same.out));
    QVERIFY(QJsonDocument::fromJson(same.out.toUtf8()).object()[QLatin1String("same")].toBool());
    const Outcome other = maps(QStringLiteral("maps diff one.yaml submaps --robot demo: --diff d.png"));
    QVERIFY2(other.code == 1, qPrintable(other.err));
    QVERIFY(QFile::exists(at("d.png")));
    QCOMPARE(maps(QStringLiteral("maps show 999 --robot demo:")).code, 4);
    QCOMPARE(maps(QStringLiteral("snapshot --robot one.yaml --raw --output raw.png --report r.json")).code,
             0);
    QFile report(at("r.json"));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QJsonObject json = QJsonDocument::fromJson(report.readAll()).object();
    QVERIFY(json[QLatin1String("complete")].toBool());
    QCOMPARE(json[QLatin1String("mode")].toString(), QStringLiteral("whole"));
  }

  void whatIsWrongWithAPictureIsSaidFirstAndByItsName() {
    const auto write = [&](const char* name, const QByteArray& bytes) {
      QFile file(at(name));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(bytes);
    };
    const auto map = [&](const char* name, const QByteArray& picture) {
      write(QByteArray(name).append(".pgm").constData(), picture);
      // Without free_thresh: that is a remark, and no reason.
      write(QByteArray(name).append(".yaml").constData(),
            "image: " + QByteArray(name) +
                ".pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n");
    };
    map("short", "P5\n10 10\n255\nabc");
    map("pointer", "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n");
    for (const char* line :
         {"maps show --robot short.yaml", "maps export --robot short.yaml -o e.png --force",
          "maps diff short.yaml short.yaml", "snapshot --robot short.yaml --output p.png"}) {
      const Outcome outcome = run(QString::fromLatin1(line).split(QLatin1Char(' ')));
      QVERIFY2(outcome.code == 1 && outcome.err.count(QLatin1Char('\n')) == 1, qPrintable(outcome.err));
      QVERIFY2(outcome.err.contains(QLatin1String("Picture short.pgm: Its header says 10 x 10")),
               qPrintable(QLatin1String(line) + outcome.err));
    }
    const Outcome pointer = run({QStringLiteral("maps"), QStringLiteral("show"), QStringLiteral("--robot"),
                                 QStringLiteral("pointer.yaml")});
    QVERIFY2(pointer.code == 2 &&
                 pointer.err.contains(QLatin1String("Picture pointer.pgm: It is a pointer of Git LFS")),
             qPrintable(pointer.err));
    const Outcome missing = run({QStringLiteral("maps"), QStringLiteral("show"), QStringLiteral("--robot"),
                                 QStringLiteral("maps/office.jpg")});
    QVERIFY2(missing.code == 2 && missing.err.contains(QLatin1String("There is no file")),
             qPrintable(missing.err));
  }

  void namesAreNoPlacesForNumbers() {
    const QString folder = at("50%1 %2");
    QVERIFY(QDir().mkpath(folder));
    const auto write = [&](const char* name, const QByteArray& bytes) {
      QFile file(folder + QLatin1Char('/') + QLatin1String(name));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    };
    write("%1.pgm", "P5\n2 3\n255\n\x01\x02\x03\x04\x05\x06");
    write("%1.yaml", "image: '%1.pgm'\nresolution: 0.25\norigin: [0, 0, 0]\n");
    write("%1.waypoints.geojson",
          R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"%2",
              "geometry":{"type":"Point","coordinates":[16.5,-37.25]},"properties":{"name":"%s%1 %4"}}]})");
    const QStringList robot{QStringLiteral("--robot"), folder + QStringLiteral("/%1.yaml")};
    const Outcome shown = run(QStringList{QStringLiteral("maps"), QStringLiteral("show")} + robot);
    QVERIFY2(shown.code == 0, qPrintable(shown.err));
    QVERIFY2(shown.out.contains(QLatin1String("%2 %s%1 %4  x 16.5 m, y -37.25 m")), qPrintable(shown.out));
    const QString picture = folder + QStringLiteral("/%1.png");
    const Outcome drawn = run(
        QStringList{QStringLiteral("snapshot"), QStringLiteral("--force"), QStringLiteral("-o"), picture} +
        robot);
    QVERIFY2(drawn.out.contains(picture) && drawn.out.contains(QLatin1String("2 x 3 cells")),
             qPrintable(drawn.out + drawn.err));
  }

  void namesCommandNoTerminal() {
    const QString evil = QStringLiteral("evil\x1b[2J") + QChar(0x9b) + QStringLiteral("31m") + QChar(0x202e);
    QVERIFY(QDir(program_.folder()).mkdir(QStringLiteral("evil")));
    QFile map(at("evil/") + evil + QStringLiteral(".pgm"));
    QVERIFY(map.open(QIODevice::WriteOnly));
    map.write("P5\n2 2\n255\n\x01\x02\x03\x04");
    map.close();
    const auto ask = [&](const QStringList& words) {
      const Outcome outcome = run(words + QStringList{QStringLiteral("--robot"), QStringLiteral("evil")});
      for (const QString& text : {outcome.out, outcome.err}) {
        for (const QChar c : text) {
          const bool layout = c == QLatin1Char('\n') || c == QLatin1Char('\t');
          if (!layout) QVERIFY2(c.isPrint(), qPrintable(words.join(QLatin1Char(' ')) + text.toHtmlEscaped()));
        }
      }
      QVERIFY(!(outcome.out + outcome.err).isEmpty());
    };
    const QString maps = QStringLiteral("maps"), json = QStringLiteral("--json");
    ask({maps, QStringLiteral("list")});
    ask({maps, QStringLiteral("list"), json});
    ask({maps, QStringLiteral("show"), evil + QStringLiteral(".pgm")});
    ask({maps, QStringLiteral("show"), evil + QStringLiteral(".pgm"), json});
    ask({maps, QStringLiteral("show"), evil});
    ask({maps, QStringLiteral("show"), evil, json});
    ask({maps, QStringLiteral("nonsense") + evil});
    ask({maps, QStringLiteral("export"), evil + QStringLiteral(".pgm"), QStringLiteral("-o"),
         evil + QStringLiteral(".png")});
    for (const char* report : {"r.json", "r2.json"}) {
      ask({QStringLiteral("snapshot"), QStringLiteral("--map"), evil + QStringLiteral(".pgm"),
           QStringLiteral("-o"), QStringLiteral("evil.png"), QStringLiteral("--report"), at(report),
           QLatin1String(report) == QLatin1String("r.json") ? json : QStringLiteral("--fit")});
    }
    const Outcome list =
        run({maps, QStringLiteral("list"), json, QStringLiteral("--robot"), QStringLiteral("evil")});
    const QJsonArray rows = QJsonDocument::fromJson(list.out.toUtf8()).array();
    QCOMPARE(rows.size(), 1);
    QCOMPARE(rows[0].toObject()[QLatin1String("id")].toString(), evil + QStringLiteral(".pgm"));
  }

  void submapsWithHolesAreNotComplete_data() {
    QTest::addColumn<QString>("fault");
    QTest::addColumn<int>("code");
    QTest::newRow("whole") << QString() << 0;
    QTest::newRow("missing") << QStringLiteral("--error-rate 0.4 --error-status 404") << 1;
    QTest::newRow("none at all") << QStringLiteral("--error-rate 1 --error-status 404") << 1;
    QTest::newRow("corrupt") << QStringLiteral("--wrong-size-rate 0.4") << 1;
    QTest::newRow("without a position") << QStringLiteral("--bad-entries") << 1;
  }
  void submapsWithHolesAreNotComplete() {
    QFETCH(QString, fault);
    QFETCH(int, code);
    QProcess robot;
    robot.setProcessEnvironment(program_.environment());
    robot.start(QStringLiteral(MAPWRIGHT_PROGRAM), QStringLiteral("simulate --paused --start-at 30 %1")
                                                       .arg(fault)
                                                       .split(QLatin1Char(' '), Qt::SkipEmptyParts));
    QVERIFY(robot.waitForReadyRead(30'000));
    const QJsonObject ready = QJsonDocument::fromJson(robot.readLine()).object();
    const QMap<QString, QString> env{
        {QStringLiteral("MAPWRIGHT_ROBOT"), ready[QLatin1String("axbot")].toString()}};
    const auto perform = [&](const char* line) {
      QFile::remove(at("r.json"));
      const Outcome outcome = run(QString::fromLatin1(line).split(QLatin1Char(' ')), env);
      QFile file(at("r.json"));
      const bool opened = file.open(QIODevice::ReadOnly);
      const QJsonObject report = opened ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
      return std::pair(outcome, report);
    };
    for (const char* line :
         {"snapshot -o s.png --report r.json", "maps export submaps --force -o e.png --report r.json",
          "maps diff submaps submaps --report r.json"}) {
      const auto [outcome, report] = perform(line);
      QVERIFY2(outcome.code == code, qPrintable(QLatin1String(line) + outcome.err + outcome.out));
      QVERIFY2(outcome.err.count(QLatin1Char('\n')) == (code ? 1 : 0), qPrintable(outcome.err));
      QCOMPARE(report[QLatin1String("complete")].toBool(), code == 0);
      QCOMPARE(report[QLatin1String("warnings")].toArray().isEmpty(), code == 0);
      // It is over: nothing will be requested again.
      const QByteArray all = outcome.err.toUtf8() + QJsonDocument(report).toJson();
      QVERIFY2(!all.contains("again"), all.constData());
    }
    robot.terminate();
    QVERIFY(robot.waitForFinished(30'000));
  }

  void whatIsNotThereInTimeHasNotFailed() {
    QProcess robot;
    robot.setProcessEnvironment(program_.environment());
    robot.start(QStringLiteral(MAPWRIGHT_PROGRAM),
                QStringLiteral("simulate --paused --start-at 30 --latency-ms 60000").split(QLatin1Char(' ')));
    QVERIFY(robot.waitForReadyRead(30'000));
    const QJsonObject ready = QJsonDocument::fromJson(robot.readLine()).object();
    const Outcome outcome =
        run(QStringLiteral("snapshot -o late.png --timeout 2 --json").split(QLatin1Char(' ')),
            {{QStringLiteral("MAPWRIGHT_ROBOT"), ready[QLatin1String("axbot")].toString()}});
    QCOMPARE(outcome.code, 1);
    const QJsonObject submaps =
        QJsonDocument::fromJson(outcome.out.toUtf8()).object()[QLatin1String("submaps")].toObject();
    QCOMPARE(submaps[QLatin1String("failed")].toInt(-1), 0);
    QVERIFY2(submaps[QLatin1String("pending")].toInt() > 0, qPrintable(outcome.out));
    robot.terminate();
    QVERIFY(robot.waitForFinished(30'000));
  }

  void aFileThatIsCalledLikeAMapIsNotThatMap() {
    QFile decoy(at("2"));
    QVERIFY(decoy.open(QIODevice::WriteOnly) && decoy.write("no map") > 0);
    decoy.close();
    const Outcome same = run({QStringLiteral("maps"), QStringLiteral("diff"), QStringLiteral("2"),
                              QStringLiteral("2"), QStringLiteral("--robot"), QStringLiteral("demo:")});
    QVERIFY2(same.code == 0, qPrintable(same.err + same.out));
    QVERIFY(QFile::remove(at("2")));
  }

  void simulateServesUntilItIsToldToStopAndSnapshotReadsIt() {
    QProcess robot;
    robot.setProcessEnvironment(program_.environment());
    robot.start(QStringLiteral(MAPWRIGHT_PROGRAM), {QStringLiteral("simulate"), QStringLiteral("--paused"),
                                                    QStringLiteral("--start-at"), QStringLiteral("30")});
    QVERIFY(robot.waitForReadyRead(30'000));
    const QJsonObject ready = QJsonDocument::fromJson(robot.readLine()).object();
    const QString address = ready[QLatin1String("axbot")].toString();
    QVERIFY(address.startsWith(QStringLiteral("axbot+http://127.0.0.1:")));

    const QMap<QString, QString> env{{QStringLiteral("MAPWRIGHT_ROBOT"), address}};
    const QStringList snapshot{
        QStringLiteral("snapshot"), QStringLiteral("--output"), at("one.png"),
        QStringLiteral("--size"),   QStringLiteral("300x200"),  QStringLiteral("--json")};
    const Outcome first = run(snapshot, env);
    QVERIFY2(first.code == 0, qPrintable(first.err));
    const QJsonObject report = QJsonDocument::fromJson(first.out.toUtf8()).object();
    QVERIFY(report[QLatin1String("fetches")].toInt() > 0);
    QFile one(at("one.png"));
    QVERIFY(one.open(QIODevice::ReadOnly));
    const QByteArray bytes = one.readAll();
    const Outcome second = run(snapshot, env);
    const QJsonObject again = QJsonDocument::fromJson(second.out.toUtf8()).object();
    QCOMPARE(again[QLatin1String("fetches")].toInt(), 0);
    QCOMPARE(again[QLatin1String("cache_hits")].toInt(), report[QLatin1String("fetches")].toInt());
    one.close();
    QVERIFY(one.open(QIODevice::ReadOnly));
    QCOMPARE(one.readAll(), bytes);

    const QString agibot = ready[QLatin1String("aimdk")].toString();
    const Outcome listed = run({QStringLiteral("maps"), QStringLiteral("list"), QStringLiteral("--robot"),
                                agibot, QStringLiteral("--json")});
    QVERIFY2(listed.code == 0, qPrintable(listed.err));
    QVERIFY(QJsonDocument::fromJson(listed.out.toUtf8()).array().size() >= 3);
    const Outcome park = run({QStringLiteral("snapshot"), QStringLiteral("--robot"), agibot,
                              QStringLiteral("--output"), at("a.png")});
    QVERIFY2(park.code == 0, qPrintable(park.err));

    robot.terminate();
    QVERIFY(robot.waitForFinished(30'000));
    QCOMPARE(robot.exitStatus(), QProcess::NormalExit);
    QCOMPARE(robot.exitCode(), 0);
  }
};

}  // namespace test_command_line

MAPWRIGHT_TEST(test_command_line, CommandLineTest, Core)
#include "test_command_line.moc"
