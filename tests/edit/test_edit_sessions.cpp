// What can go wrong while something that is open for editing is saved: the same faults for waypoints,
// overlays and pictures, and what each session says of itself after them.
#include <numbers>

#include <QTimer>
#include <QtTest>

#include "edit/open_waypoints.h"
#include "edit/overlays/overlay_session.h"
#include "edit/picture/picture_session.h"
#include "fake_waypoint_store.h"
#include "test_program.h"

namespace test_edit_sessions {

using namespace mapwright;
using namespace mapwright::edit;

namespace {

/// What becomes of one change on its way to the store.
enum class Fate {
  Done,
  Refused,     // the store says no
  NotSent,     // the link is gone before
  LostBefore,  // no answer, and it was not done
  LostAfter,   // no answer, and it was done
  Overtaken,   // others change something else just before
};

std::optional<map::Failure> failureOf(Fate fate) {
  map::Failure failure{.kind = map::FailureKind::Unreachable, .asked_for = map::AskedFor::Change};
  switch (fate) {
    case Fate::Refused:
      failure.kind = map::FailureKind::RejectedByRobot;
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
const QString kAddress = QStringLiteral("http://robot");

/// A session on a store of its own, whose next change has a fate.
class Desk {
 public:
  virtual ~Desk() = default;
  virtual EditSession& session() = 0;
  virtual void change() = 0;
  virtual void save(Fate fate) = 0;
  /// Others change something else.
  virtual void changeTheirs() = 0;
  virtual bool holdsMine() const = 0;
  virtual bool holdsTheirs() const = 0;
  /// Reads again, as the window does when the robot is back.
  virtual void read() = 0;
};

class WaypointsDesk : public Desk {
 public:
  WaypointsDesk() {
    store_.points = {test::waypoint("a", 1, 1, "Dock"), test::waypoint("b", 3, 2, "Kitchen")};
    open_ = std::make_unique<OpenWaypoints>(store_, kMap, kAddress, EditOptions());
  }
  EditSession& session() override { return *open_; }
  void change() override {
    map::Waypoint point = *open_->document().find("a");
    point.name = "Dock 7";
    open_->document().change({open_->document().to("a", point)}, QStringLiteral("rename"));
  }
  void save(Fate fate) override {
    if (fate == Fate::Overtaken) changeTheirs();
    if (const auto failure = failureOf(fate)) store_.failures.push_back(*failure);
    store_.does_what_fails = happens(fate);
    open_->save();
  }
  void changeTheirs() override { store_.put(test::waypoint("b", 3, 2, "Canteen")); }
  bool holdsMine() const override { return store_.find("Dock 7") != nullptr; }
  bool holdsTheirs() const override { return store_.find("Canteen") != nullptr; }
  void read() override { open_->read(); }

 private:
  test::FakeWaypointStore store_{test::FakeWaypointStore::Mode::OneByOne};
  std::unique_ptr<OpenWaypoints> open_;
};

class OverlaysDesk : public Desk, public robot::OverlayStore {
 public:
  OverlaysDesk() {
    session_ = std::make_unique<OverlaySession>(
        [this] { return this; }, OverlaySession::Target{kMap, true, {}}, kAddress, editing_, EditOptions());
    session_->read();
  }
  EditSession& session() override { return *session_; }
  void change() override {
    editing_.select({0});
    editing_.changeSelected(QStringLiteral("move"), [](const overlays::Feature& feature) {
      return overlays::movedBy(feature, {1, 0});
    });
  }
  void save(Fate fate) override {
    if (fate == Fate::Overtaken) changeTheirs();
    fate_ = fate;
    session_->send(false);
  }
  void changeTheirs() override {
    text_.insert(
        text_.rfind(']'),
        R"(,{"id":"p9","type":"Feature","geometry":{"type":"Point","coordinates":[9,9]},"properties":{"name":"theirs"}})");
    ++version_;
  }
  bool holdsMine() const override { return text_.find("[3") != std::string::npos; }
  bool holdsTheirs() const override { return text_.find("theirs") != std::string::npos; }
  void read() override { session_->read(); }
  int answered() const { return answered_; }
  void close() { session_.reset(); }
  OverlayEditing& editing() { return editing_; }
  OverlaySession& overlays() { return *session_; }
  /// The next answer about what is held is on its way until it is let go.
  void holdNextAnswer() { holds_next_ = true; }
  void letGo() { std::exchange(held_back_, nullptr)(); }

  robot::Call read(const map::MapKey&, robot::OutcomeTo<robot::OverlayText> reply) override {
    if (std::exchange(holds_next_, false)) {
      held_back_ = [reply, now = answer()] { reply(now); };
      return {};
    }
    QTimer::singleShot(0, &timers_, [this, reply] {
      ++answered_;
      reply(answer());
    });
    return {};
  }
  robot::Call write(const map::MapKey&, const std::string& text,
                    robot::OutcomeTo<std::monostate> reply) override {
    if (happens(fate_)) {
      text_ = text;
      ++version_;
    }
    QTimer::singleShot(0, &timers_, [fate = fate_, reply] {
      if (const auto failure = failureOf(fate)) return reply(tl::make_unexpected(*failure));
      reply(std::monostate());
    });
    return {};
  }

 private:
  robot::OverlayText answer() const {
    return {.text = text_, .version = version_, .map_uid = "u", .map_name = "Hall"};
  }

  std::string text_ =
      R"({"type":"FeatureCollection","features":[{"id":"p1","type":"Feature","geometry":{"type":"Point","coordinates":[2,1]},"properties":{"type":"25","name":"Desk"}}]})";
  int version_ = 1, answered_ = 0;
  bool holds_next_ = false;
  std::function<void()> held_back_;
  Fate fate_ = Fate::Done;
  OverlayEditing editing_;
  std::unique_ptr<OverlaySession> session_;
  QObject timers_;  // last: nothing is answered after the session
};

std::string boxOf(const overlays::Feature& feature) {
  const auto box = feature.root().member("bbox");
  return box ? std::string(box->text()) : std::string();
}

class PictureDesk : public Desk {
 public:
  PictureDesk() {
    session_ = std::make_unique<PictureSession>([this] { return &store_; }, kMap, kAddress, picture(),
                                                editing_, EditOptions());
    QObject::connect(&store_, &robot::PictureStore::changed, session_.get(), [this] { read(); });
  }
  EditSession& session() override { return *session_; }
  void change() override {
    editing_.setKind(picture::Kind::Occupied);
    editing_.drawRectangle({40, 30, 44, 34});
  }
  void save(Fate fate) override {
    store_.fate = fate;
    session_->send({});
  }
  void changeTheirs() override {
    put([](int x, int y) { return x == 70 && y == 50; });
  }
  bool holdsMine() const override { return cells_->at(41, 31) == kBlack; }
  bool holdsTheirs() const override { return cells_->at(70, 50) == kBlack; }
  void read() override { session_->onRead(picture()); }

 private:
  static constexpr std::uint8_t kBlack = 0;
  class Store : public robot::PictureStore {
   public:
    explicit Store(PictureDesk* of) : of_(of) {}
    std::optional<robot::PictureObstacle> obstacle(const map::WholeMap&) const override { return {}; }
    bool holdsUnknown(const map::WholeMap&) const override { return true; }
    robot::Call write(const robot::PictureChange& change,
                      robot::OutcomeTo<robot::PictureReceipt> reply) override {
      if (fate == Fate::Overtaken) of_->changeTheirs();
      const Fate now = std::exchange(fate, Fate::Done);
      const bool conflict = change.revision != std::to_string(of_->revision_);
      if (!conflict && happens(now)) of_->put([&](int x, int y) { return change.cells->at(x, y) == kBlack; });
      QTimer::singleShot(0, this, [this, now, conflict, map = change.map, reply] {
        if (conflict) {
          reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Conflict,
                                                 .applied = map::Applied::No,
                                                 .asked_for = map::AskedFor::Change}));
        } else if (const auto failure = failureOf(now)) {
          reply(tl::make_unexpected(*failure));
        } else {
          reply(robot::PictureReceipt{std::to_string(of_->revision_)});
        }
        if (conflict || !failureOf(now)) Q_EMIT changed(map);
      });
      return {};
    }
    Fate fate = Fate::Done;

   private:
    PictureDesk* of_;
  };
  static std::shared_ptr<const grids::GridPyramid> made(const std::function<bool(int, int)>& black) {
    const auto builder = grids::buildGrid(80, 60, grids::CellCode::Gray, grids::Reduction::OccupiedWins);
    std::vector<std::uint8_t> row(80);
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 80; ++x) row[std::size_t(x)] = black(x, y) ? kBlack : 254;
      builder->pushRow(row);
    }
    builder->finish();
    return builder->pyramid();
  }
  /// Black where `black` says so, and where it was.
  void put(const std::function<bool(int, int)>& black) {
    cells_ = made([&](int x, int y) { return cells_->at(x, y) == kBlack || black(x, y); });
    ++revision_;
  }
  PictureSession::Picture picture() const {
    map::GridReference place;
    place.width = 80;
    place.height = 60;
    place.resolution_m = 0.05;
    return {cells_, place, std::to_string(revision_), true};
  }

  std::shared_ptr<const grids::GridPyramid> cells_ = made([](int, int) { return false; });
  int revision_ = 1;
  Store store_{this};
  PictureEditing editing_{std::make_shared<work::Workers>()};
  std::unique_ptr<PictureSession> session_;
};

std::unique_ptr<Desk> deskOf(const QString& what) {
  if (what == QLatin1String("waypoints")) return std::make_unique<WaypointsDesk>();
  if (what == QLatin1String("overlays")) return std::make_unique<OverlaysDesk>();
  return std::make_unique<PictureDesk>();
}

}  // namespace

class EditSessionsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theBoxOfAnOverlayFollowsIt() {
    const auto feature = [](const char* box) {
      return R"({"id":"a","type":"Feature","bbox":)" + std::string(box) +
             R"(,"geometry":{"type":"LineString","coordinates":[[2,1],[4,3]]},"properties":{}})";
    };
    OverlayEditing editing;
    const auto open = [&](const char* box) {
      editing.open(*overlays::OverlayDocument::read(R"({"type":"FeatureCollection","features":[)" +
                                                    feature(box) + "]}"));
      editing.select({0});
    };
    const auto move = [&] {
      editing.changeSelected(QStringLiteral("move"), [](const overlays::Feature& one) {
        return overlays::movedBy(one, {1, 0});
      });
    };
    open("[2,1,4,3]");
    move();
    QCOMPARE(boxOf(*editing.find(0)), std::string("[3,1,5,3]"));
    editing.undoStack().undo();
    QCOMPARE(editing.find(0)->text(), feature("[2,1,4,3]"));
    editing.set(0, overlays::withVertexAt(*editing.find(0), {0, 1}, {6, 2}), QStringLiteral("reshape"));
    QCOMPARE(boxOf(*editing.find(0)), std::string("[2,1,6,2]"));
    editing.duplicateSelected();
    QCOMPARE(boxOf(*editing.find(1)), std::string("[2.5,0.5,6.5,1.5]"));
    // What did not fit goes; what has not moved keeps whatever it has.
    open("[0,0,1,1]");
    editing.set(0, overlays::withProperty(*editing.find(0), "name", "\"A\""), QStringLiteral("name"));
    QCOMPARE(boxOf(*editing.find(0)), std::string("[0,0,1,1]"));
    move();
    QCOMPARE(boxOf(*editing.find(0)), std::string());
  }

  void theBoxesOfACollectionOfGeometriesTurnWithIt() {
    OverlayEditing editing;
    editing.open(*overlays::OverlayDocument::read(
        R"({"type":"FeatureCollection","bbox":[0,0,4,2],"features":[{"id":"a","type":"Feature",)"
        R"("bbox":[0,0,4,2],"geometry":{"type":"GeometryCollection","bbox":[0,0,4,2],"geometries":[)"
        R"({"type":"Point","bbox":[4,2,4,2],"coordinates":[4,2]},)"
        R"({"type":"GeometryCollection","bbox":[0,0,3,1],"geometries":[)"
        R"({"type":"LineString","bbox":[0,0,3,1],"coordinates":[[0,0],[3,1]]}]}]},"properties":{}}]})"));
    editing.select({0});
    editing.changeSelected(QStringLiteral("turn"), [](const overlays::Feature& one) {
      return overlays::turnedAbout(one, {0, 0}, std::numbers::pi / 2);
    });
    const std::string now = editing.document().mine().text();
    const auto count = [&](const std::string& box) {
      int found = 0;
      for (auto at = now.find(box); at != std::string::npos; at = now.find(box, at + 1)) ++found;
      return found;
    };
    QVERIFY2(count("\"bbox\":[-2,0,0,4]") == 3 && count("\"bbox\":[-2,4,-2,4]") == 1 &&
                 count("\"bbox\":[-1,0,0,3]") == 2,
             now.c_str());
  }

  void nothingIsSentOfWhatIsClosedWhileItIsMerged() {
    OverlaysDesk desk;
    QTRY_COMPARE(desk.session().phase(), EditSession::Phase::Ready);
    desk.change();
    desk.save(Fate::Done);
    const int before = desk.answered();
    while (desk.answered() == before) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    desk.close();  // another thread merges
    QCoreApplication::processEvents();
    QVERIFY(!desk.holdsMine());
  }

  void anAnswerFromBeforeASaveIsNoNews() {
    OverlaysDesk desk;
    QTRY_COMPARE(desk.session().phase(), EditSession::Phase::Ready);
    desk.holdNextAnswer();
    desk.read();
    desk.change();
    QSignalSpy theirs(&desk.overlays(), &OverlaySession::changedThere);
    desk.save(Fate::Done);
    QTRY_VERIFY(!desk.session().saving());
    const std::string saved = desk.editing().document().mine().text();
    desk.letGo();
    QVERIFY(desk.holdsMine() && !desk.session().unsaved() && !desk.overlays().reading());
    QCOMPARE(desk.editing().document().mine().text(), saved);
    QVERIFY(theirs.isEmpty());
    desk.read();
    QTRY_VERIFY(!desk.overlays().reading());
    QCOMPARE(desk.editing().document().mine().text(), saved);
  }

  void whatIsUndoneWhileItIsSentIsToBeSavedAgain() {
    OverlaysDesk desk;
    QTRY_COMPARE(desk.session().phase(), EditSession::Phase::Ready);
    desk.change();
    const std::string once = desk.editing().document().mine().text();
    desk.change();
    QSignalSpy theirs(&desk.overlays(), &OverlaySession::changedThere);
    desk.save(Fate::Done);
    desk.editing().undoStack().undo();
    QTRY_VERIFY(!desk.session().saving());
    QVERIFY(!desk.session().inConflict() && theirs.isEmpty());
    QVERIFY(desk.session().unsaved());
    QCOMPARE(desk.editing().document().mine().text(), once);
    desk.editing().undoStack().redo();
    QVERIFY(!desk.session().unsaved());
  }

  void whatIsNotStoredIsUnsaved_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("fate");
    const std::pair<const char*, Fate> fates[] = {{"done", Fate::Done},
                                                  {"refused", Fate::Refused},
                                                  {"not sent", Fate::NotSent},
                                                  {"lost, not done", Fate::LostBefore},
                                                  {"lost, done", Fate::LostAfter},
                                                  {"overtaken", Fate::Overtaken}};
    for (const char* what : {"waypoints", "overlays", "picture"}) {
      for (const auto& [name, fate] : fates)
        QTest::addRow("%s: %s", what, name) << QString::fromLatin1(what) << int(fate);
    }
  }
  void whatIsNotStoredIsUnsaved() {
    QFETCH(QString, what);
    QFETCH(int, fate);
    const auto desk = deskOf(what);
    EditSession& session = desk->session();
    QTRY_COMPARE(session.phase(), EditSession::Phase::Ready);
    QVERIFY(!session.unsaved());
    desk->change();
    QVERIFY(session.unsaved() && !session.inDoubt());
    QSignalSpy saved(&session, &EditSession::saved);
    desk->save(Fate(fate));
    QVERIFY(session.saving());
    QTRY_VERIFY(!session.saving());
    if (failureOf(Fate(fate)) && failureOf(Fate(fate))->applied == map::Applied::Maybe) desk->read();
    QTRY_COMPARE(desk->holdsMine(), happens(Fate(fate)));
    QTRY_COMPARE(session.unsaved(), !desk->holdsMine());
    QTRY_VERIFY(!session.inConflict());
    if (Fate(fate) == Fate::Overtaken) QVERIFY(desk->holdsTheirs());
    if (desk->holdsMine()) return;
    QVERIFY(saved.isEmpty());
    desk->save(Fate::Done);
    QTRY_VERIFY(desk->holdsMine() && !session.unsaved());
  }
};

}  // namespace test_edit_sessions

MAPWRIGHT_TEST(test_edit_sessions, EditSessionsTest, Core)
#include "test_edit_sessions.moc"
