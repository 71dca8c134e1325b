#include <cmath>

#include <QTest>

#include "app/commands.h"
#include "app/snapshot.h"
#include "test_program.h"

namespace test_snapshot_options {

using namespace mapwright;
using app::parseSnapshotOptions;
using app::SnapshotArguments;
using app::SnapshotMode;

class SnapshotOptionsTest : public QObject {
  Q_OBJECT
 private:
  static SnapshotArguments words() {
    SnapshotArguments w;
    w.robot = "demo:";
    w.output = "picture.png";
    return w;
  }

 private Q_SLOTS:
  void withoutMoreItFitsEverything() {
    const auto options = parseSnapshotOptions(words());
    QVERIFY(options.has_value());
    QVERIFY(!options->center_m);
    QCOMPARE(options->size_px, QSize(1280, 800));
    QVERIFY(options->mode == SnapshotMode::Automatic);
    QVERIFY(options->layers.contains(ui::scene::Layer::Robot) &&
            !options->layers.contains(ui::scene::Layer::Ids));
  }

  void everyOptionIsTakenOver() {
    SnapshotArguments w = words();
    w.center = "12.5,-3";
    w.scale = 0.1;
    w.size = "640x480";
    w.rotate_deg = 450;
    w.layers = "submaps,ids";
    w.colors = "active";
    w.theme = "dark";
    w.settle = "2.5";
    const auto options = parseSnapshotOptions(w);
    QVERIFY(options.has_value());
    QCOMPARE(*options->center_m, Eigen::Vector2d(12.5, -3));
    QCOMPARE(options->size_px, QSize(640, 480));
    QVERIFY(std::abs(options->rotation_rad - 1.5707963267948966) < 1e-12);
    QCOMPARE(options->layers.size(), std::size_t(2));
    QCOMPARE(*options->settle_s, 2.5);
    QVERIFY(options->dark && options->colors == render::ColorMode::Active);
  }

  void everyColourHasAName() {
    const char* const names[] = {"normal", "incremental", "active", "trajectory", "age", "version"};
    int mode = 0;
    for (const char* name : names) {
      SnapshotArguments w = words();
      w.colors = name;
      const auto options = parseSnapshotOptions(w);
      QVERIFY(options && options->colors == render::ColorMode(mode++));
    }
    SnapshotArguments w = words();
    w.colors = "rainbow";
    QVERIFY(parseSnapshotOptions(w).error().contains(QLatin1String("trajectory, age or version")));
  }

  void aMapMeansTheWholeMode() {
    SnapshotArguments w = words();
    w.map = "1764059676131";
    auto options = parseSnapshotOptions(w);
    QVERIFY(options && options->mode == SnapshotMode::Whole && options->map->id == "1764059676131");
    w.mode = "submaps";
    QVERIFY(!parseSnapshotOptions(w));
    w.mode = "grid";
    w.map = "mapping:48";
    options = parseSnapshotOptions(w);
    QVERIFY(options && options->mode == SnapshotMode::Whole && options->map->kind == map::MapKind::Mapping);
  }

  void aBarePictureTakesItsPlaceFromTheOptions() {
    SnapshotArguments w = words();
    w.robot = "/maps/floor.png";
    w.resolution = "0.1";
    w.origin = "-3,4,0.5";
    QCOMPARE(parseSnapshotOptions(w)->robot,
             QStringLiteral("file:/maps/floor.png?resolution=0.1&origin=-3,4,0.5"));
  }

  void wrongWordsAreRefusedWithASentence_data() {
    QTest::addColumn<QString>("option");
    QTest::addColumn<QString>("value");
    const auto row = [](const char* option, const char* value) {
      QTest::addRow("%s=%s", option, value) << QString::fromLatin1(option) << QString::fromLatin1(value);
    };
    row("size", "0x10");
    row("size", "wide");
    row("size", "30000x30000");
    row("size", "99999999999x1");
    row("center", "1");
    row("center", "nan,0");
    row("center", "1e10,0");
    row("colors", "pink");
    row("theme", "blue");
    row("layers", "submaps,moon");
    row("settle", "soon");
    row("settle", "-1");
    row("mode", "hologram");
    row("robot", "");
    row("output", "/no/such/folder/p.png");
  }
  void wrongWordsAreRefusedWithASentence() {
    QFETCH(QString, option);
    QFETCH(QString, value);
    SnapshotArguments w = words();
    const std::string v = value.toStdString();
    if (option == QLatin1String("size")) w.size = v;
    if (option == QLatin1String("center")) w.center = v, w.scale = 1;
    if (option == QLatin1String("colors")) w.colors = v;
    if (option == QLatin1String("theme")) w.theme = v;
    if (option == QLatin1String("layers")) w.layers = v;
    if (option == QLatin1String("settle")) w.settle = v;
    if (option == QLatin1String("mode")) w.mode = v;
    if (option == QLatin1String("map")) w.map = v;
    if (option == QLatin1String("robot")) w.robot = v;
    if (option == QLatin1String("output")) w.output = v;
    const auto options = parseSnapshotOptions(w);
    QVERIFY(!options.has_value());
    QVERIFY(options.error().size() > 10);
  }

  void anOptionWithoutEffectIsRefused_data() {
    QTest::addColumn<SnapshotArguments>("given");
    QTest::addColumn<bool>("fine");
    const auto row = [](const char* name, bool fine, auto change) {
      SnapshotArguments w = words();
      change(w);
      QTest::newRow(name) << w << fine;
    };
    using W = SnapshotArguments;
    row("average of submaps", false, [](W& w) { w.mode = "submaps", w.average = true; });
    row("average of whole maps", true, [](W& w) { w.mode = "whole", w.average = true; });
    row("average of whatever is there", true, [](W& w) { w.average = true; });
    row("slice of a whole map", false, [](W& w) { w.map = "7", w.slice = 1; });
    row("slice of submaps", true, [](W& w) { w.slice = 1; });
    row("colours of a whole map", false, [](W& w) { w.mode = "whole", w.colors = "incremental"; });
    row("raw and dark", false, [](W& w) { w.raw = true, w.theme = "dark"; });
    row("raw and coloured", false, [](W& w) { w.raw = true, w.colors = "active"; });
    row("raw and a layer", false, [](W& w) { w.raw = true, w.layers = "submaps,robot"; });
    row("raw and all layers", false, [](W& w) { w.raw = true, w.layers = "all"; });
    row("raw and no layers", true, [](W& w) { w.raw = true, w.layers = "none"; });
    row("raw and the maps", true, [](W& w) { w.raw = true, w.layers = "submaps,whole"; });
    row("settles within the time", true, [](W& w) { w.settle = "60"; });
    row("settles after the time", false, [](W& w) { w.settle = "60.5"; });
    row("a place for a robot", false, [](W& w) { w.resolution = "0.1"; });
    row("a place for a yaml", false, [](W& w) { w.robot = "/maps/hall.yaml", w.origin = "1,2"; });
    row("a place twice", false, [](W& w) { w.robot = "file:/m/a.png?resolution=1", w.resolution = "2"; });
    row("a place for a picture", true, [](W& w) { w.robot = "/maps/hall.png", w.origin = "1,2"; });
  }
  void anOptionWithoutEffectIsRefused() {
    QFETCH(SnapshotArguments, given);
    QFETCH(bool, fine);
    const auto options = parseSnapshotOptions(given);
    QVERIFY2(options.has_value() == fine, options ? "taken" : qPrintable(options.error()));
    if (!fine) QVERIFY2(options.error().contains(QLatin1String("--")), qPrintable(options.error()));
  }

  void aRawPictureWantsNothingButTheMap() {
    SnapshotArguments w = words();
    w.raw = true;
    const auto options = parseSnapshotOptions(w);
    QVERIFY(options.has_value());
    for (const ui::scene::Layer layer : options->layers)
      QVERIFY(layer == ui::scene::Layer::Submaps || layer == ui::scene::Layer::WholeMap);
  }

  void numbersAreDecimal() {
    for (const char* word : {"0", "-0", "+1", "12", "-0.5", ".5", "5.", "1e-3", "1E+30"})
      QVERIFY2(app::isDecimal(word), word);
    for (const char* word : {"", " ", "nan", "inf", "-inf", "infinity", "0x10", "5m", "1,5", "--5", "1e", ".",
                             "1 2", " 1", "1_000", "٣"})
      QVERIFY2(!app::isDecimal(word), word);
  }

  void centerAndScaleBelongTogether() {
    SnapshotArguments w = words();
    w.center = "0,0";
    QVERIFY(!parseSnapshotOptions(w));
    w.scale = 0.05;
    QVERIFY(parseSnapshotOptions(w));
    w.fit = true;
    QVERIFY(!parseSnapshotOptions(w));
    w.fit = false;
    for (const double scale : {-1.0, 0.0, 1e-9, 1e9, std::nan(""), HUGE_VAL}) {
      w.scale = scale;
      QVERIFY2(!parseSnapshotOptions(w), qPrintable(QString::number(scale)));
      SnapshotArguments alone = words();
      alone.scale = scale;
      QVERIFY2(!parseSnapshotOptions(alone), qPrintable(QString::number(scale)));
    }
  }
};

}  // namespace test_snapshot_options

MAPWRIGHT_TEST(test_snapshot_options, SnapshotOptionsTest, Core)
#include "test_snapshot_options.moc"
