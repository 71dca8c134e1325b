#include "replay/events.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "map/live_state.h"

namespace mapwright::replay {
namespace {

constexpr int kPoor = 3;  // SlamStatus::position_quality

// A bag of few messages has pauses between all of them.
constexpr double kTimesUsual = 10;

/// By kind.
constexpr EventGroup kGroupOf[] = {
    EventGroup::Alerts, EventGroup::Alerts,   EventGroup::Planner,  EventGroup::Position, EventGroup::Maps,
    EventGroup::Maps,   EventGroup::Position, EventGroup::Position, EventGroup::Stops,    EventGroup::Stops};
constexpr const char* kGroupWords[] = {"alerts", "planner", "position", "maps", "stops"};

struct Telling {
  std::vector<Event> events = {};
  std::map<std::pair<std::int64_t, std::string>, int> alerts = {};  // active ones
  std::optional<std::string> move = {};
  std::optional<map::MapInfo> info = {};
  std::string uuid = {};
  bool low = false, stopped = false;
  std::optional<Digest::Pose> pose = {};
  bool placed_anew = false;  // a new frame: the next pose is not a jump
  double at_s = 0;

  Event& add(EventKind kind, std::int64_t code = 0, std::string text = {}) {
    events.push_back({at_s, kind, code, std::move(text), 0});
    return events.back();
  }

  void operator()(const map::AlertsMessage& message) {
    std::map<std::pair<std::int64_t, std::string>, int> now;
    for (const map::Alert& alert : message.alerts) ++now[{alert.code, alert.text}];
    for (const auto& [alert, count] : alerts) {
      if (!now.contains(alert)) add(EventKind::AlertEnded, alert.first, alert.second);
    }
    for (const auto& [alert, count] : now) {
      if (!alerts.contains(alert)) add(EventKind::AlertBegan, alert.first, alert.second);
    }
    alerts = std::move(now);
  }
  void operator()(const map::MapInfo& message) {
    const bool other = info && std::tie(info->uid, info->name, info->map_version) !=
                                   std::tie(message.uid, message.name, message.map_version);
    if (other) {
      add(EventKind::MapChanged, message.map_version.value_or(0), message.name);
      placed_anew |= info->uid != message.uid || info->name != message.name;
    }
    info = message;
  }
  void operator()(const map::SubmapList& list) {
    if (list.uuid.empty() || list.uuid == uuid) return;
    if (!uuid.empty()) add(EventKind::SessionChanged, 0, list.uuid);
    placed_anew |= !uuid.empty();
    uuid = list.uuid;
  }
  void operator()(const map::SlamStatus& slam) {
    const int quality = slam.position_quality.value_or(0);
    if (quality <= 0 && !slam.reliable) return;  // it does not say
    const bool now = (quality > 0 && quality <= kPoor) || slam.reliable == false;
    if (now != low) add(now ? EventKind::QualityLow : EventKind::QualityGood, quality);
    low = now;
  }
  void operator()(const map::WheelState& wheels) {
    if (!wheels.emergency_stop) return;  // it does not say
    const bool now = *wheels.emergency_stop;
    if (now != stopped) add(now ? EventKind::EmergencyStopOn : EventKind::EmergencyStopOff);
    stopped = now;
  }
  template <typename Other>
  void operator()(const Other&) {}

  void onPose(const Digest::Pose& now) {
    if (pose && !placed_anew && map::isJump(placeOf(*pose), placeOf(now))) {
      Event& jump = add(EventKind::PositionJump);
      jump.metres = std::hypot(now.pose.x_m - pose->pose.x_m, now.pose.y_m - pose->pose.y_m);
    }
    placed_anew = false;
    pose = now;
  }
  void onMove(const Digest::Move& now) {
    if (move && *move != now.state) add(EventKind::MoveState, 0, now.state);
    move = now.state;
  }
  void onKept(const Digest::Kept& kept) { std::visit(*this, kept.message); }
};

}  // namespace

EventGroup groupOf(EventKind kind) { return kGroupOf[std::size_t(kind)]; }

std::string wordOf(EventGroup group) { return kGroupWords[std::size_t(group)]; }

std::vector<Event> eventsOf(const std::map<Tick, Digest>& digests) {
  Telling telling;
  for (const auto& [from, digest] : digests) {
    auto pose = digest.poses.begin();
    auto kept = digest.history.begin();
    for (;;) {
      const bool poses = pose != digest.poses.end(), keeps = kept != digest.history.end();
      if (!poses && !keeps) break;
      if (poses && (!keeps || pose->index < kept->index)) {
        telling.at_s = pose->stamp_s;
        telling.onPose(*pose++);
      } else {
        telling.at_s = kept->stamp_s;
        telling.onKept(*kept++);
      }
    }
    for (const Digest::Move& move : digest.moves) {
      telling.at_s = move.stamp_s;
      telling.onMove(move);
    }
  }
  std::stable_sort(telling.events.begin(), telling.events.end(),
                   [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
  return std::move(telling.events);
}

std::vector<Silence> silencesIn(const Chunks& chunks, const std::map<Tick, Digest>& digests) {
  std::size_t messages = 0;
  double read_s = 0;
  for (const auto& [from, cell] : chunks.cells()) {
    if (cell.state != CellState::Read || cell.beyond) continue;
    messages += cell.messages;
    read_s += secondsOf(cell.until) - secondsOf(cell.from);
  }
  const double least_s =
      std::max(kSilenceS, messages > 0 ? kTimesUsual * read_s / double(messages) : kSilenceS);
  std::vector<Silence> silences;
  double since_s = chunks.start_s();  // the last message
  bool known = true;                  // everything in between has been read
  const auto endAt = [&](double at_s) {
    if (known && at_s - since_s >= least_s) silences.push_back({since_s, at_s});
  };
  for (const auto& [from, cell] : chunks.cells()) {
    if (cell.beyond) continue;
    const auto digest = digests.find(from);
    if (cell.state != CellState::Read || digest == digests.end()) {
      endAt(secondsOf(cell.from));
      known = false;
      continue;
    }
    if (!std::exchange(known, true)) since_s = std::max(secondsOf(cell.from), chunks.start_s());
    if (digest->second.messages == 0) continue;
    endAt(digest->second.first_s);
    for (const auto& [before_s, after_s] : digest->second.silences) {
      since_s = before_s;
      endAt(after_s);
    }
    since_s = digest->second.last_s;
  }
  endAt(chunks.end_s());
  return silences;
}

}  // namespace mapwright::replay
