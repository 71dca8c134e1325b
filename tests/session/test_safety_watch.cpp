// When dangers begin, end and expire.
#include <QSignalSpy>
#include <QTest>

#include "map/world.h"
#include "session/safety_watch.h"
#include "test_program.h"

namespace test_safety_watch {

using namespace mapwright;
using map::reduce;
using session::SafetyWatch;

class SafetyWatchTest : public QObject {
  Q_OBJECT
  map::LiveState live_;
  double now_s_ = 100;
  std::unique_ptr<SafetyWatch> watch_;
  std::unique_ptr<QSignalSpy> changed_, began_, ended_;

  void press(bool pressed) { say(map::WheelState{"auto", pressed, {}}); }
  void say(const map::TopicMessage& message) {
    live_ = reduce(std::move(live_), message, now_s_);
    watch_->look();
  }
  static map::AlertsMessage alerts(std::vector<std::pair<int, std::string>> errors) {
    map::AlertsMessage message;
    for (auto& [code, text] : errors) message.alerts.push_back({code, map::AlertLevel::Error, text, 0});
    return message;
  }

 private Q_SLOTS:
  void init() {
    live_ = {};
    now_s_ = 100;
    watch_ = std::make_unique<SafetyWatch>(live_, [this] { return now_s_; });
    changed_ = std::make_unique<QSignalSpy>(watch_.get(), &SafetyWatch::changed);
    began_ = std::make_unique<QSignalSpy>(watch_.get(), &SafetyWatch::began);
    ended_ = std::make_unique<QSignalSpy>(watch_.get(), &SafetyWatch::ended);
  }

  void tellsOfABeginningAndAnEndOnce() {
    for (int i = 0; i < 3; ++i) press(true);
    QCOMPARE(began_->size(), 1);
    QCOMPARE(changed_->size(), 1);
    QCOMPARE(watch_->conditions().size(), std::size_t(1));
    for (int i = 0; i < 3; ++i) press(false);
    QCOMPARE(ended_->size(), 1);
    QCOMPARE(changed_->size(), 2);
    QVERIFY(watch_->conditions().empty());
  }

  void aTextWhoseNumberMovesIsNoNewBeginning() {
    say(alerts({{6004, "81 degrees"}}));
    say(alerts({{6004, "82 degrees"}}));
    QCOMPARE(began_->size(), 1);
    QCOMPARE(changed_->size(), 2);  // what is shown has changed
    QCOMPARE(ended_->size(), 0);
  }

  void oneOfTwoOfTheSameNameIsNoEnd() {
    say(alerts({{7, "left"}, {7, "right"}}));
    say(alerts({{7, "right"}}));
    QCOMPARE(ended_->size(), 0);
    say(alerts({}));
    QCOMPARE(ended_->size(), 1);
  }

  void everyReturnIsABeginning() {
    for (int i = 0; i < 3; ++i) {
      press(true);
      now_s_ += 1;
      press(false);
      now_s_ += 1;
    }
    QCOMPARE(began_->size(), 3);
    QCOMPARE(ended_->size(), 2);  // the third time it is held: it comes and goes
    QCOMPARE(watch_->conditions().size(), std::size_t(1));
  }

  void whatIsHeldExpiresByItself() {
    for (int i = 0; i < 3; ++i) {
      press(true);
      press(false);
    }
    QCOMPARE(watch_->conditions().size(), std::size_t(1));
    now_s_ += map::kSafetyHoldS - 0.01;
    watch_->look();
    QCOMPARE(watch_->conditions().size(), std::size_t(1));
    now_s_ += 0.02;
    QTRY_VERIFY(watch_->conditions().empty());
    QCOMPARE(ended_->size(), 3);
  }
};

}  // namespace test_safety_watch

MAPWRIGHT_TEST(test_safety_watch, SafetyWatchTest, Core)
#include "test_safety_watch.moc"
