// What the window writes: whole or not at all, and never unasked over what it reads.
#include <csignal>
#include <sys/resource.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QRadioButton>
#include <QtTest>

#include "grids/export_grid.h"
#include "test_program.h"
#include "ui/maps/export_controller.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_writing {

using namespace mapwright;
using namespace mapwright::jobs;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

/// No file may grow beyond `bytes` while this lives: a full disk for whoever may not make one.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

WholeMapExport smallMap() {
  const auto builder = grids::buildGrid(60, 40, grids::CellCode::Gray, grids::Reduction::OccupiedWins);
  for (int v = 0; v < 40; ++v) builder->pushRow(std::vector<std::uint8_t>(60, std::uint8_t(v * 5)));
  builder->finish();
  return {builder->pyramid(), {60, 40, 0.05, {0, 0, 0}}};
}

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

}  // namespace

class TestWindowWriting : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;
  QString at(const char* name) const { return folder_->filePath(QLatin1String(name)); }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void aFullDiskLeavesWhatWasThereAndIsSaid_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<bool>("world_file");
    QTest::newRow("picture of the map") << int(ExportFormat::MapPicture) << false;
    QTest::newRow("with a world file") << int(ExportFormat::MapPicture) << true;
    QTest::newRow("for map_server") << int(ExportFormat::MapServer) << false;
    QTest::newRow("the view") << int(ExportFormat::ViewPicture) << true;
  }
  void aFullDiskLeavesWhatWasThereAndIsSaid() {
    QFETCH(int, format);
    QFETCH(bool, world_file);
    ExportRequest request;
    request.format = ExportFormat(format);
    request.world_file = world_file;
    request.path = at("out.") + exportSuffix(request.format);
    if (request.format == ExportFormat::ViewPicture) {
      QImage picture(60, 40, QImage::Format_RGB32);
      picture.fill(Qt::red);
      request.source = ViewExport{picture, {60, 40, 0.05, {0, 0, 0}}};
    } else {
      request.source = smallMap();
    }
    const QStringList files = exportedFiles(request.path, request.format, world_file);
    QCOMPARE(files.size(), qsizetype(world_file || request.format == ExportFormat::MapServer ? 2 : 1));
    for (const QString& file : files) put(file, "what was there");
    ExportResult full;
    {
      const SmallDisk disk(16);
      full = exportMap(request, {});
    }
    QVERIFY2(full.error.contains(QStringLiteral("cannot be written")), qPrintable(full.error));
    for (const QString& file : files) QCOMPARE(read(file), QByteArray("what was there"));
    QCOMPARE(exportMap(request, {}).error, QString());
    for (const QString& file : files) QVERIFY(read(file) != "what was there");
  }

  void aPictureOfTheMapThatDoesNotFitLeavesTheOldOne() {
    Bench bench;
    MainWindow& window = bench.open();
    put(at("map.png"), "what was there");
    {
      const SmallDisk disk(16);
      const auto error = part<ExportController>(window)->saveMapPicture(at("map.png"));
      QVERIFY(error && error->contains(QStringLiteral("cannot be written")));
    }
    QCOMPARE(read(at("map.png")), QByteArray("what was there"));
  }

  void whatTheMapIsReadFromIsReplacedOnlyWhenAskedTwice() {
    put(at("map.pgm"), "the source");
    put(at("map.yaml"), "the yaml");
    QVERIFY(QFile::link(at("map.yaml"), at("link.yaml")));
    for (const char* name : {"map.yaml", "link.yaml", "map.pgm"}) {
      ExportOffer offer;
      offer.whole = smallMap();
      offer.folder = folder_->path();
      offer.sources = {at("map.yaml").toStdString(), at("map.pgm").toStdString()};
      ExportDialog dialog(offer, std::make_shared<work::Workers>());
      QSignalSpy exported(&dialog, &ExportDialog::exported);
      dialog.formatButton(ExportFormat::MapServer)->setChecked(true);
      dialog.pathEdit()->setText(at(name));
      dialog.start();
      QVERIFY2(dialog.errorText().contains(QStringLiteral("read from")), qPrintable(dialog.errorText()));
      QCOMPARE(read(at("map.pgm")), QByteArray("the source"));
      QCOMPARE(read(at("map.yaml")), QByteArray("the yaml"));
    }
    ExportOffer offer;
    offer.whole = smallMap();
    offer.sources = {at("map.yaml").toStdString(), at("map.pgm").toStdString()};
    ExportDialog dialog(offer, std::make_shared<work::Workers>());
    dialog.formatButton(ExportFormat::MapServer)->setChecked(true);
    dialog.pathEdit()->setText(at("map.yaml"));
    dialog.start();
    dialog.start();
    QTRY_VERIFY(read(at("map.yaml")).contains("resolution"));
  }

  void aMapOfWhichMostIsMissingIsAskedFor() {
    const auto builder = grids::buildGrid(2000, 2000, grids::CellCode::Gray, grids::Reduction::OccupiedWins);
    for (int v = 0; v < 100; ++v) builder->pushRow(std::vector<std::uint8_t>(2000, 255));
    builder->finish();
    ExportOffer offer;
    offer.whole = WholeMapExport{builder->pyramid(), {2000, 2000, 0.05, {0, 0, 0}}};
    for (const ExportFormat format : {ExportFormat::MapServer, ExportFormat::MapPicture}) {
      ExportDialog dialog(offer, std::make_shared<work::Workers>());
      dialog.formatButton(format)->setChecked(true);
      const QString path = at("out.") + exportSuffix(format);
      dialog.pathEdit()->setText(path);
      dialog.start();
      QVERIFY2(dialog.errorText().contains(QStringLiteral("only 100 of the 2,000 rows")),
               qPrintable(dialog.errorText()));
      QVERIFY(!QFile::exists(path));
      dialog.start();
      QTRY_VERIFY(QFile::exists(path));
    }
  }

  void theMapModeOfTheDialogIsWritten() {
    ExportOffer offer;
    offer.whole = smallMap();
    ExportDialog dialog(offer, std::make_shared<work::Workers>());
    QSignalSpy exported(&dialog, &ExportDialog::exported);
    QVERIFY(!dialog.mapModeBox()->isEnabled());
    dialog.formatButton(ExportFormat::MapServer)->setChecked(true);
    QVERIFY(dialog.mapModeBox()->isEnabled() && !dialog.occupiedBox()->isEnabled());
    dialog.mapModeBox()->setCurrentIndex(1);
    dialog.thresholdsBox()->setChecked(true);
    dialog.occupiedBox()->setValue(0.3);
    dialog.freeBox()->setValue(0.6);
    dialog.pathEdit()->setText(at("map.yaml"));
    dialog.start();
    QVERIFY2(dialog.errorText().contains(QStringLiteral("Between the thresholds")),
             qPrintable(dialog.errorText()));
    dialog.occupiedBox()->setValue(0.9);
    dialog.start();
    QTRY_COMPARE(exported.size(), 1);
    const QByteArray yaml = read(at("map.yaml"));
    QVERIFY(yaml.contains("mode: scale") && yaml.contains("occupied_thresh: 0.9") &&
            yaml.contains("free_thresh: 0.6"));
    QVERIFY(QFile::exists(at("map.png")));
    // Walls that robots will not see are counted.
    QVERIFY2(exported.front()[1].toString().contains(QStringLiteral(" wall cells as walls")),
             qPrintable(exported.front()[1].toString()));
  }

  void everyFileThatWouldBeReplacedIsAskedFor() {
    for (const char* name : {"map.pgm", "map.yaml", "map.pgw", "map.png"}) {
      folder_ = std::make_unique<QTemporaryDir>();
      put(at(name), "what was there");
      ExportOffer offer;
      offer.whole = smallMap();
      ExportDialog dialog(offer, std::make_shared<work::Workers>());
      const bool pair = at(name).endsWith(QStringLiteral("m")) || at(name).endsWith(QStringLiteral("l"));
      dialog.formatButton(pair ? ExportFormat::MapServer : ExportFormat::MapPicture)->setChecked(true);
      dialog.worldFileBox()->setChecked(!pair);
      dialog.pathEdit()->setText(pair ? at("map.yaml") : at("map.png"));
      dialog.start();
      QVERIFY2(dialog.errorText().contains(QLatin1String(name)), qPrintable(dialog.errorText()));
      QCOMPARE(read(at(name)), QByteArray("what was there"));
      dialog.start();
      QTRY_VERIFY(read(at(name)) != "what was there");
    }
  }

  void settingsThatCannotBeKeptAreSaidOnce() {
    QSettings settings(QStringLiteral("/dev/null/settings.ini"), QSettings::IniFormat);
    MainWindow window({[](const QString& address,
                          const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
                         return std::unique_ptr<robot::Robot>(std::make_unique<test::FakeRobot>(address));
                       },
                       settings,
                       {},
                       {},
                       {},
                       {},
                       {},
                       test::knownAddresses()});
    QVERIFY(!window.connectTo(kAddress));
    const auto said = [&] {
      return part<MapOverlay>(window)->toasts()->texts().filter(settings.fileName()).size();
    };
    QCOMPARE(said(), qsizetype(1));
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(said(), qsizetype(1));
  }
};

}  // namespace test_window_writing

MAPWRIGHT_TEST(test_window_writing, TestWindowWriting, Widgets)
#include "test_window_writing.moc"
