// Maps of every kind, exported by the program: what robots read of them has the walls that are shown.
#include <algorithm>
#include <cmath>

#include <QBuffer>
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QTest>
#include <QtEndian>

#include "../grids/served_map.h"
#include "program.h"
#include "test_program.h"

namespace test_map_export {

using namespace mapwright;

namespace {

constexpr int kWide = 90, kHigh = 70;

/// A gray picture with all shades, as SLAM makes them: walls, free ground, a transparent rim.
QImage shadedPicture() {
  QImage image(kWide, kHigh, QImage::Format_RGBA8888);
  image.fill(Qt::transparent);
  for (int y = 5; y < kHigh - 5; ++y) {
    for (int x = 5; x < kWide - 5; ++x) {
      const int gray = (x * 7 + y * 13) % 256;
      image.setPixelColor(x, y, QColor(gray, gray, gray));
    }
  }
  return image;
}

}  // namespace

class MapExportTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<tests::Program> program_;
  tests::Ended run(const QString& line) const { return program_->run(line.split(QLatin1Char(' '))); }

 private Q_SLOTS:
  void init() {
    program_ = std::make_unique<tests::Program>();
    QVERIFY(shadedPicture().save(program_->path("shaded.png")));
  }

  void whatRobotsReadHasTheWallsThatAreShown_data() {
    QTest::addColumn<QString>("map");
    QTest::newRow("gray picture") << QStringLiteral("--robot shaded.png --resolution 0.05");
    QTest::newRow("stored map") << QStringLiteral("--robot demo: 12");
    QTest::newRow("submaps") << QStringLiteral("--robot demo:?submaps=6 submaps");
  }
  void whatRobotsReadHasTheWallsThatAreShown() {
    QFETCH(QString, map);
    QCOMPARE(run(QStringLiteral("maps export %1 -o shown.png").arg(map)).code, 0);
    const auto exported = run(QStringLiteral("maps export %1 -o map.yaml").arg(map));
    QVERIFY2(exported.code == 0 && exported.err.isEmpty(), qPrintable(exported.err));
    const QImage shown = QImage(program_->path("shown.png")).convertToFormat(QImage::Format_RGBA8888);
    const bool has_alpha = QImage(program_->path("shown.png")).hasAlphaChannel();
    for (const test::MapServer server :
         {test::MapServer::Nav2, test::MapServer::Nav2Later, test::MapServer::Ros1}) {
      const auto served = test::servedMap(program_->path("map.yaml"), server);
      QVERIFY(served && served->width == shown.width() && served->height == shown.height());
      QCOMPARE(served->mode, QStringLiteral("trinary"));
      int walls = 0;
      for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x) {
          const std::uint8_t* const pixel = shown.constScanLine(y) + 4 * x;
          // Without alpha: gray levels as docs/command-line.md tells them.
          const bool unknown = has_alpha
                                   ? pixel[3] == 0 || (pixel[0] == 128 && map.contains(QLatin1String("png")))
                                   : pixel[0] == 205 || (pixel[0] >= 112 && pixel[0] <= 143);
          const bool wall = std::lround((255 - pixel[0]) * 100 / 255.0) >= 50;
          const auto cell = test::amclCell(served->cells[std::size_t(y * served->width + x)]);
          QCOMPARE(cell, unknown ? test::AmclCell::Unknown
                         : wall  ? test::AmclCell::Occupied
                                 : test::AmclCell::Free);
          walls += !unknown && wall;
        }
      }
      QVERIFY(walls > 100);
    }
  }

  void wallsThatAreLostAreCountedAloud() {
    for (const char* options : {"--map-mode raw", "--map-mode scale", "--occupied 0.9 --free 0.05"}) {
      const auto exported =
          run(QStringLiteral("maps export --robot shaded.png --resolution 0.05 -o map.yaml --force %1")
                  .arg(QLatin1String(options)));
      QCOMPARE(exported.code, 0);
      const auto served = test::servedMap(program_->path("map.yaml"), test::MapServer::Nav2);
      QVERIFY(served);
      const auto walls =
          std::count_if(served->cells.begin(), served->cells.end(), [](int cell) { return cell == 100; });
      QVERIFY2(exported.err.contains(QStringLiteral("will see %1 of ").arg(walls)), qPrintable(exported.err));
    }
    QVERIFY(QFile::exists(program_->path("map.png")));  // of mode scale: a PGM has no unknown there
  }

  void aHeaderAloneIsNotWritten_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("PGM") << QStringLiteral("huge.pgm") << QByteArray("P5\n40000 40000\n255\n");
    QTest::newRow("PGM of text") << QStringLiteral("huge.pgm") << QByteArray("P2\n40000 40000\n255\n0 0 0");
    QByteArray bmp(54 + 4 * 256, '\0');
    bmp.replace(0, 2, "BM");
    const auto put = [&bmp](int at, quint32 number) { qToLittleEndian(number, bmp.data() + at); };
    put(10, 54 + 4 * 256);
    put(14, 40);
    put(18, 40'000);
    put(22, 40'000);
    bmp[26] = 1;
    bmp[28] = 8;
    QTest::newRow("BMP") << QStringLiteral("huge.bmp") << bmp;
    // A whole PNG of a few rows whose header is another one.
    QImage few(30'000, 3, QImage::Format_Grayscale8);
    few.fill(Qt::white);
    QByteArray png;
    QBuffer buffer(&png);
    few.save(&buffer, "png");
    qToBigEndian<quint32>(30'000, png.data() + 20);
    const auto sum = [](const QByteArray& part) {
      quint32 crc = 0xffffffff;
      for (const char byte : part) {
        crc ^= quint8(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0);
      }
      return ~crc;
    };
    qToBigEndian<quint32>(sum(png.mid(12, 17)), png.data() + 29);
    QTest::newRow("PNG") << QStringLiteral("huge.png") << png;
  }
  void aHeaderAloneIsNotWritten() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    program_->put(name.toLatin1().constData(), bytes);
    const QString map = QStringLiteral("--robot %1 --resolution 0.05").arg(name);
    for (const QString& line :
         {QStringLiteral("maps export %1 -o out.yaml").arg(map),
          QStringLiteral("maps export %1 -o out.png").arg(map),
          QStringLiteral("maps diff %1 %1 --resolution 0.05 --diff out.png").arg(name)}) {
      const auto refused = run(line);
      QVERIFY2(refused.code == 2, qPrintable(line + refused.err));
      QVERIFY2(refused.err.contains(QStringLiteral("000 rows that its header says")) &&
                   refused.err.contains(QStringLiteral("--allow-missing")),
               qPrintable(refused.err));
    }
    QVERIFY(!QDir(program_->folder()).exists(QStringLiteral("out.pgm")));
    QVERIFY(!QDir(program_->folder()).exists(QStringLiteral("out.png")));
  }

  void whatIsMissingIsWrittenWhenAskedFor() {
    program_->put("short.pgm", "P5\n2000 2000\n255\n" + QByteArray(600 * 2000, '\xff'));
    const QString line =
        QStringLiteral("maps export --robot short.pgm --resolution 0.05 --force -o out.yaml");
    QCOMPARE(run(line).code, 2);
    const auto agreed = run(line + QStringLiteral(" --allow-missing"));
    QVERIFY2(agreed.code == 1, qPrintable(agreed.err));  // not complete
    const auto served = test::servedMap(program_->path("out.yaml"), test::MapServer::Nav2);
    QVERIFY(served && served->cells.size() == 4'000'000);
    QCOMPARE(std::count(served->cells.begin(), served->cells.end(), -1), 1400 * 2000);
    // One that lacks less than half is written at once, and told as before.
    program_->put("short.pgm", "P5\n2000 2000\n255\n" + QByteArray(1200 * 2000, '\xff'));
    QCOMPARE(run(line).code, 1);
  }

  void farMapsAreShownWithAllDigits() {
    program_->put("far.pgm", "P5\n4 3\n255\n" + QByteArray(12, '\xfe'));
    program_->put("far.yaml",
                  "image: far.pgm\nresolution: 0.05\norigin: [388096.123456, 5572094.155411, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    const auto shown = run(QStringLiteral("maps show --robot far.yaml"));
    QVERIFY2(shown.out.contains(QStringLiteral("x 388096.123456 m, y 5572094.155411 m, yaw 0 rad")),
             qPrintable(shown.out));
    // The centre of a report is one that is understood.
    const QString snapshot =
        QStringLiteral("snapshot --robot far.yaml --size 80x60 --raw -o %1.png --report %1.json");
    QCOMPARE(run(snapshot.arg(QStringLiteral("fit"))).code, 0);
    const QJsonObject view =
        QJsonDocument::fromJson(program_->bytes("fit.json")).object()[QLatin1String("view")].toObject();
    const QJsonArray center = view[QLatin1String("center")].toArray();
    const auto number = [](const QJsonValue& value) {
      return QString::number(value.toDouble(), 'g', QLocale::FloatingPointShortest);
    };
    const QString place = number(center[0]) + QLatin1Char(',') + number(center[1]);
    const auto again =
        run(snapshot.arg(QStringLiteral("again")) +
            QStringLiteral(" --center %1 --scale %2").arg(place, number(view[QLatin1String("scale")])));
    QVERIFY2(again.code == 0, qPrintable(again.err));
    QCOMPARE(program_->bytes("again.png"), program_->bytes("fit.png"));
    program_->put("suite.yaml",
                  QStringLiteral("views:\n- {name: far, robot: far.yaml, size: 80x60, center: [%1], "
                                 "scale: 0.01}\n")
                      .arg(place)
                      .toUtf8());
    const auto accepted = run(QStringLiteral("suite accept suite.yaml --expected expected --report report"));
    QVERIFY2(accepted.code == 0, qPrintable(accepted.out + accepted.err));
    QCOMPARE(run(QStringLiteral("suite run suite.yaml --expected expected --report report")).code, 0);
    // Exported again it lies at the same numbers.
    QCOMPARE(run(QStringLiteral("maps export --robot far.yaml -o out.yaml")).code, 0);
    QVERIFY2(program_->bytes("out.yaml").contains("origin: [388096.123456, 5572094.155411, 0.0]"),
             program_->bytes("out.yaml").constData());
  }

  void whatCannotBeIsWrongUsage() {
    for (const char* options :
         {"-o map.png --map-mode trinary", "-o map.pgm --map-mode scale", "-o map.yaml --map-mode grey",
          "-o map.yaml --map-mode raw --occupied 0.5", "-o map.yaml --occupied 0.5 --free 0.5",
          "-o map.yaml --occupied 65", "-o map.yaml --free nan"}) {
      const auto refused = run(
          QStringLiteral("maps export --robot shaded.png --resolution 0.05 %1").arg(QLatin1String(options)));
      QVERIFY2(refused.code == 2, options);
      QVERIFY(!QFile::exists(program_->path("map.yaml")));
    }
  }
};

}  // namespace test_map_export

MAPWRIGHT_TEST(test_map_export, MapExportTest, Core)
#include "test_map_export.moc"
