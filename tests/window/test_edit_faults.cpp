// What can go wrong while something is saved, for each of the three editors: the same table of faults, and
// what holds after each of them.
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>

#include "../edit/fake_waypoint_store.h"
#include "robot/overlay_store.h"
#include "robot/picture_store.h"
#include "test_program.h"
#include "ui/overlays/overlay_review.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/picture/picture_controller.h"
#include "ui/view/map_overlay.h"
#include "ui/view/toast_stack.h"
#include "ui/waypoints/waypoint_review.h"
#include "ui/waypoints/waypoints_controller.h"
#include "window_bench.h"

namespace test_edit_faults {

using namespace mapwright;
using namespace mapwright::ui;

namespace {

/// What becomes of one change on its way to the robot.
enum class Fate {
  Done,
  Refused,     // the robot says no
  NotSent,     // the link is gone before
  LostBefore,  // no answer, and the robot has not done it
  LostAfter,   // no answer, and the robot has done it
  Ignored,  // the robot says yes, and has not done it: overlays are looked at, other stores notice themselves
  Overtaken,  // others change something else just before
};

std::optional<map::Failure> failureOf(Fate fate) {
  map::Failure failure{.kind = map::FailureKind::Unreachable, .asked_for = map::AskedFor::Change};
  switch (fate) {
    case Fate::Refused:
      failure.kind = map::FailureKind::RejectedByRobot;
      failure.detail = "Not now.";
      failure.applied = map::Applied::No;
      return failure;
    case Fate::NotSent:
      failure.applied = map::Applied::No;
      return failure;
    case Fate::LostBefore:
    case Fate::LostAfter:
      failure.applied = map::Applied::Maybe;
      return failure;
    default:
      return std::nullopt;
  }
}

bool happens(Fate fate) { return fate == Fate::Done || fate == Fate::LostAfter || fate == Fate::Overtaken; }

const map::MapKey kMap{map::MapKind::Stored, "1"};

/// One editor in a window on a robot of its own, whose next change has a fate.
class Editor : public test::Bench {
 public:
  virtual ~Editor() = default;  // derived: the window goes before its robot's stores
  virtual EditorController& control() = 0;
  virtual bool isOpen() = 0;
  virtual void change() = 0;
  /// Confirms what is asked before anything is sent.
  virtual void confirm() = 0;
  virtual bool busy() = 0;
  /// The robot has what was changed here.
  virtual bool holdsMine() = 0;
  /// The link is back: what the robot keeps may have changed.
  virtual void reconnect() {
    robot->goAway(QStringLiteral("It was cut."));
    robot->goOnline();
  }
  /// The robot has what others changed.
  virtual bool holdsTheirs() { return true; }
  virtual void offerStore(test::FakeRobot& made) = 0;

  void start() {
    offerMaps();
    prepare = [this, offer = prepare](test::FakeRobot& made) {
      offer(made);
      made.has_submaps = false;
      offerStore(made);
    };
    edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    openWindow();
  }
  void openWindow() {
    open({1900, 1050});
    QVERIFY(!window->connectTo(test::kAddress));
    window->session()->openMap(map::MapKey(kMap));
  }
  void save(Fate next) {
    fate = next;
    action("save")->trigger();
    confirm();
  }
  /// What is on disk at this moment is all that is left of the program.
  void kill() {
    std::map<QString, QByteArray> left;
    for (const QString& path : draftFiles()) {
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadOnly));
      left[path] = file.readAll();
    }
    window.reset();
    for (const QString& path : draftFiles()) QVERIFY(QFile::remove(path));
    for (const auto& [path, bytes] : left) {
      QFile file(path);
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
  }
  QStringList draftFiles() const {
    const QDir drafts(edit.drafts_folder);
    QStringList paths;
    for (const QString& name : drafts.entryList({QStringLiteral("*.json")}, QDir::Files))
      paths << drafts.filePath(name);
    return paths;
  }
  /// What the window says of it, as messages or in the panel.
  QString said() { return part<MapOverlay>(*window)->toasts()->texts().join(QLatin1Char('\n')); }

  Fate fate = Fate::Done;
};

class WaypointsEditor : public Editor {
 public:
  WaypointsEditor() {
    store.points = {test::waypoint("a", 1, 1, "Dock"), test::waypoint("b", 3, 2, "Kitchen")};
    store.before_performing = [this] {
      if (fate == Fate::Overtaken) store.put(test::waypoint("b", 3, 2, "Canteen"));
      if (const auto failure = failureOf(fate == Fate::Ignored ? Fate::Refused : fate))
        store.failures.push_back(*failure);
      store.does_what_fails = happens(fate);
      fate = Fate::Done;
    };
  }
  ~WaypointsEditor() override { window.reset(); }
  void reconnect() override {
    Editor::reconnect();
    Q_EMIT store.changed();
  }
  WaypointsController& control() override { return *part<WaypointsController>(*window); }
  bool isOpen() override { return control().editing()->document() != nullptr; }
  void change() override { control().editing()->rename("a", QStringLiteral("Dock 7")); }
  void confirm() override {
    if (control().review()->isVisible()) QFAIL("there is nothing to review in one change");
  }
  bool busy() override { return control().list()->saving(); }
  bool holdsMine() override { return store.find("Dock 7") != nullptr; }
  bool holdsTheirs() override { return store.find("Canteen") != nullptr; }
  void offerStore(test::FakeRobot& made) override { made.waypoint_store = &store; }

 private:
  test::FakeWaypointStore store{test::FakeWaypointStore::Mode::OneByOne};
};

class OverlaysEditor : public Editor, public robot::OverlayStore {
 public:
  ~OverlaysEditor() override { window.reset(); }
  OverlaysController& control() override { return *part<OverlaysController>(*window); }
  bool isOpen() override {
    if (!control().editing()->isOpen() && action("overlayTool")->isEnabled())
      action("overlayTool")->trigger();
    return control().editing()->isOpen();
  }
  void change() override {
    control().editing()->select({0});
    control().editing()->changeSelected(QStringLiteral("move"), [](const Feature& feature) {
      return overlays::movedBy(feature, {1, 0});
    });
  }
  void confirm() override {
    QTRY_VERIFY(control().review() || !busy());
    if (control().review()) QTest::mouseClick(control().review()->saveButton(), Qt::LeftButton);
  }
  bool busy() override { return control().busy(); }
  bool holdsMine() override { return held_.find("[3") != std::string::npos; }
  bool holdsTheirs() override { return held_.find("theirs") != std::string::npos; }
  void offerStore(test::FakeRobot& made) override { made.overlay_store = this; }

  robot::Call read(const map::MapKey&, robot::OutcomeTo<robot::OverlayText> reply) override {
    QTimer::singleShot(0, &timers_, [this, reply] {
      reply(robot::OverlayText{.text = held_, .version = version_, .map_uid = "u", .map_name = "Hall"});
    });
    return {};
  }
  robot::Call write(const map::MapKey&, const std::string& text,
                    robot::OutcomeTo<std::monostate> reply) override {
    const Fate now = std::exchange(fate, Fate::Done);
    if (happens(now)) {
      held_ = text;
      ++version_;
    }
    QTimer::singleShot(0, &timers_, [now, reply] {
      if (const auto failure = failureOf(now)) return reply(tl::make_unexpected(*failure));
      reply(std::monostate());
    });
    return {};
  }
  /// Others add a point.
  void addTheirs() {
    const std::string more =
        R"(,{"id":"p9","type":"Feature","geometry":{"type":"Point","coordinates":[9,9]},"properties":{"name":"theirs"}})";
    held_.insert(held_.rfind(']'), more);
    ++version_;
  }

 private:
  std::string held_ =
      R"({"type":"FeatureCollection","features":[{"id":"p1","type":"Feature","geometry":{"type":"Point","coordinates":[2,1]},"properties":{"type":"25","name":"Desk"}}]})";
  int version_ = 1;
  QObject timers_;
};

class PictureEditor : public Editor {
 public:
  ~PictureEditor() override { window.reset(); }
  PictureController& control() override { return *part<PictureController>(*window); }
  bool isOpen() override { return control().editing()->isOpen(); }
  void change() override {
    control().editing()->setKind(picture::Kind::Occupied);
    control().editing()->drawRectangle({40, 30, 44, 34});
  }
  void confirm() override {
    QVERIFY(control().sendingQuestion());
    control().sendingQuestion()->findChild<QPushButton*>(QStringLiteral("sendPicture"))->click();
  }
  bool busy() override { return control().saving() || control().editing()->merging(); }
  bool holdsMine() override { return black(41, 31); }
  bool holdsTheirs() override { return black(70, 50); }
  void offerStore(test::FakeRobot& made) override {
    maps_ = &made.maps;
    if (!held_.bytes) {
      held_ = test::wholeMap(kMap, "Ground floor", 80, 60);
      held_.fingerprint = "1";
    }
    maps_->pictures[kMap.id] = held_;
    made.picture_store = &store_;
  }

 private:
  /// Compares the version before it writes, and what is there afterwards, as the port asks.
  class Store : public robot::PictureStore {
   public:
    explicit Store(PictureEditor* of) : of_(of) {}
    std::optional<robot::PictureObstacle> obstacle(const map::WholeMap&) const override { return {}; }
    bool holdsUnknown(const map::WholeMap&) const override { return true; }
    robot::Call write(const robot::PictureChange& change,
                      robot::OutcomeTo<robot::PictureReceipt> reply) override {
      const Fate now = std::exchange(of_->fate, Fate::Done);
      if (now == Fate::Overtaken) of_->put([](int x, int y) { return x == 70 && y == 50; });
      const bool conflict = change.revision != of_->held_.fingerprint;
      if (!conflict && happens(now)) of_->put([&](int x, int y) { return change.cells->at(x, y) == 0; });
      QTimer::singleShot(0, this, [this, now, conflict, map = change.map, reply] {
        if (conflict) {
          reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Conflict,
                                                 .applied = map::Applied::No,
                                                 .asked_for = map::AskedFor::Change}));
        } else if (const auto failure = failureOf(now == Fate::Ignored ? Fate::Refused : now)) {
          reply(tl::make_unexpected(*failure));
        } else {
          reply(robot::PictureReceipt{of_->held_.fingerprint});
        }
        Q_EMIT changed(map);
      });
      return {};
    }

   private:
    PictureEditor* of_;
  };
  /// Black where `black` says so, and where it was.
  void put(const std::function<bool(int, int)>& black) {
    std::string pgm = *held_.bytes;
    const std::size_t cells = pgm.size() - 80 * 60;
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 80; ++x) {
        if (black(x, y)) pgm[cells + std::size_t(y * 80 + x)] = 0;
      }
    }
    held_.bytes = std::make_shared<const std::string>(std::move(pgm));
    held_.fingerprint = std::to_string(std::stoi(held_.fingerprint) + 1);
    maps_->pictures[kMap.id] = held_;
  }
  bool black(int x, int y) const {
    return (*held_.bytes)[held_.bytes->size() - 80 * 60 + std::size_t(y * 80 + x)] == 0;
  }

  Store store_{this};
  test::FakeMaps* maps_ = nullptr;
  map::WholeMap held_;
};

std::unique_ptr<Editor> editorOf(const QString& what) {
  if (what == QLatin1String("waypoints")) return std::make_unique<WaypointsEditor>();
  if (what == QLatin1String("overlays")) return std::make_unique<OverlaysEditor>();
  return std::make_unique<PictureEditor>();
}

}  // namespace

class EditFaultsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsSaidIsTrueAndNothingIsLost_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("fate");
    const std::pair<const char*, Fate> fates[] = {{"done", Fate::Done},
                                                  {"refused", Fate::Refused},
                                                  {"not sent", Fate::NotSent},
                                                  {"lost, not done", Fate::LostBefore},
                                                  {"lost, done", Fate::LostAfter},
                                                  {"ignored", Fate::Ignored},
                                                  {"overtaken", Fate::Overtaken}};
    for (const char* what : {"waypoints", "overlays", "picture"}) {
      for (const auto& [name, fate] : fates)
        QTest::addRow("%s: %s", what, name) << QString::fromLatin1(what) << int(fate);
    }
  }
  void whatIsSaidIsTrueAndNothingIsLost() {
    QFETCH(QString, what);
    QFETCH(int, fate);
    const std::unique_ptr<Editor> editor = editorOf(what);
    editor->start();
    QTRY_VERIFY(editor->isOpen());
    editor->change();
    QVERIFY(editor->control().unsaved());
    auto* const overlays = dynamic_cast<OverlaysEditor*>(editor.get());
    if (overlays && Fate(fate) == Fate::Overtaken) overlays->addTheirs();
    editor->save(Fate(fate));
    QTRY_VERIFY(!editor->said().isEmpty());
    QTRY_VERIFY(!editor->busy());
    const QString said = editor->said();
    if (const auto failure = failureOf(Fate(fate)); failure && failure->applied == map::Applied::Maybe)
      editor->reconnect();
    // What is not on the robot is still unsaved here, and never called saved.
    QTRY_VERIFY2(editor->holdsMine() == !editor->control().unsaved(), qPrintable(editor->said()));
    static const QRegularExpression no(QStringLiteral("\\b([Nn]ot|unknown)\\b"));
    if (!editor->holdsMine()) QVERIFY2(said.contains(no), qPrintable(said));
    QCOMPARE(editor->holdsMine(), happens(Fate(fate)));
    if (Fate(fate) == Fate::Overtaken) QVERIFY(editor->holdsTheirs());
    if (editor->holdsMine()) return;
    // It can be saved again, and then it is.
    QTRY_VERIFY(editor->control().maySave());
    editor->save(Fate::Done);
    QTRY_VERIFY2(editor->holdsMine() && !editor->control().unsaved(), qPrintable(editor->said()));
  }

  void whatAKilledProgramHadNotSavedCanBeRestored_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<bool>("sent");
    QTest::addColumn<int>("fate");
    for (const char* what : {"waypoints", "overlays", "picture"}) {
      const QString kind = QString::fromLatin1(what);
      QTest::addRow("%s: before it was sent", what) << kind << false << int(Fate::NotSent);
      QTest::addRow("%s: sent, and done", what) << kind << true << int(Fate::LostAfter);
      QTest::addRow("%s: sent, and not done", what) << kind << true << int(Fate::LostBefore);
    }
  }
  void whatAKilledProgramHadNotSavedCanBeRestored() {
    QFETCH(QString, what);
    QFETCH(bool, sent);
    QFETCH(int, fate);
    const std::unique_ptr<Editor> editor = editorOf(what);
    editor->start();
    QTRY_VERIFY(editor->isOpen());
    editor->change();
    QTRY_COMPARE(editor->draftFiles().size(), 1);
    if (sent) {
      editor->save(Fate(fate));
      QTRY_COMPARE(editor->fate, Fate::Done);  // it has reached the robot
    }
    editor->kill();
    const bool held = editor->holdsMine();
    editor->openWindow();
    QTRY_VERIFY(editor->isOpen());
    if (!held) QTRY_VERIFY(!editor->control().offerText().isEmpty());
    editor->control().edited()->restoreDraft(QStringLiteral("restore"));
    QCOMPARE(editor->control().unsaved(), !held);
    if (held) return;
    editor->save(Fate::Done);
    QTRY_VERIFY2(editor->holdsMine() && !editor->control().unsaved(), qPrintable(editor->said()));
  }

  void whatIsBeingSentCannotBeDiscarded_data() {
    QTest::addColumn<QString>("what");
    for (const char* what : {"waypoints", "overlays", "picture"})
      QTest::addRow("%s", what) << QString::fromLatin1(what);
  }
  void whatIsBeingSentCannotBeDiscarded() {
    QFETCH(QString, what);
    const std::unique_ptr<Editor> editor = editorOf(what);
    editor->start();
    QTRY_VERIFY(editor->isOpen());
    editor->change();
    editor->save(Fate::Done);
    QVERIFY(editor->control().edited()->saving());
    editor->window->close();
    QVERIFY(editor->control().question());
    editor->control().question()->button(QMessageBox::Discard)->click();
    QVERIFY2(editor->said().contains(QLatin1String("being saved")), qPrintable(editor->said()));
    QTRY_VERIFY(!editor->control().edited()->saving());
    QVERIFY(editor->holdsMine() && !editor->control().unsaved());
    QVERIFY(editor->window->isVisible());
    editor->window->close();
    QTRY_VERIFY(!editor->window->isVisible());
  }
};

}  // namespace test_edit_faults

MAPWRIGHT_TEST(test_edit_faults, EditFaultsTest, Widgets)
#include "test_edit_faults.moc"
