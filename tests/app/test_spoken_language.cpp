// --language: what commands say follows it, and nothing else does.
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include "program.h"
#include "test_program.h"

namespace test_spoken_language {

using mapwright::tests::Ended;
using mapwright::tests::Program;

namespace {

bool isChinese(const QString& text) {
  static const QRegularExpression kHan(QStringLiteral("\\p{Han}"));
  return text.contains(kHan);
}

QStringList words(const char* line) { return QString::fromLatin1(line).split(QLatin1Char(' ')); }

}  // namespace

class SpokenLanguageTest : public QObject {
  Q_OBJECT
  Program program_;
  const QMap<QString, QString> chinese_{{QStringLiteral("LC_ALL"), QStringLiteral("zh_CN.UTF-8")},
                                        {QStringLiteral("LANGUAGE"), QStringLiteral("zh_CN")}};

  Ended run(const char* line, const QMap<QString, QString>& environment = {}) const {
    return program_.run(words(line), {.environment = environment});
  }

 private Q_SLOTS:
  void helpIsTranslated_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {"--help --language zh_CN", "--language=zh_CN maps export --help",
                             "maps list --language zh_CN --help", "--help-all --language zh_CN"})
      QTest::newRow(line) << QString::fromLatin1(line);
  }
  void helpIsTranslated() {
    QFETCH(QString, line);
    const Ended ended = program_.run(line.split(QLatin1Char(' ')));
    QCOMPARE(ended.code, 0);
    for (const char* english : {"Options:", "Subcommands:", "Positionals:", "Usage:", "Print this"})
      QVERIFY2(!ended.out.contains(QLatin1String(english)), english);
    QVERIFY(isChinese(ended.out));
    QVERIFY(ended.out.contains(QStringLiteral("--language")));
  }

  void commandsSpeakEnglishWhateverTheSystemSpeaks() {
    for (const char* line :
         {"--help", "maps list --robot demo:", "maps list", "maps show nothing --robot demo:"}) {
      const Ended usual = run(line), there = run(line, chinese_);
      QCOMPARE(there.out, usual.out);
      QCOMPARE(there.err, usual.err);
      QVERIFY(!isChinese(usual.err));
    }
    QVERIFY(!isChinese(run("--help", chinese_).out));
    QVERIFY(isChinese(run("--help --language system", chinese_).out));
  }

  void errorsAreTranslatedBeforeAndWhileTheCommandRuns() {
    for (const char* line :
         {"maps list --language zh_CN", "snapshot --robot demo: -o p.tiff --language zh_CN",
          "snapshot --language zh_CN", "snapshot --robot demo: -o --language zh_CN",
          "--language zh_CN slam constraints --kind x", "simulate --port 70000 --language zh_CN",
          "maps show nothing --robot demo: --language zh_CN", "probe --language zh_CN --timeout -1 demo"}) {
      const Ended ended = run(line);
      QVERIFY(ended.code != 0);
      QCOMPARE(ended.err.count(QLatin1Char('\n')), 1);
      QVERIFY2(isChinese(ended.err), qPrintable(ended.err));
    }
  }

  void anUnknownLanguageIsOneLineAndExitCodeTwo() {
    for (const char* line : {"maps list --robot demo: --language klingon", "--language zh_TW --help",
                             "--language=nonsense", "--language  --help"}) {
      const Ended ended = run(line);
      QCOMPARE(ended.code, 2);
      QVERIFY2(ended.err.count(QLatin1Char('\n')) == 1 && ended.out.isEmpty(),
               qPrintable(ended.out + ended.err));
    }
    QVERIFY(run("--language klingon").err.contains(QStringLiteral("en, zh_CN and system")));
  }

  void namesThatAreStoredAreInNoLanguage() {
    program_.put("map.pgm", "P5\n2 2\n255\n\xff\xff\xff\xff");
    program_.put("map.yaml",
                 "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                 "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    program_.put("places.csv", "x,y\n1,2\n3,4\n");
    const Ended in = run("waypoints import places.csv --robot map.yaml --language zh_CN");
    QVERIFY2(in.code == 0, qPrintable(in.err));
    QVERIFY2(isChinese(in.out + in.err), qPrintable(in.out + in.err));
    const Ended list = run("waypoints list --robot map.yaml --json");
    QVERIFY2(list.out.contains(QLatin1String("Waypoint 1")) && !isChinese(list.out), qPrintable(list.out));
  }

  void membersOfJsonStayAsTheyAre() {
    const Ended usual = run("maps list --robot demo: --json"),
                there = run("maps list --robot demo: --json --language zh_CN");
    QCOMPARE(there.code, 0);
    QCOMPARE(there.out, usual.out);
  }

  void labelsOfTypesFollowItAndPicturesAreTheSameByDefault() {
    const char* const line = "snapshot --robot demo: --mode whole --layers overlays --size 1200x800 -o ";
    const auto drawn = [&](const char* file, const char* more, const QMap<QString, QString>& environment) {
      QStringList all = words(line).mid(0, words(line).size() - 1) + QStringList{program_.path(file)};
      if (*more) all += words(more);
      const Ended ended = program_.run(all, {.environment = environment});
      return ended.code == 0 ? program_.bytes(file) : ended.err.toUtf8();
    };
    const QByteArray usual = drawn("usual.png", "", {});
    QVERIFY2(usual.startsWith("\x89PNG"), usual.constData());
    QVERIFY(drawn("there.png", "", chinese_) == usual);
    const QByteArray chinese = drawn("chinese.png", "--language zh_CN", {});
    QVERIFY2(chinese.startsWith("\x89PNG"), chinese.constData());
    QVERIFY(chinese != usual);
  }
};

}  // namespace test_spoken_language

MAPWRIGHT_TEST(test_spoken_language, SpokenLanguageTest, Core)
#include "test_spoken_language.moc"
