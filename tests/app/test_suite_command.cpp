// `compare` and `suite`: what a server that builds and tests sees, with differences that were planted.
#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QRegularExpression>
#include <QTcpServer>
#include <QTest>
#include <QXmlStreamReader>

#include "program.h"
#include "test_program.h"

namespace test_suite_command {

using namespace mapwright;
using tests::Ended;

namespace {

QStringList words(const char* typed) { return QString::fromUtf8(typed).split(QLatin1Char(' ')); }

/// Everything in a folder.
void copyFolder(const QString& from, const QString& to) {
  QDir().mkpath(to);
  for (const QFileInfo& one : QDir(from).entryInfoList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
    const QString target = to + QLatin1Char('/') + one.fileName();
    if (one.isDir())
      copyFolder(one.filePath(), target);
    else
      QFile::copy(one.filePath(), target);
  }
}

}  // namespace

class SuiteCommandTest : public QObject {
  Q_OBJECT
  std::unique_ptr<tests::Program> program_;

  Ended run(const QStringList& typed, const QMap<QString, QString>& environment = {}) const {
    tests::Program::Means means;
    means.environment = environment;
    return program_->run(typed, means);
  }
  Ended accept(const char* more = "") const {
    QStringList typed = words("suite accept suite.yaml --expected expected --report accepted");
    if (*more) typed += words(more);
    return run(typed);
  }
  Ended runSuite(const char* more = "") const {
    QStringList typed = words("suite run suite.yaml --expected expected --report report");
    if (*more) typed += words(more);
    return run(typed);
  }
  void replaceIn(const char* file, const QByteArray& from, const QByteArray& to) const {
    QByteArray bytes = program_->bytes(file);
    if (!bytes.contains(from)) qFatal("%s is not in %s", from.constData(), file);
    program_->put(file, bytes.replace(from, to));
  }
  /// Name -> kind and message of what failed.
  QMap<QString, QString> failures() const {
    QMap<QString, QString> found;
    QXmlStreamReader xml(program_->bytes("report/junit.xml"));
    QString name;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      if (xml.name() == QLatin1String("testcase"))
        name = xml.attributes().value(QLatin1String("name")).toString();
      if (xml.name() == QLatin1String("failure") || xml.name() == QLatin1String("error"))
        found[name] = xml.attributes().value(QLatin1String("message")).toString();
    }
    if (xml.hasError()) qFatal("junit.xml: %s", qPrintable(xml.errorString()));
    return found;
  }

 private Q_SLOTS:
  void init() {
    program_ = std::make_unique<tests::Program>();
    copyFolder(QStringLiteral(MAPWRIGHT_EXAMPLES "/maps-in-ci"), program_->folder());
  }

  void theExampleIsAsExpected() {
    const Ended ended = runSuite();
    QVERIFY2(ended.code == 0, qPrintable(ended.out + ended.err));
    QVERIFY(ended.out.endsWith(QStringLiteral("3 views as expected.\n")));
    QVERIFY(failures().isEmpty());
    QVERIFY(program_->bytes("report/report.html").contains("wall W17"));
    // What is as expected leaves no pictures.
    QVERIFY(QDir(program_->path("report/actual")).isEmpty());
  }

  void severalAtOnceGiveTheSameBytes() {
    QDir(program_->path("expected")).removeRecursively();
    QByteArrayList one, four;
    for (const auto& [jobs, into] : {std::pair("--jobs 1", &one), std::pair("--jobs 4", &four)}) {
      QCOMPARE(runSuite(jobs).code, 1);
      for (const char* name : {"cells", "overlays and waypoints", "wall W17"})
        *into << program_->bytes(qPrintable(QStringLiteral("report/actual/%1.png").arg(QLatin1String(name))));
    }
    QVERIFY(!one.first().isEmpty());
    QVERIFY(one == four);
  }

  void aWallThatMovedIsNamedAsTheCause() {
    replaceIn("map/office.overlays.geojson", "[-6.0, -2.0], [-3.0, -2.0]", "[-6.0, -1.6], [-3.0, -1.6]");
    const Ended ended = runSuite();
    QCOMPARE(ended.code, 1);
    const auto found = failures();
    QCOMPARE(found.size(), 2);
    const QString why = found[QStringLiteral("wall W17")];
    QVERIFY2(why.contains(QStringLiteral("virtual wall W17 moved by 0.40 m")), qPrintable(why));
    QVERIFY2(why.contains(QStringLiteral(" m² at (")), qPrintable(why));
    QVERIFY(!why.contains(QStringLiteral("Elsewhere")));
    QVERIFY(QFile::exists(program_->path("report/difference/wall W17.png")));
    QVERIFY(program_->bytes("report/report.html").contains("virtual wall W17 moved by 0.40 m"));
  }

  void overlaysThatCannotBeReadAreNotTakenForNone() {
    program_->put("map/office.overlays.geojson", program_->bytes("map/office.overlays.geojson").left(100));
    const QByteArray before = program_->bytes("expected/wall W17.png");
    QCOMPARE(runSuite().code, 1);
    const auto found = failures();
    QCOMPARE(found.size(), 2);
    const QString why = found[QStringLiteral("wall W17")];
    QVERIFY2(why.contains(QStringLiteral("office.overlays.geojson cannot be read: line 2, column ")),
             qPrintable(why));
    QVERIFY2(!why.contains(QStringLiteral("delete")), qPrintable(why));
    QCOMPARE(accept().code, 1);
    QCOMPARE(program_->bytes("expected/wall W17.png"), before);
    const Ended drawn = run(words("snapshot --robot map/office.yaml --layers overlays -o o.png --json"));
    QCOMPARE(drawn.code, 1);
    QCOMPARE(drawn.object()[QLatin1String("complete")].toBool(true), false);
    // Nobody asked for them.
    QCOMPARE(run(words("snapshot --robot map/office.yaml --layers none -o o.png")).code, 0);
  }

  void cellsThatChangedAreNamed() {
    QByteArray bytes = program_->bytes("map/office.pgm");
    for (int y = 60; y < 66; ++y) {
      for (int x = 80; x < 86; ++x) bytes[bytes.size() - 160 * 100 + y * 160 + x] = 0;
    }
    program_->put("map/office.pgm", bytes);
    QCOMPARE(runSuite().code, 1);
    const QString why = failures()[QStringLiteral("cells")];
    QVERIFY2(
        why.contains(QStringLiteral("at (0.3, -1.3): cells of map office.yaml changed within 1.60 x 3.20 m "
                                    "at (0.8, -1.4).")),
        qPrintable(why));
    QVERIFY2(!why.contains(QStringLiteral("lsewhere")), qPrintable(why));
  }
  void acceptRenewsFactsOfEarlierVersions() {
    const QByteArray now = program_->bytes("expected/cells.json");
    QJsonObject facts = QJsonDocument::fromJson(now).object();
    facts.remove(QLatin1String("picture"));
    QJsonObject map = facts[QLatin1String("map")].toObject();
    map.remove(QLatin1String("blocks"));
    facts[QLatin1String("map")] = map;
    program_->put("expected/cells.json", QJsonDocument(facts).toJson());
    QCOMPARE(accept("--only cells").code, 0);
    QCOMPARE(program_->bytes("expected/cells.json"), now);
  }

  /// As if `accept` had been killed between the picture and its facts.
  void factsOfAnotherPictureAreNoCauseAndAcceptRenewsThem() {
    const QByteArray old = program_->bytes("expected/wall W17.json");
    replaceIn("map/office.overlays.geojson", "[-6.0, -2.0], [-3.0, -2.0]", "[-6.0, -1.6], [-3.0, -1.6]");
    QCOMPARE(accept().code, 0);
    const QByteArray now = program_->bytes("expected/wall W17.json");
    program_->put("expected/wall W17.json", old);
    replaceIn("map/office.overlays.geojson", "[-6.0, -1.6], [-3.0, -1.6]", "[-6.0, -1.5], [-3.0, -1.5]");
    QCOMPARE(runSuite().code, 1);
    const QString why = failures()[QStringLiteral("wall W17")];
    QVERIFY2(why.contains(QStringLiteral("The facts beside expected/wall W17.png are of another picture.")),
             qPrintable(why));
    QVERIFY2(!why.contains(QStringLiteral("virtual wall")), qPrintable(why));
    replaceIn("map/office.overlays.geojson", "[-6.0, -1.5], [-3.0, -1.5]", "[-6.0, -1.6], [-3.0, -1.6]");
    const Ended ended = accept();
    QVERIFY2(ended.out.contains(QStringLiteral(
                 "wall W17: as expected, the facts beside it are new: expected/wall W17.json")),
             qPrintable(ended.out));
    QCOMPARE(program_->bytes("expected/wall W17.json"), now);
    QCOMPARE(program_->bytes("expected/wall W17.json").contains("\"picture\""), true);
    // Of a picture that stays and lacks them.
    QVERIFY(QFile::remove(program_->path("expected/wall W17.json")));
    QCOMPARE(accept().code, 0);
    QCOMPARE(program_->bytes("expected/wall W17.json"), now);
  }

  void anotherVersionOfASubmapIsNamed() {
    program_->put(
        "suite.yaml",
        "views:\n  - {name: slam, robot: \"demo:?submaps=6&seed=3\", mode: submaps, size: 300x200}\n");
    const Ended first = accept();
    QVERIFY2(first.code == 0, qPrintable(first.out + first.err));
    QVERIFY(first.out.contains(QStringLiteral("slam: new, ")));
    QCOMPARE(runSuite().code, 0);
    // As if other submaps had been expected, and another picture.
    QJsonObject facts = QJsonDocument::fromJson(program_->bytes("expected/slam.json")).object();
    QJsonArray submaps = facts[QLatin1String("submaps")].toArray();
    QVERIFY(submaps.size() > 2);
    QJsonObject one = submaps[2].toObject();
    const int version = one[QLatin1String("version")].toInt();
    one[QLatin1String("version")] = version - 1;
    submaps[2] = one;
    facts[QLatin1String("submaps")] = submaps;
    facts.remove(QLatin1String("picture"));  // as in files of earlier versions
    program_->put("expected/slam.json", QJsonDocument(facts).toJson());
    QImage picture(program_->path("expected/slam.png"));
    picture.fill(Qt::red);
    picture.save(program_->path("expected/slam.png"));
    QCOMPARE(runSuite().code, 1);
    const QString why = failures()[QStringLiteral("slam")];
    QVERIFY2(why.contains(QStringLiteral("submap %1 went from version %2 to %3")
                              .arg(one[QLatin1String("id")].toString())
                              .arg(version - 1)
                              .arg(version)),
             qPrintable(why));
  }

  void acceptSaysWhatItReplacesAndIsRefusedOnServers() {
    const Ended refused = run(words("suite accept suite.yaml --expected expected --report r"),
                              {{QStringLiteral("CI"), QStringLiteral("true")}});
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.err.contains(QStringLiteral("CI")));
    QVERIFY(accept().out.contains(QStringLiteral("cells: as expected, nothing is replaced")));
    replaceIn("map/office.overlays.geojson", "[-6.0, -2.0]", "[-6.0, -1.5]");
    const Ended ended = accept();
    QCOMPARE(ended.code, 0);
    QVERIFY2(ended.out.contains(QStringLiteral("wall W17: replaced expected/wall W17.png. ")),
             qPrintable(ended.out));
    QCOMPARE(runSuite().code, 0);
  }

  void aPictureAndItsFactsAreAcceptedTogetherOrNotAtAll() {
    replaceIn("map/office.overlays.geojson", "[-6.0, -2.0]", "[-6.0, -1.5]");
    const QByteArray before = program_->bytes("expected/wall W17.png");
    QVERIFY(QFile::remove(program_->path("expected/wall W17.json")));
    QVERIFY(QDir(program_->folder()).mkdir(QStringLiteral("expected/wall W17.json")));
    const Ended ended = accept();
    QCOMPARE(ended.code, 2);
    QVERIFY2(ended.out.contains(QStringLiteral("wall W17: nothing accepted. ")), qPrintable(ended.out));
    QCOMPARE(program_->bytes("expected/wall W17.png"), before);
    QVERIFY(QDir(program_->path("expected/wall W17.json")).removeRecursively());
    QCOMPARE(accept().code, 0);
    QVERIFY(program_->bytes("expected/wall W17.png") != before);
    QVERIFY(QFile::exists(program_->path("expected/wall W17.json")));
  }

  void aMaskOfAnotherSizeIsNotAccepted() {
    QImage(20, 10, QImage::Format_Grayscale8).save(program_->path("m.png"));
    program_->put("suite.yaml",
                  "views:\n  - {name: masked, robot: map/office.yaml, size: 100x80, mask: m.png}\n");
    const Ended ended = accept();
    QCOMPARE(ended.code, 2);
    QVERIFY2(ended.out.contains(QStringLiteral("masked: nothing accepted. ")) &&
                 ended.out.contains(QStringLiteral("20 x 10")),
             qPrintable(ended.out));
    QVERIFY(!QFile::exists(program_->path("expected/masked.png")));
  }

  void anAcceptedVariantIsAsGood() {
    QVERIFY(QFile::rename(program_->path("expected/cells.png"), program_->path("expected/cells.1.png")));
    QVERIFY(QFile::copy(program_->path("expected/wall W17.png"), program_->path("expected/cells.png")));
    const Ended ended = runSuite("--only cells");
    QVERIFY2(ended.code == 0, qPrintable(ended.out));
    QVERIFY(ended.out.contains(QStringLiteral("1 view as expected.")));
  }

  void aVariantEndsWhenItsPictureIsReplaced() {
    QVERIFY(QFile::copy(program_->path("expected/cells.png"), program_->path("expected/wall W17.1.png")));
    QVERIFY(QFile::copy(program_->path("expected/cells.json"), program_->path("expected/wall W17.1.json")));
    QVERIFY(QFile::copy(program_->path("expected/cells.png"), program_->path("expected/cells.1.png")));
    replaceIn("map/office.overlays.geojson", "[-6.0, -2.0]", "[-6.0, -1.5]");
    const Ended ended = accept();
    QCOMPARE(ended.code, 0);
    QVERIFY2(ended.out.contains(QStringLiteral("No longer accepted: wall W17.1.png.")),
             qPrintable(ended.out));
    QVERIFY(!QFile::exists(program_->path("expected/wall W17.1.png")));
    QVERIFY(!QFile::exists(program_->path("expected/wall W17.1.json")));
    QVERIFY(QFile::exists(program_->path("expected/cells.1.png")));  // its picture stays
  }

  void anExpectedPictureWhoseViewIsGoneIsNamed() {
    QVERIFY(QFile::copy(program_->path("expected/cells.png"), program_->path("expected/kitchen.png")));
    QVERIFY(QFile::copy(program_->path("expected/cells.png"), program_->path("expected/kitchen.2.png")));
    QVERIFY(QFile::copy(program_->path("expected/cells.png"), program_->path("expected/cells.1.png")));
    for (const Ended& ended : {runSuite(), runSuite("--only cells"), accept(),
                               run(words("suite list suite.yaml --expected expected"))}) {
      QCOMPARE(ended.code, 0);
      for (const char* name : {"kitchen.png", "kitchen.2.png"})
        QVERIFY2(ended.err.contains(QLatin1String("expected/") + QLatin1String(name) +
                                    QLatin1String(": no view of this suite makes this picture.")),
                 qPrintable(ended.err));
      QCOMPARE(ended.err.count(QLatin1Char('\n')), 2);
    }
  }

  void anAddressThatIsNoneIsRefusedBeforeAnythingIsDrawn() {
    program_->put("suite.yaml",
                  "views:\n  - {name: a, robot: map/office.yaml}\n  - {name: b, robot: \"no://x\"}\n");
    for (const Ended& ended : {runSuite(), run(words("suite list suite.yaml"))}) {
      QCOMPARE(ended.code, 2);
      QVERIFY2(ended.err.contains(QStringLiteral("Line 3, ")) && ended.err.contains(QStringLiteral("b: ")),
               qPrintable(ended.err));
    }
    QVERIFY(!QFile::exists(program_->path("report/actual/a.png")));
  }

  void optionsForSubmapsAreRefusedWhereThereAreNone() {
    for (const char* option : {"--slice 2", "--colors active"}) {
      const Ended ended = run(words("snapshot --robot map/office.yaml -o o.png") + words(option));
      QVERIFY2(ended.code == 2 && ended.err.contains(QStringLiteral("no submaps")), qPrintable(ended.err));
      QVERIFY(!QFile::exists(program_->path("o.png")));
    }
  }

  void anEmptyCIVariableIsNone() {
    QCOMPARE(run(words("suite accept suite.yaml --expected expected --report accepted"),
                 {{QStringLiteral("CI"), QString()}})
                 .code,
             0);
  }

  void theFactsOfAVariantAreThoseBesideIt() {
    // The wall lay elsewhere when the variant was accepted, which the nearest picture is.
    replaceIn("map/office.overlays.geojson", "[-6.0, -2.0], [-3.0, -2.0]", "[-6.0, -1.6], [-3.0, -1.6]");
    QCOMPARE(runSuite().code, 1);
    for (const char* kind : {"png", "json"})
      QVERIFY(QFile::rename(
          program_->path(qPrintable(QStringLiteral("report/actual/wall W17.%1").arg(QLatin1String(kind)))),
          program_->path(qPrintable(QStringLiteral("expected/wall W17.1.%1").arg(QLatin1String(kind))))));
    QCOMPARE(runSuite().code, 1);  // the other view with the wall
    QCOMPARE(failures().size(), 1);
    QVERIFY(!QFile::exists(program_->path("report/actual/wall W17.json")));
    replaceIn("map/office.overlays.geojson", "[-6.0, -1.6], [-3.0, -1.6]", "[-6.0, -1.6], [-2.9, -1.6]");
    QCOMPARE(runSuite().code, 1);
    QString why = failures()[QStringLiteral("wall W17")];
    QVERIFY2(why.contains(QStringLiteral("virtual wall W17")) && !why.contains(QStringLiteral("0.4")),
             qPrintable(why));
    // Those of another picture say nothing of this one.
    QVERIFY(QFile::remove(program_->path("expected/wall W17.1.json")));
    QCOMPARE(runSuite().code, 1);
    why = failures()[QStringLiteral("wall W17")];
    QVERIFY2(!why.contains(QStringLiteral("virtual wall")), qPrintable(why));
  }

  void aViewThatDoesNotComeIsAFailureWithItsSentence() {
    QTcpServer silent;  // takes the connection and says nothing
    QVERIFY(silent.listen(QHostAddress::LocalHost));
    program_->put("suite.yaml",
                  "views:\n  - {name: gone, robot: nowhere.yaml}\n"
                  "  - {name: away, robot: \"axbot+http://127.0.0.1:9\", timeout: 2}\n"
                  "  - {name: silent, robot: \"axbot+http://127.0.0.1:" +
                      QByteArray::number(silent.serverPort()) + "\", timeout: 2}\n");
    QCOMPARE(runSuite().code, 1);
    const auto found = failures();
    QVERIFY2(found[QStringLiteral("gone")].contains(QStringLiteral("nowhere.yaml")),
             qPrintable(found[QStringLiteral("gone")]));
    QVERIFY(found[QStringLiteral("away")].contains(QStringLiteral("127.0.0.1")));
    QVERIFY2(found[QStringLiteral("silent")].contains(QStringLiteral("no connection within 2 s")),
             qPrintable(found[QStringLiteral("silent")]));
    QVERIFY(!QFile::exists(program_->path("report/actual/gone.png")));
  }

  void namesWithMarkupStayText() {
    program_->put("suite.yaml",
                  "defaults: {robot: map/office.yaml, size: 100x80}\nviews:\n  - name: \"door <b>&'x' "
                  "\xF0\x9F\x9A\xAA\"\n");
    QCOMPARE(runSuite().code, 1);
    QCOMPARE(failures().firstKey(), QString::fromUtf8("door <b>&'x' \xF0\x9F\x9A\xAA"));
    QVERIFY(!program_->bytes("report/report.html").contains("<b>"));
  }

  void whatIsWrongIsRefused_data() {
    QTest::addColumn<QByteArray>("yaml");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const char* yaml, const char* word) {
      QTest::newRow(name) << QByteArray(yaml) << QString::fromUtf8(word);
    };
    row("an unknown key", "views:\n  - {name: a, robot: map/office.yaml, sizes: 1x1}", "Line 2, column 39");
    row("an option that snapshot refuses", "views:\n  - {name: a, robot: map/office.yaml, size: big}",
        "Line 2, column 45: a: --size");
    row("options that exclude each other",
        "views:\n  - {name: a, robot: map/office.yaml, raw: true, theme: dark}", "a: --raw");
    row("no number", "views:\n  - {name: a, robot: map/office.yaml, scale: x}", "--scale");
    row("no robot", "views:\n  - {name: a}", "names no robot");
    row("a missing mask", "views:\n  - {name: a, robot: map/office.yaml, mask: none.png}", "none.png");
    row("a limit that is none",
        "views:\n  - {name: a, robot: map/office.yaml, quality: {closures_over_m: x}}",
        "Line 2, column 66: closures_over_m must be a number");
    row("an option of files", "views:\n  - {name: a, robot: map/office.yaml, output: /tmp/x}", "\"output\"");
    row("a secret", "views:\n  - {name: a, robot: map/office.yaml, secret-file: /tmp/x}", "\"secret-file\"");
  }
  void whatIsWrongIsRefused() {
    QFETCH(QByteArray, yaml);
    QFETCH(QString, word);
    program_->put("suite.yaml", yaml);
    const Ended ended = runSuite();
    QCOMPARE(ended.code, 2);
    QVERIFY2(ended.err.contains(word), qPrintable(ended.err));
    QCOMPARE(ended.err.count(QLatin1Char('\n')), 1);
  }
  void foldersAndFilesThatAreNotThereAreRefused() {
    QCOMPARE(run(words("suite run none.yaml --expected expected --report report")).code, 2);
    QCOMPARE(run(words("suite run suite.yaml --expected expected --report suite.yaml")).code, 2);
    QCOMPARE(run(words("suite run suite.yaml --expected expected --report expected")).code, 2);
    QCOMPARE(runSuite("--only nobody").code, 2);
    QCOMPARE(runSuite("--jobs 0").code, 2);
    program_->put("expected/cells.png", "no picture");
    QCOMPARE(runSuite().code, 2);
    QVERIFY(failures().contains(QStringLiteral("cells")));
  }
  void theFolderOfTheReportIsNotThatOfTheExpected() {
    const QDir folder(program_->folder());
    QVERIFY(QFile::link(program_->path("expected"), program_->path("link")));
    QVERIFY(QFile::link(QStringLiteral("fresh"), program_->path("to fresh")));
    QVERIFY(QFile::link(QStringLiteral("."), program_->path("here")));
    for (const auto& [expected, report] :
         {std::pair("expected", "expected/"), std::pair("expected", "link"), std::pair("link", "expected"),
          std::pair("fresh", "fresh"), std::pair("fresh", "map/../fresh"), std::pair("fresh", "to fresh"),
          std::pair("here/fresh", "fresh"), std::pair("here/a/b", "a/b/")}) {
      const Ended ended = run({QStringLiteral("suite"), QStringLiteral("run"), QStringLiteral("suite.yaml"),
                               QStringLiteral("--expected"), QLatin1String(expected),
                               QStringLiteral("--report"), QLatin1String(report)});
      QVERIFY2(ended.code == 2 && ended.err.contains(QStringLiteral("same folder")), qPrintable(ended.err));
    }
    for (const char* made : {"expected/actual", "expected/difference", "fresh", "a"})
      QVERIFY2(!folder.exists(QLatin1String(made)), made);
  }
  void aRecordingWithoutATimeIsRefusedAtOnce() {
    program_->put("map/walk.mcap", "\x89MCAP0\r\n");
    for (const char* yaml : {"views:\n  - {name: a, robot: map/walk.mcap, timeout: 200}\n",
                             "views:\n  - {name: a, robot: \"file:map/walk.mcap\", timeout: 200}\n",
                             "views:\n  - {name: a, bag: map/walk.mcap, timeout: 200}\n",
                             "defaults: {timeout: 200}\nviews:\n  - {name: a}\n"}) {
      program_->put("suite.yaml", yaml);
      QElapsedTimer clock;
      clock.start();
      const Ended ended = runSuite(QByteArray(yaml).contains("walk") ? "" : "--robot map/walk.mcap");
      QVERIFY2(ended.code == 2, qPrintable(ended.out + ended.err));
      QVERIFY2(ended.err.contains(QStringLiteral("suite.yaml: Line ")), qPrintable(ended.err));
      QVERIFY2(ended.err.contains(QRegularExpression(QStringLiteral("\"at\"|--at"))), qPrintable(ended.err));
      QVERIFY(clock.elapsed() < 100'000);
    }
  }
  // quality

  void submapsThatContradictAreOverTheLimitAndTheirPlacesNamed() {
    const auto limited = [this](const char* limit) {
      program_->put("suite.yaml",
                    QByteArray("views:\n  - {name: slam, robot: \"demo:?submaps=30\", mode: submaps, size: "
                               "300x200, quality: {disagreement_over: ") +
                        limit + "}}\n");
    };
    limited("0");
    const Ended accepted = accept();
    QVERIFY2(accepted.code == 0, qPrintable(accepted.out + accepted.err));
    QVERIFY2(accepted.out.contains(QStringLiteral("more than 0 %")), qPrintable(accepted.out));
    const QJsonObject asked = run(words("slam disagreement --robot demo:?submaps=30 --json")).object();
    QJsonObject facts = QJsonDocument::fromJson(program_->bytes("expected/slam.json")).object();
    QJsonObject figures = facts[QLatin1String("disagreement")].toObject();
    for (const char* figure : {"tolerance_cells", "occupied_cells", "contradicted_cells", "share"})
      QCOMPARE(figures[QLatin1String(figure)], asked[QLatin1String(figure)]);
    QVERIFY(figures[QLatin1String("share")].toDouble() > 0);

    QCOMPARE(runSuite().code, 1);
    const QJsonObject worst = asked[QLatin1String("places")][0].toObject();
    const QString place = QStringLiteral("%1 cells at (%2, %3), submaps %4 ")
                              .arg(worst[QLatin1String("cells")].toInt())
                              .arg(worst[QLatin1String("x")].toDouble(), 0, 'f', 1)
                              .arg(worst[QLatin1String("y")].toDouble(), 0, 'f', 1)
                              .arg(worst[QLatin1String("submaps")][0].toString());
    QVERIFY(failures()[QStringLiteral("slam")].startsWith(QStringLiteral("Submaps contradict each other")));
    QVERIFY2(program_->bytes("report/junit.xml").contains(place.toUtf8()), qPrintable(place));
    QVERIFY(QString::fromUtf8(program_->bytes("report/report.html")).contains(place));
    QVERIFY(QFile::exists(program_->path("report/actual/slam.png")));

    // The limit holds: the change is still shown, and what a trend is made of kept.
    limited("1");
    figures[QLatin1String("contradicted_cells")] = 0;
    facts[QLatin1String("disagreement")] = figures;
    program_->put("expected/slam.json", QJsonDocument(facts).toJson());
    const Ended held = runSuite();
    QVERIFY2(held.code == 0, qPrintable(held.out + held.err));
    QVERIFY(failures().isEmpty());
    const QString change = QStringLiteral("contradicted cells 0 -> ");
    QVERIFY2(held.out.contains(QStringLiteral("slam: as expected. SLAM session: share 0 % -> ")),
             qPrintable(held.out));
    QVERIFY(QString::fromUtf8(program_->bytes("report/junit.xml")).contains(change.toHtmlEscaped()));
    QVERIFY(!QFile::exists(program_->path("report/actual/slam.png")));
    const QJsonObject kept = QJsonDocument::fromJson(program_->bytes("report/actual/slam.json")).object();
    QCOMPARE(kept[QLatin1String("disagreement")][QLatin1String("share")], asked[QLatin1String("share")]);
    QVERIFY(accept().out.contains(QStringLiteral("the facts beside it are new")));
    QVERIFY(accept().out.contains(QStringLiteral("nothing is replaced")));
  }
  void submapsAreComparedBehindAWholeMapToo() {
    program_->put(
        "suite.yaml",
        "views:\n  - {name: whole, robot: \"demo:?submaps=30\", mode: whole, size: 300x200, quality: "
        "{disagreement_over: 1}}\n");
    const Ended accepted = accept();
    QVERIFY2(accepted.code == 0, qPrintable(accepted.out + accepted.err));
    QVERIFY2(accepted.out.contains(QStringLiteral("SLAM session: share ")), qPrintable(accepted.out));
  }
  void whatCannotBeJudgedFailsWithItsReason() {
    program_->put(
        "suite.yaml",
        "defaults: {size: 100x80}\n"
        "views:\n"
        "  - {name: graph, robot: \"demo:?submaps=6\", mode: submaps, quality: {closures_over_m: 1}}\n"
        "  - {name: file, robot: map/office.yaml, quality: {disagreement_over: 1}}\n");
    const Ended accepted = accept();
    QCOMPARE(accepted.code, 1);
    QCOMPARE(accepted.out.count(QStringLiteral("nothing accepted")), 2);
    // Also where the picture itself is as expected.
    for (const char* name : {"graph", "file"})
      QFile::copy(
          program_->path(qPrintable(QStringLiteral("accepted/actual/%1.png").arg(QLatin1String(name)))),
          program_->path(qPrintable(QStringLiteral("expected/%1.png").arg(QLatin1String(name)))));
    QCOMPARE(runSuite().code, 1);
    const auto found = failures();
    const QString graph = found[QStringLiteral("graph")], file = found[QStringLiteral("file")];
    QVERIFY2(graph.startsWith(QStringLiteral("Loop closures could not be judged. ")), qPrintable(graph));
    QVERIFY2(file.contains(QStringLiteral("could not be judged: there is no list of submaps")),
             qPrintable(file));
    QVERIFY(program_->bytes("report/junit.xml").contains("errors=\"2\""));
  }
  void submapsThatAreMissingAreNotJudgedWithoutThem() {
    QProcess robot;
    robot.setProcessEnvironment(program_->environment());
    robot.start(QStringLiteral(MAPWRIGHT_PROGRAM), words("simulate --submaps 20 --wrong-size-rate 0.3"));
    QVERIFY(QTest::qWaitFor([&] { return robot.canReadLine(); }, 60'000));
    const QByteArray address =
        QJsonDocument::fromJson(robot.readLine()).object()[QLatin1String("axbot")].toString().toUtf8();
    program_->put("suite.yaml", "views:\n  - {name: few, robot: \"" + address +
                                    "\", mode: whole, layers: none, quality: {disagreement_over: 1}}\n");
    const Ended accepted = accept();
    robot.terminate();
    robot.waitForFinished();
    QCOMPARE(accepted.code, 1);
    QVERIFY2(accepted.out.startsWith(QStringLiteral("few: nothing accepted. Whether submaps contradict each "
                                                    "other could not be judged: ")),
             qPrintable(accepted.out));
    QVERIFY2(accepted.out.contains(QStringLiteral(" submaps are here.")), qPrintable(accepted.out));
  }

  void listTellsWhatIsExpected() {
    QFile::remove(program_->path("expected/cells.png"));
    const Ended ended = run(words("suite list suite.yaml --expected expected"));
    QCOMPARE(ended.code, 0);
    QVERIFY2(ended.out.contains(QStringLiteral("not expected yet")), qPrintable(ended.out));
    QVERIFY(ended.out.contains(QStringLiteral("1 accepted picture")));
  }

  // compare

  void compareTellsWhatDiffersAndWhere() {
    QCOMPARE(
        run(words("snapshot --robot map/office.yaml --layers none -o a.png --report a.json --size 320x200"))
            .code,
        0);
    QImage other(program_->path("a.png"));
    for (int y = 50; y < 56; ++y) {
      for (int x = 40; x < 46; ++x) other.setPixel(x, y, qRgb(200, 0, 0));
    }
    other.save(program_->path("b.png"));
    const Ended ended = run(words("compare a.png b.png --max-differing 50 --diff d.png --json"));
    QCOMPARE(ended.code, 1);
    const QJsonObject json = ended.object();
    QCOMPARE(json[QLatin1String("equal")].toBool(true), false);
    QCOMPARE(json[QLatin1String("differing")].toInt(), 36);
    const QJsonObject cluster = json[QLatin1String("clusters")].toArray().at(0).toObject();
    QCOMPARE(cluster[QLatin1String("box")].toArray(), (QJsonArray{40, 50, 6, 6}));
    QCOMPARE(cluster[QLatin1String("pixels")].toInt(), 36);
    QCOMPARE(cluster[QLatin1String("world")].toArray().size(), 4);
    QVERIFY(!json.contains(QLatin1String("sizes")));
    QCOMPARE(QImage(program_->path("d.png")).size(), other.size());
    QCOMPARE(run(words("compare a.png a.png")).code, 0);
  }
  void aReportThatDoesNotFitIsRefusedOrNotUsed() {
    QImage black(32, 20, QImage::Format_RGB32), white(32, 20, QImage::Format_RGB32);
    black.fill(Qt::black);
    white.fill(Qt::white);
    black.save(program_->path("a.png"));
    white.save(program_->path("b.png"));
    const auto report = [](const char* center, const char* size) {
      return QByteArray(R"({"view": {"center": )") + center + R"(, "scale": 0.05, "size": )" + size + "}}";
    };
    for (const auto& [bytes, fits] :
         {std::pair(report("[1, 2]", "[32, 20]"), true), std::pair(report("[1, 2]", "[33, 20]"), false),
          std::pair(report("[1e308, 2]", "[32, 20]"), false),
          std::pair(report("[1, -1e308]", "[32, 20]"), false),
          std::pair(report("[1, null]", "[32, 20]"), false)}) {
      program_->put("r.json", bytes);
      const Ended asked = run(words("compare a.png b.png --report r.json --json"));
      QVERIFY2(asked.code == (fits ? 1 : 2), bytes.constData());
      QCOMPARE(asked.err.count(QLatin1Char('\n')), fits ? 0 : 1);
      program_->put("b.json", bytes);
      const Ended found = run(words("compare a.png b.png --json"));
      QCOMPARE(found.code, 1);
      const QJsonObject cluster = found.object()[QLatin1String("clusters")].toArray().at(0).toObject();
      QCOMPARE(cluster.contains(QLatin1String("world")), fits);
    }
  }
  void compareSaysOtherSizesFirst() {
    QImage(10, 10, QImage::Format_Grayscale8).save(program_->path("a.png"));
    QImage(12, 10, QImage::Format_Grayscale8).save(program_->path("b.png"));
    const Ended ended = run(words("compare a.png b.png"));
    QCOMPARE(ended.code, 1);
    QVERIFY2(ended.out.startsWith(QStringLiteral("The sizes differ: 10 x 10 expected, 12 x 10 here.")),
             qPrintable(ended.out));
    const QJsonArray sizes =
        run(words("compare a.png b.png --json")).object()[QLatin1String("sizes")].toArray();
    QCOMPARE(sizes, (QJsonArray{QJsonArray{10, 10}, QJsonArray{12, 10}}));
  }
  void compareRefusesWhatItCannotRead() {
    QImage(10, 10, QImage::Format_Grayscale8).save(program_->path("a.png"));
    program_->put("bad.png", "no");
    for (const char* typed :
         {"compare a.png bad.png", "compare nowhere.png a.png", "compare a.png a.png --tolerance 256",
          "compare a.png a.png --max-differing 101", "compare a.png a.png --mask bad.png",
          "compare a.png a.png --diff a.png", "compare a.png a.png --report bad.png", "compare a.png"}) {
      const Ended ended = run(words(typed));
      QVERIFY2(ended.code == 2, typed);
      QCOMPARE(ended.err.count(QLatin1Char('\n')), 1);
    }
    QCOMPARE(QImage(program_->path("a.png")).size(), QSize(10, 10));
  }
};

}  // namespace test_suite_command

MAPWRIGHT_TEST(test_suite_command, SuiteCommandTest, Core)
#include "test_suite_command.moc"
