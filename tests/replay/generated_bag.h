// Bags made up at random, and a library that plays them as robots do.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>

#include "map/world.h"
#include "robot/bag_library.h"

namespace mapwright::replay {

struct Recorded {
  double stamp_s = 0;
  std::string topic;
  map::TopicMessage message;
  bool latched = false, known = true;
  std::string picture_url = {};
};
using Bag = std::vector<Recorded>;  // in the order of the file

struct BagWish {
  double start_s = 1'717'405'200.25;
  int messages = 2000;
  bool jumps_back = false;  // the clock is set back now and then
  bool duplicate_stamps = false;
  std::uint32_t seed = 1;
};

inline Bag makeBag(const BagWish& wish) {
  using namespace map;
  std::mt19937 random(wish.seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  const auto number = [&](int below) { return int(random() % unsigned(below)); };
  Bag bag;
  double stamp_s = wish.start_s, x_m = 0, y_m = 0;
  const auto add = [&](const char* topic, TopicMessage message, bool latched = false, bool known = true) {
    bag.push_back({stamp_s, topic, std::move(message), latched, known, {}});
  };
  for (int i = 0; i < wish.messages; ++i) {
    if (!(wish.duplicate_stamps && chance(40))) stamp_s += double(1 + number(200)) / 1000;
    if (wish.jumps_back && chance(1)) stamp_s -= number(60);
    if (chance(1)) stamp_s += number(40);  // gaps
    if (chance(60)) {
      x_m += double(number(200) - 80) / 1000;
      y_m += chance(1) ? 5 : 0.01;
      add("/tracked_pose", TrackedPose{{x_m, y_m, double(number(6))}});
      continue;
    }
    switch (number(18)) {
      case 0: {
        SubmapList list;
        list.uuid = chance(90) ? "session-" + std::to_string(i / 700) : chance(50) ? "" : "other";
        list.slam_state = chance(50) ? SlamState::Slam : SlamState::Positioning;
        for (int n = 0; n < 60; ++n) list.entries.push_back({{0, n}, i, {}, false, false, false});
        add("/submap_list", list);
        break;
      }
      case 1: {
        MapInfo info;
        info.name = "map " + std::to_string(number(2));
        info.uid = chance(70) ? "uid-" + std::to_string((i / 500) % 2) : "";
        info.map_version = i;
        add("/map/info", info, true);
        break;
      }
      case 2: {
        AlertsMessage alerts;
        for (int n = number(3); n > 0; --n) {
          // Two that look the same but for their numbers, and numbers that move.
          alerts.alerts.push_back({6000 + number(2), chance(50) ? AlertLevel::Error : AlertLevel::Warning,
                                   "Motor " + std::to_string(number(3)) + " is hot", 0});
        }
        add("/alerts", alerts, true);
        break;
      }
      case 3:
        add("/wheel_state", WheelState{chance(80) ? "auto" : "manual", chance(30), chance(20)});
        break;
      case 4:
      case 5: {
        SlamStatus slam;
        slam.state = chance(80) ? "positioning" : "slam";
        slam.position_quality = chance(70) ? 10 : number(9);
        slam.reliable = chance(90);
        slam.lidar_matching_score = double(number(100)) / 100;
        add("/slam/state", slam);
        break;
      }
      case 6: {
        GridMessage grid;
        grid.kind = chance(50) ? GridKind::WholeMap : GridKind::CostmapLow;
        grid.topic = grid.kind == GridKind::WholeMap ? (chance(50) ? "/map" : "/map_v2") : "/map/costmap_v2";
        grid.png =
            std::make_shared<const std::string>(std::size_t(chance(50) ? 10 : 5000), char('a' + i % 26));
        add(grid.topic.c_str(), grid);
        break;
      }
      case 7: {
        const char* topic = chance(70) ? "/scan_matched_points2" : "/semantic_points";
        auto points = std::make_shared<std::vector<CloudPoint>>();
        for (int n = chance(50) ? 3 : 300; n > 0; --n) points->push_back({double(n), double(i), 0, 1});
        add(topic, PointCloudMessage{topic, points});
        break;
      }
      case 8: {
        PathMessage path;
        for (int n = chance(80) ? 4 : 500; n > 0; --n) path.points.push_back({double(n), double(i)});
        add("/path", path, true);
        break;
      }
      case 9: {
        PlanningState planning;
        planning.move_state = chance(50) ? "moving" : "idle";
        planning.targets.push_back({double(i), 1, 0});
        planning.remaining_distance_m = i;
        add("/planning_state", planning, true);
        break;
      }
      case 10:
        add("/battery_state", BatteryState{double(number(100)) / 100, 24.0, {}, "discharging"});
        break;
      case 11: {
        NearbyFootprintsMessage nearby;
        nearby.by_digest["digest " + std::to_string(number(4))] = {{double(number(3)), 1}};
        add("/nearby_robot_footprints", nearby, true);
        break;
      }
      case 12:
        add("/landmarks", LandmarksMessage{{Landmark{"L" + std::to_string(i), {1, double(i)}, false}}});
        break;
      case 13: {
        GlobalPositioning positioning;
        positioning.state = "done " + std::to_string(i);
        positioning.pose = geometry::Pose2{double(i), 0, 0};
        add("/global_positioning_state", positioning);
        break;
      }
      case 14:
        add("/collected_barcode", BarcodeMessage{"ok", std::to_string(i), geometry::Pose2{1, double(i), 0}});
        break;
      case 15: {
        if (chance(40)) {
          add("/odd_state", UnreadableMessage{"/odd_state", {}}, true, false);
        } else if (chance(50)) {
          DetectedFeaturesMessage seen;
          seen.kind = chance(50) ? BoxKind::Rack : BoxKind::Charger;
          seen.boxes.push_back({"R" + std::to_string(i), {1, double(i), 0}, 1, 1});
          add(seen.kind == BoxKind::Rack ? "/detected_features/racks_v2" : "/detected_features/chargers",
              seen, true);
        } else if (chance(50)) {
          add("/jack_state", JackState{"hold", double(number(100)) / 100, false, double(i)}, true);
        } else {
          add("/towing_state", TowingState{chance(50) ? "locked" : "released", 1.0, chance(50)}, true);
        }
        break;
      }
      case 16:
        add("/robot_model", RobotModel{{{1, 1}, {2, double(i)}}, {}, 0.5}, true);
        break;
      default:
        add("/constraint_list", ConstraintsMessage{{{"all", {{{0, 0}, {1, double(i)}}}}}});
        break;
    }
  }
  return bag;
}

/// What playing makes of it at each of `times`: every message up to then, one after the other.
inline std::vector<map::World> foldedAt(const Bag& bag, const std::vector<double>& times) {
  std::vector<const Recorded*> played;
  for (const Recorded& each : bag) {
    if (each.known) played.push_back(&each);
  }
  std::stable_sort(played.begin(), played.end(),
                   [](const Recorded* a, const Recorded* b) { return a->stamp_s < b->stamp_s; });
  std::vector<std::size_t> earliest_first(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) earliest_first[i] = i;
  std::sort(earliest_first.begin(), earliest_first.end(),
            [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
  std::vector<map::World> worlds(times.size());
  map::World world;
  auto next = played.begin();
  for (const std::size_t which : earliest_first) {
    for (; next != played.end() && (*next)->stamp_s <= times[which]; ++next)
      world = map::reduce(std::move(world), {(*next)->message, (*next)->stamp_s, {}, (*next)->topic});
    worlds[which] = world;
  }
  return worlds;
}

inline map::World foldedUntil(const Bag& bag, double at_s) { return foldedAt(bag, {at_s}).front(); }

inline std::map<std::string, double> topicsUntil(const Bag& bag, double at_s) {
  std::map<std::string, double> last;
  for (const Recorded& each : bag) {
    if (each.stamp_s > at_s) continue;
    const auto [known, is_new] = last.try_emplace(each.topic, each.stamp_s);
    if (!is_new) known->second = std::max(known->second, each.stamp_s);
  }
  return last;
}

/// Answers from its event loop, like a robot far away; what is asked is counted.
class BagRobot : public QObject, public robot::BagLibrary {
 public:
  explicit BagRobot(Bag bag) : bag_(std::move(bag)) {}

  bool end_inclusive = false, refuses_beyond = false, repeats_at_borders = false;
  std::size_t most_messages = 1'000'000;  // in an answer; more are "too long"
  int fail_next = 0;                      // so many requests fail
  std::string busy_code;                  // with this answer of the robot; empty = without one
  std::vector<double> damaged_s;          // ranges that contain one of these stamps are refused
  std::string damaged_code = "400";       // with this answer
  int asked = 0, at_once = 0, most_at_once = 0, cancelled = 0;
  bool holds_back = false;  // answers nothing until release()
  int answers_first = 0;    // which it answers all the same, if it holds back
  std::vector<robot::BagRange> ranges;

  robot::BagInfo infoOf() const {
    if (bag_.empty()) return {};
    return {std::int64_t(bag_.size()), std::floor(bag_.front().stamp_s), std::floor(bag_.back().stamp_s)};
  }

  robot::Call list(robot::OutcomeTo<std::vector<robot::BagEntry>> reply) override {
    later([reply] { reply(std::vector<robot::BagEntry>()); });
    return {};
  }
  robot::Call info(const robot::BagKey&, robot::OutcomeTo<robot::BagInfo> reply) override {
    later([this, reply] { reply(infoOf()); });
    return {};
  }
  robot::Call picture(const std::string& topic, const std::string& url,
                      robot::OutcomeTo<std::shared_ptr<const std::string>> reply) override {
    later([topic, url, reply] {
      if (url.empty() || url == "gone") {
        reply(tl::make_unexpected(
            map::Failure{.subject = map::Subject(map::SubjectKind::Topic, topic), .detail = "gone"}));
      } else {
        reply(std::make_shared<const std::string>("picture at " + url));
      }
    });
    return {};
  }
  robot::Call record(const robot::BagOrder&, robot::OutcomeTo<robot::BagEntry>) override { return {}; }
  robot::Call remove(const robot::BagKey&, robot::OutcomeTo<robot::BagKey>) override { return {}; }
  robot::Call download(const robot::BagKey&, const QString&, robot::OutcomeTo<robot::BagDownload>) override {
    return {};
  }
  robot::Call messages(const robot::BagKey& key, const robot::BagRange& range,
                       robot::OutcomeTo<robot::BagChunkPtr> reply) override {
    ++asked;
    ranges.push_back(range);
    most_at_once = std::max(most_at_once, ++at_once);
    auto state = std::make_shared<robot::Call::State>();
    const auto counted = std::make_shared<bool>(true);
    const auto leave = [this, counted] {
      if (std::exchange(*counted, false)) --at_once;
    };
    const auto end = [state, leave, reply](const robot::Outcome<robot::BagChunkPtr>& outcome) {
      if (std::exchange(state->over, true)) return;
      leave();
      reply(outcome);
    };
    // Not with `end`: a state that holds itself would never go.
    state->cancel = [this, key, leave, reply, weak = std::weak_ptr(state)] {
      ++cancelled;
      leave();
      later([weak, key, reply] {
        const auto still = weak.lock();
        if (!still || std::exchange(still->over, true)) return;
        reply(tl::make_unexpected(
            map::Failure{.kind = map::FailureKind::Cancelled, .subject = robot::subjectOf(key)}));
      });
    };
    const auto answer = [this, key, range, end] { end(outcomeOf(key, range)); };
    if (holds_back && answers_first-- <= 0) {
      waiting_.push_back(answer);
    } else {
      later(answer);
    }
    return robot::Call(state);
  }
  void release() {
    holds_back = false;
    for (auto& answer : std::exchange(waiting_, {})) later(answer);
  }

 private:
  template <typename Job>
  void later(Job job) {
    QMetaObject::invokeMethod(this, std::move(job), Qt::QueuedConnection);
  }

  robot::Outcome<robot::BagChunkPtr> outcomeOf(const robot::BagKey& key, const robot::BagRange& range) {
    const auto fail = [&](map::FailureKind kind, Fault cause = {}) {
      return tl::make_unexpected(
          map::Failure{.kind = kind, .subject = robot::subjectOf(key), .cause = std::move(cause)});
    };
    if (fail_next > 0 && fail_next-- > 0) {
      if (busy_code.empty()) return fail(map::FailureKind::TimedOut);
      return tl::make_unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                                              .subject = robot::subjectOf(key),
                                              .robot_code = busy_code});
    }
    const bool damaged = std::any_of(damaged_s.begin(), damaged_s.end(),
                                     [&](double s) { return s >= range.from_s && s < range.until_s; });
    if (damaged)
      return tl::make_unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot,
                                              .subject = robot::subjectOf(key),
                                              .robot_code = damaged_code,
                                              .detail = "The bag is corrupted."});
    const robot::BagInfo told = infoOf();
    const double first_s = std::min(told.start_s, told.end_s), last_s = std::max(told.start_s, told.end_s);
    if (refuses_beyond && (range.from_s > last_s || range.until_s <= first_s))
      return fail(map::FailureKind::RejectedByRobot);
    auto chunk = std::make_shared<robot::BagChunk>();
    chunk->from_s = range.from_s;
    chunk->until_s = range.until_s;
    std::string text;
    const auto add = [&](std::size_t which) {
      const Recorded& each = bag_[which];
      robot::BagMessage message;
      message.message = {each.message, each.stamp_s, {}, each.topic};
      message.known = each.known;
      message.latched = each.latched;
      message.picture_url = each.picture_url;
      message.at = text.size();
      text += std::to_string(which);
      message.size = text.size() - message.at;
      chunk->messages.push_back(std::move(message));
    };
    std::map<std::string_view, std::size_t> latched;  // last before the range, by stamp
    for (std::size_t i = 0; i < bag_.size(); ++i) {
      const bool before =
          repeats_at_borders ? bag_[i].stamp_s <= range.from_s : bag_[i].stamp_s < range.from_s;
      if (!bag_[i].latched || !before) continue;
      const auto [known, is_new] = latched.try_emplace(bag_[i].topic, i);
      if (!is_new && bag_[known->second].stamp_s <= bag_[i].stamp_s) known->second = i;
    }
    for (const auto& [topic, which] : latched) add(which);
    for (std::size_t i = 0; i < bag_.size(); ++i) {
      const double s = bag_[i].stamp_s;
      if (s >= range.from_s && (end_inclusive ? s <= range.until_s : s < range.until_s)) add(i);
    }
    if (chunk->messages.size() > most_messages)
      return fail(map::FailureKind::MalformedAnswer, {fault::AnswerTooLong, {"1"}});
    chunk->text = std::make_shared<const std::string>(std::move(text));
    return robot::BagChunkPtr(std::move(chunk));
  }

  Bag bag_;
  std::vector<std::function<void()>> waiting_;
};

}  // namespace mapwright::replay
