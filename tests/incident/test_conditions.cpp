// What a report says of safety and jumps is what the robot had said by then: random messages, read once more
// message by message.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

#include "incident/report.h"
#include "map/safety.h"
#include "sentences/subject_name.h"
#include "test_program.h"

namespace test_conditions {

using namespace mapwright;
using map::SafetyKind;

namespace {

constexpr double kStart = 1'717'405'200;

struct Said {
  double at_s = 0;
  map::TopicMessage message;
};
using Story = std::vector<Said>;  // by time

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  int below(int n) { return int(random_() % unsigned(n)); }
  bool chance(int percent) { return below(100) < percent; }
  std::optional<bool> maybe() { return chance(15) ? std::nullopt : std::optional(chance(40)); }

 private:
  std::mt19937 random_;
};

map::AlertsMessage someAlerts(Dice& dice) {
  // Two that differ in a number alone, one without a code, one that is none.
  static const std::vector<map::Alert> known{{6004, map::AlertLevel::Error, "Motor 1 is hot", 0},
                                             {6004, map::AlertLevel::Error, "Motor 2 is hot", 0},
                                             {8501, map::AlertLevel::Warning, "low", 0},
                                             {0, map::AlertLevel::Warning, "dusty", 0},
                                             {7, map::AlertLevel::None, "a note", 0}};
  map::AlertsMessage message;
  for (const map::Alert& alert : known) {
    if (dice.chance(45)) message.alerts.push_back(alert);
  }
  std::shuffle(message.alerts.begin(), message.alerts.end(), std::mt19937(unsigned(dice.below(1000))));
  return message;
}

map::SlamStatus someSlam(Dice& dice) {
  static const std::vector<std::string> states{"positioning", "positioning", "positioning", "slam",
                                               "inactive"};
  static const std::vector<int> qualities{0, 1, 1, 3, 6, 8, 10};
  map::SlamStatus slam;
  slam.state = states[std::size_t(dice.below(int(states.size())))];
  if (dice.chance(80)) slam.position_quality = qualities[std::size_t(dice.below(int(qualities.size())))];
  slam.reliable = dice.maybe();
  slam.wheel_slipping = dice.maybe();
  slam.lidar_matching_score = dice.below(100) / 100.0;
  return slam;
}

Story someStory(unsigned seed) {
  Dice dice(seed);
  Story story;
  double at_s = kStart, x_m = 0;
  for (int i = 0; i < 250; ++i) {
    if (!dice.chance(20)) at_s += 0.05 + dice.below(1500) / 1000.0;
    switch (dice.below(4)) {
      case 0:
        story.push_back(
            {at_s, map::WheelState{dice.chance(30) ? "manual" : "auto", dice.maybe(), dice.maybe()}});
        break;
      case 1:
        story.push_back({at_s, someSlam(dice)});
        break;
      case 2:
        story.push_back({at_s, someAlerts(dice)});
        break;
      default:
        at_s += 0.01;  // jumps have a time of their own
        x_m += dice.chance(25) ? 10 + dice.below(10) : 0.01;
        story.push_back({at_s, map::TrackedPose{{x_m, 0, 0}}});
    }
  }
  return story;
}

/// As a bag is read: in ranges, whose limits lie anywhere.
std::map<replay::Tick, replay::Digest> readInRanges(const Story& story, unsigned seed) {
  Dice dice(seed);
  std::map<replay::Tick, replay::Digest> digests;
  replay::Tick from = replay::tickOf(kStart) - 100;
  const replay::Tick end = replay::tickOf(story.back().at_s) + 100;
  while (from < end) {
    auto answer = std::make_shared<robot::BagChunk>();
    const replay::Tick until = from + 64 * (1 + dice.below(60));
    answer->from_s = replay::secondsOf(from);
    answer->until_s = replay::secondsOf(until);
    for (const Said& said : story) {
      if (said.at_s < answer->from_s || said.at_s >= answer->until_s) continue;
      robot::BagMessage message;
      message.message = {said.message, said.at_s, {}, "/topic"};
      message.known = true;
      message.size = 1;
      answer->messages.push_back(std::move(message));
    }
    digests.emplace(from, replay::digestOf(replay::inRange(answer)));
    from = until;
  }
  return digests;
}

incident::Run runAt(const std::map<replay::Tick, replay::Digest>& digests, double at_s, double until_s) {
  incident::Run run;
  run.at_s = at_s;
  run.conditions = incident::conditionsAt(digests, at_s);
  run.events = replay::eventsOf(digests);
  std::erase_if(run.events, [&](const replay::Event& event) { return event.at_s > until_s; });
  return run;
}

// The other reading.

/// Since when all messages of a kind have said it, back from the last one at `at_s`; nullopt: it does not.
template <typename Message, typename Says>
std::optional<double> sinceWhen(const Story& story, double at_s, Says says) {
  std::optional<double> since_s;
  for (auto said = story.rbegin(); said != story.rend(); ++said) {
    const auto* message = std::get_if<Message>(&said->message);
    if (!message || said->at_s > at_s) continue;
    if (!says(*message)) break;
    since_s = said->at_s;
  }
  return since_s;
}

bool hasPosition(const map::SlamStatus& slam) { return slam.state != "slam" && slam.state != "inactive"; }
bool isLost(const map::SlamStatus& slam) {
  const int quality = slam.position_quality.value_or(0);
  return hasPosition(slam) && (quality == 1 || (quality == 0 && slam.reliable == false));
}
bool isUncertain(const map::SlamStatus& slam) {
  const int quality = slam.position_quality.value_or(0);
  return hasPosition(slam) && !isLost(slam) && (slam.reliable == false || quality == 3);
}

/// Name, code, text, since, since of the code.
using Line = std::tuple<QString, qint64, QString, double, double>;

std::multiset<Line> linesAt(const Story& story, double at_s) {
  std::multiset<Line> lines;
  const auto add = [&](SafetyKind kind, std::optional<double> since_s, qint64 code = 0,
                       const std::string& text = {}, std::optional<double> code_since_s = {}) {
    map::SafetyCondition named;
    named.kind = kind;
    named.code = code;
    if (since_s)
      lines.emplace(sentences::nameOf(map::problemOf(named).subject), code, QString::fromStdString(text),
                    *since_s, code_since_s.value_or(*since_s));
  };
  using Wheels = map::WheelState;
  using Slam = map::SlamStatus;
  add(SafetyKind::EmergencyStop,
      sinceWhen<Wheels>(story, at_s, [](const auto& said) { return said.emergency_stop == true; }));
  add(SafetyKind::WheelsReleased,
      sinceWhen<Wheels>(story, at_s, [](const auto& said) { return said.wheels_released == true; }));
  add(SafetyKind::ManualControl,
      sinceWhen<Wheels>(story, at_s, [](const auto& said) { return said.control_mode == "manual"; }));
  add(SafetyKind::PositionLost, sinceWhen<Slam>(story, at_s, isLost));
  add(SafetyKind::PositionUncertain, sinceWhen<Slam>(story, at_s, isUncertain));
  add(SafetyKind::WheelsSlipping,
      sinceWhen<Slam>(story, at_s, [](const auto& said) { return said.wheel_slipping == true; }));
  std::set<std::pair<std::int64_t, std::string>> alerts;
  for (const Said& said : story) {
    if (const auto* message = std::get_if<map::AlertsMessage>(&said.message)) {
      for (const map::Alert& alert : message->alerts) {
        if (alert.level != map::AlertLevel::None) alerts.emplace(alert.code, alert.text);
      }
    }
  }
  for (const auto& alert : alerts) {
    const auto has = [&](bool words) {
      return sinceWhen<map::AlertsMessage>(story, at_s, [&, words](const map::AlertsMessage& message) {
        return std::any_of(message.alerts.begin(), message.alerts.end(), [&](const map::Alert& each) {
          return each.code == alert.first && (!words || each.text == alert.second);
        });
      });
    };
    add(SafetyKind::Alert, has(true), alert.first, alert.second,
        alert.first == 0 ? std::nullopt : has(false));
  }
  return lines;
}

std::multiset<Line> linesOf(const QJsonObject& report) {
  std::multiset<Line> lines;
  for (const auto each : report[QStringLiteral("safety")].toArray()) {
    const QJsonObject row = each.toObject();
    lines.emplace(row[QStringLiteral("condition")].toString(), row[QStringLiteral("code")].toInteger(),
                  row[QStringLiteral("text")].toString(), row[QStringLiteral("since")].toDouble(),
                  row[QStringLiteral("code_since")].toDouble());
  }
  return lines;
}

/// Time and distance of every jump until then.
std::vector<std::pair<double, double>> jumpsUntil(const Story& story, double at_s) {
  std::vector<std::pair<double, double>> jumps;
  const Said* before = nullptr;
  for (const Said& said : story) {
    if (!std::holds_alternative<map::TrackedPose>(said.message) || said.at_s > at_s) continue;
    if (before) {
      const double way_m = std::abs(std::get<map::TrackedPose>(said.message).pose.x_m -
                                    std::get<map::TrackedPose>(before->message).pose.x_m);
      if (way_m > 0.5 && way_m > 5 * (said.at_s - before->at_s)) jumps.emplace_back(said.at_s, way_m);
    }
    before = &said;
  }
  return jumps;
}

std::vector<incident::NamedJump> namedAt(const Story& story, double at_s,
                                         std::optional<double> poor_since_s) {
  std::optional<incident::NamedJump> loss, last;
  for (const auto& [jumped_s, metres] : jumpsUntil(story, at_s)) {
    if (jumped_s >= at_s - 30) last = incident::NamedJump{jumped_s, metres, false};
    if (!poor_since_s || std::abs(jumped_s - *poor_since_s) > 5) continue;
    if (!loss || std::abs(jumped_s - *poor_since_s) < std::abs(loss->at_s - *poor_since_s))
      loss = incident::NamedJump{jumped_s, metres, true};
  }
  if (loss && last && loss->at_s == last->at_s) last.reset();
  std::vector<incident::NamedJump> named;
  for (const auto& one : {loss, last}) {
    if (one) named.push_back(*one);
  }
  std::sort(named.begin(), named.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  return named;
}

/// When the robot said that a stop was pressed or released, or localization poor or good, and had said
/// something else before. A message that says nothing of it changes nothing.
std::vector<std::pair<double, replay::EventKind>> turnsOf(const Story& story) {
  std::vector<std::pair<double, replay::EventKind>> turns;
  bool stopped = false, low = false;
  for (const Said& said : story) {
    if (const auto* wheels = std::get_if<map::WheelState>(&said.message)) {
      if (!wheels->emergency_stop || *wheels->emergency_stop == stopped) continue;
      stopped = !stopped;
      turns.emplace_back(said.at_s,
                         stopped ? replay::EventKind::EmergencyStopOn : replay::EventKind::EmergencyStopOff);
    }
    if (const auto* slam = std::get_if<map::SlamStatus>(&said.message)) {
      const int quality = slam->position_quality.value_or(0);
      if (quality == 0 && !slam->reliable) continue;
      const bool now = slam->reliable == false || quality == 1 || quality == 3;
      if (std::exchange(low, now) != now)
        turns.emplace_back(said.at_s, now ? replay::EventKind::QualityLow : replay::EventKind::QualityGood);
    }
  }
  return turns;
}

}  // namespace

class ConditionsTest : public QObject {
  Q_OBJECT
  int conditions_ = 0, losses_ = 0;

 private Q_SLOTS:
  /// The stories hold something to be told.
  void cleanupTestCase() { QVERIFY(conditions_ > 2000 && losses_ > 40); }

  void aReportSaysWhatTheRobotSaid_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 40; ++seed) QTest::addRow("seed %u", seed) << seed;
  }
  void aReportSaysWhatTheRobotSaid() {
    QFETCH(unsigned, seed);
    const Story story = someStory(seed);
    const auto digests = readInRanges(story, seed);
    Dice dice(seed);
    for (int i = 0; i < 60; ++i) {
      const Said& near = story[std::size_t(dice.below(int(story.size())))];
      const double at_s = near.at_s + (i % 3 == 0 ? 0 : i % 3 == 1 ? 0.004 : dice.below(4000) / 1000.0);
      const incident::Run run = runAt(digests, at_s, at_s + incident::kBesideS);
      const QJsonObject report = incident::reportJson({run, {}, {}, false});
      const auto lines = linesAt(story, at_s);
      QVERIFY(linesOf(report) == lines);
      QCOMPARE(report[QStringLiteral("conditions")].toArray().size(), qsizetype(lines.size()));
      conditions_ += int(lines.size());

      const auto poor_since_s = sinceWhen<map::SlamStatus>(
          story, at_s, [](const auto& slam) { return isLost(slam) || isUncertain(slam); });
      QCOMPARE(report[QStringLiteral("poor_since")].isNull(), !poor_since_s);
      if (poor_since_s) QCOMPARE(report[QStringLiteral("poor_since")].toDouble(), *poor_since_s);
      const auto named = namedAt(story, at_s, poor_since_s);
      QCOMPARE(report[QStringLiteral("jumps")].toArray().size(), qsizetype(named.size()));
      QVERIFY(incident::namedJumps(run) == named);
      for (const incident::NamedJump& jump : named) losses_ += jump.with_loss;

      // What comes later changes nothing of it.
      QCOMPARE(incident::consistent(run), incident::consistent(runAt(digests, at_s, at_s)));
    }
  }

  void eventsAreWhatTheRobotSaid() {
    for (unsigned seed = 1; seed <= 40; ++seed) {
      const Story story = someStory(seed);
      std::vector<std::pair<double, replay::EventKind>> told;
      for (const replay::Event& event : replay::eventsOf(readInRanges(story, seed))) {
        if (event.kind == replay::EventKind::EmergencyStopOn ||
            event.kind == replay::EventKind::EmergencyStopOff ||
            event.kind == replay::EventKind::QualityLow || event.kind == replay::EventKind::QualityGood)
          told.emplace_back(event.at_s, event.kind);
      }
      QVERIFY(told == turnsOf(story));
    }
  }
};

}  // namespace test_conditions

MAPWRIGHT_TEST(test_conditions, ConditionsTest, Core)
#include "test_conditions.moc"
