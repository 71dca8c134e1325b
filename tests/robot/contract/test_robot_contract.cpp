// What every adapter must hold, whatever it speaks: run over the simulator of each (robot/robot.h).
#include <QTest>

#include "contract_bench.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_robot_contract {

using namespace mapwright;
using namespace mapwright::robot;
using map::Applied;
using map::FailureKind;
using testing::Adapter;
using testing::AnswerGate;
using testing::Bench;
using testing::Ended;
using testing::Question;

namespace {

constexpr int kPatienceMs = 20'000;
constexpr std::chrono::milliseconds kShort{300};

/// One question in progress.
struct Asked {
  explicit Asked(const Question& question) : name(question.name) {
    call = question.ask([this](Ended how) {
      ++replies;
      ended = how;
      over_when_told = call.over();
    });
    from_within = replies > 0;
  }
  bool wait() const {
    return QTest::qWaitFor([this] { return replies > 0; }, kPatienceMs);
  }
  FailureKind kind() const { return ended ? ended->kind : FailureKind::None; }

  const char* name;
  Call call;
  int replies = 0;
  bool from_within = false, over_when_told = false;
  Ended ended;
};

/// Whatever may still be in progress has had its chance.
void settle() {
  for (int times = 0; times < 50; ++times) QCoreApplication::processEvents(QEventLoop::AllEvents, 2);
}

const QByteArray kPage = "<!DOCTYPE html><html><body>It works</body></html>";

}  // namespace

class RobotContractTest : public QObject {
  Q_OBJECT

  static void adapters(bool with_files) {
    QTest::addColumn<Adapter>("adapter");
    QTest::newRow("axbot") << Adapter::Axbot;
    QTest::newRow("aimdk") << Adapter::Aimdk;
    QTest::newRow("aimdk, newer firmware") << Adapter::AimdkNewer;
    QTest::newRow("ros") << Adapter::Ros;
    QTest::newRow("kabam") << Adapter::Kabam;
    QTest::newRow("rep130") << Adapter::Rep130;
    if (with_files) QTest::newRow("files") << Adapter::Files;
    if (with_files) QTest::newRow("recorded") << Adapter::Recorded;
    if (with_files) QTest::newRow("state file") << Adapter::State;
  }

 private Q_SLOTS:
  void everyQuestionEndsOnceAndLater_data() { adapters(true); }
  void everyQuestionEndsOnceAndLater() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    for (const Question& question : bench.questions()) {
      const Asked asked(question);
      QVERIFY2(!asked.from_within && !asked.call.over(), asked.name);
      QVERIFY2(asked.wait(), asked.name);
      settle();
      QVERIFY2(asked.replies == 1, asked.name);
      QVERIFY2(asked.call.over() && asked.over_when_told, asked.name);
      const bool good = asked.kind() == FailureKind::None || asked.kind() == FailureKind::Unsupported;
      QVERIFY2(good, asked.ended ? sentences::sentenceOf(*asked.ended).c_str() : asked.name);
      asked.call.cancel();
      settle();
      QVERIFY2(asked.replies == 1, asked.name);
    }
  }

  void questionsAskedTogetherEndEachOnce_data() { adapters(true); }
  void questionsAskedTogetherEndEachOnce() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    std::vector<std::unique_ptr<Asked>> asked;
    for (int times = 0; times < 3; ++times) {
      for (const Question& question : bench.questions()) {
        if (!question.changes) asked.push_back(std::make_unique<Asked>(question));
      }
    }
    for (const auto& one : asked) QVERIFY2(one->wait(), one->name);
    settle();
    for (const auto& one : asked) QVERIFY2(one->replies == 1, one->name);
  }

  void aRobotThatIsGoneAnswersNobody_data() { adapters(true); }
  void aRobotThatIsGoneAnswersNobody() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    std::vector<std::unique_ptr<Asked>> asked;
    for (const Question& question : bench.questions()) asked.push_back(std::make_unique<Asked>(question));
    bench.robot.reset();
    settle();
    for (const auto& one : asked) {
      QVERIFY2(one->replies == 0, one->name);
      QVERIFY2(one->call.over(), one->name);
      one->call.cancel();
    }
    settle();
  }

  void theRobotMayGoWithinAnAnswer_data() { adapters(true); }
  void theRobotMayGoWithinAnAnswer() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    const std::size_t count = bench.questions().size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!bench.robot) bench.make();
      const Question question = bench.questions()[i];
      int replies = 0;
      const Call call = question.ask([&](const Ended&) {
        ++replies;
        bench.robot.reset();
      });
      QVERIFY2(QTest::qWaitFor([&] { return replies > 0; }, kPatienceMs), question.name);
      QVERIFY(call.over());
    }
  }

  void whatIsCancelledEndsOnceAndLater_data() { adapters(true); }
  void whatIsCancelledEndsOnceAndLater() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    if (bench.gate) bench.gate->answerAll({});  // as long as it takes
    for (const Question& question : bench.questions()) {
      const Asked asked(question);
      asked.call.cancel();
      asked.call.cancel();
      QVERIFY2(asked.replies == 0, asked.name);
      QVERIFY2(asked.wait(), asked.name);
      settle();
      QVERIFY2(asked.replies == 1 && asked.call.over(), asked.name);
      // A file may have been read before it was told not to be, and what was told before needs no question.
      if ((!bench.gate || bench.overRosbridge()) && asked.kind() == FailureKind::None) continue;
      QVERIFY2(asked.kind() == FailureKind::Cancelled || asked.kind() == FailureKind::Unsupported,
               asked.name);
      // A change may have left before it was told to stay; nobody has answered that it was made.
      QVERIFY2(
          asked.ended->applied == Applied::No || (question.changes && asked.ended->applied == Applied::Maybe),
          asked.name);
    }
  }

  void oneQuestionIsCancelledAndNoOther_data() { adapters(true); }
  void oneQuestionIsCancelledAndNoOther() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    for (const Question& question : bench.questions()) {
      if (question.changes) continue;
      const Asked kept(question), dropped(question);
      dropped.call.cancel();
      QVERIFY2(kept.wait() && dropped.wait(), question.name);
      QVERIFY2(kept.kind() == FailureKind::None || kept.kind() == FailureKind::Unsupported, question.name);
      // Where the answer was quicker it is too late, and the outcome is what it would have been.
      QVERIFY2(dropped.kind() == FailureKind::Cancelled || dropped.kind() == kept.kind(), question.name);
    }
  }

  void failuresSayOfWhichKindTheyAre_data() {
    QTest::addColumn<Adapter>("adapter");
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("code");
    for (const auto& [name, adapter] :
         {std::pair{"axbot", Adapter::Axbot}, std::pair{"aimdk", Adapter::Aimdk}}) {
      const auto row = [&, of = adapter, called = name](const char* what, const QByteArray& answer,
                                                        FailureKind kind, const char* code = "") {
        QTest::addRow("%s, %s", called, what) << of << answer << int(kind) << QString::fromLatin1(code);
      };
      row("silence", {}, FailureKind::TimedOut);
      row("hang up", "HTTP", FailureKind::Unreachable);
      row("401", AnswerGate::reply(401, "{}"), FailureKind::Refused, "401");
      row("403", AnswerGate::reply(403, "{}"), FailureKind::Refused, "403");
      row("400", AnswerGate::reply(400, R"({"message":"not <b>so</b>"})"), FailureKind::RejectedByRobot,
          "400");
      row("409", AnswerGate::reply(409, "{}"), FailureKind::Conflict, "409");
      row("500", AnswerGate::reply(500, "{}"), FailureKind::RejectedByRobot, "500");
      row("a web page", AnswerGate::reply(200, kPage, "text/html"), FailureKind::NotARobot);
      row("another question's answer", AnswerGate::reply(200, "17"), FailureKind::MalformedAnswer);
    }
  }
  void failuresSayOfWhichKindTheyAre() {
    QFETCH(Adapter, adapter);
    QFETCH(QByteArray, answer);
    QFETCH(int, kind);
    QFETCH(QString, code);
    Bench bench(adapter);
    if (answer.isEmpty()) bench.make(kShort);
    bench.gate->answerAll(answer);
    for (const Question& question : bench.questions()) {
      const bool picture = qstrcmp(question.name, "thumbnail") == 0;
      // Pictures are not looked into here, and a submap that cannot be read is only not had.
      if (answer.contains("200 Word") &&
          (picture || question.changes || qstrcmp(question.name, "submap") == 0))
        continue;
      const Asked asked(question);
      QVERIFY2(asked.wait(), asked.name);
      if (asked.kind() == FailureKind::Unsupported) continue;
      QVERIFY2(asked.ended, asked.name);
      // A submap's answer knows no conflict.
      const bool of_submap = qstrcmp(question.name, "submap") == 0;
      const FailureKind expected = of_submap && FailureKind(kind) == FailureKind::Conflict
                                       ? FailureKind::RejectedByRobot
                                       : FailureKind(kind);
      QVERIFY2(asked.kind() == expected, asked.name);
      if (of_submap) continue;
      QCOMPARE(QString::fromStdString(asked.ended->robot_code), code);
      QVERIFY2(asked.ended->subject.kind != map::SubjectKind::Other, asked.name);
      const std::string sentence = sentences::sentenceOf(*asked.ended);
      QVERIFY2(sentence.ends_with('.') && sentence.find('<') == std::string::npos, sentence.c_str());
      if (!question.changes) QVERIFY2(asked.ended->applied == Applied::No, asked.name);
    }
  }

  void aRobotThatCannotBeFoundIsUnreachable_data() { adapters(false); }
  void aRobotThatCannotBeFoundIsUnreachable() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    bench.gate->close();
    if (bench.overRosbridge())
      QTRY_VERIFY_WITH_TIMEOUT(bench.robot->connection().phase != ConnectionPhase::Online, kPatienceMs);
    for (const Question& question : bench.questions()) {
      const Asked asked(question);
      QVERIFY2(asked.wait(), asked.name);
      if (asked.kind() == FailureKind::Unsupported) continue;
      QVERIFY2(asked.kind() == FailureKind::Unreachable, asked.name);
      QVERIFY2(asked.ended->applied == Applied::No, asked.name);
    }
  }

  void anAnswerThatBreaksOffIsAFailure_data() {
    // Those whose every answer has a connection of its own.
    QTest::addColumn<Adapter>("adapter");
    QTest::newRow("axbot") << Adapter::Axbot;
    QTest::newRow("aimdk") << Adapter::Aimdk;
  }
  void anAnswerThatBreaksOffIsAFailure() {
    QFETCH(Adapter, adapter);
    for (const qint64 bytes : {20, 120, 250}) {
      Bench bench(adapter);
      bench.gate->cutAfter(bytes);
      for (const Question& question : bench.questions()) {
        const Asked asked(question);
        QVERIFY2(asked.wait(), asked.name);
        if (asked.kind() == FailureKind::Unsupported) continue;
        QVERIFY2(asked.kind() == FailureKind::Unreachable || (!asked.ended && bytes == 250), asked.name);
        settle();
        QVERIFY2(asked.replies == 1, asked.name);
      }
    }
  }

  void whatTheRobotDoesNotHaveIsRejected_data() { adapters(true); }
  void whatTheRobotDoesNotHaveIsRejected() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    bench.key = bench.unknown;
    for (const Question& question : bench.questions()) {
      const bool of_the_map = qstrcmp(question.name, "describe") == 0 ||
                              qstrcmp(question.name, "whole map") == 0 || question.changes;
      if (!of_the_map) continue;
      const Asked asked(question);
      QVERIFY2(asked.wait(), asked.name);
      QVERIFY2(asked.kind() == FailureKind::RejectedByRobot, asked.name);
      QVERIFY2(asked.ended->applied == Applied::No, asked.name);
      QVERIFY(asked.ended->subject == map::subjectOf(bench.unknown));
    }
  }

  void howFarABodyHasTravelledIsTold() {
    Bench bench(Adapter::Axbot);
    std::vector<Progress> told;
    bool ended = false;
    const Call call =
        bench.robot->wholeMapSource()->fetch(bench.key, [&](const auto& map) { ended = map.has_value(); });
    call.onProgress([&](Progress progress) {
      QVERIFY(!ended);
      told.push_back(progress);
    });
    QTRY_VERIFY_WITH_TIMEOUT(ended, kPatienceMs);
    QVERIFY(!told.empty());
    QVERIFY(told.back().of_bytes && told.back().bytes == *told.back().of_bytes);
  }

  void whatIsAbsentSaysWhy_data() { adapters(true); }
  void whatIsAbsentSaysWhy() {
    QFETCH(Adapter, adapter);
    Bench bench(adapter);
    Robot& robot = *bench.robot;
    const std::vector<std::pair<Capability, bool>> all{
        {Capability::Submaps, robot.submapSource() != nullptr},
        {Capability::Catalogue, robot.mapCatalogue() != nullptr},
        {Capability::WholeMaps, robot.wholeMapSource() != nullptr},
        {Capability::Overview, robot.overviewSource() != nullptr},
        {Capability::Waypoints, robot.waypointSource() != nullptr},
        {Capability::WaypointEditing, robot.waypointStore() != nullptr},
        {Capability::Live, robot.liveTopics() != nullptr},
        {Capability::Administration, robot.mapAdministration() != nullptr},
        {Capability::PictureEditing, robot.pictureStore() != nullptr},
        {Capability::OverlayEditing, robot.overlayStore() != nullptr},
        {Capability::Bags, robot.bagLibrary() != nullptr},
        {Capability::Dispatch, robot.mapDispatch() != nullptr},
        {Capability::Localization, robot.localization() != nullptr},
        {Capability::MapTransfer, robot.mapTransfer() != nullptr},
        {Capability::PoseGraph, robot.poseGraphSource() != nullptr}};
    for (const auto& [capability, there] : all) {
      if (there) continue;
      const QString why = sentences::absenceReason(capability, robot.unavailableReason(capability));
      QVERIFY2(why.endsWith(QLatin1Char('.')), qPrintable(why));
      QVERIFY(!why.contains(QLatin1String("%1")));
    }
  }

  // What changes something. Every adapter that has MapAdministration; today the one.

  void aChangeIsMadeAndTold() {
    Bench bench(Adapter::Axbot);
    MapAdministration& maps = *bench.robot->mapAdministration();
    std::optional<Outcome<map::CatalogueEntry>> renamed, loaded;
    maps.carryOut({MapChange::Rename, bench.key, "Hall \"2\" 🏭"},
                  [&](auto outcome) { renamed = std::move(outcome); });
    QTRY_VERIFY_WITH_TIMEOUT(renamed.has_value(), kPatienceMs);
    QVERIFY(renamed->has_value());
    QCOMPARE((*renamed)->name, std::string("Hall \"2\" 🏭"));
    QVERIFY(!(*renamed)->is_current);
    QSignalSpy changed(bench.robot.get(), &Robot::mapsChanged);
    maps.carryOut({MapChange::Load, bench.key}, [&](auto outcome) { loaded = std::move(outcome); });
    QTRY_VERIFY_WITH_TIMEOUT(loaded.has_value(), kPatienceMs);
    QVERIFY(loaded->has_value() && (*loaded)->is_current);
    QVERIFY((*loaded)->key == bench.key);
    QVERIFY(!changed.isEmpty());
  }

  void anAnswerThatIsLostIsLookedFor() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    Bench bench(Adapter::Axbot, faults);
    std::optional<Outcome<map::CatalogueEntry>> renamed;
    bench.robot->mapAdministration()->carryOut({MapChange::Rename, bench.key, "Lobby"},
                                               [&](auto outcome) { renamed = std::move(outcome); });
    QTRY_VERIFY_WITH_TIMEOUT(renamed.has_value(), kPatienceMs);
    QVERIFY(renamed->has_value());
    QCOMPARE((*renamed)->name, std::string("Lobby"));
    QCOMPARE(bench.gate->count("PATCH "), 1);
  }

  void whatCannotBeAskedForSaysWhy() {
    Bench bench(Adapter::Axbot);
    const MapAdministration& maps = *bench.robot->mapAdministration();
    map::CatalogueEntry stored, mapping, loaded;
    stored.key = bench.key;
    mapping.key = {map::MapKind::Mapping, "1"};
    loaded = stored;
    loaded.is_current = true;
    QVERIFY(!maps.obstacle(MapChange::Rename, &stored));
    QVERIFY(!maps.obstacle(MapChange::Load, &stored));
    QVERIFY(maps.obstacle(MapChange::Load, &loaded) == Obstacle::IsLoaded);
    QVERIFY(maps.obstacle(MapChange::Rename, &mapping) == Obstacle::NotOfThisMap);
    QVERIFY(!maps.obstacle(MapChange::Delete, &stored));
    QVERIFY(maps.obstacle(MapChange::Delete, &mapping) == Obstacle::NotOfThisMap);
    QVERIFY(maps.obstacle(MapChange::Archive, &stored) == Obstacle::NotOffered);
    std::optional<Outcome<map::CatalogueEntry>> ended;
    bench.robot->mapAdministration()->carryOut({MapChange::Archive, bench.key},
                                               [&](auto outcome) { ended = std::move(outcome); });
    QVERIFY(!ended);
    QTRY_VERIFY_WITH_TIMEOUT(ended.has_value(), kPatienceMs);
    QVERIFY(ended->error().kind == FailureKind::Unsupported && ended->error().applied == Applied::No);
  }

  void aFailedChangeSaysWhetherItWasMade_data() {
    QTest::addColumn<QString>("how");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("applied");
    QTest::addColumn<bool>("made");
    const auto row = [](const char* how, FailureKind kind, Applied applied, bool made) {
      QTest::newRow(how) << QString::fromLatin1(how) << int(kind) << int(applied) << made;
    };
    row("nobody is there", FailureKind::Unreachable, Applied::No, false);
    row("it refuses", FailureKind::RejectedByRobot, Applied::No, false);
    row("it wants another secret", FailureKind::Refused, Applied::No, false);
    row("it has been changed meanwhile", FailureKind::Conflict, Applied::No, false);
    row("it stumbles", FailureKind::RejectedByRobot, Applied::Maybe, false);
    row("the request is lost", FailureKind::Unreachable, Applied::Maybe, false);
    row("the answer breaks off", FailureKind::Unreachable, Applied::Maybe, true);
    row("it is silent", FailureKind::TimedOut, Applied::Maybe, false);
    row("it is cancelled while it waits", FailureKind::Cancelled, Applied::Maybe, false);
    row("what became of it cannot be read", FailureKind::NotARobot, Applied::Maybe, true);
  }
  void aFailedChangeSaysWhetherItWasMade() {
    QFETCH(QString, how);
    QFETCH(int, kind);
    QFETCH(int, applied);
    QFETCH(bool, made);
    const auto is = [&](const char* what) { return how == QLatin1String(what); };
    simulator::Faults faults;
    if (is("the request is lost"))
      faults.requests.push_back({simulator::FaultKind::Drop, simulator::kWrites});
    if (is("it stumbles")) faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kWrites});
    Bench bench(Adapter::Axbot, faults);
    AnswerGate& gate = *bench.gate;
    if (is("nobody is there")) gate.close();
    if (is("it refuses")) gate.answerAll(AnswerGate::reply(422, "{}"));
    if (is("it wants another secret")) gate.answerAll(AnswerGate::reply(401, "{}"));
    if (is("it has been changed meanwhile")) gate.answerAll(AnswerGate::reply(409, "{}"));
    if (is("the answer breaks off")) gate.cutAfter(200);
    if (is("it is silent")) bench.make(kShort);
    if (is("it is silent") || is("it is cancelled while it waits")) gate.answerAll({});
    if (is("what became of it cannot be read")) {
      gate.answerAll(AnswerGate::reply(200, kPage, "text/html"));
      gate.passOnly("PATCH ");
    }
    Ended ended;
    int replies = 0;
    const Call call = bench.robot->mapAdministration()->carryOut({MapChange::Rename, bench.key, "Lobby"},
                                                                 [&](const auto& outcome) {
                                                                   ++replies;
                                                                   if (!outcome) ended = outcome.error();
                                                                 });
    if (is("it is cancelled while it waits")) {
      QTRY_COMPARE_WITH_TIMEOUT(gate.count("PATCH "), 1, kPatienceMs);
      call.cancel();
    }
    QTRY_COMPARE_WITH_TIMEOUT(replies, 1, kPatienceMs);
    QVERIFY(ended);
    QCOMPARE(int(ended->kind), kind);
    QCOMPARE(int(ended->applied), applied);
    QVERIFY(ended->subject == map::subjectOf(bench.key));
    settle();
    QCOMPARE(replies, 1);
    QVERIFY(gate.count("PATCH ") <= 1);  // never a second time by itself
    // The robot itself knows.
    Bench::Name name(*bench.robot_itself, bench.key.id);
    QTRY_VERIFY_WITH_TIMEOUT(name.known(), kPatienceMs);
    QCOMPARE(name.text() == QLatin1String("Lobby"), made);
  }
};

}  // namespace test_robot_contract

MAPWRIGHT_TEST(test_robot_contract, RobotContractTest, Core)
#include "test_robot_contract.moc"
