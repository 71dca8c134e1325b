// "Compare with expected…" in a real window: the picture that the commands draw, the cause, and the divider.
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QTabWidget>
#include <QtTest>

#include "app/display.h"
#include "program.h"
#include "shown_window.h"
#include "test_program.h"
#include "ui/maps/expected_controller.h"
#include "ui/maps/picture_swipe.h"

namespace test_expected_picture {

using namespace mapwright;
using ui::ExpectedController;
using ui::PictureSwipe;
using ui::SwipeHandle;

namespace {

void copyMaps(const QString& from, const QString& to) {
  QDir().mkpath(to);
  for (const QFileInfo& one : QDir(from).entryInfoList(QDir::AllEntries | QDir::NoDotAndDotDot)) {
    const QString target = to + QLatin1Char('/') + one.fileName();
    if (one.isDir())
      copyMaps(one.filePath(), target);
    else
      QFile::copy(one.filePath(), target);
  }
}

}  // namespace

class ExpectedPictureTest : public QObject {
  Q_OBJECT
  std::unique_ptr<tests::Program> files_;
  std::unique_ptr<test::ShownWindow> shown_;

  /// The map of the example in the window, and the dialog of this view of it.
  QDialog* compared(const char* view) {
    shown_ = std::make_unique<test::ShownWindow>(
        [](const QString& to, const QByteArray&) { return app::makeRobot(to, {}, app::DemoTime::Frozen); });
    const QString map = QStringLiteral("file:") + files_->path("map/office.yaml");
    if (!shown_->connectTo(map)) return nullptr;
    const auto ready = [this] { return shown_->session()->wholeMap().cells() && shown_->mapsSettled(); };
    if (!QTest::qWaitFor(ready, 30'000)) return nullptr;
    auto* const controller = shown_->window().findChild<ExpectedController*>();
    controller->compareWith(
        files_->path(qPrintable(QStringLiteral("expected/%1.png").arg(QLatin1String(view)))));
    (void)QTest::qWaitFor([&] { return controller->dialog() && controller->dialog()->isVisible(); }, 30'000);
    return controller->dialog();
  }
  static QString textsOf(const QDialog& dialog) {
    QStringList texts;
    for (const QLabel* const label : dialog.findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('\n'));
  }
  void moveWall() const {
    const char* const overlays = "map/office.overlays.geojson";
    QByteArray bytes = files_->bytes(overlays);
    files_->put(overlays, bytes.replace("[-6.0, -2.0], [-3.0, -2.0]", "[-6.0, -1.6], [-3.0, -1.6]"));
  }

 private Q_SLOTS:
  // As in the program: the window's own texts have the same font, hinted.
  void initTestCase() {
    app::addLabelFont();
    QImage paper(400, 40, QImage::Format_RGB32);
    QPainter painter(&paper);
    QFont font(QStringLiteral("DejaVu Sans"));
    for (const int size_px : {9, 15}) {
      font.setPixelSize(size_px);
      painter.setFont(font);
      painter.drawText(10, 30, QStringLiteral("Dock Gate Lab 2 m"));
    }
  }
  void init() {
    files_ = std::make_unique<tests::Program>();
    copyMaps(QStringLiteral(MAPWRIGHT_EXAMPLES "/maps-in-ci"), files_->folder());
  }
  void cleanup() { shown_.reset(); }

  void theWindowDrawsTheSamePixelsAsTheCommand_data() {
    QTest::addColumn<QByteArray>("view");
    for (const char* view : {"cells", "overlays and waypoints", "wall W17"})
      QTest::newRow(view) << QByteArray(view);
  }
  void theWindowDrawsTheSamePixelsAsTheCommand() {
    QFETCH(QByteArray, view);
    QDialog* const dialog = compared(view.constData());
    QVERIFY(dialog);
    QVERIFY2(textsOf(*dialog).contains(QLatin1String("The pictures are the same.")),
             qPrintable(textsOf(*dialog)));
    QVERIFY(!dialog->findChild<QTabWidget*>());  // there is no difference to show
    QVERIFY(!dialog->findChild<QListWidget*>()->isVisible());
  }

  void namesInAnyWritingLookAsTheCommandDrawsThem() {
    const char* const places = "map/office.waypoints.geojson";
    QByteArray bytes = files_->bytes(places);
    QVERIFY(bytes.contains("\"Gate\""));
    files_->put(places, bytes.replace("Gate", "\\u5317\\u4eac \\u65e5\\u672c \\ud83d\\ude00"));
    const tests::Ended accepted =
        files_->run({QStringLiteral("suite"), QStringLiteral("accept"), QStringLiteral("suite.yaml"),
                     QStringLiteral("--expected"), QStringLiteral("expected"), QStringLiteral("--only"),
                     QStringLiteral("overlays and waypoints")});
    QVERIFY2(accepted.code == 0, qPrintable(accepted.out + accepted.err));
    QVERIFY2(accepted.out.contains(QLatin1String("replaced")), qPrintable(accepted.out));
    QDialog* const dialog = compared("overlays and waypoints");
    QVERIFY(dialog);
    QVERIFY2(textsOf(*dialog).contains(QLatin1String("The pictures are the same.")),
             qPrintable(textsOf(*dialog)));
  }

  void itNamesTheCause() {
    moveWall();
    QDialog* const dialog = compared("wall W17");
    QVERIFY(dialog);
    QVERIFY2(textsOf(*dialog).contains(QLatin1String("virtual wall W17 moved by 0.40 m")),
             qPrintable(textsOf(*dialog)));
    auto* const changes = dialog->findChild<QListWidget*>();
    QVERIFY(changes->isVisible());
    QVERIFY2(changes->item(0)->text().contains(QLatin1String("virtual wall W17 moved by 0.40 m")),
             qPrintable(changes->item(0)->text()));
    QCOMPARE(dialog->findChild<QTabWidget*>()->count(), 2);
  }

  void theDividerIsMovedByKeysAndByTheMouse() {
    moveWall();
    QDialog* const dialog = compared("wall W17");
    QVERIFY(dialog);
    SwipeHandle& divider = dialog->findChild<PictureSwipe*>()->handle();
    QVERIFY(divider.hasFocus());
    const double before = divider.at();
    QTest::keyClick(&divider, Qt::Key_Right);
    QVERIFY(divider.at() > before);
    QTest::keyClick(&divider, Qt::Key_Home);
    QCOMPARE(divider.at(), 0.0);
    const QImage all_now = dialog->findChild<PictureSwipe*>()->grab().toImage();
    QTest::keyClick(&divider, Qt::Key_End);
    QCOMPARE(divider.at(), 1.0);
    QVERIFY(dialog->findChild<PictureSwipe*>()->grab().toImage() != all_now);
    const int width = divider.parentWidget()->width();
    QTest::mousePress(&divider, Qt::LeftButton, {}, divider.rect().center());
    QMouseEvent drag(QEvent::MouseMove, QPointF(divider.rect().center() - QPoint(width / 2, 0)),
                     divider.mapToGlobal(divider.rect().center() - QPoint(width / 2, 0)), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(&divider, &drag);
    QTest::mouseRelease(&divider, Qt::LeftButton, {}, divider.rect().center());
    QVERIFY2(std::abs(divider.at() - 0.5) < 0.05, qPrintable(QString::number(divider.at())));
    QTest::keyClick(&divider, Qt::Key_Escape);
    QTRY_VERIFY(!shown_->window().findChild<ExpectedController*>()->dialog());
  }
};

}  // namespace test_expected_picture

MAPWRIGHT_TEST(test_expected_picture, ExpectedPictureTest, Widgets)
#include "test_expected_picture.moc"
