// What a snapshot does not depend on (docs/same-bytes.md).
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_same_bytes {

using namespace mapwright;
using tests::EndedBytes;
using tests::Program;

namespace {

simulator::Options paused() {
  simulator::Options options;
  options.paused = true;
  return options;
}

constexpr int kNotAllowed = 77;

constexpr char kOverlays[] =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"w","properties":{"lineType":"2","name":"Wand Ö"},)"
    R"("geometry":{"type":"LineString","coordinates":[[0.3,0.3],[2.7,1.9]]}},{"type":"Feature","id":"p",)"
    R"("properties":{"type":"34","name":"رف 12 🚀","yaw":"90"},"geometry":{"type":"Point","coordinates":[1.5,1.0]}}]})";

}  // namespace

class SameBytesTest : public QObject {
  Q_OBJECT
  Program program_;
  std::unique_ptr<simulator::Simulator> robot_;
  QMap<QString, QByteArray> expected_;

  QMap<QString, QStringList> pictures() const {
    const auto of = [](const char* line) { return QString::fromLatin1(line).split(QLatin1Char(' ')); };
    const QStringList live{QStringLiteral("--robot"), QString::fromStdString(robot_->address())};
    const QStringList local{QStringLiteral("--robot"), program_.path("map.yaml")};
    return {
        {QStringLiteral("submaps"), live + of("--layers all --theme dark --rotate 17 --size 640x480")},
        {QStringLiteral("raw"), live + of("--raw --rotate 33.3 --center 2,1 --scale 0.021 --size 333x444")},
        {QStringLiteral("overlays"), local + of("--layers all --size 500x400")}};
  }
  EndedBytes picture(const QStringList& options, const Program::Means& means) const {
    return program_.runForBytes(
        QStringList{QStringLiteral("snapshot"), QStringLiteral("-o"), QStringLiteral("-")} + options, means);
  }
  QByteArray pictureOf(const QStringList& options, const Program::Means& means) const {
    const EndedBytes ended = picture(options, means);
    if (!ended.out.startsWith("\x89PNG")) qWarning("%s", ended.err.constData());
    return ended.out;
  }

 private Q_SLOTS:
  void initTestCase() {
    robot_ = std::make_unique<simulator::Simulator>(paused());
    QVERIFY(!robot_->start());
    QByteArray cells(60 * 40, '\xfe');
    for (int i = 0; i < cells.size(); i += 7) cells[i] = char(i % 206);
    program_.put("map.pgm", "P5\n60 40\n255\n" + cells);
    program_.put("map.yaml",
                 "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                 "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
    program_.put("map.geojson", kOverlays);
    const auto all = pictures();
    for (auto it = all.begin(); it != all.end(); ++it) {
      expected_[it.key()] = pictureOf(it.value(), {});
      QVERIFY2(expected_[it.key()].startsWith("\x89PNG"), qPrintable(it.key()));
    }
    QVERIFY(expected_[QStringLiteral("submaps")] != expected_[QStringLiteral("raw")]);
  }
  void cleanupTestCase() { robot_.reset(); }

  void theSurroundingsChangeNoByte_data() {
    QTest::addColumn<QMap<QString, QString>>("environment");
    using Words = QMap<QString, QString>;
    const auto one = [](const char* name, const char* value) {
      return Words{{QString::fromLatin1(name), QString::fromLatin1(value)}};
    };
    QTest::newRow("again") << Words();
    for (const char* locale : {"C", "de_DE.UTF-8", "tr_TR.UTF-8", "ar_EG.UTF-8", "ja_JP.UTF-8", "zz"}) {
      Words words = one("LC_ALL", locale);
      words[QStringLiteral("LANG")] = words[QStringLiteral("LANGUAGE")] = QString::fromLatin1(locale);
      QTest::newRow(locale) << words;
    }
    QTest::newRow("time zone") << one("TZ", "Pacific/Apia");
    QTest::newRow("home") << one("HOME", "/nonexistent");
    Words desktop{{QStringLiteral("QT_SCALE_FACTOR"), QStringLiteral("2")},
                  {QStringLiteral("QT_FONT_DPI"), QStringLiteral("192")},
                  {QStringLiteral("QT_STYLE_OVERRIDE"), QStringLiteral("windows")},
                  {QStringLiteral("QT_QPA_PLATFORMTHEME"), QStringLiteral("gtk3")},
                  {QStringLiteral("QT_SCREEN_SCALE_FACTORS"), QStringLiteral("1.5")},
                  {QStringLiteral("XDG_CURRENT_DESKTOP"), QStringLiteral("KDE")},
                  {QStringLiteral("QT_AUTO_SCREEN_SCALE_FACTOR"), QStringLiteral("1")}};
    QTest::newRow("desktop") << desktop;
    QTest::newRow("small letters") << one("QT_FONT_DPI", "48");
    QTest::newRow("one thread") << one("MAPWRIGHT_THREADS", "1");
    QTest::newRow("eight threads") << one("MAPWRIGHT_THREADS", "8");
    QTest::newRow("portable code") << one("MAPWRIGHT_PORTABLE", "1");
    QTest::newRow("a cache that cannot be written") << one("XDG_CACHE_HOME", "/proc/none");
  }
  void theSurroundingsChangeNoByte() {
    using Words = QMap<QString, QString>;
    QFETCH(Words, environment);
    const auto all = pictures();
    for (auto it = all.begin(); it != all.end(); ++it)
      QVERIFY2(pictureOf(it.value(), {.environment = environment}) == expected_[it.key()],
               qPrintable(it.key()));
  }

  void oneProcessorMakesTheSame() {
    const auto all = pictures();
    const Program::Means means{.in_child = [] {
      cpu_set_t one;
      CPU_ZERO(&one);
      CPU_SET(0, &one);
      sched_setaffinity(0, sizeof(one), &one);
    }};
    for (auto it = all.begin(); it != all.end(); ++it)
      QVERIFY2(pictureOf(it.value(), means) == expected_[it.key()], qPrintable(it.key()));
  }

  void installedFontsChangeNoLetter() {
    const Program::Means means{.in_child = [] {
      const bool apart = ::unshare(CLONE_NEWNS) == 0 || ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
      if (!apart || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
          ::mount("none", "/usr/share/fonts/truetype/dejavu", "tmpfs", 0, nullptr) != 0)
        ::_exit(kNotAllowed);
    }};
    const auto all = pictures();
    for (auto it = all.begin(); it != all.end(); ++it) {
      const EndedBytes ended = picture(it.value(), means);
      if (ended.code == kNotAllowed) QSKIP("folders cannot be hidden from a program here");
      QVERIFY2(ended.out == expected_[it.key()], qPrintable(it.key()));
    }
  }
};

}  // namespace test_same_bytes

MAPWRIGHT_TEST(test_same_bytes, SameBytesTest, Core)
#include "test_same_bytes.moc"
