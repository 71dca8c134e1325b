// The pictures of the documents, made by the program itself: each task is done in a real window, and what is
// seen then is the picture. docs/draw-pictures writes them; without it the test shows that the tasks work.
#include <functional>

#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QRegularExpression>
#include <QTableView>
#include <QtTest>

#include "app/robot_factory.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/bag_library.h"
#include "shown_window.h"
#include "simulator/simulator.h"
#include "test_program.h"
#include "ui/replay/replay_controller.h"
#include "ui/shell/replay_clock.h"
#include "window/window_parts.h"

namespace test_guide_pictures {

using namespace mapwright;

namespace {

/// A robot that stands still in time, so that its pictures hardly change from one run to the next.
simulator::Options frozen() {
  simulator::Options options;
  options.paused = true;
  options.start_at_s = 90;
  return options;
}

constexpr int kLongMs = 60'000;

/// A window on a simulated robot, and what a hand does there. What it cannot do ends the test.
class Desk {
 public:
  explicit Desk(const simulator::Options& options = frozen())
      : robot_(options), shown_([](const QString& to, const QByteArray&) {
          return app::makeRobot(to, {}, app::DemoTime::Frozen);
        }) {
    if (const auto error = robot_.start()) qFatal("%s", error->c_str());
  }

  window::MainWindow& window() { return shown_.window(); }
  session::Session* session() { return shown_.session(); }
  const simulator::Simulator& robot() const { return robot_; }
  bool connectTo(const std::string& address) {
    return shown_.connectTo(QString::fromStdString(address)) && settles();
  }
  /// Opens the first map that the robot stores.
  bool openMap() {
    const auto stored = [this]() -> const map::CatalogueEntry* {
      for (const map::CatalogueEntry& entry : session()->catalogue().entries())
        if (entry.key.kind == map::MapKind::Stored) return &entry;
      return nullptr;
    };
    if (!QTest::qWaitFor([&] { return stored() != nullptr; }, kLongMs)) return false;
    session()->openMap(stored()->key);
    return QTest::qWaitFor([this] { return session()->wholeMap().cells() && settled(); }, kLongMs);
  }
  void act(const char* id) {
    QAction* const action = window().actionList().find(QLatin1String(id));
    if (!action || !QTest::qWaitFor([&] { return action->isEnabled(); }, kLongMs)) qFatal("no action %s", id);
    action->trigger();
  }
  QDockWidget& front(const char* dock) {
    auto* const panel = window().findChild<QDockWidget*>(QLatin1String(dock));
    if (!panel) qFatal("no dock %s", dock);
    panel->show();
    panel->raise();
    return *panel;
  }
  /// Selects the first row in a table of the dock that contains `text`.
  bool select(const char* dock, const char* text) {
    return QTest::qWaitFor(
        [&, &panel = front(dock)] {
          for (auto* const table : panel.findChildren<QTableView*>()) {
            const QModelIndexList rows = table->model()->match(table->model()->index(0, 0), Qt::DisplayRole,
                                                               QLatin1String(text), 1, Qt::MatchContains);
            if (rows.isEmpty()) continue;
            table->setCurrentIndex(rows.front());
            return true;
          }
          return false;
        },
        kLongMs);
  }
  /// What is seen when nothing moves any more; written if asked to.
  bool picture(const char* name) {
    const bool quiet = settles() && QTest::qWaitFor([this] { return !shown_.hasToasts(); }, kLongMs);
    const QImage seen = window().grab().toImage();
    const QString folder = qEnvironmentVariable("MAPWRIGHT_GUIDE_PICTURES");
    if (!folder.isEmpty() &&
        !seen.save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"), nullptr, 0))
      return false;
    return quiet && seen.size() == QSize(1366, 768);
  }

 private:
  bool settled() { return session() && shown_.mapsSettled() && window().mapScene()->settled(); }
  bool settles() {
    return QTest::qWaitFor([this] { return settled(); }, kLongMs);
  }

  simulator::Simulator robot_;
  test::ShownWindow shown_;
};

}  // namespace

class GuidePicturesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void inspectWhatARobotKnows() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    desk.act("layoutInspect");
    desk.act("modeBoth");
    desk.front("layers");
    desk.front("robot");
    desk.act("fit");
    QVERIFY(desk.picture("inspect"));
  }

  void editAMap_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<QString>("dock");
    QTest::addColumn<QString>("picture");
    QTest::newRow("waypoints") << QStringLiteral("waypointTool") << QStringLiteral("waypoints")
                               << QStringLiteral("waypoints");
    QTest::newRow("picture") << QStringLiteral("pictureTool") << QStringLiteral("picture")
                             << QStringLiteral("clean");
  }
  void editAMap() {
    QFETCH(QString, tool);
    QFETCH(QString, dock);
    QFETCH(QString, picture);
    Desk desk(simulator::Options{});  // its rosbridge needs time that passes
    QVERIFY(desk.connectTo(desk.robot().kabamAddress()) && desk.openMap());
    desk.act(qPrintable(tool));
    desk.front(qPrintable(dock));
    desk.act("fit");
    QVERIFY(desk.picture(qPrintable(picture)));
  }

  void editOverlays() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()) && desk.openMap());
    desk.act("layoutOperate");
    desk.act("modeWhole");
    desk.act("overlayTool");
    QVERIFY(desk.select("overlays", "Region 15"));
    desk.act("fit");
    QVERIFY(desk.picture("overlays"));
  }

  void replayWhatHappened() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    robot::BagKey key;
    bool listed = false;
    const auto call = desk.session()->robot().bagLibrary()->list([&](auto bags) {
      listed = true;
      if (bags && bags->size() > 2) key = (*bags)[1].key;
    });
    QTRY_VERIFY(listed);
    auto* const replay = window::part<window::ReplayController>(desk.window());
    QVERIFY(replay);
    replay->openBag(key);
    QTRY_VERIFY_WITH_TIMEOUT(replay->clock().isOpen(), 30'000);
    desk.act("modeWhole");
    QTRY_VERIFY_WITH_TIMEOUT(replay->clock().readShare() == 1, 30'000);
    replay->clock().seek(replay->clock().start() + 300);
    QTRY_VERIFY(replay->clock().knowledge() == replay::Knowledge::Exact);
    desk.act("layoutReplay");
    desk.front("events");
    desk.front("timeline");
    desk.act("fit");
    QVERIFY(desk.picture("replay"));
  }

  void compareTwoMaps() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    desk.act("modeWhole");
    desk.act("compare");
    desk.act("fit");
    QVERIFY(desk.picture("compare"));
  }

  /// A picture that nothing makes would show an old program for ever.
  void thePagesShowJustThese() {
    const QDir top(QFINDTESTDATA("../../docs"));
    QStringList pages{top.filePath(QStringLiteral("../README.md"))};
    QDirIterator below(top.path(), {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories);
    while (below.hasNext()) pages << below.next();
    QSet<QString> shown;
    for (const QString& page : pages) {
      QFile file(page);
      QVERIFY(file.open(QIODevice::ReadOnly));
      static const QRegularExpression picture(QStringLiteral("\\]\\([^)]*pictures/(\\w+)\\.png\\)"));
      for (auto all = picture.globalMatch(QString::fromUtf8(file.readAll())); all.hasNext();)
        shown << all.next().captured(1);
    }
    QStringList kept;
    for (const QFileInfo& picture :
         QDir(top.filePath(QStringLiteral("pictures"))).entryInfoList(QDir::Files)) {
      kept << picture.baseName();
      QVERIFY2(picture.size() < 350'000, qPrintable(picture.fileName()));
    }
    QCOMPARE(kept, (QStringList{QStringLiteral("clean"), QStringLiteral("compare"), QStringLiteral("inspect"),
                                QStringLiteral("overlays"), QStringLiteral("replay"),
                                QStringLiteral("waypoints")}));
    QCOMPARE(shown, QSet<QString>(kept.begin(), kept.end()));
  }
};

}  // namespace test_guide_pictures

MAPWRIGHT_TEST(test_guide_pictures, GuidePicturesTest, Widgets)
#include "test_guide_pictures.moc"
