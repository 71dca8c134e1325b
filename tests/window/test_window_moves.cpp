// The robot's pose, its mapping and whole maps on their way, in the window: what is asked first, what is
// sent, what is said of it.
#include <QBuffer>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

#include "test_program.h"
#include "ui/maps/administration_controller.h"
#include "ui/maps/mapping_dock.h"
#include "ui/maps/maps_dock.h"
#include "ui/maps/new_map_dialog.h"
#include "ui/maps/pose_controller.h"
#include "ui/maps/pose_dock.h"
#include "ui/maps/transfer_controller.h"
#include "ui/view/toast_stack.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_moves {

using namespace mapwright;
using namespace mapwright::ui;
using robot::MapChange;
using robot::Obstacle;
using test::Bench;
using test::kAddress;

namespace {

/// Keeps what it is asked for until it is told what comes of it.
template <class T>
struct Asked {
  robot::Call keep(robot::OutcomeTo<T> to) {
    reply = std::move(to);
    state = std::make_shared<robot::Call::State>();
    state->cancel = [this] { ++cancelled; };
    return robot::Call(state);
  }
  void answer(robot::Outcome<T> outcome) {
    state->over = true;
    std::exchange(reply, nullptr)(std::move(outcome));
  }
  robot::OutcomeTo<T> reply;
  std::shared_ptr<robot::Call::State> state;
  int cancelled = 0;
};

class FakeLocalization : public robot::Localization {
 public:
  robot::Call setPose(const robot::PoseOrder& order, robot::OutcomeTo<geometry::Pose2> reply) override {
    orders.push_back(order);
    return poses.keep(std::move(reply));
  }
  robot::Call findItself(robot::OutcomeTo<map::GlobalPositioning> reply) override {
    return searches.keep(std::move(reply));
  }
  std::vector<robot::PoseOrder> orders;
  Asked<geometry::Pose2> poses;
  Asked<map::GlobalPositioning> searches;
};

class FakeMapping : public robot::MapAdministration {
 public:
  std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry*) const override {
    if (!mapping) return std::nullopt;
    const bool ends = change == MapChange::StopMapping || change == MapChange::CancelMapping;
    if (ends) return *mapping ? std::nullopt : std::optional(Obstacle::NotMapping);
    return *mapping ? std::optional(Obstacle::WhileMapping) : std::nullopt;
  }
  robot::Call carryOut(const robot::MapOrder& order, robot::OutcomeTo<map::CatalogueEntry> reply) override {
    orders.push_back(order);
    return changes.keep(std::move(reply));
  }
  bool tellsProgress() const override { return true; }
  robot::Call progress(robot::OutcomeTo<std::optional<robot::MappingProgress>> reply) override {
    return looks.keep(std::move(reply));
  }
  std::optional<bool> mapping;
  std::vector<robot::MapOrder> orders;
  Asked<map::CatalogueEntry> changes;
  Asked<std::optional<robot::MappingProgress>> looks;
};

class FakeTransfer : public robot::MapTransfer {
 public:
  robot::Call parts(const map::MapKey& key, robot::OutcomeTo<robot::MapParts> reply) override {
    keys.push_back(key);
    return whole.keep(std::move(reply));
  }
  robot::Call download(const robot::MapFacts&, const QString& path,
                       robot::OutcomeTo<robot::DataDownload> reply) override {
    data_path = path;
    return data.keep(std::move(reply));
  }
  robot::Call add(const robot::NewMap& map, robot::OutcomeTo<robot::MapParts> reply) override {
    added.push_back(map);
    return put.keep(std::move(reply));
  }
  std::vector<map::MapKey> keys;
  std::vector<robot::NewMap> added;
  QString data_path;
  Asked<robot::MapParts> put, whole;
  Asked<robot::DataDownload> data;
};

struct Desk {
  Desk() {
    bench.offerMaps();
    bench.prepare = [this, offer = bench.prepare](test::FakeRobot& robot) {
      offer(robot);
      robot.has_live = true;
      robot.localizing = &localization;
      robot.administration = &mapping;
      robot.transferring = &transfer;
    };
    bench.open();
    (void)bench.window->connectTo(kAddress);
    (void)QTest::qWaitFor([this] { return part<MapsDock>(*bench.window)->model()->maps() == 3; }, 30'000);
    bench.robot->goOnline();
    geometry::ViewTransform view = bench.window->mapScene()->view();
    view.center_m = {0, 0};
    view.scale_m_per_px = 0.05;
    view.rotation_rad = 0;
    bench.window->view()->moveTo(view, false);
  }
  ~Desk() { bench.window.reset(); }
  PoseDock& pose() { return *part<PoseDock>(*bench.window); }
  QStringList toasts() { return bench.window->findChild<ToastStack*>()->texts(); }
  QPoint at(double x_m, double y_m) const {
    const Eigen::Vector2d px = bench.window->mapScene()->view().pixelFromWorld({x_m, y_m});
    return QPoint(int(std::lround(px.x())), int(std::lround(px.y())));
  }
  void drag(const QPoint& from, const QPoint& to) {
    QWidget* const map = bench.window->view()->viewport();
    QTest::mousePress(map, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 4; ++step) {
      QMouseEvent move(QEvent::MouseMove, from + (to - from) * step / 4, QPoint(), Qt::NoButton,
                       Qt::LeftButton, {});
      QApplication::sendEvent(map, &move);
    }
    QTest::mouseRelease(map, Qt::LeftButton, {}, to);
  }

  FakeLocalization localization;
  FakeMapping mapping;
  FakeTransfer transfer;
  Bench bench;
};

map::Failure unknown() {
  return {.kind = map::FailureKind::TimedOut,
          .subject = {map::SubjectKind::Robot},
          .applied = map::Applied::Maybe,
          .asked_for = map::AskedFor::Change};
}

QByteArray pngOf(int width, int height) {
  QImage image(width, height, QImage::Format_Grayscale8);
  image.fill(255);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return png;
}

}  // namespace

class TestWindowMoves : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aSmallPictureIsSeenInALargeMap() {
    QImage red(30, 20, QImage::Format_RGB32);
    red.fill(Qt::red);
    PlacePreview preview;
    preview.resize(420, 240);
    preview.setPicture(red);
    preview.setPlace({0, 0, 15, 10});
    preview.setPresent({-500, -500, 500, 500}, std::nullopt);
    const QImage shown = preview.grab().toImage();
    int seen = 0;
    for (int x = 0; x < shown.width(); ++x)
      seen += shown.pixelColor(x, shown.height() / 2) == QColor(Qt::red);
    QVERIFY2(seen > shown.width() / 10, qPrintable(QString::number(seen)));
  }

  void thePoseIsPlacedByHandSetAndReadBack() {
    Desk desk;
    desk.bench.action("robotPose")->trigger();
    QVERIFY(desk.pose().isVisible() && desk.pose().placeButton()->isChecked());
    QVERIFY(desk.pose().warningShown().contains(QLatin1String("tells the robot where it is")));
    QVERIFY(!desk.pose().setButton()->isEnabled());
    desk.drag(desk.at(1, 2), desk.at(1, 5));
    QVERIFY(std::abs(desk.pose().xBox()->value() - 1) < 0.06);
    QVERIFY(std::abs(desk.pose().yBox()->value() - 2) < 0.06);
    QVERIFY(std::abs(desk.pose().yawBox()->value() - 90) < 1.5);
    // A click keeps the heading.
    QTest::mouseClick(desk.bench.window->view()->viewport(), Qt::LeftButton, {}, desk.at(3, -1));
    QVERIFY(std::abs(desk.pose().yawBox()->value() - 90) < 1.5);
    desk.pose().adjustBox()->setChecked(false);
    QVERIFY(desk.localization.orders.empty());  // nothing is sent by placing
    QTest::mouseClick(desk.pose().setButton(), Qt::LeftButton);
    QCOMPARE(desk.localization.orders.size(), std::size_t(1));
    const robot::PoseOrder order = desk.localization.orders[0];
    QVERIFY(!order.adjust && std::abs(order.pose.x_m - 3) < 0.06);
    QVERIFY(!desk.pose().setButton()->isEnabled());
    QVERIFY(desk.toasts().isEmpty());
    desk.localization.poses.answer(order.pose);
    QVERIFY(desk.pose().outcomeShown().contains(QStringLiteral("0.00 m and 0.0°")));
    QCOMPARE(desk.toasts().size(), 1);
    QVERIFY(!desk.pose().placeButton()->isChecked());
  }

  void escapeLeavesThePlacingAndNothingIsSent() {
    Desk desk;
    desk.bench.action("robotPose")->trigger();
    desk.drag(desk.at(1, 2), desk.at(1, 5));
    desk.bench.window->view()->setFocus();
    desk.bench.key(Qt::Key_Escape);
    QVERIFY(!desk.pose().placeButton()->isChecked());
    QVERIFY(desk.localization.orders.empty());
  }

  void aPoseThatTheRobotDoesNotHoldIsSaid() {
    Desk desk;
    desk.bench.action("robotPose")->trigger();
    desk.drag(desk.at(1, 2), desk.at(1, 5));
    QTest::mouseClick(desk.pose().setButton(), Qt::LeftButton);
    desk.localization.poses.answer(geometry::Pose2{20, 2, 0});
    QVERIFY2(desk.pose().outcomeShown().contains(QLatin1String("says that it is at x 20.00 m")),
             qPrintable(desk.pose().outcomeShown()));
    QVERIFY(desk.toasts().isEmpty());
    QVERIFY(desk.pose().setButton()->isEnabled());  // what was placed is still there
    QTest::mouseClick(desk.pose().setButton(), Qt::LeftButton);
    desk.localization.poses.answer(tl::make_unexpected(unknown()));
    QVERIFY2(desk.pose().outcomeShown().contains(QLatin1String("is unknown")),
             qPrintable(desk.pose().outcomeShown()));
    QTest::mouseClick(desk.pose().setButton(), Qt::LeftButton);
    QTest::mouseClick(desk.pose().cancelButton(), Qt::LeftButton);
    QCOMPARE(desk.localization.poses.cancelled, 1);
  }

  void aPoseThatTheRobotProposesIsSetOnlyWhenItIsConfirmed() {
    Desk desk;
    desk.bench.action("robotPose")->trigger();
    QTest::mouseClick(desk.pose().findButton(), Qt::LeftButton);
    map::GlobalPositioning found;
    found.state = "succeeded";
    found.score = 0.7;
    found.needs_confirmation = true;
    found.pose = geometry::Pose2{4, 5, 1};
    desk.localization.searches.answer(found);
    QVERIFY(desk.pose().confirmButton()->isVisible());
    QVERIFY(desk.localization.orders.empty());
    QTest::mouseClick(desk.pose().rejectButton(), Qt::LeftButton);
    QVERIFY(!desk.pose().confirmButton()->isVisible());
    QTest::mouseClick(desk.pose().findButton(), Qt::LeftButton);
    desk.localization.searches.answer(found);
    QTest::mouseClick(desk.pose().confirmButton(), Qt::LeftButton);
    QCOMPARE(desk.localization.orders.size(), std::size_t(1));
    QVERIFY(desk.localization.orders[0].pose == *found.pose);
  }

  void aRobotThatIsAwayIsGivenNoPose() {
    Desk desk;
    desk.bench.action("robotPose")->trigger();
    desk.drag(desk.at(1, 2), desk.at(1, 5));
    desk.bench.robot->goAway(QStringLiteral("gone"));
    QVERIFY(!desk.pose().setButton()->isEnabled());
    QVERIFY(desk.pose().warningShown().contains(QLatin1String("not connected")));
    desk.bench.robot->goOnline();
    QVERIFY(desk.pose().setButton()->isEnabled());
  }

  void aMappingIsNoticedWhoeverStartedIt() {
    Desk desk;
    MappingDock& dock = *part<MappingDock>(*desk.bench.window);
    auto& controller = *part<AdministrationController>(*desk.bench.window);
    desk.mapping.mapping = false;
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QVERIFY(dock.said().contains(QLatin1String("not mapping")));
    desk.mapping.mapping = true;
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    QVERIFY2(dock.said().startsWith(QLatin1String("The robot is mapping.")), qPrintable(dock.said()));
    QVERIFY(!desk.toasts().isEmpty());
    robot::MappingProgress progress{{map::MapKind::Mapping, "7"}, 200.0, true};
    desk.mapping.looks.answer(std::optional(progress));
    QVERIFY2(dock.said().contains(QLatin1String("more of Ground floor")), qPrintable(dock.said()));
    QVERIFY(dock.said().contains(QLatin1String("3 min 20 s")));
    desk.bench.robot->goAway(QStringLiteral("gone"));
    QVERIFY(dock.said().contains(QLatin1String("when the connection was lost")));
    desk.bench.robot->goOnline();
    controller.lookAtMapping();
    desk.mapping.looks.answer(tl::make_unexpected(test::failed("busy")));
    QVERIFY(dock.said().contains(QLatin1String("Busy")));
  }

  void aMappingIsDiscardedOnlyAfterAQuestion() {
    Desk desk;
    desk.mapping.mapping = true;
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    desk.bench.action("cancelMapping")->trigger();
    ChangeDialog* const dialog = part<AdministrationController>(*desk.bench.window)->dialog();
    QVERIFY(dialog && dialog->textShown().contains(QLatin1String("is lost")));
    QVERIFY(desk.mapping.orders.empty());
    QTest::keyClick(dialog, Qt::Key_Return);  // the safe one
    QVERIFY(desk.mapping.orders.empty());
    desk.bench.action("cancelMapping")->trigger();
    QTest::mouseClick(part<AdministrationController>(*desk.bench.window)->dialog()->acceptButton(),
                      Qt::LeftButton);
    QCOMPARE(desk.mapping.orders.size(), std::size_t(1));
    QVERIFY(desk.mapping.orders[0].change == MapChange::CancelMapping);
  }

  void aMapIsDownloadedWithProgressAndGoesOnAfterAFailure() {
    Desk desk;
    QTemporaryDir folder;
    auto& controller = *part<TransferController>(*desk.bench.window);
    const QString target = folder.filePath(QStringLiteral("one"));
    const map::MapKey key{map::MapKind::Stored, "1"};
    controller.download(key, QStringLiteral("Ground floor"), target);
    const auto give = [&] {
      robot::MapParts parts;
      parts.facts.key = key;
      parts.facts.name = "Ground floor";
      parts.facts.grid.resolution_m = 0.05;
      parts.picture = std::make_shared<const std::string>(pngOf(4, 4).toStdString());
      desk.transfer.whole.answer(parts);
    };
    give();
    desk.transfer.data.state->on_progress({50'000, 100'000});
    QVERIFY2(controller.dialog()->said().contains(QLatin1String("of")),
             qPrintable(controller.dialog()->said()));
    desk.transfer.data.answer(tl::make_unexpected(
        map::Failure{.kind = map::FailureKind::Unreachable, .subject = map::subjectOf(key)}));
    QVERIFY(controller.dialog()->failed());
    QVERIFY(!QFile::exists(target + QStringLiteral("/map.json")));
    QTest::mouseClick(controller.dialog()->againButton(), Qt::LeftButton);
    QTRY_COMPARE(desk.transfer.keys.size(), std::size_t(2));
    give();
    QFile data(desk.transfer.data_path);
    QVERIFY(data.open(QIODevice::WriteOnly));
    data.write("data");
    data.close();
    desk.transfer.data.answer(robot::DataDownload{desk.transfer.data_path, 4, true});
    QTRY_VERIFY(QFile::exists(target + QStringLiteral("/map.json")));
    QTRY_VERIFY(!desk.toasts().isEmpty());
    // And from there to the robot.
    controller.upload(target);
    QTRY_COMPARE(desk.transfer.added.size(), std::size_t(1));
    QCOMPARE(*desk.transfer.added[0].data, std::string("data"));
    desk.transfer.put.answer(tl::make_unexpected(unknown()));
    QVERIFY(controller.dialog()->said().contains(QLatin1String("is unknown")));
  }

  void belowEachStoredMapIsARowThatOpensItsSubmaps() {
    Desk desk;
    MapsDock& dock = *part<MapsDock>(*desk.bench.window);
    const MapsModel& model = *dock.model();
    QStringList rows;
    for (int row = 0; row < model.rowCount(); ++row) rows << model.index(row).data().toString();
    QCOMPARE(rows.count(QStringLiteral("Its submaps")), 2);  // a mapping has none
    const map::MapKey attic{map::MapKind::Stored, "2"};
    const QModelIndex of_attic = model.index(model.indexOf(attic).row() + 1);
    QVERIFY(model.isSubmaps(of_attic) && model.key(of_attic) == attic);
    // Both ask where to, and nothing is opened here before it is downloaded.
    const auto asksWhereTo = [&](const std::function<void()>& act) {
      QString title;
      QTimer looks;
      QObject::connect(&looks, &QTimer::timeout, &looks, [&] {
        QWidget* const asked = QApplication::activeModalWidget();
        if (!asked) return;
        title = asked->windowTitle();
        asked->close();
      });
      looks.start(0);
      act();
      return title;
    };
    desk.bench.robot->maps.opened.clear();
    dock.show();
    dock.raise();
    dock.list()->scrollTo(of_attic);
    dock.list()->setCurrentIndex(of_attic);
    QVERIFY(asksWhereTo([&] {
              QTest::keyClick(dock.list(), Qt::Key_Return);
            }).contains(QStringLiteral("<b>Attic</b>")));
    const QPoint at = dock.list()->visualRect(of_attic).center();
    QTest::mouseClick(dock.list()->viewport(), Qt::LeftButton, {}, at);
    QVERIFY(asksWhereTo([&] {
              QTest::mouseDClick(dock.list()->viewport(), Qt::LeftButton, {}, at);
            }).contains(QStringLiteral("<b>Attic</b>")));
    QVERIFY(desk.bench.robot->maps.opened.empty());
    // A robot that gives no files has no such rows.
    desk.bench.robot->transferring = nullptr;
    Q_EMIT desk.bench.robot->capabilitiesChanged();
    for (int row = 0; row < model.rowCount(); ++row) QVERIFY(!model.isSubmaps(model.index(row)));
    QCOMPARE(model.maps(), 3);
  }

  void aMapIsMadeOfAPictureWhosePlaceIsShown() {
    Desk desk;
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("Hall.png"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(pngOf(60, 40));
    file.close();
    auto& controller = *part<TransferController>(*desk.bench.window);
    controller.create(path);
    QTRY_VERIFY(controller.newMapDialog());
    NewMapDialog& dialog = *controller.newMapDialog();
    QCOMPARE(dialog.nameEdit()->text(), QStringLiteral("Hall"));
    QVERIFY2(dialog.sizeShown().contains(QLatin1String("3.0 x 2.0 m")), qPrintable(dialog.sizeShown()));
    dialog.resolutionBox()->setValue(5);
    QVERIFY(!dialog.acceptButton()->isEnabled() && !dialog.errorShown().isEmpty());
    dialog.resolutionBox()->setValue(0.1);
    dialog.xBox()->setValue(-3);
    QTest::mouseClick(dialog.acceptButton(), Qt::LeftButton);
    QTRY_COMPARE(desk.transfer.added.size(), std::size_t(1));
    const robot::NewMap& sent = desk.transfer.added[0];
    QCOMPARE(sent.grid.width, 60);
    QCOMPARE(sent.grid.origin.x_m, -3.0);
    robot::MapFacts now;
    now.key = {map::MapKind::Stored, "9"};
    now.name = "Hall";
    now.grid = sent.grid;
    now.grid.resolution_m = 0.2;
    desk.transfer.put.answer(robot::MapParts{now, sent.picture});
    QTRY_VERIFY(desk.toasts().join(QLatin1Char(' ')).contains(QLatin1String("its resolution is 0.2 m")));
  }

  void whatIsNoPictureIsNotAskedFor() {
    Desk desk;
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("no.png"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("no picture");
    file.close();
    part<TransferController>(*desk.bench.window)->create(path);
    QTRY_VERIFY(desk.toasts().join(QLatin1Char(' ')).contains(QLatin1String("cannot be a map")));
    QVERIFY(desk.transfer.added.empty());
  }
};

}  // namespace test_window_moves

MAPWRIGHT_TEST(test_window_moves, TestWindowMoves, Widgets)
#include "test_window_moves.moc"
