// An hour of use in ten minutes: a window on a simulated robot whose clock runs fast and that fails as robots
// do. Again and again it connects, moves the map, edits overlays and waypoints, records, replays what it
// recorded and leaves the robot. After each round, when nothing is open, memory, file handles, threads,
// objects and timers are counted. Ends with 1 if they still grow in the second half, with 2 if a part of the
// rounds never worked.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <malloc.h>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <QAbstractButton>
#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QMutex>
#include <QPixmapCache>
#include <QProcess>
#include <QPushButton>
#include <QScopeGuard>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>

#include "app/robot_factory.h"
#include "edit/overlays/overlay_editing.h"
#include "replay/replay_robot.h"
#include "session/session.h"
#include "ui/overlays/overlay_review.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/replay/recording_controller.h"
#include "ui/replay/replay_controller.h"
#include "ui/shell/replay_clock.h"
#include "ui/view/map_view.h"
#include "ui/view/replay_state.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoints_controller.h"
#include "ui/window/main_window.h"
#include "work/budgets.h"

// Qt's hooks for programs that watch objects (private/qhooks_p.h): 3 is called for each new object, 4 for
// each that is destroyed.
extern quintptr Q_DECL_IMPORT qtHookData[];

namespace {

using namespace mapwright;

QMutex living_lock;
std::set<QObject*> living;
void onAdded(QObject* object) {
  const QMutexLocker lock(&living_lock);
  living.insert(object);
}
void onRemoved(QObject* object) {
  const QMutexLocker lock(&living_lock);
  living.erase(object);
}

struct Sample {
  double at_s = 0;
  double memory_mib = 0;  // resident
  double heap_mib = 0;    // in use, without what malloc keeps
  double handles = 0, threads = 0, objects = 0, timers = 0;
};

double entriesOf(const char* folder) {
  return double(
      QDir(QLatin1String(folder)).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::System).size());
}

Sample count(double at_s) {
  malloc_trim(0);
  Sample made;
  made.at_s = at_s;
  QFile file(QStringLiteral("/proc/self/statm"));
  if (file.open(QIODevice::ReadOnly))
    made.memory_mib = file.readAll().split(' ').at(1).toDouble() * 4096 / 1048576;
  file.close();
  const struct mallinfo2 heap = mallinfo2();
  made.heap_mib = double(heap.uordblks + heap.hblkhd) / 1048576;
  made.handles = entriesOf("/proc/self/fd");
  made.threads = entriesOf("/proc/self/task");
  const QMutexLocker lock(&living_lock);
  made.objects = double(living.size());
  for (QObject* const object : living) {
    if (object->thread() != qApp->thread()) continue;  // another's timers must not be asked for here
    made.timers += double(QAbstractEventDispatcher::instance()->registeredTimers(object).size());
  }
  return made;
}

/// How many objects of this thread there are of each class, and in what.
std::map<std::string, int> classes() {
  std::map<std::string, int> made;
  const QMutexLocker lock(&living_lock);
  for (const QObject* const object : living) {
    if (object->thread() != qApp->thread()) continue;
    const QObject* const parent = object->parent();
    ++made[std::string(object->metaObject()->className()) + " in " +
           (parent ? parent->metaObject()->className() : "nothing")];
  }
  return made;
}

bool waitFor(const std::function<bool()>& done, int most_ms) {
  QElapsedTimer since;
  since.start();
  while (!done() && since.elapsed() < most_ms) {
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // no loop does it for us here
  }
  return done();
}
void live(int ms) {
  waitFor([] { return false; }, ms);
}

template <class Part>
Part& part(ui::MainWindow& window) {
  return *window.findChild<Part*>();
}

/// A question about what is not saved is answered as somebody would who does not want it.
void answerQuestions() {
  for (QWidget* const top : QApplication::topLevelWidgets()) {
    auto* const box = qobject_cast<QMessageBox*>(top);
    if (!box || !box->isVisible()) continue;
    for (QAbstractButton* const button : box->buttons()) {
      if (box->buttonRole(button) != QMessageBox::DestructiveRole) continue;
      button->click();
      return;
    }
    box->reject();
  }
}

struct Use {
  ui::MainWindow& window;
  QString autoxing, kabam, recording;
  std::map<std::string, int> worked = {}, tried = {};
  std::size_t overlays = 0;  // of the robot, at first

  void mark(const char* what, bool did) {
    ++tried[what];
    worked[what] += did;
  }
  QAction* action(const char* id) { return window.actionList().find(QLatin1String(id)); }
  bool connect(const QString& address) {
    return !window.connectTo(address) && waitFor([&] { return window.session() != nullptr; }, 5'000);
  }
  void lookAround(int steps) {
    for (int i = 0; i < steps; ++i) {
      geometry::ViewTransform camera = window.mapScene()->view();
      camera.center_m = {10 * std::sin(i * 0.7), 10 * std::cos(i * 1.1)};
      camera.scale_m_per_px = 0.01 * std::pow(2, i % 5);
      camera.rotation_rad = 0.3 * (i % 4);
      window.view()->moveTo(camera, false);
      live(60);
    }
  }
  void everyDockOnce() {
    for (QDockWidget* const dock : window.findChildren<QDockWidget*>()) {
      if (!dock->isHidden() || !dock->toggleViewAction()->isEnabled()) continue;
      dock->show();
      live(10);
      dock->hide();
    }
  }
  void editOverlays(bool save) {
    auto& control = part<ui::OverlaysController>(window);
    edit::OverlayEditing& editing = *control.editing();
    action("overlayTool")->trigger();
    mark("open overlays",
         waitFor([&] { return editing.editable() && editing.document().size() > 0; }, 10'000));
    if (!editing.editable() || editing.document().size() == 0) return;
    if (overlays == 0) overlays = editing.document().keysOfMine().size();
    for (int i = 0; i < 20; ++i) {
      editing.select({0});
      editing.duplicateSelected();
      live(5);
      editing.removeSelected();
      live(5);
      action("undo")->trigger();
      action("undo")->trigger();
    }
    if (!save) return;
    // One more, and at the next save one less: the document does not grow.
    const std::vector<overlays::FeatureKey> keys = editing.document().keysOfMine();
    editing.select({keys.back()});
    keys.size() > overlays ? editing.removeSelected() : editing.duplicateSelected();
    action("save")->trigger();
    if (!waitFor([&] { return control.review() != nullptr; }, 10'000)) return mark("save overlays", false);
    control.review()->saveButton()->click();
    mark("save overlays", waitFor([&] { return !control.busy() && !control.review(); }, 30'000));
  }
  void editWaypoints() {
    ui::WaypointEditing& editing = *part<ui::WaypointsController>(window).editing();
    mark("open waypoints", waitFor([&] { return editing.document() && editing.editable(); }, 10'000));
    if (!editing.document()) return;
    for (int i = 0; i < 20; ++i) {
      editing.selectAll();
      editing.moveSelected({0.1, 0.2});
      live(5);
      action("undo")->trigger();
    }
  }
  void record() {
    auto& control = part<ui::RecordingController>(window);
    QFile::remove(recording);
    if (control.startInto(recording)) return mark("record", false);
    live(2'500);
    control.stop();
    mark("record", waitFor([&] { return control.shown().isEmpty(); }, 10'000) && QFile::exists(recording));
  }
  void replay() {
    if (!connect(QStringLiteral("file:") + recording)) return mark("replay", false);
    ui::ReplayClock& clock = part<ui::ReplayController>(window).clock();
    if (!waitFor([&] { return clock.isOpen(); }, 10'000)) return mark("replay", false);
    clock.setLoop(replay::Player::Loop{clock.start(), clock.end()});
    clock.setSpeed(10);
    clock.play();
    live(2'000);
    for (int i = 0; i < 10; ++i) {
      clock.seek(clock.start() + (clock.end() - clock.start()) * (i % 7) / 7.0);
      live(30);
    }
    mark("replay", clock.isOpen());
  }
  void leave() {
    window.leaveRobot();
    mark("leave", waitFor([&] { return window.session() == nullptr; }, 20'000));
    live(700);  // what is deleted later, is; connections that end, have
  }
  void round(int number) {
    if (connect(autoxing)) {
      mark("submaps",
           waitFor([&] { return window.session() && window.session()->counts().shown > 0; }, 15'000));
      lookAround(20);
      everyDockOnce();
      editOverlays(number % 3 == 0);
      record();
    }
    leave();
    replay();
    leave();
    if (connect(kabam)) {
      live(500);
      lookAround(8);
      editWaypoints();
    }
    leave();
  }
};

double median(std::vector<double> of) {
  std::nth_element(of.begin(), of.begin() + std::ptrdiff_t(of.size() / 2), of.end());
  return of[of.size() / 2];
}

/// Whether it grew from the third quarter to the last by more than `most` and by more than `share`.
bool grew(const std::vector<Sample>& samples, double Sample::*figure, double most, double share,
          const char* name) {
  const std::size_t quarter = samples.size() / 4;
  const auto of = [&](std::size_t from, std::size_t to) {
    std::vector<double> all;
    for (std::size_t i = from; i < to; ++i) all.push_back(samples[i].*figure);
    return median(std::move(all));
  };
  const double before = of(2 * quarter, 3 * quarter), after = of(3 * quarter, samples.size());
  const bool more = after - before > most && after > before * (1 + share);
  std::printf("%-8s %10.1f in the third quarter, %10.1f in the last%s\n", name, before, after,
              more ? "   GREW" : "");
  return more;
}

}  // namespace

int main(int argc, char** argv) {
  const double minutes = argc > 1 ? std::atof(argv[1]) : 10;
  if (!(minutes > 0)) {
    std::fputs("Usage: mapwright-soak [minutes]\n", stderr);
    return 2;
  }
  qtHookData[3] = reinterpret_cast<quintptr>(&onAdded);
  qtHookData[4] = reinterpret_cast<quintptr>(&onRemoved);
  // Qt destroys its own last objects after what is static here.
  const auto unhook = qScopeGuard([] { qtHookData[3] = qtHookData[4] = 0; });
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QTemporaryDir folder;
  for (const char* home : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"})
    qputenv(home, QFile::encodeName(folder.filePath(QLatin1String(home))));
  QApplication program(argc, argv);
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& text) {
    if (!text.startsWith(QLatin1String("This plugin does not support")))
      std::fprintf(stderr, "%s\n", qPrintable(text));
  });

  QProcess robot;  // of its own, so that its memory is not counted
  robot.setProcessChannelMode(QProcess::ForwardedErrorChannel);
  robot.start(
      QCoreApplication::applicationDirPath() + QStringLiteral("/../../app/mapwright"),
      QStringLiteral("simulate --speed 6 --latency-ms 5 --jitter-ms 40 --drop-rate 0.02 --truncate-rate 0.02 "
                     "--corrupt-rate 0.02 --error-rate 0.02 --error-status 502 --websocket-drop-every 120 "
                     "--uuid-change-every 900 --overlay-edit-every 60 --lose-write-answers 0.1")
          .split(QLatin1Char(' ')));
  QByteArray said;
  const bool up = waitFor(
      [&] {
        said += robot.readAllStandardOutput();
        return said.contains('\n');
      },
      20'000);
  const QJsonObject addresses = QJsonDocument::fromJson(said.left(said.indexOf('\n'))).object();
  if (!up || addresses.isEmpty()) {
    std::fprintf(stderr, "The simulated robot did not start. %s\n", said.constData());
    return 2;
  }

  QSettings settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
  ui::MainWindow::Dependencies wanted{
      [](const QString& address, const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
        auto made = app::makeRobot(address, {}, app::DemoTime::Running);
        const QString path = QString(address).remove(QStringLiteral("file:"));
        if (made && address.startsWith(QLatin1String("file:")))
          *made = std::make_unique<replay::ReplayRobot>(std::move(*made), app::bagNameOf(path),
                                                        ui::followedReading());
        return made;
      },
      settings};
  wanted.session = app::sessionOptions();
  wanted.addresses = app::knownAddresses();
  wanted.edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
  wanted.overlays_history = folder.filePath(QStringLiteral("overlays.sqlite")).toStdString();
  wanted.budgets =
      work::budgetsFrom(work::kLeastBudget);  // full after some rounds: what grows then is no cache
  QPixmapCache::setCacheLimit(1'024);         // KB: the same
  ui::MainWindow window(std::move(wanted));
  window.resize(1366, 768);
  window.show();
  QTimer answering;
  QObject::connect(&answering, &QTimer::timeout, [] { answerQuestions(); });
  answering.start(200);

  Use use{window, addresses[QStringLiteral("axbot")].toString(),
          addresses[QStringLiteral("kabam")].toString(), folder.filePath(QStringLiteral("soak.mcap"))};
  std::vector<Sample> samples;
  std::map<std::string, int> middle;
  QElapsedTimer since;
  since.start();
  std::puts("   time   memory     heap  handles  threads  objects   timers");
  for (int number = 0; double(since.elapsed()) < minutes * 60'000 || samples.size() < 8; ++number) {
    use.round(number);
    const Sample now = count(double(since.elapsed()) / 1'000);
    samples.push_back(now);
    if (middle.empty() && now.at_s > minutes * 30) middle = classes();
    std::printf("%5.0f s %5.0f MiB %5.1f MiB %8.0f %8.0f %8.0f %8.0f\n", now.at_s, now.memory_mib,
                now.heap_mib, now.handles, now.threads, now.objects, now.timers);
    std::fflush(stdout);
  }
  bool never = false;
  for (const auto& [what, tries] : use.tried) {
    std::printf("%-16s %4d of %d\n", what.c_str(), use.worked[what], tries);
    never = never || use.worked[what] == 0;
  }
  bool more = grew(samples, &Sample::memory_mib, 8, 0.04, "memory");
  more = grew(samples, &Sample::heap_mib, 6, 0.05, "heap") || more;
  more = grew(samples, &Sample::handles, 3, 0, "handles") || more;
  more = grew(samples, &Sample::threads, 2, 0, "threads") || more;
  more = grew(samples, &Sample::objects, 20, 0.005, "objects") || more;
  more = grew(samples, &Sample::timers, 3, 0, "timers") || more;
  if (more) {
    std::puts("Objects that are more than in the middle:");
    for (const auto& [name, number] : classes()) {
      const auto earlier = middle.find(name);
      const int had = earlier == middle.end() ? 0 : earlier->second;
      if (number > had) std::printf("%6d -> %6d %s\n", had, number, name.c_str());
    }
  }
  robot.terminate();
  robot.waitForFinished(5'000);
  return more ? 1 : never ? 2 : 0;
}
