// Snapshots of the simulated robot: repeatable, complete, honest.
#include <cmath>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/exit_code.h"
#include "app/robot_factory.h"
#include "app/snapshot_run.h"
#include "test_program.h"
#include "ui/scene/map_theme.h"

namespace test_snapshot_run {

using namespace mapwright;
using app::SnapshotOptions;
using app::SnapshotRun;

class SnapshotRunTest : public QObject {
  Q_OBJECT
 private:
  QTemporaryDir folder_;

  SnapshotOptions small(const QString& name) const {
    app::SnapshotArguments words;
    words.robot = "demo:";
    words.output = folder_.filePath(name).toStdString();
    words.size = "320x240";
    return *app::parseSnapshotOptions(words);
  }
  static simulator::Options frozen() { return *app::parseDemoQuery(QUrlQuery(), app::DemoTime::Frozen); }

  /// Runs to the end; the exit code.
  static int take(const SnapshotOptions& options, const simulator::Options& robot,
                  QJsonObject* report = nullptr) {
    auto made = app::makeDemoRobot(QStringLiteral("demo:"), robot);
    if (!made) return -1;
    SnapshotRun run(options, std::move(*made));
    QSignalSpy finished(&run, &SnapshotRun::finished);
    run.start();
    if (!finished.wait(120'000)) return -2;
    if (report) *report = run.report();
    return finished.at(0).at(0).toInt();
  }
  QByteArray bytesOf(const QString& name) const {
    QFile file(folder_.filePath(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private Q_SLOTS:
  void theSameRobotGivesTheSameBytes() {
    QJsonObject report;
    QCOMPARE(take(small(QStringLiteral("a.png")), frozen(), &report), int(app::kDone));
    QCOMPARE(take(small(QStringLiteral("b.png")), frozen()), int(app::kDone));
    QVERIFY(bytesOf(QStringLiteral("a.png")).size() > 1000);
    QCOMPARE(bytesOf(QStringLiteral("a.png")), bytesOf(QStringLiteral("b.png")));
    const QJsonObject submaps = report[QLatin1String("submaps")].toObject();
    QVERIFY(report[QLatin1String("complete")].toBool());
    QVERIFY(submaps[QLatin1String("listed")].toInt() > 0);
    QCOMPARE(submaps[QLatin1String("drawn")].toInt(), submaps[QLatin1String("listed")].toInt());
    QVERIFY(report[QLatin1String("warnings")].toArray().isEmpty());
  }

  void theRobotIsLeftOutOfAMapThatItIsNotIn() {
    const auto other = [&](const std::string& layers, const QString& name, bool anyway = false) {
      app::SnapshotArguments words;
      words.robot = "demo:";
      words.output = folder_.filePath(name).toStdString();
      words.size = "320x240";
      words.mode = std::string("whole");
      words.map = std::string("2");
      words.layers = layers;
      words.robot_anyway = anyway;
      return *app::parseSnapshotOptions(words);
    };
    const auto warnings = [](const QJsonObject& report) {
      QStringList all;
      for (const QJsonValue& each : report[QLatin1String("warnings")].toArray()) all << each.toString();
      return all.join(QLatin1Char('\n'));
    };
    QJsonObject report;
    QCOMPARE(take(other("grid,robot,trail,footprint", QStringLiteral("with.png")), frozen(), &report),
             int(app::kDone));
    QVERIFY2(warnings(report).contains(QLatin1String("Left out: trail, footprint, robot.")),
             qPrintable(warnings(report)));
    QCOMPARE(take(other("grid", QStringLiteral("without.png")), frozen(), &report), int(app::kDone));
    QVERIFY2(warnings(report).isEmpty(), qPrintable(warnings(report)));
    QCOMPARE(bytesOf(QStringLiteral("with.png")), bytesOf(QStringLiteral("without.png")));
    // One of its overlays has no points.
    QCOMPARE(take(other("overlays", QStringLiteral("overlays.png")), frozen(), &report), int(app::kDone));
    QVERIFY2(warnings(report).contains(QLatin1String("1 feature of its overlays cannot be read")),
             qPrintable(warnings(report)));
    QCOMPARE(take(other("grid,robot", QStringLiteral("anyway.png"), true), frozen(), &report),
             int(app::kDone));
    QVERIFY(warnings(report).contains(QLatin1String("Drawn anyway: robot.")));
  }

  void theRawPictureHoldsIntensityAndObservation() {
    SnapshotOptions options = small(QStringLiteral("raw.png"));
    options.raw = true;
    options.center_m = Eigen::Vector2d(5, 5);
    options.scale_m_per_px = 0.05;
    QCOMPARE(take(options, frozen()), int(app::kDone));
    const QImage picture =
        QImage(folder_.filePath(QStringLiteral("raw.png"))).convertToFormat(QImage::Format_ARGB32);
    QCOMPARE(picture.size(), QSize(320, 240));
    int observed = 0, free = 0, occupied = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const QRgb pixel = picture.pixel(x, y);
        QVERIFY(qRed(pixel) == qGreen(pixel) && qGreen(pixel) == qBlue(pixel));
        if (qAlpha(pixel) == 0) {
          QCOMPARE(qRed(pixel), 128);
          continue;
        }
        QCOMPARE(qAlpha(pixel), 255);
        ++observed;
        free += qRed(pixel) > 160;
        occupied += qRed(pixel) < 90;
      }
    }
    QVERIFY(observed > 5000 && free > observed / 2 && occupied > 50);
  }

  void theWindowsSceneShowsTheSamePixelsAsTheRawPicture() {
    SnapshotOptions options = small(QStringLiteral("plain.png"));
    options.layers = {ui::scene::Layer::Submaps};
    QCOMPARE(take(options, frozen()), int(app::kDone));
    options = small(QStringLiteral("raw2.png"));
    options.raw = true;
    QCOMPARE(take(options, frozen()), int(app::kDone));
    const QImage plain(folder_.filePath(QStringLiteral("plain.png")));
    const QImage raw =
        QImage(folder_.filePath(QStringLiteral("raw2.png"))).convertToFormat(QImage::Format_ARGB32);
    const render::MapColors colors = ui::scene::lightMapTheme().map;
    const auto mixed = [](QRgb dark, QRgb light, int intensity) {
      return dark + (light - dark) * intensity / 255.0;
    };
    for (int y = 0; y < raw.height(); ++y) {
      for (int x = 0; x < raw.width(); ++x) {
        const QRgb pixel = raw.pixel(x, y), shown = plain.pixel(x, y);
        if (qAlpha(pixel) == 0) {
          QCOMPARE(shown, QRgb(colors.unknown));
        } else {
          const double red = mixed(QRgb(qRed(colors.occupied)), QRgb(qRed(colors.free)), qRed(pixel));
          QVERIFY(std::abs(qRed(shown) - red) <= 1.0);
        }
      }
    }
  }

  void aTurnedPictureIsTheSameMapTurned() {
    // A quarter turn maps pixel centres onto pixel centres, so the pictures must agree closely.
    SnapshotOptions upright = small(QStringLiteral("upright.png"));
    upright.raw = true;
    upright.size_px = QSize(240, 240);
    upright.center_m = Eigen::Vector2d(5, 5);
    upright.scale_m_per_px = 0.05;
    QCOMPARE(take(upright, frozen()), int(app::kDone));
    SnapshotOptions turned = upright;
    turned.output = folder_.filePath(QStringLiteral("turned.png"));
    turned.rotation_rad = geometry::radiansFromDegrees(90);
    QCOMPARE(take(turned, frozen()), int(app::kDone));
    const QImage a =
        QImage(folder_.filePath(QStringLiteral("upright.png"))).convertToFormat(QImage::Format_ARGB32);
    const QImage b =
        QImage(folder_.filePath(QStringLiteral("turned.png"))).convertToFormat(QImage::Format_ARGB32);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 240; ++x) {
        const QRgb p = a.pixel(x, y), q = b.pixel(y, 239 - x);  // counter-clockwise
        if (qAlpha(p) == 0 || qAlpha(q) == 0) continue;
        sum += std::abs(qRed(p) - qRed(q));
        ++count;
      }
    }
    QVERIFY(count > 1000);
    QVERIFY2(sum / count < 0.5, qPrintable(QString::number(sum / count)));
  }

  void whatIsMissingIsSaid() {
    simulator::Options robot = frozen();
    robot.faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kSubmaps, 0.3, 404});
    QJsonObject report;
    QCOMPARE(take(small(QStringLiteral("missing.png")), robot, &report), int(app::kIncomplete));
    QVERIFY(!report[QLatin1String("complete")].toBool());
    const QJsonObject submaps = report[QLatin1String("submaps")].toObject();
    QVERIFY(submaps[QLatin1String("missing")].toInt() > 0);
    QCOMPARE(submaps[QLatin1String("missing")].toInt() + submaps[QLatin1String("drawn")].toInt(),
             submaps[QLatin1String("listed")].toInt());
    QCOMPARE(report[QLatin1String("warnings")].toArray().size(), submaps[QLatin1String("missing")].toInt());
    QVERIFY(!bytesOf(QStringLiteral("missing.png")).isEmpty());
  }

  void aSilentRobotEndsAtTheTimeout() {
    simulator::Options robot = frozen();
    robot.faults.silent_websocket = true;
    SnapshotOptions options = small(QStringLiteral("silent.png"));
    options.timeout_s = 1;
    QJsonObject report;
    QCOMPARE(take(options, robot, &report), int(app::kIncomplete));
    QVERIFY(!report[QLatin1String("complete")].toBool());
    QVERIFY(report[QLatin1String("warnings")].toArray().at(0).toString().contains(
        QStringLiteral("no submap list")));
  }

  void whereNoListOfSubmapsComesTheWholeMapIsDrawn() {
    simulator::Options robot = frozen();
    robot.faults.silent_websocket = true;
    SnapshotOptions options = small(QStringLiteral("instead.png"));
    options.timeout_s = 30;
    QJsonObject report;
    QCOMPARE(take(options, robot, &report), int(app::kDone));
    QCOMPARE(report[QLatin1String("mode")].toString(), QStringLiteral("whole"));
    QVERIFY(!report[QLatin1String("map")].toObject().isEmpty());
    const QStringList warnings = report[QLatin1String("warnings")].toVariant().toStringList();
    QVERIFY2(warnings.join(QLatin1Char('|')).contains(QLatin1String("its whole map is drawn instead")),
             qPrintable(warnings.join(QLatin1Char('|'))));
    // Who asks for submaps gets nothing else.
    options.mode = app::SnapshotMode::Submaps;
    options.timeout_s = 5;
    QCOMPARE(take(options, robot, &report), int(app::kIncomplete));
    QCOMPARE(report[QLatin1String("mode")].toString(), QStringLiteral("submaps"));
  }

  void aRobotThatLooksForASecretItDoesNotGetRefuses() {
    simulator::Options robot = frozen();
    robot.secret = std::string("open sesame");
    QCOMPARE(take(small(QStringLiteral("refused.png")), robot), int(app::kUnreachable));
    QVERIFY(bytesOf(QStringLiteral("refused.png")).isEmpty());
  }

  void aMapOfManySubmapsFitsToo() {
    simulator::Options robot = frozen();
    robot.submaps = 150;
    QJsonObject report;
    QCOMPARE(take(small(QStringLiteral("many.png")), robot, &report), int(app::kDone));
    QVERIFY(report[QLatin1String("submaps")].toObject()[QLatin1String("drawn")].toInt() > 75);
  }
};

}  // namespace test_snapshot_run

MAPWRIGHT_TEST(test_snapshot_run, SnapshotRunTest, Widgets)
#include "test_snapshot_run.moc"
