#include "simulator/bag_recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "simulator/json_text.h"
#include "simulator/live_topics.h"
#include "simulator/noise.h"
#include "simulator/point_topics.h"
#include "simulator/stamp.h"
#include "simulator/topic_messages.h"

namespace mapwright::simulator {
namespace {

constexpr int kPointsPerScan = 360;
constexpr double kScanS = 1, kEveryScanS = 0.2;
constexpr std::int64_t kSetBackMs = 120'000, kSilentS = 30;

enum class Rhythm { Again, Once, WhenNew };

struct Recorded {
  std::string_view topic;
  double period_s;  // of looking
  Rhythm rhythm;
  bool latched;
};
constexpr std::string_view kScans = "/scan_matched_points2";
constexpr std::string_view kSubmaps = kSubmapListTopic;
constexpr std::array<Recorded, 19> kRecorded{{{"/map/info", 1, Rhythm::Once, true},
                                              {"/robot_model", 1, Rhythm::Once, true},
                                              {"/sensor_manager_state", 1, Rhythm::Once, true},
                                              {"/tracked_pose", 0.1, Rhythm::Again, false},
                                              {kScans, kScanS, Rhythm::Again, false},
                                              {"/slam/state", 1, Rhythm::Again, false},
                                              {"/planning_state", 1, Rhythm::Again, true},
                                              {"/path", 5, Rhythm::Again, true},
                                              {"/local_path", 0.5, Rhythm::Again, true},
                                              {"/trajectory", 10, Rhythm::Again, false},
                                              {"/alerts", 1, Rhythm::WhenNew, true},
                                              {"/battery_state", 1, Rhythm::Again, false},
                                              {"/wheel_state", 1, Rhythm::Again, false},
                                              {"/nearby_robots", 0.5, Rhythm::Again, false},
                                              {"/nearby_robot_footprints", 30, Rhythm::Again, true},
                                              {"/landmarks", 30, Rhythm::Again, false},
                                              {"/nearby_auto_doors", 1, Rhythm::WhenNew, false},
                                              {"/detected_pallets", 1, Rhythm::WhenNew, false},
                                              {kSubmaps, 10, Rhythm::Again, false}}};

std::string contentOf(std::string_view topic, const RobotState& then, const std::optional<StoredMap>& map,
                      std::uint32_t seed) {
  if (topic == kScans) return scanMessage(then, kPointsPerScan, seed);
  if (std::optional<std::string> own = ownTopic(topic, then, map)) return std::move(*own);
  return surroundingsTopic(topic, then).value_or(std::string());
}

/// What its SLAM has is asked of the robot itself, whenever a bag is looked at: so bags list what it has from
/// its start on.
std::string submapsOf(const RobotState& state) {
  map::SubmapList list = state.recordedAt(0).list();
  std::erase_if(list.entries, [&](const auto& entry) { return !state.find(entry.id); });
  return submapListJson(list);
}

std::int64_t stampMs(double time_s) { return std::llround(1000 * stampOf(time_s)); }
double timeOf(std::int64_t stamp_ms) { return static_cast<double>(stamp_ms) / 1000 - stampOf(0); }

}  // namespace

BagRecording::BagRecording(const RobotState& state, std::optional<StoredMap> map, std::uint32_t seed,
                           BagSpan span)
    : state_(state), map_(std::move(map)), seed_(seed) {
  for (std::size_t topic = 0; topic < kRecorded.size(); ++topic) {
    const Recorded& recorded = kRecorded[topic];
    const double period_s = recorded.topic == kScans && span.every_scan ? kEveryScanS : recorded.period_s;
    // What comes once comes when the recording begins.
    const double phase_s = recorded.rhythm == Rhythm::Again ? period_s * unitFrom(hashOf(seed, 71, topic))
                                                            : 0.01 + 0.003 * double(topic);
    std::string last;
    for (int i = 0; span.from_s + phase_s + i * period_s < span.until_s; ++i) {
      const std::int64_t at_ms = stampMs(span.from_s + phase_s + i * period_s);
      const Tick tick{at_ms, at_ms, topic};
      if (recorded.rhythm != Rhythm::Again || i == 0) {
        std::string now = recorded.topic == kSubmaps
                              ? submapsOf(state)
                              : contentOf(recorded.topic, state.recordedAt(timeOf(tick.true_ms)), map_, seed);
        if (now.empty()) break;  // a robot that has no such topic
        if (i > 0 && now == last) continue;
        last = std::move(now);
      }
      ticks_.push_back(tick);
      if (recorded.rhythm == Rhythm::Once) break;
    }
  }
  std::stable_sort(ticks_.begin(), ticks_.end(),
                   [](const Tick& a, const Tick& b) { return a.true_ms < b.true_ms; });
  apply(span.quirk);
}

void BagRecording::apply(BagQuirk quirk) {
  const std::size_t middle = ticks_.size() / 2;
  switch (quirk) {
    case BagQuirk::None:
      break;
    case BagQuirk::ClockSetBack:
      for (std::size_t i = middle; i < ticks_.size(); ++i) ticks_[i].stamp_ms -= kSetBackMs;
      break;
    case BagQuirk::SameStamps:
      for (Tick& tick : ticks_) tick.stamp_ms -= tick.stamp_ms % 500;
      break;
    case BagQuirk::Gap:
      ticks_.erase(ticks_.begin() + std::ptrdiff_t(ticks_.size() * 2 / 5),
                   ticks_.begin() + std::ptrdiff_t(ticks_.size() * 3 / 5));
      break;
    case BagQuirk::EndsLate:
      silent_s_ = kSilentS;
      break;
    case BagQuirk::OneMessage:
      ticks_.resize(std::min<std::size_t>(ticks_.size(), 1));
      break;
    case BagQuirk::Empty:
      ticks_.clear();
      break;
  }
}

std::int64_t BagRecording::startTime() const { return ticks_.empty() ? 0 : ticks_.front().stamp_ms / 1000; }

std::int64_t BagRecording::endTime() const {
  return ticks_.empty() ? 0 : ticks_.back().stamp_ms / 1000 - silent_s_;
}

std::string BagRecording::textOf(const Tick& tick) const {
  const Recorded& recorded = kRecorded[tick.topic];
  std::string text = recorded.topic == kSubmaps
                         ? submapsOf(state_)
                         : contentOf(recorded.topic, state_.recordedAt(timeOf(tick.true_ms)), map_, seed_);
  text.pop_back();  // the closing brace
  text += ",\"__stamp\":";
  appendJsonFixed(text, static_cast<double>(tick.stamp_ms) / 1000, 3);
  return text + (recorded.latched ? ",\"__latched\":true}" : ",\"__latched\":false}");
}

std::string BagRecording::messagesJson(double from, double until, End end) const {
  std::array<const Tick*, kRecorded.size()> last{};
  std::vector<const Tick*> wanted;
  for (const Tick& tick : ticks_) {
    const double stamp = static_cast<double>(tick.stamp_ms) / 1000;
    if (stamp > until || (stamp == until && end == End::Exclusive)) continue;
    if (stamp >= from) {
      wanted.push_back(&tick);
    } else if (kRecorded[tick.topic].latched) {
      const Tick*& known = last[tick.topic];
      if (known == nullptr || known->stamp_ms <= tick.stamp_ms) known = &tick;
    }
  }
  std::vector<const Tick*> all;
  for (const Tick* tick : last) {
    if (tick != nullptr) all.push_back(tick);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Tick* a, const Tick* b) { return a->stamp_ms < b->stamp_ms; });
  all.insert(all.end(), wanted.begin(), wanted.end());
  std::string out = "[";
  for (const Tick* tick : all) {
    if (out.size() > 1) out += ',';
    out += textOf(*tick);
  }
  return out + "]";
}

}  // namespace mapwright::simulator
