// A store of the tests' own: keeps waypoints in memory, one request for each of them like a robot with
// services, or one for all like a file, and fails as it is told to.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include <QTimer>

#include "robot/waypoint_store.h"

namespace mapwright::test {

inline map::Waypoint waypoint(const std::string& id, double x, double y, const std::string& name) {
  map::Waypoint made;
  made.id = id;
  made.name = name;
  made.position_m = {x, y};
  return made;
}

class FakeWaypointStore : public robot::WaypointStore {
 public:
  enum class Mode { OneByOne, AllAtOnce };
  explicit FakeWaypointStore(Mode mode) : mode_(mode) {}

  robot::KeptFields keeps() const override { return kept_fields; }
  robot::Call read(const map::MapKey& map, robot::OutcomeTo<robot::StoredWaypoints> reply) override {
    ++reads;
    read_of = map;
    if (slow) {
      answers.push_back(
          [reply, now = robot::StoredWaypoints{points, std::to_string(revision), {}, there, zero_turns}] {
            reply(now);
          });
      return {};
    }
    return later([this, reply] {
      if (unreadable || reads > readable) {
        reply(tl::make_unexpected(map::Failure{map::FailureKind::Unreachable}));
      } else {
        reply(robot::StoredWaypoints{points, std::to_string(revision), {}, there, zero_turns});
      }
    });
  }
  std::vector<robot::WaypointRequest> plan(const robot::StoredWaypoints& now,
                                           const std::vector<robot::WaypointChange>& changes) const override {
    if (changes.empty()) return {};
    if (mode_ == Mode::AllAtOnce) return {{changes, now.revision}};
    std::vector<robot::WaypointRequest> requests;
    for (const auto& change : changes) requests.push_back({{change}, now.revision});
    return requests;
  }
  robot::WaypointCall callOf(const map::MapKey&, const robot::WaypointRequest& request) const override {
    if (!is_called || request.changes.empty()) return {};
    const auto& change = request.changes.front();
    const auto& point = change.after ? *change.after : *change.before;
    const std::string arguments = "{\"id\":\"" + change.id + "\",\"name\":\"" + point.name +
                                  "\",\"x\":" + std::to_string(point.position_m.x()) + "}";
    return {!change.before ? "create" : !change.after ? "delete" : "change", arguments};
  }
  robot::Call perform(const map::MapKey&, const robot::WaypointRequest& request,
                      robot::OutcomeTo<robot::WaypointReceipt> reply) override {
    asked.push_back(request);
    if (before_performing) before_performing();
    if (hold) {
      auto state = std::make_shared<robot::Call::State>();
      // Weak: a state that holds itself would never go.
      state->cancel = [this, held = std::weak_ptr(state), reply] {
        QTimer::singleShot(0, this, [held, reply] {
          if (const auto it = held.lock()) it->over = true;
          reply(tl::make_unexpected(map::Failure{map::FailureKind::Cancelled, {}, map::Applied::No}));
        });
      };
      return robot::Call(state);
    }
    std::optional<map::Failure> failure;
    if (!failures.empty()) {
      failure = failures.front();
      failures.pop_front();
    }
    if (mode_ == Mode::AllAtOnce && request.revision != std::to_string(revision))
      failure = map::Failure{map::FailureKind::Conflict};
    // A lost answer: the robot has done it.
    const bool does = !failure || (does_what_fails && failure->applied != map::Applied::No);
    robot::WaypointReceipt receipt;
    if (does) apply(request, receipt);
    return later([reply, failure, receipt] {
      if (failure) {
        reply(tl::make_unexpected(*failure));
      } else {
        reply(receipt);
      }
    });
  }
  /// Somebody else changes it.
  void put(const map::Waypoint& point) {
    remove(point.id);
    points.push_back(point);
    ++revision;
  }
  void remove(const std::string& id) {
    std::erase_if(points, [&](const map::Waypoint& one) { return one.id == id; });
    ++revision;
  }
  const map::Waypoint* find(const std::string& name) const {
    const auto found =
        std::find_if(points.begin(), points.end(), [&](const auto& one) { return one.name == name; });
    return found == points.end() ? nullptr : &*found;
  }

  std::vector<map::Waypoint> points;
  robot::KeptFields kept_fields;
  std::set<std::string> zero_turns;  // ids
  int revision = 1, reads = 0;
  map::MapKey read_of;  // the last one
  bool hold = false, unreadable = false;
  bool slow = false;  // reading ends when the test calls its answer
  std::vector<std::function<void()>> answers;
  bool is_called = false;             // its requests are calls of services
  int readable = 1'000'000;           // times
  bool there = true;                  // the list, be it empty
  std::deque<map::Failure> failures;  // of the next requests
  bool does_what_fails = true;        // where the failure says that it may have been done
  std::vector<robot::WaypointRequest> asked;
  std::function<void()> before_performing;

 private:
  template <typename Then>
  robot::Call later(Then then) {
    auto state = std::make_shared<robot::Call::State>();
    QTimer::singleShot(0, this, [state, then] {
      state->over = true;
      then();
    });
    return robot::Call(state);
  }
  void apply(const robot::WaypointRequest& request, robot::WaypointReceipt& receipt) {
    std::unordered_map<std::string, map::Waypoint> made;  // thousands at once cost no more than each
    std::unordered_set<std::string> gone;
    for (const auto& change : request.changes) {
      gone.insert(change.id);
      if (!change.after) continue;
      map::Waypoint point = *change.after;
      point.id = change.id;
      if (!kept_fields.type) point.type.clear();
      if (!kept_fields.no_heading) point.yaw_rad = point.yaw_rad.value_or(0);
      if (!change.before && mode_ == Mode::OneByOne) {
        point.id = "robot-" + std::to_string(++last_id_);
        receipt.ids[change.id] = point.id;
      }
      made.emplace(point.id, std::move(point));
    }
    std::erase_if(points, [&](const map::Waypoint& one) { return gone.contains(one.id); });
    for (auto& [id, point] : made) points.push_back(std::move(point));
    ++revision;
  }
  Mode mode_;
  int last_id_ = 0;
};

}  // namespace mapwright::test
