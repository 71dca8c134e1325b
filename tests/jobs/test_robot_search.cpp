// Looking for robots at a host: everybody is asked at once, and nobody is waited for too long.
#include <QPointer>
#include <QSignalSpy>
#include <QtTest>

#include "jobs/robot_search.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_robot_search {

using namespace mapwright;
using jobs::RobotSearch;

namespace {

/// Answers when it is told to.
struct Asked {
  QPointer<QObject> owner;
  robot::Probe::Reply reply;
};

robot::Probe question(const char* title, Asked& asked) {
  return {QLatin1String(title), QUrl(QStringLiteral("http://192.0.2.7")),
          [&asked](QObject* owner, std::chrono::milliseconds, robot::Probe::Reply reply) {
            asked.owner = new QObject(owner);
            asked.reply = std::move(reply);
          }};
}

robot::ProbeAnswer robotAt(const char* address) { return {{{.address = QLatin1String(address)}}, {}}; }

}  // namespace

class TestRobotSearch : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void asksEverybodyAtOnceAndTellsWhatCame() {
    Asked first, second;
    RobotSearch search({question("A", first), question("B", second)}, std::chrono::hours(1));
    QVERIFY(first.reply && second.reply);
    QSignalSpy changed(&search, &RobotSearch::changed), ended(&search, &RobotSearch::ended);
    second.reply(robotAt("b"));
    QCOMPARE(changed.size(), 1);
    QVERIFY(ended.isEmpty() && !search.over());
    QCOMPARE(search.found().size(), std::size_t(1));
    first.reply(robotAt("a"));
    QVERIFY(search.over());
    QCOMPARE(ended.size(), 1);
    QCOMPARE(search.found().front().address, QStringLiteral("a"));  // in the order of the questions
  }

  void givesUpWhatIsSilent() {
    Asked talks, silent;
    RobotSearch search({question("A", talks), question("B", silent)}, std::chrono::milliseconds(50));
    talks.reply(robotAt("a"));
    QSignalSpy ended(&search, &RobotSearch::ended);
    QTRY_COMPARE(ended.size(), 1);
    QVERIFY(!silent.owner);  // nothing goes on behind it
    QCOMPARE(search.found().size(), std::size_t(1));
    QCOMPARE(sentences::wordsOf(search.rows().back().answer->reason),
             QStringLiteral("no answer within 0.05 s"));
  }

  void theReasonThatSaysMostIsTold() {
    Asked first, second, third;
    RobotSearch search({question("A", first), question("B", second), question("C", third)},
                       std::chrono::hours(1));
    QVERIFY(!search.mostTelling());
    first.reply({{}, fault::said("silence")});
    second.reply({{}, fault::said("refused by host:1")});
    QCOMPARE(search.mostTelling()->title, QStringLiteral("A"));
    third.reply({{}, fault::said("refused by host:2")});
    QCOMPARE(search.mostTelling()->title, QStringLiteral("B"));  // ports make no other reason
    Asked one, other;
    RobotSearch again({question("A", one), question("B", other)}, std::chrono::hours(1));
    one.reply({{}, fault::said("refused")});
    other.reply({{}, fault::said("a web server"), true});
    QCOMPARE(again.mostTelling()->title, QStringLiteral("B"));
  }

  void endsWithoutAWordWhenItIsDestroyed() {
    Asked asked;
    auto search = std::make_unique<RobotSearch>(std::vector{question("A", asked)}, std::chrono::hours(1));
    QVERIFY(asked.owner);
    search.reset();
    QVERIFY(!asked.owner);
  }

  void endsLaterEvenWithoutAQuestion() {
    RobotSearch search({}, std::chrono::hours(1));
    QSignalSpy ended(&search, &RobotSearch::ended);
    QTRY_COMPARE(ended.size(), 1);
  }
};

}  // namespace test_robot_search

MAPWRIGHT_TEST(test_robot_search, TestRobotSearch, Core)
#include "test_robot_search.moc"
