// Changing the overlays of a map on a robot: what is sent, and what is said when others change them, too.
#include <deque>
#include <thread>

#include <QtTest>

#include "jobs/change_overlays.h"
#include "test_program.h"

namespace test_change_overlays {

using namespace mapwright;
using overlays::OverlayDocument;
using robot::Outcome;
using robot::OverlayText;

namespace {

OverlayDocument document(const std::string& text) { return *OverlayDocument::read(text); }

std::string features(const std::string& list) { return R"({"features":[)" + list + "]}"; }

const std::string kWall = R"({"id":"w","geometry":{"type":"LineString","coordinates":[[0,0],[1,1.50]]}})";
const std::string kPoint = R"({"id":"p","properties":{"name":"A"}})";

/// Holds one text, and does with a change what the test wants.
class Store : public robot::OverlayStore {
 public:
  robot::Call read(const map::MapKey&, robot::OutcomeTo<OverlayText> reply) override {
    ++reads;
    reply(held);
    return {};
  }
  robot::Call write(const map::MapKey&, const std::string& text,
                    robot::OutcomeTo<std::monostate> reply) override {
    sent.push_back(text);
    auto kept = stores(text);
    if (!kept) return reply(robot::fail(kept.error())), robot::Call();
    held = *kept;
    reply(std::monostate());
    return {};
  }

  OverlayText held{features(kWall), 5, "uid", "Hall"};
  std::function<Outcome<OverlayText>(const std::string&)> stores = [this](const std::string& text) {
    held.text = text;
    held.version = held.version.value_or(0) + 1;
    return held;
  };
  std::vector<std::string> sent;
  int reads = 0;
};

Outcome<jobs::OverlayOutcome> change(Store& store, const std::string& mine, const std::string& base,
                                     bool send = true) {
  std::optional<Outcome<jobs::OverlayOutcome>> outcome;
  jobs::OverlayOrder order{{map::MapKind::Stored, "1"}, document(mine), std::nullopt, send};
  if (!base.empty()) order.base = document(base);
  jobs::changeOverlays(store, std::move(order), [&](auto came) { outcome = std::move(came); });
  return std::move(*outcome);
}

using Between = jobs::OverlayOutcome::Between;

/// Another thread, which does one work after the other when the test says so.
class Elsewhere {
 public:
  jobs::OverlayOrder::Elsewhere asked() {
    return [this](std::function<std::function<void()>()> work) { works_.push_back(std::move(work)); };
  }
  bool idle() const { return works_.empty(); }
  void doNext() {
    const auto work = std::move(works_.front());
    works_.pop_front();
    std::function<void()> then;
    std::thread([&] { then = work(); }).join();
    then();
  }

 private:
  std::deque<std::function<std::function<void()>()>> works_;
};

}  // namespace

class TestChangeOverlays : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsMergedIsSentOnceAndReadBack() {
    Store store;
    store.held.text = features(kWall + " , " + kPoint);
    const auto outcome = change(store, features(R"({"id":"w","geometry":null})"), features(kWall));
    QVERIFY(outcome && outcome->sent && outcome->certain());
    QCOMPARE(store.sent, std::vector<std::string>{features(R"({"id":"w","geometry":null} , )" + kPoint)});
    QCOMPARE(outcome->held.version, std::optional(6));
    QCOMPARE(store.reads, 2);  // before and after
    QCOMPARE(outcome->merge.mine.size(), std::size_t(1));
    QCOMPARE(outcome->merge.theirs.size(), std::size_t(1));
  }

  void nothingIsSentForNothing() {
    Store store;
    const auto same = change(store, features(kWall), features(kWall));
    QVERIFY(same && !same->sent && same->certain());
    const auto dry = change(store, features(""), features(kWall), false);
    QVERIFY(dry && !dry->sent && dry->merge.mine.size() == 1);
    QVERIFY(store.sent.empty());
  }

  void aConflictSendsNothing() {
    Store store;
    store.held.text = features(R"({"id":"p","properties":{"name":"theirs"}})");
    const auto outcome =
        change(store, features(R"({"id":"p","properties":{"name":"mine"}})"), features(kPoint));
    QVERIFY(outcome && !outcome->sent);
    QCOMPARE(outcome->merge.conflicts.size(), std::size_t(1));
    QVERIFY(store.sent.empty());
  }

  void withoutABaseEverythingIsReplaced() {
    Store store;
    store.held.text = "no JSON";
    const auto outcome = change(store, features(kPoint), "");
    QVERIFY(outcome && outcome->sent && outcome->certain());
    QCOMPARE(store.sent, std::vector<std::string>{features(kPoint)});
    // But what cannot be read is not merged with.
    store.held.text = "no JSON";
    QVERIFY(!change(store, features(kPoint), features(kWall)));
    QCOMPARE(store.sent.size(), std::size_t(1));
  }

  void whoCameBetweenIsSeenByTheVersion() {
    Store store;
    store.stores = [&](const std::string& text) -> Outcome<OverlayText> {
      return OverlayText{text, 7, {}, {}};
    };
    const auto overwritten = change(store, features(kPoint), features(kWall));
    QVERIFY(overwritten && overwritten->between == Between::Somebody && overwritten->differs.empty());
    store.held = {features(kWall), 5, "uid", "Hall"};
    store.stores = [&](const std::string&) -> Outcome<OverlayText> {
      return OverlayText{features(kPoint + "," + kWall), 7, {}, {}};
    };
    const auto after = change(store, features(kPoint), features(kWall));
    QVERIFY(after && after->between == Between::Somebody && after->differs.size() == 1 && !after->certain());
  }

  void aRobotThatIgnoresItOrTellsNoVersionIsNotBelieved() {
    Store store;
    store.stores = [&](const std::string&) -> Outcome<OverlayText> { return store.held; };
    const auto ignored = change(store, features(kPoint), features(kWall));
    QVERIFY(ignored && ignored->between == Between::None && !ignored->differs.empty() && !ignored->certain());
    store.held.version.reset();
    store.stores = [&](const std::string& text) -> Outcome<OverlayText> {
      return OverlayText{text, {}, {}, {}};
    };
    const auto untold = change(store, features(kPoint), features(kWall));
    QVERIFY(untold && untold->between == Between::Unknown && untold->differs.empty() && !untold->certain());
  }

  void whatCannotBeReadAfterwardsIsNotCalledRefused() {
    Store store;
    store.stores = [&](const std::string& text) -> Outcome<OverlayText> {
      return OverlayText{text.substr(0, 20), 6, {}, {}};
    };
    const auto cut = change(store, features(kPoint), features(kWall));
    QVERIFY(cut && cut->sent && cut->unreadable.any() && !cut->certain());
    QCOMPARE(cut->held.version, std::optional(6));
  }

  void whatIsWorkedOutElsewhereComesToTheSame() {
    Store store;
    store.held.text = features(kWall + " , " + kPoint);
    Elsewhere elsewhere;
    std::optional<Outcome<jobs::OverlayOutcome>> outcome;
    const std::string moved = R"({"id":"w","geometry":null})";
    jobs::OverlayOrder order{
        {map::MapKind::Stored, "1"}, document(features(moved)), document(features(kWall))};
    order.elsewhere = elsewhere.asked();
    jobs::changeOverlays(store, order, [&](auto came) { outcome = std::move(came); });
    QVERIFY(store.sent.empty());
    elsewhere.doNext();
    QCOMPARE(store.sent, std::vector<std::string>{features(moved + " , " + kPoint)});
    QVERIFY(!outcome);
    elsewhere.doNext();
    QVERIFY(outcome && *outcome && elsewhere.idle());
    QVERIFY((*outcome)->certain());
    QCOMPARE((*outcome)->changes.size(), std::size_t(1));
    QCOMPARE((*outcome)->changes[0].id, "w");
  }

  void cancelledWhileItIsMergedNothingIsSent() {
    Store store;
    Elsewhere elsewhere;
    std::optional<Outcome<jobs::OverlayOutcome>> outcome;
    jobs::OverlayOrder order{
        {map::MapKind::Stored, "1"}, document(features(kPoint)), document(features(kWall))};
    order.elsewhere = elsewhere.asked();
    const robot::Call call =
        jobs::changeOverlays(store, order, [&](auto came) { outcome = std::move(came); });
    call.cancel();
    elsewhere.doNext();
    QVERIFY(store.sent.empty() && elsewhere.idle());
    QVERIFY(outcome && !*outcome);
    QCOMPARE(outcome->error().kind, map::FailureKind::Cancelled);
    QCOMPARE(outcome->error().applied, map::Applied::No);
    QVERIFY(call.over());
  }

  /// What the review of the window shows.
  void theChangesAreThoseToWhatTheRobotHolds() {
    Store store;
    store.held.text = features(kPoint + "," + kWall);  // another order, which is no change
    const std::string moved = R"({"id":"w","geometry":null})";
    const auto looked = change(store, features(moved + "," + kPoint), features(kWall + "," + kPoint), false);
    QVERIFY(looked && looked->merge.theirs.empty());
    QCOMPARE(looked->changes.size(), std::size_t(1));
    QCOMPARE(looked->changes[0].from, std::optional<std::size_t>(1));
  }

  void aVersionIsNotPutIntoAnotherMap() {
    Store store;
    std::optional<Outcome<jobs::OverlayOutcome>> outcome;
    jobs::OverlayOrder order{{map::MapKind::Stored, "1"}, document(features(kPoint)), std::nullopt};
    order.only_uid = "another";
    jobs::changeOverlays(store, order, [&](auto came) { outcome = std::move(came); });
    QVERIFY(outcome && !*outcome && store.sent.empty());
    order.only_uid = "uid";
    jobs::changeOverlays(store, order, [&](auto came) { outcome = std::move(came); });
    QVERIFY(outcome && *outcome && store.sent.size() == 1);
  }

  void idsThatTheRobotGivesAreNoDifference() {
    Store store;
    store.stores = [&](const std::string&) -> Outcome<OverlayText> {
      return OverlayText{features(R"({"properties":{"name":"A"},"id":77})"), 6, {}, {}};
    };
    const auto outcome = change(store, features(R"({"properties":{"name":"A"}})"), features(kWall));
    QVERIFY(outcome && outcome->certain());
  }

  void aRefusalIsNotBelieved() {
    for (const auto kind :
         {map::FailureKind::RejectedByRobot, map::FailureKind::Refused, map::FailureKind::Conflict}) {
      Store store;
      const auto refuses = [&](const std::string& keeps) {
        store.stores = [&store, kind, keeps](const std::string& text) -> Outcome<OverlayText> {
          if (!keeps.empty()) store.held = {keeps == "all" ? text : keeps, 6, "uid", "Hall"};
          return robot::fail(map::Failure{.kind = kind, .asked_for = map::AskedFor::Change});
        };
        return change(store, features(kWall + "," + kPoint), features(kWall));
      };
      const auto not_done = refuses("");
      QVERIFY(!not_done && not_done.error().kind == kind && not_done.error().applied == map::Applied::No);
      const auto other = refuses(features(""));
      QVERIFY(!other && other.error().kind == kind);
      QCOMPARE(other.error().applied == map::Applied::Maybe, kind != map::FailureKind::Conflict);
      store.held = {features(kWall), 5, "uid", "Hall"};
      const auto done = refuses("all");
      QVERIFY(done && done->certain() && done->held.version == 6);
    }
  }

  void whatIsKnownIsNotAskedFor() {
    Store store;
    std::optional<Outcome<jobs::OverlayOutcome>> outcome;
    jobs::OverlayOrder order{
        {map::MapKind::Stored, "1"}, document(features(kPoint)), document(features(kWall))};
    order.held = store.held;
    int told = 0;
    order.seen = [&](const OverlayText& text, bool saved, const jobs::OverlaysHeld* read) {
      ++told;
      QVERIFY(saved && text.text == features(kPoint));
      QVERIFY(read && read->as_sent && read->document.text() == text.text);
    };
    jobs::changeOverlays(store, order, [&](auto came) { outcome = std::move(came); });
    QVERIFY(outcome && *outcome && (*outcome)->certain());
    QCOMPARE(store.reads, 1);
    QCOMPARE(told, 1);
  }

  void aLostAnswerIsLookedFor() {
    for (const bool done : {true, false}) {
      Store store;
      store.stores = [&](const std::string& text) -> Outcome<OverlayText> {
        // The robot gave it an id, and counted.
        if (done) store.held = {text.substr(0, text.size() - 3) + R"(,"id":7}]})", 6, "uid", "Hall"};
        return robot::fail(map::Failure{.kind = map::FailureKind::TimedOut, .applied = map::Applied::Maybe});
      };
      const auto outcome = change(store, features(R"({"name":"A"})"), features(kWall));
      QCOMPARE(outcome.has_value(), done);
      QCOMPARE(store.reads, 2);
      if (done) QVERIFY(outcome->certain() && outcome->applied() == map::Applied::Yes);
      if (!done) QVERIFY(outcome.error().applied == map::Applied::Maybe);
    }
  }

  void whatNeverLeftIsNotLookedFor() {
    Store store;
    store.stores = [&](const std::string&) -> Outcome<OverlayText> {
      return robot::fail(map::Failure{.kind = map::FailureKind::Unreachable});
    };
    const auto outcome = change(store, features(kPoint), features(kWall));
    QVERIFY(!outcome && outcome.error().applied == map::Applied::No);
    QCOMPARE(store.reads, 1);
  }

  void whatIsHeldBackIsNotApplied() {
    Store store;
    std::optional<Outcome<jobs::OverlayOutcome>> outcome;
    jobs::OverlayOrder order{{map::MapKind::Stored, "1"}, document(features("")), document(features(kWall))};
    order.may_empty = false;
    jobs::changeOverlays(store, order, [&](auto came) { outcome = std::move(came); });
    QVERIFY(outcome && *outcome && (*outcome)->held_back && (*outcome)->applied() == map::Applied::No);
  }

  void aRefusalComesThrough() {
    Store store;
    store.stores = [&](const std::string&) -> Outcome<OverlayText> {
      return robot::fail(map::Failure{.kind = map::FailureKind::TimedOut, .applied = map::Applied::Maybe});
    };
    const auto outcome = change(store, features(kPoint), features(kWall));
    QVERIFY(!outcome && outcome.error().applied == map::Applied::Maybe);
  }
};

}  // namespace test_change_overlays

MAPWRIGHT_TEST(test_change_overlays, TestChangeOverlays, Core)
#include "test_change_overlays.moc"
