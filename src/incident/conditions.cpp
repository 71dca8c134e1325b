#include "incident/conditions.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "map/live_state.h"
#include "map/world.h"

namespace mapwright::incident {
namespace {

using map::SafetyCondition;
using map::SafetyKind;

bool isOfPosition(const SafetyCondition& condition) {
  return condition.kind == SafetyKind::PositionLost || condition.kind == SafetyKind::PositionUncertain;
}

/// Since when each has been said without a break.
class Since {
 public:
  void say(const map::TopicMessage& message, double at_s) {
    map::reduceInto(live_, message, at_s);
    auto said = std::exchange(live_.safety, {});  // without a past it is exactly what is said now
    std::map<Words, double> words;
    std::map<std::int64_t, double> codes;
    bool poor = false;
    for (SafetyCondition& each : said) {
      each.since_s = keep(words_, Words(int(each.kind), each.code, each.text), at_s, words);
      if (each.code != 0) keep(codes_, each.code, at_s, codes);
      poor |= isOfPosition(each);
    }
    said_ = std::move(said);
    words_ = std::move(words);
    codes_ = std::move(codes);
    poor_since_s_ = poor ? std::optional(std::min(poor_since_s_.value_or(at_s), at_s)) : std::nullopt;
  }

  Conditions conditions() && {
    Conditions now{{}, poor_since_s_};
    for (SafetyCondition& each : said_) {
      const auto code = codes_.find(each.code);
      const double code_since_s = code == codes_.end() ? each.since_s : code->second;
      now.all.push_back({std::move(each), code_since_s});
    }
    std::stable_sort(now.all.begin(), now.all.end(), [](const Condition& a, const Condition& b) {
      return std::tuple(-int(a.said.severity), int(a.said.kind), a.said.since_s) <
             std::tuple(-int(b.said.severity), int(b.said.kind), b.said.since_s);
    });
    return now;
  }

 private:
  using Words = std::tuple<int, std::int64_t, std::string>;

  /// Moves what is still said from `before` to `now`.
  template <typename Key>
  static double keep(const std::map<Key, double>& before, Key key, double at_s, std::map<Key, double>& now) {
    const auto then = before.find(key);
    const double since_s = then == before.end() ? at_s : std::min(then->second, at_s);
    return now.emplace(std::move(key), since_s).first->second;
  }

  map::LiveState live_;
  std::vector<SafetyCondition> said_;
  std::map<Words, double> words_;
  std::map<std::int64_t, double> codes_;
  std::optional<double> poor_since_s_;
};

bool isOfSafety(const map::TopicMessage& message) {
  return std::holds_alternative<map::AlertsMessage>(message) ||
         std::holds_alternative<map::WheelState>(message) || std::holds_alternative<map::SlamStatus>(message);
}

}  // namespace

Conditions conditionsAt(const std::map<replay::Tick, replay::Digest>& digests, double at_s) {
  Since since;
  for (const auto& [from, digest] : digests) {
    for (const replay::Digest::Kept& kept : digest.history) {
      if (kept.stamp_s > at_s) return std::move(since).conditions();
      if (isOfSafety(kept.message)) since.say(kept.message, kept.stamp_s);
    }
  }
  return std::move(since).conditions();
}

}  // namespace mapwright::incident
