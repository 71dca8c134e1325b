// Names that are exchanged, broken off anywhere and gone on with: in the end everything is called as wanted,
// and a temporary name that stays on the robot is told.
#include <algorithm>
#include <random>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include "../edit/fake_waypoint_store.h"
#include "app/waypoint_sending.h"
#include "exchange/waypoint_plan.h"
#include "exchange/waypoint_steps.h"
#include "robot/ros/kabam_plan.h"
#include "test_program.h"

namespace test_name_swaps {

using namespace mapwright;
using test::FakeWaypointStore;
using test::waypoint;

namespace {

/// How a call breaks off.
enum class Break { Refused, CutBefore, LostAndDone, LostAndNotDone };
constexpr Break kBreaks[] = {Break::Refused, Break::CutBefore, Break::LostAndDone, Break::LostAndNotDone};

/// Plans like a map manager of KABAM, and has every name once.
class ManagerStore : public FakeWaypointStore {
 public:
  ManagerStore() : FakeWaypointStore(Mode::OneByOne) {
    is_called = true;
    before_performing = [this] { meet(); };
  }
  std::vector<robot::WaypointRequest> plan(const robot::StoredWaypoints& now,
                                           const std::vector<robot::WaypointChange>& changes) const override {
    return robot::ros::planWaypoints(now, changes);
  }
  robot::WaypointCall callOf(const map::MapKey&, const robot::WaypointRequest& request) const override {
    const auto& change = request.changes.front();
    const auto& point = change.after ? *change.after : *change.before;
    return {robot::ros::nameOf(robot::ros::serviceOf(change)), change.id + " " + point.name};
  }
  /// The call of that number, counted from 1, does.
  void breakAt(std::size_t call, Break how) {
    break_at_ = asked.size() + call;
    how_ = how;
  }
  void mend() {
    break_at_ = 0;
    unreadable = false;
    failures.clear();
    does_what_fails = true;
  }
  bool broke = false, name_twice = false;
  /// What cannot be read stays so until mend().
  bool stays_away = false;
  /// Before the call of that number.
  std::function<void(std::size_t)> others;

 private:
  void meet() {
    if (others) others(asked.size());
    const auto& change = asked.back().changes.front();
    const bool taken = change.after && std::any_of(points.begin(), points.end(), [&](const auto& one) {
                         return one.id != change.id && one.name == change.after->name;
                       });
    if (taken) {
      name_twice = true;
      failures = {failure(map::FailureKind::RejectedByRobot, map::Applied::No)};
    }
    if (asked.size() != break_at_) return;
    broke = true;
    does_what_fails = how_ == Break::LostAndDone;
    unreadable = stays_away && how_ != Break::Refused;
    failures = {how_ == Break::Refused     ? failure(map::FailureKind::RejectedByRobot, map::Applied::No)
                : how_ == Break::CutBefore ? failure(map::FailureKind::Unreachable, map::Applied::No)
                                           : failure(map::FailureKind::Unreachable, map::Applied::Maybe)};
  }
  static map::Failure failure(map::FailureKind kind, map::Applied applied) {
    map::Failure failure;
    failure.kind = kind;
    failure.applied = applied;
    return failure;
  }
  std::size_t break_at_ = 0;
  Break how_ = Break::Refused;
};

/// What is there, and what it is to be.
struct Trial {
  std::vector<map::Waypoint> points, wanted;
  std::size_t calls = 0;
  QString told;

  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto* all : {&points, &wanted}) {
      for (const map::Waypoint& point : *all) names.insert(point.name);
    }
    return names;
  }
  std::vector<exchange::WaypointEdit> edits() const {
    std::vector<exchange::WaypointEdit> edits;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!(points[i] == wanted[i])) edits.push_back({points[i].id, points[i], wanted[i]});
    return edits;
  }
};

/// Rings and chains: the names go round among some, others get new ones, some move besides.
Trial trialOf(std::mt19937& dice) {
  const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(dice); };
  Trial trial;
  const int count = 2 + upTo(5);
  for (int i = 0; i < count; ++i)
    trial.points.push_back(waypoint(std::to_string(i), i, i, "name " + std::to_string(i)));
  std::vector<std::size_t> order(trial.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), dice);
  trial.wanted = trial.points;
  const std::size_t round = 2 + std::size_t(upTo(count - 2));
  const bool is_chain = upTo(3) == 0;
  for (std::size_t i = 0; i < round; ++i)
    trial.wanted[order[i]].name = trial.points[order[(i + 1) % round]].name;
  if (is_chain) trial.wanted[order[round - 1]].name = "new";
  for (map::Waypoint& point : trial.wanted) {
    if (upTo(3) == 0) point.position_m.x() += 10;
    if (upTo(4) == 0) point.yaw_rad = 0.5;
    if (upTo(4) == 0) point.tags = {"tag"};
  }
  std::vector<robot::WaypointChange> changes;
  for (const auto& edit : trial.edits()) changes.push_back({edit.key, edit.before, edit.after});
  trial.calls = robot::ros::planWaypoints({trial.points, {}, {}}, changes).size();
  for (std::size_t i = 0; i < trial.points.size(); ++i)
    trial.told += QStringLiteral("%1>%2 ").arg(QString::fromStdString(trial.points[i].name),
                                               QString::fromStdString(trial.wanted[i].name));
  return trial;
}

exchange::WantedWaypoint wantedRow(const map::Waypoint& point) {
  exchange::WantedWaypoint row;
  row.id = point.id;
  row.name = point.name;
  row.position_m = point.position_m;
  row.yaw_rad = point.yaw_rad;
  row.tags = point.tags;
  return row;
}

const map::MapKey kMap{map::MapKind::Stored, "1"};
const QString kAddress = QStringLiteral("kabam+ws://192.0.2.7");

}  // namespace

class NameSwapsTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>();
  std::unique_ptr<app::RobotReading> reading_;

  app::ListedWaypoints listed(ManagerStore& store) {
    return {reading_.get(), kMap, {store.points, {}, {}}, &store};
  }
  static QByteArray planOf(const Trial& trial) {
    return exchange::planBytes({kAddress, "1", exchange::itemsOf(trial.points), trial.edits()}, {});
  }
  app::SentWaypoints apply(ManagerStore& store, const QByteArray& bytes, app::AtFailure at_failure) {
    const auto plan = exchange::planFromBytes(bytes.toStdString());
    auto sent = app::sendWaypoints(
        listed(store), exchange::withoutCreated(*plan, exchange::itemsOf(store.points)), at_failure);
    return sent ? *sent : app::SentWaypoints{};
  }
  static bool isAsWanted(const ManagerStore& store, const Trial& trial) {
    return std::all_of(trial.wanted.begin(), trial.wanted.end(), [&](const map::Waypoint& point) {
      const auto kept = std::find_if(store.points.begin(), store.points.end(),
                                     [&](const auto& one) { return one.id == point.id; });
      return kept != store.points.end() && edit::difference(*kept, point) == 0;
    });
  }
  /// Of all names that are neither the old nor the new ones the sentence and the JSON tell.
  static QString untold(const ManagerStore& store, const Trial& trial, const app::SentWaypoints& sent) {
    const QJsonArray told = app::sentJson(sent, "1")[QStringLiteral("temporary_names")].toArray();
    for (const map::Waypoint& point : store.points) {
      if (trial.names().contains(point.name)) continue;
      const QString name = QString::fromStdString(point.name);
      const bool in_json = std::any_of(told.begin(), told.end(), [&](const QJsonValue& row) {
        return row[QStringLiteral("name")].toString() == name &&
               row[QStringLiteral("id")].toString().toStdString() == point.id;
      });
      if (!in_json || !sent.sentence().contains(name)) return name;
    }
    return {};
  }
  std::unique_ptr<edit::OpenWaypoints> window(ManagerStore& store, const QString& drafts) {
    edit::EditOptions options;
    options.drafts_folder = drafts;
    options.workers = workers_;
    auto list = std::make_unique<edit::OpenWaypoints>(store, kMap, kAddress, options);
    return reading_->waitUntil([&] { return list->phase() == edit::OpenWaypoints::Phase::Ready; }, 30)
               ? std::move(list)
               : nullptr;
  }
  static void edited(edit::OpenWaypoints& list, const Trial& trial) {
    std::vector<edit::Change> changes;
    for (const map::Waypoint& point : trial.wanted) changes.push_back(list.document().to(point.id, point));
    list.document().change(std::move(changes), QStringLiteral("names"));
  }
  bool send(edit::OpenWaypoints& list) {
    list.send(list.planned(), edit::AtFailure::Stop);
    return reading_->waitUntil([&] { return !list.saving(); }, 30);
  }

 private Q_SLOTS:
  void initTestCase() {
    QFile picture(folder_.filePath(QStringLiteral("map.pgm")));
    QVERIFY(picture.open(QIODevice::WriteOnly));
    QCOMPARE(picture.write("P5\n1 1\n255\n\xfe"), 12);
    picture.close();
    auto opened = app::RobotReading::open(picture.fileName(), {}, {app::commandStart(600, 0), 600},
                                          app::RobotReading::Purpose::Maps, workers_);
    QVERIFY(opened);
    reading_ = std::move(*opened);
  }

  void whatBrokeOffIsToldAndGoneOnWith_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 12; ++seed) QTest::addRow("%d", seed) << seed;
  }
  void whatBrokeOffIsToldAndGoneOnWith() {
    QFETCH(int, seed);
    std::mt19937 dice{std::mt19937::result_type(seed)};
    const Trial trial = trialOf(dice);
    enum class Continuation { SamePlan, NewPlan, SendTheRest, AnotherWindow };
    for (std::size_t call = 1; call <= trial.calls; ++call) {
      for (const Break how : kBreaks) {
        for (const Continuation continuation : {Continuation::SamePlan, Continuation::NewPlan,
                                                Continuation::SendTheRest, Continuation::AnotherWindow}) {
          // A window takes long: one call of each trial is enough for it.
          if (continuation >= Continuation::SendTheRest && call != 1 + std::size_t(seed) % trial.calls)
            continue;
          const QByteArray where = QStringLiteral("%1 call %2 break %3 continuation %4")
                                       .arg(trial.told)
                                       .arg(call)
                                       .arg(int(how))
                                       .arg(int(continuation))
                                       .toUtf8();
          ManagerStore store;
          store.points = trial.points;
          store.breakAt(call, how);
          const bool by_command =
              continuation == Continuation::SamePlan || continuation == Continuation::NewPlan;
          QTemporaryDir drafts;
          std::unique_ptr<edit::OpenWaypoints> list;
          if (by_command) {
            const auto at_failure = seed % 2 ? app::AtFailure::Stop : app::AtFailure::GoOn;
            const app::SentWaypoints sent = apply(store, planOf(trial), at_failure);
            QVERIFY2(untold(store, trial, sent).isEmpty(), where + " " + sent.sentence().toUtf8());
          } else {
            list = window(store, drafts.path());
            QVERIFY2(list, where);
            edited(*list, trial);
            QVERIFY2(send(*list), where);
          }
          QVERIFY2(store.broke, where);
          store.mend();
          if (continuation == Continuation::SamePlan) {
            const app::SentWaypoints sent = apply(store, planOf(trial), app::AtFailure::Stop);
            QVERIFY2(sent.complete(), where + " " + sent.sentence().toUtf8());
            QVERIFY2(sent.left_names.empty(), where);
          } else if (continuation == Continuation::NewPlan) {
            std::vector<exchange::WantedWaypoint> rows;
            for (const map::Waypoint& point : trial.wanted) rows.push_back(wantedRow(point));
            const auto edits =
                exchange::editsFor(exchange::itemsOf(store.points), rows, exchange::Others::Go);
            QVERIFY2(edits, where);
            const auto sent = app::sendWaypoints(listed(store), *edits, app::AtFailure::Stop);
            QVERIFY2(sent && sent->complete(),
                     where + " " + (sent ? sent->sentence().toUtf8() : QByteArray()));
          } else if (continuation == Continuation::SendTheRest) {
            list->read();
            QVERIFY2(send(*list), where);
            QVERIFY2(!list->unsaved() && list->document().conflicts().empty(), where);
          } else {
            list.reset();
            list = window(store, drafts.path());
            QVERIFY2(list, where);
            QVERIFY2(
                reading_->waitUntil(
                    [&] { return list->drafts()->offered() != nullptr || isAsWanted(store, trial); }, 30),
                where);
            list->restoreDraft(QStringLiteral("take up"));
            QVERIFY2(list->document().conflicts().empty(), where);
            QVERIFY2(send(*list), where);
            QVERIFY2(!list->unsaved(), where);
          }
          QVERIFY2(!store.name_twice, where);
          QVERIFY2(isAsWanted(store, trial), where);
        }
      }
    }
  }

  // The link is gone until after the command has ended: what may be is told as such.
  void whatNobodyCouldLookAtMayHaveATemporaryName() {
    for (std::size_t call = 1; call <= 3; ++call) {
      for (const Break how : {Break::LostAndDone, Break::LostAndNotDone}) {
        Trial trial;
        trial.points = {waypoint("1", 0, 0, "alfa"), waypoint("2", 1, 1, "bravo")};
        trial.wanted = {waypoint("1", 0, 0, "bravo"), waypoint("2", 1, 1, "alfa")};
        ManagerStore store;
        store.points = trial.points;
        store.stays_away = true;
        store.breakAt(call, how);
        const app::SentWaypoints sent = apply(store, planOf(trial), app::AtFailure::Stop);
        QVERIFY(store.broke);
        QCOMPARE(untold(store, trial, sent), QString());
        QCOMPARE(sent.left_names.size(), std::size_t(1));
        QCOMPARE(sent.left_names.front().name, std::string("alfa ~1"));
        QVERIFY(!sent.left_names.front().certain);
        QVERIFY2(sent.sentence().contains(QStringLiteral("\"alfa\" may temporarily be called \"alfa ~1\"")),
                 qPrintable(sent.sentence()));
        store.mend();
        QVERIFY(apply(store, planOf(trial), app::AtFailure::Stop).complete());
        QVERIFY(isAsWanted(store, trial));
      }
    }
  }

  // Broken off again and again: not one name stays.
  void everyCallMayBreakOffOnce() {
    Trial trial;
    trial.points = {waypoint("1", 0, 0, "alfa"), waypoint("2", 1, 1, "bravo"),
                    waypoint("3", 2, 2, "charlie")};
    trial.wanted = {waypoint("1", 0, 0, "bravo"), waypoint("2", 1, 1, "charlie"),
                    waypoint("3", 2, 2, "alfa")};
    for (const Break how : kBreaks) {
      ManagerStore store;
      store.points = trial.points;
      bool complete = false;
      for (int attempt = 0; attempt < 12 && !complete; ++attempt) {
        store.mend();
        store.breakAt(attempt % 3 == 2 ? 1 : 2, how);
        const app::SentWaypoints sent = apply(store, planOf(trial), app::AtFailure::Stop);
        QCOMPARE(untold(store, trial, sent), QString());
        complete = sent.complete();
      }
      QVERIFY(complete);
      QVERIFY(isAsWanted(store, trial));
    }
  }

  // Somebody else comes between: what he does is a conflict, and the temporary name is told all the same.
  void whatOthersDoInTheMiddleDoesNotHideIt() {
    Trial trial;
    trial.points = {waypoint("1", 0, 0, "alfa"), waypoint("2", 1, 1, "bravo")};
    trial.wanted = {waypoint("1", 0, 0, "bravo"), waypoint("2", 1, 1, "alfa")};
    for (const bool can_look : {true, false}) {
      ManagerStore store;
      store.points = trial.points;
      store.others = [&](std::size_t call) {
        if (call != 2) return;
        store.put(waypoint("2", 1, 1, "golf"));
        store.failures = {map::Failure{map::FailureKind::Conflict}};
        store.readable = store.reads + (can_look ? 1000 : 1);
      };
      const app::SentWaypoints sent = apply(store, planOf(trial), app::AtFailure::Stop);
      QCOMPARE(sent.conflicts.size(), std::size_t(1));
      QCOMPARE(sent.count(app::StepState::Applied), std::size_t(0));
      QCOMPARE(sent.left_names.size(), std::size_t(1));
      QCOMPARE(sent.left_names.front().name, std::string("alfa ~1"));
      QVERIFY2(sent.sentence().contains(QStringLiteral("alfa ~1")), qPrintable(sent.sentence()));
    }
  }

  void aNameThatSomebodyElseGaveIsStillAConflict() {
    Trial trial;
    trial.points = {waypoint("1", 0, 0, "alfa"), waypoint("2", 1, 1, "bravo")};
    trial.wanted = {waypoint("1", 0, 0, "bravo"), waypoint("2", 1, 1, "alfa")};
    for (const char* theirs : {"golf", "alfa ~", "alfa 1", "~1", "bravo ~1", "alfa ~x"}) {
      ManagerStore store;
      store.points = trial.points;
      store.points.front().name = theirs;
      const app::SentWaypoints sent = apply(store, planOf(trial), app::AtFailure::Stop);
      QCOMPARE(sent.conflicts.size(), std::size_t(1));
      QVERIFY(store.asked.empty());
    }
  }

  void temporaryNamesAreFound() {
    const auto found = exchange::temporaryNamesIn(exchange::itemsOf(
        {waypoint("1", 0, 0, "alfa ~1"), waypoint("2", 0, 0, "alfa"), waypoint("3", 0, 0, "golf ~2 ~1"),
         waypoint("4", 0, 0, "golf ~3"), waypoint("5", 0, 0, "~1"), waypoint("6", 0, 0, " ~1"),
         waypoint("7", 0, 0, "a~1")}));
    QCOMPARE(found.size(), std::size_t(3));
    QCOMPARE(found[0].permanent, std::string("alfa"));
    QVERIFY(!found[0].is_free);
    QCOMPARE(found[1].permanent, std::string("golf"));
    QVERIFY(found[1].is_free && !found[2].is_free);
  }
};

}  // namespace test_name_swaps

MAPWRIGHT_TEST(test_name_swaps, NameSwapsTest, Widgets)
#include "test_name_swaps.moc"
