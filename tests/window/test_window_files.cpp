// Map files: opening, dropping, placing pictures, exporting.
#include <QCheckBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QSemaphore>
#include <QtTest>

#include "fake_robot.h"
#include "test_program.h"
#include "ui/kit/folders.h"
#include "ui/maps/expected_controller.h"
#include "ui/maps/export_controller.h"
#include "ui/maps/files_controller.h"
#include "ui/maps/map_files.h"
#include "ui/maps/maps_controller.h"
#include "ui/robot/recent_robots.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_files {

using namespace mapwright;
using namespace mapwright::jobs;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

void drop(MainWindow& window, const QList<QUrl>& urls) {
  QMimeData data;
  data.setUrls(urls);
  QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&window, &enter);
  QDropEvent event(QPointF(400, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&window, &event);
}

QString touched(const QTemporaryDir& folder, const char* name) {
  const QString path = folder.filePath(QLatin1String(name));
  QFile file(path);
  (void)file.open(QIODevice::WriteOnly);
  return path;
}

QLineEdit* field(const PictureDialog& dialog, const char* name) {
  return dialog.findChild<QLineEdit*>(QLatin1String(name));
}

}  // namespace

class TestWindowFiles : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void opensADroppedMap() {
    Bench bench;
    MainWindow& window = bench.open();
    const QString yaml = touched(bench.folder, "map.yaml"), picture = touched(bench.folder, "map.png");
    drop(window, {QUrl::fromLocalFile(picture), QUrl::fromLocalFile(yaml)});
    QVERIFY(window.session());
    QCOMPARE(window.session()->robot().address(), QStringLiteral("file:") + yaml);
    drop(window, {QUrl::fromLocalFile(bench.folder.path())});
    QCOMPARE(window.session()->robot().address(), QStringLiteral("file:") + bench.folder.path());
  }

  void leavesOtherDropsAlone() {
    Bench bench;
    MainWindow& window = bench.open();
    drop(window, {QUrl(QStringLiteral("https://example.com/map.yaml")),
                  QUrl::fromLocalFile(touched(bench.folder, "notes.txt"))});
    QVERIFY(!window.session());
    part<FilesController>(window)->open(bench.folder.filePath(QStringLiteral("gone.yaml")));
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().last().contains(QLatin1String("does not exist")));
    part<FilesController>(window)->open(touched(bench.folder, "notes.txt"));
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().last().contains(QLatin1String("neither a map")));
    QVERIFY(!window.session());
  }

  void recordingsAreOpenedLikeMaps() {
    Bench bench;
    const QString recording = touched(bench.folder, "drive.mcap");
    QVERIFY(isRecordingFile(recording) && isRecordingFile(QStringLiteral("/bags/A.BAG")));
    QVERIFY(!isRecordingFile(QStringLiteral("/bags/a.yaml")));
    QCOMPARE(
        droppedMap({QUrl::fromLocalFile(touched(bench.folder, "notes.txt")), QUrl::fromLocalFile(recording)}),
        recording);
    QVERIFY(mapFileFilter().contains(QLatin1String("*.mcap")));
    MainWindow& window = bench.open();
    part<FilesController>(window)->open(recording);
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().isEmpty());
    QCOMPARE(window.session()->robot().address(), QStringLiteral("file:") + recording);
  }

  void asksWhereABarePictureLies() {
    Bench bench;
    MainWindow& window = bench.open();
    const QString path = touched(bench.folder, "floor <b>1.png");
    drop(window, {QUrl::fromLocalFile(path)});
    QVERIFY(!window.session());
    PictureDialog* dialog = part<PictureDialog>(window);
    QVERIFY(dialog && dialog->isVisible());
    field(*dialog, "resolution")->setText(QStringLiteral("0.1"));
    field(*dialog, "originX")->setText(QStringLiteral("-12.5"));
    field(*dialog, "originYaw")->setText(QStringLiteral("180"));
    dialog->accept();
    QVERIFY(window.session());
    const QString address = window.session()->robot().address();
    QVERIFY2(address.startsWith(QStringLiteral("file:") + path +
                                QStringLiteral("?resolution=0.1&origin=-12.5,0,3.14159265")),
             qPrintable(address));
    QCOMPARE(test::knownAddresses().parse(address)->path, path);
  }

  void opensAPictureByTheYamlThatNamesIt() {
    Bench bench;
    const QString yaml = touched(bench.folder, "office.yaml");
    bench.yamls_naming = [&](const QString&) { return QStringList{yaml}; };
    MainWindow& window = bench.open();
    drop(window, {QUrl::fromLocalFile(touched(bench.folder, "office.pgm"))});
    QTRY_VERIFY(window.session());
    QCOMPARE(window.session()->robot().address(), QStringLiteral("file:") + yaml);
    QVERIFY(!part<PictureDialog>(window));
  }

  void asksWhereAPictureOfSeveralYamlsLies() {
    Bench bench;
    bench.yamls_naming = [](const QString&) {
      return QStringList{QStringLiteral("/m/a.yaml"), QStringLiteral("/m/<b>.yaml")};
    };
    MainWindow& window = bench.open();
    part<FilesController>(window)->open(touched(bench.folder, "office.png"));
    QTRY_VERIFY(part<PictureDialog>(window));
    QVERIFY(part<PictureDialog>(window)->introText().contains(QLatin1String("a.yaml, <b>.yaml")));
    QVERIFY(!window.session());
  }

  void asksWhereAPictureOfNoYamlLies() {
    Bench bench;
    bench.yamls_naming = [](const QString&) { return QStringList(); };
    MainWindow& window = bench.open();
    part<FilesController>(window)->open(touched(bench.folder, "office.png"));
    QTRY_VERIFY(part<PictureDialog>(window));
    QVERIFY(part<PictureDialog>(window)->introText().contains(QLatin1String("without a map.yaml")));
  }

  void goesOnWithTheLastPictureOnly() {
    Bench bench;
    QSemaphore slow;
    bench.yamls_naming = [&](const QString& picture) {
      if (picture.endsWith(QLatin1String("slow.png"))) slow.acquire();
      return QStringList{picture + QStringLiteral(".yaml")};
    };
    MainWindow& window = bench.open();
    part<FilesController>(window)->open(touched(bench.folder, "slow.png"));
    part<FilesController>(window)->open(touched(bench.folder, "fast.png"));
    QTRY_VERIFY(window.session());
    slow.release();
    QTRY_COMPARE(bench.workers->running(), 0);
    QCoreApplication::processEvents();
    QVERIFY(window.session()->robot().address().endsWith(QLatin1String("fast.png.yaml")));
  }

  void proposesFoldersThatExist() {
    QTemporaryDir folder;
    const QString there = folder.path(), gone = folder.filePath(QStringLiteral("gone")),
                  file = touched(folder, "file");
    QCOMPARE(folderToWriteInto({there}), there);
    for (const QString& bad : {QString(), gone, file}) {
      QCOMPARE(folderToWriteInto({bad, there}), there);
      QCOMPARE(folderToReadFrom({bad, there}), there);
      QVERIFY(QFileInfo(folderToWriteInto({bad})).isWritable());
      QCOMPARE(folderToReadFrom({bad}), QString());
    }
  }

  void proposesTheFolderOfTheLastExportUnlessItIsGone() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    const auto proposed = [&] {
      bench.action("export")->trigger();
      const QString folder = QFileInfo(part<ExportDialog>(window)->pathEdit()->text()).absolutePath();
      return folder;
    };
    QVERIFY(QFileInfo(proposed()).isDir());
    const QString folder = bench.folder.filePath(QStringLiteral("exports"));
    QVERIFY(QDir().mkpath(folder));
    part<ExportDialog>(window)->pathEdit()->setText(folder + QStringLiteral("/view.png"));
    part<ExportDialog>(window)->start();
    QTRY_VERIFY(!part<ExportDialog>(window) || !part<ExportDialog>(window)->isVisible());
    QCOMPARE(proposed(), folder);
    QVERIFY(QDir(folder).removeRecursively());
    QVERIFY(QFileInfo(proposed()).isDir());
  }

  void refusesPlacesThatAreNone_data() {
    QTest::addColumn<QString>("resolution");
    QTest::addColumn<QString>("x");
    QTest::addColumn<bool>("fine");
    QTest::newRow("usual") << QStringLiteral("0.05") << QStringLiteral("0") << true;
    QTest::newRow("comma") << QStringLiteral("0,05") << QStringLiteral("-3,5") << true;
    QTest::newRow("zero") << QStringLiteral("0") << QStringLiteral("0") << false;
    QTest::newRow("negative") << QStringLiteral("-0.05") << QStringLiteral("0") << false;
    QTest::newRow("nan") << QStringLiteral("nan") << QStringLiteral("0") << false;
    QTest::newRow("infinite") << QStringLiteral("inf") << QStringLiteral("0") << false;
    QTest::newRow("huge") << QStringLiteral("1e9") << QStringLiteral("0") << false;
    QTest::newRow("empty") << QString() << QStringLiteral("0") << false;
    QTest::newRow("far") << QStringLiteral("0.05") << QStringLiteral("1e12") << false;
    QTest::newRow("word") << QStringLiteral("0.05") << QStringLiteral("here") << false;
  }
  void refusesPlacesThatAreNone() {
    QFETCH(QString, resolution);
    QFETCH(QString, x);
    QFETCH(bool, fine);
    PictureDialog dialog(QStringLiteral("/maps/a.png"), {}, QStringLiteral("Open"));
    field(dialog, "resolution")->setText(resolution);
    field(dialog, "originX")->setText(x);
    QCOMPARE(dialog.placement().has_value(), fine);
    QCOMPARE(dialog.errorText().isEmpty(), fine);
    if (!fine) QVERIFY(dialog.errorText().endsWith(QLatin1Char('.')));
  }

  void remembersFilesAmongTheRecents() {
    Bench bench;
    MainWindow& window = bench.open();
    const QString yaml = touched(bench.folder, "map.yaml");
    part<FilesController>(window)->open(yaml);
    const RecentRobots recents(bench.settings, test::knownAddresses());
    QCOMPARE(recents.list().front().address, QStringLiteral("file:") + yaml);
  }

  void tellsThatAFileChanged() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    part<FilesController>(window)->open(touched(bench.folder, "map.yaml"));
    part<MapsController>(window)->open({map::MapKind::File, {}});
    QTRY_COMPARE(window.session()->wholeMap().phase(), session::MapSlot::Phase::Ready);
    Q_EMIT bench.robot->mapsChanged();
    const auto said = [&] {
      return part<MapOverlay>(window)->toasts()->texts().filter(QStringLiteral("changed on disk")).size();
    };
    QCOMPARE(said(), 0);  // it is not read yet
    QTRY_COMPARE(said(), 1);
  }

  void aRecordingDoesNotChangeOnDiskWhileItIsPlayed() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(QStringLiteral("file:/recordings/night.mcap")));
    window.session()->openMap({map::MapKind::Live, {}});
    QVERIFY(window.session()->wholeMap().phase() != session::MapSlot::Phase::Empty);
    Q_EMIT bench.robot->mapsChanged();
    const QString said = part<MapOverlay>(window)->toasts()->texts().join(QLatin1Char('\n'));
    QVERIFY2(!said.contains(QLatin1String("changed on disk")), qPrintable(said));
  }

  void exportsTheWholeMap() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    part<MapsController>(window)->open({map::MapKind::Stored, "2"});
    QTRY_COMPARE(window.session()->wholeMap().phase(), session::MapSlot::Phase::Ready);
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    QVERIFY(dialog);
    const QString path = bench.folder.filePath(QStringLiteral("out.png"));
    dialog->pathEdit()->setText(path);
    dialog->worldFileBox()->setChecked(true);
    dialog->start();
    QTRY_VERIFY(!part<ExportDialog>(window) || !part<ExportDialog>(window)->isVisible());
    QImage picture(path);
    QCOMPARE(picture.size(), QSize(80, 60));
    QCOMPARE(qGray(picture.pixel(0, 0)), 0);
    QCOMPARE(qGray(picture.pixel(20, 20)), 254);
    QFile world(worldFilePath(path, ExportFormat::ViewPicture));
    QVERIFY(world.open(QIODevice::ReadOnly));
    QCOMPARE(world.readAll().split('\n').first().trimmed().toDouble(), 0.05);
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().last().startsWith(QLatin1String("Exported to")));
  }

  void dialogsStartInTheFolderOfWhatIsOpen() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(QDir(bench.folder.path()).mkdir(QStringLiteral("site")));
    const QString folder = bench.folder.filePath(QStringLiteral("site"));
    QVERIFY(!window.connectTo(fileAddress(folder + QStringLiteral("/map.yaml"))));
    QCOMPARE(lastMapFolder(bench.settings), folder);
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(lastMapFolder(bench.settings), folder);
  }

  void asksBeforeAMapThatBreaksOffIsExported() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    map::WholeMap cut = test::wholeMap({map::MapKind::Stored, "2"}, "Attic", 80, 60);
    cut.bytes = std::make_shared<const std::string>(cut.bytes->substr(0, cut.bytes->size() * 3 / 4));
    bench.robot->maps.pictures.emplace("2", std::move(cut));
    part<MapsController>(window)->open({map::MapKind::Stored, "2"});
    QTRY_COMPARE(window.session()->wholeMap().phase(), session::MapSlot::Phase::Ready);
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    const QString path = bench.folder.filePath(QStringLiteral("out.png"));
    dialog->pathEdit()->setText(path);
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QCOMPARE(dialog->errorText(),
             QStringLiteral("Parts of this map could not be read. They would be unknown cells. "
                            "Press Export again to write them anyway."));
    QVERIFY(!QFile::exists(path));
    QTest::mouseClick(dialog->exportButton(), Qt::LeftButton);
    QTRY_VERIFY(!part<ExportDialog>(window) || !part<ExportDialog>(window)->isVisible());
    QCOMPARE(QImage(path).size(), QSize(80, 60));
  }

  void theMapIsComparedWithAnExpectedPicture() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    part<MapsController>(window)->open({map::MapKind::Stored, "2"});
    QTRY_COMPARE(window.session()->wholeMap().phase(), session::MapSlot::Phase::Ready);
    QVERIFY(bench.action("compareExpected")->isEnabled());
    auto* const expected = part<ExpectedController>(window);
    const QString path = bench.folder.filePath(QStringLiteral("expected.png"));
    QImage picture(120, 90, QImage::Format_RGB32);
    picture.fill(Qt::magenta);
    QVERIFY(picture.save(path));
    expected->compareWith(path);
    QVERIFY(part<MapOverlay>(window)->toasts()->texts().last().startsWith(
        QLatin1String("No report beside expected.png")));
    QVERIFY(!expected->dialog());
    QFile report(bench.folder.filePath(QStringLiteral("expected.json")));
    QVERIFY(report.open(QIODevice::WriteOnly));
    report.write(R"({"view": {"center": [1, 1], "scale": 0.05, "size": [120, 90], "rotation_deg": 0}})");
    report.close();
    expected->compareWith(path);
    QTRY_VERIFY(expected->dialog() && expected->dialog()->isVisible());
    QStringList texts;
    for (const QLabel* const label : expected->dialog()->findChildren<QLabel*>()) texts << label->text();
    QVERIFY2(
        texts.join(QLatin1Char('|')).contains(QStringLiteral("10,800 pixels differ (100\u00a0%), by up to ")),
        qPrintable(texts.join(QLatin1Char('|'))));
    QVERIFY(texts.join(QLatin1Char('|')).contains(QString::fromUtf8("1 cluster of 27.0 m² at (1.0, 1.0)")));
    expected->dialog()->close();
  }

  void exportsForMapServer() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    part<MapsController>(window)->open({map::MapKind::Stored, "2"});
    QTRY_COMPARE(window.session()->wholeMap().phase(), session::MapSlot::Phase::Ready);
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    dialog->pathEdit()->setText(bench.folder.filePath(QStringLiteral("out.png")));
    dialog->formatButton(ExportFormat::MapServer)->setChecked(true);
    QVERIFY(dialog->pathEdit()->text().endsWith(QLatin1String("out.yaml")));
    QVERIFY(!dialog->worldFileBox()->isEnabled());
    dialog->start();
    QTRY_VERIFY(QFile::exists(bench.folder.filePath(QStringLiteral("out.yaml"))));
    QVERIFY(QFile::exists(bench.folder.filePath(QStringLiteral("out.pgm"))));
  }

  void exportsTheSubmaps() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    const QString path = bench.folder.filePath(QStringLiteral("submaps.png"));
    dialog->pathEdit()->setText(path);
    dialog->start();
    QTRY_VERIFY(QFile::exists(path));
    QVERIFY(QImage(path).width() > 100);
  }

  void hidingIsAMatterOfLookingAndExportAsks() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.robot->missing = {{1, 1}};
    bench.robot->list({test::entry(0, 0, 1, 0, 0), test::entry(0, 1, 1, 5, 0), test::entry(1, 0, 3, 40, 0),
                       test::entry(1, 1, 1, 0, 5)});
    QTRY_COMPARE(window.session()->counts().held, 3);
    QTRY_COMPARE(window.session()->counts().missing, 1);
    const auto width = [&](const char* name, bool with_hidden) {
      bench.action("export")->trigger();
      ExportDialog* dialog = part<ExportDialog>(window);
      dialog->hiddenBox()->setChecked(with_hidden);
      const QString path = bench.folder.filePath(QLatin1String(name));
      dialog->pathEdit()->setText(path);
      dialog->start();
      return QTest::qWaitFor([&] { return QFile::exists(path); }) ? QImage(path).width() : 0;
    };
    const int all = width("all.png", true);
    window.session()->setVisible({{0, 0}, {1, 0}}, false);
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    QVERIFY(dialog->hiddenBox()->isVisible());
    QVERIFY(dialog->hiddenBox()->isChecked());
    QVERIFY(dialog->hiddenBox()->text().contains(QLatin1String("2 submaps")));
    QCOMPARE(dialog->contentText(), QStringLiteral("3 of 4 submaps are included. Missing or damaged: 1."));
    dialog->hiddenBox()->setChecked(false);
    QCOMPARE(dialog->contentText(), QStringLiteral("1 of 4 submaps are included. Missing or damaged: 1."));
    dialog->formatButton(ExportFormat::ViewPicture)->setChecked(true);
    QVERIFY(dialog->contentText().contains(QLatin1String("hidden")));
    QVERIFY(!dialog->hiddenBox()->isEnabled());
    QCOMPARE(width("again.png", true), all);
    QVERIFY(width("shown.png", false) < all / 2);
    // With everything hidden there is still a map to export, if that is wanted.
    window.session()->setVisible({{0, 1}}, false);
    bench.action("export")->trigger();
    QVERIFY(part<ExportDialog>(window)->exportButton()->isEnabled());
    part<ExportDialog>(window)->hiddenBox()->setChecked(false);
    QVERIFY(!part<ExportDialog>(window)->exportButton()->isEnabled());
  }

  void nothingIsAskedWhereNothingIsHidden() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    bench.action("export")->trigger();
    QVERIFY(!part<ExportDialog>(window)->hiddenBox()->isVisible());
    QCOMPARE(part<ExportDialog>(window)->contentText(), QStringLiteral("3 of 3 submaps are included."));
  }

  void exportsTheViewAndSaysWhatWentWrong() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    QVERIFY(!dialog->formatButton(ExportFormat::MapServer)->isEnabled());
    QVERIFY(dialog->formatButton(ExportFormat::ViewPicture)->isChecked());
    dialog->pathEdit()->setText(bench.folder.filePath(QStringLiteral("no/such/folder.png")));
    dialog->start();
    QTRY_VERIFY(dialog->errorText().contains(QLatin1String("cannot be written")));
    QVERIFY(dialog->isVisible());
    const QString path = bench.folder.filePath(QStringLiteral("view.png"));
    dialog->pathEdit()->setText(path);
    dialog->start();
    QTRY_VERIFY(QFile::exists(path));
    QCOMPARE(QImage(path).size(), window.view()->viewport()->size());
  }

  void asksBeforeItReplacesAFile() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    bench.action("export")->trigger();
    ExportDialog* dialog = part<ExportDialog>(window);
    const QString path = touched(bench.folder, "old.png");
    dialog->pathEdit()->setText(path);
    dialog->start();
    QVERIFY(dialog->errorText().contains(QLatin1String("exists")));
    QCOMPARE(QFileInfo(path).size(), qint64(0));
    dialog->start();
    QTRY_VERIFY(QFileInfo(path).size() > 0);
  }
};

}  // namespace test_window_files

MAPWRIGHT_TEST(test_window_files, TestWindowFiles, Widgets)
#include "test_window_files.moc"
