#include "simulator/bags.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/axbot_routes.h"
#include "simulator/noise.h"
#include "simulator/simulator.h"
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
constexpr std::string_view kMapImage = "/map_image";
constexpr std::array<Recorded, 25> kRecorded{{{"/map/info", 1, Rhythm::Once, true},
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
                                              {kSubmapListTopic, 10, Rhythm::Again, false},
                                              // In one of all that robots latch.
                                              {kMapImage, 1, Rhythm::Once, true},
                                              {"/detected_features/racks_v2", 1, Rhythm::Once, true},
                                              {"/detected_features/pallets", 1, Rhythm::Once, true},
                                              {"/detected_features/chargers", 1, Rhythm::Once, true},
                                              {"/jack_state", 1, Rhythm::Once, true},
                                              {"/towing_state", 1, Rhythm::Once, true}}};
constexpr std::size_t kUsualTopics = 19;

/// Of the topics after the usual ones.
std::string latchedContent(std::string_view topic, const MapPicturePtr& picture) {
  Value::Object message{{"topic", topic}};
  const auto thing = [](double x, double y, double yaw) {
    return Value::Object{{"frame", "map"},
                         {"pose", Value::Object{{"pos", Value::List{x, y}}, {"ori", yaw}}},
                         {"size", Value::Object{{"width", 0.8}, {"depth", 1.2}}}};
  };
  if (topic == kMapImage) {
    if (!picture) return {};
    message.emplace_back("resolution", picture->resolution_m);
    message.emplace_back("size", Value::List{picture->width, picture->height});
    message.emplace_back("origin", Value::List{picture->origin_m.x(), picture->origin_m.y()});
    message.emplace_back("data", Value::Bytes{*picture->png});
  } else if (topic == "/jack_state") {
    message.emplace_back("state", "hold");
    message.emplace_back("progress", 0.35);
    message.emplace_back("self_checking", false);
    message.emplace_back("weight", 120);
  } else if (topic == "/towing_state") {
    message.emplace_back("state", "locked");
    message.emplace_back("action_progress", 1.0);
    message.emplace_back("cargo_detected", true);
    message.emplace_back("error_code", 0);
    message.emplace_back("error_message", "");
  } else if (topic.ends_with("racks_v2")) {
    message.emplace_back("racks", Value::List{thing(3, 2, 0), thing(5, 2, 1.5)});
  } else if (topic.ends_with("pallets")) {
    message.emplace_back("pallets", Value::List{thing(4, 3, 0)});
  } else {
    message.emplace_back("poses", Value::List{Value::Object{{"pos", Value::List{1.0, 1.0}}, {"ori", 0.5}}});
  }
  return toJson(message);
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

/// The content of a bag: the robot's own topics at their times. A pure function of scene, seed and time span:
/// later edits do not change the past.
class BagRecording {
 public:
  /// `state` is only used for its past; `map` is the robot's map at that time.
  BagRecording(const RobotState& state, std::optional<StoredMap> map, MapPicturePtr picture,
               std::uint32_t seed, BagSpan span)
      : state_(state), map_(std::move(map)), picture_(std::move(picture)), seed_(seed) {
    const std::size_t topics = span.quirk == BagQuirk::Latched ? kRecorded.size() : kUsualTopics;
    for (std::size_t topic = 0; topic < topics; ++topic) {
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
          std::string now = contentAt(tick);
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

  std::size_t messages() const { return ticks_.size(); }
  /// Of the first and the last message, in whole seconds of the epoch as these robots give it: the last
  /// message may be after endTime().
  std::int64_t startTime() const { return ticks_.empty() ? 0 : ticks_.front().stamp_ms / 1000; }
  std::int64_t endTime() const { return ticks_.empty() ? 0 : ticks_.back().stamp_ms / 1000 - silent_s_; }

  /// Whether a range contains what cannot be read.
  bool isDamaged(double from, double until) const {
    const double damaged = static_cast<double>(damaged_ms_) / 1000;
    return damaged_ms_ > 0 && from <= damaged && damaged <= until;
  }

  /// A JSON list of the messages in [from, until] (epoch seconds; without its end if asked so), preceded by
  /// the last one of each latched topic. Only these are generated.
  std::string messagesJson(double from, double until, bool without_end) const {
    std::array<const Tick*, kRecorded.size()> last{};
    std::vector<const Tick*> wanted;
    for (const Tick& tick : ticks_) {
      const double stamp = static_cast<double>(tick.stamp_ms) / 1000;
      if (stamp > until || (stamp == until && without_end)) continue;
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

 private:
  struct Tick {
    std::int64_t stamp_ms = 0;  // of the epoch, by the robot's clock
    std::int64_t true_ms = 0;   // as it was
    std::size_t topic = 0;
  };

  void apply(BagQuirk quirk) {
    const auto at = [&](std::size_t fifths) {
      return ticks_.begin() + static_cast<std::ptrdiff_t>(ticks_.size() * fifths / 5);
    };
    const std::size_t middle = ticks_.size() / 2;
    if (quirk == BagQuirk::ClockSetBack) {
      for (std::size_t i = middle; i < ticks_.size(); ++i) ticks_[i].stamp_ms -= kSetBackMs;
    }
    if (quirk == BagQuirk::SameStamps) {
      for (Tick& tick : ticks_) tick.stamp_ms -= tick.stamp_ms % 500;
    }
    if (quirk == BagQuirk::Gap) ticks_.erase(at(2), at(3));
    if (quirk == BagQuirk::EndsLate) silent_s_ = kSilentS;
    if (quirk == BagQuirk::OneMessage) ticks_.resize(std::min<std::size_t>(ticks_.size(), 1));
    if (quirk == BagQuirk::Empty) ticks_.clear();
    if (quirk == BagQuirk::Damaged || quirk == BagQuirk::Unreadable) damaged_ms_ = ticks_[middle].stamp_ms;
  }

  std::string contentAt(const Tick& tick) const {
    const std::string_view topic = kRecorded[tick.topic].topic;
    if (tick.topic >= kUsualTopics) return latchedContent(topic, picture_);
    if (topic == kSubmapListTopic) return submapsOf(state_);
    const RobotState then = state_.recordedAt(timeOf(tick.true_ms));
    if (topic == kScans) return scanMessage(then, kPointsPerScan, seed_);
    return liveMessage(topic, then, map_).value_or(std::string());
  }

  std::string textOf(const Tick& tick) const {
    const Recorded& recorded = kRecorded[tick.topic];
    std::string text = contentAt(tick);
    text.pop_back();  // the closing brace
    text += ",\"__stamp\":";
    appendJsonNumber(text, static_cast<double>(tick.stamp_ms) / 1000, 3);
    return text + (recorded.latched ? ",\"__latched\":true}" : ",\"__latched\":false}");
  }

  const RobotState& state_;
  const std::optional<StoredMap> map_;
  const MapPicturePtr picture_;
  const std::uint32_t seed_;
  std::vector<Tick> ticks_;      // as recorded
  std::int64_t silent_s_ = 0;    // after the stated end
  std::int64_t damaged_ms_ = 0;  // of the epoch; 0: it is sound
};

namespace {

constexpr double kBagS = 600;
constexpr double kFirstBagS = -3 * kBagS;  // the robot was on before its world begins
constexpr double kKeptBags = 12;
constexpr double kCorruptBagS = -60 * kBagS;
struct OddBag {
  const char* name;
  double long_s;
  BagQuirk quirk;
};
constexpr OddBag kOddBags[] = {{"eight_hours.bag", 8 * 3600, BagQuirk::None},
                               {"clock_set_back.bag", kBagS, BagQuirk::ClockSetBack},
                               {"same_stamps.bag", kBagS, BagQuirk::SameStamps},
                               {"gap.bag", kBagS, BagQuirk::Gap},
                               {"ends_late.bag", kBagS, BagQuirk::EndsLate},
                               {"one_message.bag", kBagS, BagQuirk::OneMessage},
                               {"empty.bag", kBagS, BagQuirk::Empty},
                               {"damaged.bag", kBagS, BagQuirk::Damaged},
                               {"unreadable.bag", kBagS, BagQuirk::Unreadable},
                               {"uncounted.bag", kBagS, BagQuirk::Uncounted},
                               {"latched.bag", kBagS, BagQuirk::Latched}};
constexpr std::size_t kBagHeaderBytes = 4096;
constexpr const char* kMonths[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                   "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

/// Bags are named after when they begin.
Bag bagFrom(double from_s, BagCondition condition) {
  return {dateOf(from_s, "%Y-%m-%d_%H-%M-%S.bag"), {from_s, from_s + kBagS, false}, condition};
}

/// Recordings are named after when they end, with a space and colons.
Bag recordingUntil(double until_s, double duration_s, std::string_view suffix, bool every_scan) {
  std::string name = dateOf(until_s, "%Y-%m-%d %H:%M:%S");
  if (!suffix.empty()) name.append("_").append(suffix);
  return {name + ".bag", {until_s - duration_s, until_s, every_scan}, BagCondition::Whole};
}

template <typename Number>
void appendField(std::string& out, std::string_view name, Number number) {
  appendNumber(out, static_cast<std::uint32_t>(name.size() + 1 + sizeof(number)));
  out.append(name).append("=");
  appendNumber(out, number);
}

/// "31-Oct-2023 14:36:17" of a simulated second, in English everywhere.
std::string listedTime(double time_s) {
  const int month = std::stoi(dateOf(time_s, "%m"));
  return dateOf(time_s, "%d-") + kMonths[month - 1] + dateOf(time_s, "-%Y %H:%M:%S");
}

/// "6.8KB".
std::string listedSize(std::size_t bytes) {
  const std::size_t tenths = (10 * bytes + 512) / 1024;
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + "KB";
}

/// A ROS bag without messages; half of it if the bag is damaged.
std::string bagBytes(const Bag& bag) {
  constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
  std::string fields;
  appendField(fields, "op", std::uint8_t{3});
  appendField(fields, "index_pos", std::uint64_t{kMagic.size() + kBagHeaderBytes});
  appendField(fields, "conn_count", std::uint32_t{0});
  appendField(fields, "chunk_count", std::uint32_t{0});
  std::string bytes(kMagic);
  appendNumber(bytes, static_cast<std::uint32_t>(fields.size()));
  bytes += fields;
  // The header record is filled up with spaces, so that a recorder can write it anew in its place.
  const std::size_t padding = kBagHeaderBytes - 8 - fields.size();
  appendNumber(bytes, static_cast<std::uint32_t>(padding));
  bytes += std::string(padding, ' ');
  if (bag.condition == BagCondition::Corrupt) bytes.resize(bytes.size() / 2);
  return bytes;
}

constexpr double kLongestRecordingS = 300, kUsualRecordingS = 120;
constexpr std::size_t kLongestSuffix = 64;

/// The player reports its errors under another name than the rest of the robot.
HttpAnswer playerError(std::string_view sentence) {
  return valueAnswer(400, Value::Object{{"error", sentence}});
}

HttpAnswer noSuchFile() { return errorAnswer(404, "There is no such file."); }

Value fileValue(BagFolder folder, const Bag& bag) {
  const std::size_t bytes = bagBytes(bag).size();
  const char* const folder_path = folder == BagFolder::Bags ? "/bags/" : "/recording/";
  return Value::Object{{"filename", bag.name},
                       {"size", listedSize(bytes)},
                       {"size_bytes", bytes},
                       {"end", listedTime(bag.span.until_s)},
                       {"download_url", ownUrl(folder_path + percentEncoded(bag.name) + "/download")}};
}

/// "90s", "2m".
std::optional<double> secondsFrom(std::string_view duration) {
  if (duration.size() < 2) return std::nullopt;
  const std::optional<int> number = numberFrom<int>(duration.substr(0, duration.size() - 1));
  const double unit_s = duration.back() == 'm' ? 60 : duration.back() == 's' ? 1 : 0;
  if (!number || *number < 1 || unit_s == 0 || *number * unit_s > kLongestRecordingS) return std::nullopt;
  return *number * unit_s;
}

bool isSuffix(std::string_view suffix) {
  return suffix.size() <= kLongestSuffix && std::all_of(suffix.begin(), suffix.end(), isWordCharacter);
}

BagFolder folderOf(const Request& request) {
  return request.question.target.starts_with("/bags") ? BagFolder::Bags : BagFolder::Recordings;
}

HttpAnswer listBags(const Robot& robot, const Request& request) {
  const BagFolder folder = folderOf(request);
  Value::List files;
  for (const Bag& bag : robot.bags.list(folder)) files.push_back(fileValue(folder, bag));
  return valueAnswer(200, files);
}

HttpAnswer deleteBags(const Robot& robot, const Request& request) {
  robot.bags.removeAll(folderOf(request));
  return emptyAnswer(204);
}

HttpAnswer record(const Robot& robot, const Request& request) {
  const RequestFields& fields = request.fields;
  const std::optional<std::string> suffix =
      fields.has("filename_suffix") ? fields.text("filename_suffix") : std::string();
  if (!suffix || !isSuffix(*suffix))
    return errorAnswer(400, "filename_suffix: must be at most 64 letters, digits, - and _.");
  const std::optional<double> duration_s =
      fields.has("duration") ? secondsFrom(fields.text("duration").value_or("")) : kUsualRecordingS;
  if (!duration_s) return errorAnswer(400, "duration: must be such as \"2m\", at most \"5m\".");
  if (fields.has("category") && fields.text("category") != "pos")
    return errorAnswer(400, "category: only \"pos\" is supported.");
  return valueAnswer(
      201, fileValue(BagFolder::Recordings, robot.bags.record(*suffix, *duration_s, fields.has("category"))));
}

std::optional<Bag> bagOf(const Robot& robot, const Request& request) {
  return robot.bags.find(folderOf(request), percentDecoded(request.name));
}

/// A route of a file, whose name the path has.
template <HttpAnswer (*kAnswer)(const Robot&, const Bag&, const Request&)>
HttpAnswer ofBag(const Robot& robot, const Request& request) {
  const std::optional<Bag> bag = bagOf(robot, request);
  return bag ? kAnswer(robot, *bag, request) : noSuchFile();
}

HttpAnswer bagDetail(const Robot&, const Bag& bag, const Request& request) {
  return valueAnswer(200, fileValue(folderOf(request), bag));
}

HttpAnswer deleteBag(const Robot& robot, const Bag& bag, const Request& request) {
  if (bag.condition == BagCondition::Recording) return errorAnswer(400, "This bag is still being recorded.");
  robot.bags.remove(folderOf(request), bag.name);
  return emptyAnswer(204);
}

HttpAnswer downloadBag(const Robot& robot, const Bag& bag, const Request& request) {
  HttpQuestion question = request.question;
  if (!robot.options.bags.ranges) question.range = {};
  HttpAnswer answer = bytesFrom(question, bagBytes(bag));
  answer.headers.emplace_back("Content-Disposition", "attachment");
  return answer;
}

HttpAnswer player(const Robot& robot, const Request& request) {
  const std::optional<Bag> bag = bagOf(robot, request);
  if (!bag) return playerError("The bag file was not found.");
  if (bag->condition == BagCondition::Corrupt)
    return playerError("The bag file is corrupted: its index is missing.");
  if (bag->condition == BagCondition::Recording) return playerError("The bag file is still being recorded.");
  const std::string_view start = queryValue(request.question.target, "start_time"),
                         end = queryValue(request.question.target, "end_time");
  const std::optional<double> from = numberFrom<double>(start), until = numberFrom<double>(end);
  const bool whole = start.empty() && end.empty();
  if (!whole) {
    if (start.empty() || end.empty()) return playerError("start_time and end_time are both required.");
    if (!from || !until || !std::isfinite(*from) || !std::isfinite(*until))
      return playerError("start_time and end_time must be numbers.");
    if (*until < *from) return playerError("end_time lies before start_time.");
  }
  const std::shared_ptr<const BagRecording> recording = robot.bags.recordingOf(*bag);
  if (!whole && recording->isDamaged(*from, *until)) {
    if (bag->span.quirk == BagQuirk::Unreadable) return errorAnswer(500, "The bag file cannot be read.");
    return playerError("The bag file is corrupted: a chunk cannot be read.");
  }
  Value body = Value::Object{{"start_time", recording->startTime()}, {"end_time", recording->endTime()}};
  if (bag->span.quirk != BagQuirk::Uncounted) body.set("total_messages", recording->messages());
  const bool without_end = robot.options.bags.end_exclusive;
  if (!whole) body.set("messages", Value::Json{recording->messagesJson(*from, *until, without_end)});
  HttpAnswer answer = valueAnswer(200, body);
  answer.headers = {{"Cache-Control", "public, max-age=2592000"}};
  return answer;
}

constexpr Route kBagRoutes[] = {{"GET", "/bags/", listBags},
                                {"DELETE", "/bags/", deleteBags},
                                {"GET", "/bags/*/player", player},
                                {"GET", "/bags/*/download", ofBag<downloadBag>},
                                {"GET", "/bags/*/", ofBag<bagDetail>},
                                {"DELETE", "/bags/*/", ofBag<deleteBag>},
                                {"GET", "/recording/", listBags},
                                {"POST", "/recording/", record, Route::Body::Json},
                                {"DELETE", "/recording/", deleteBags},
                                {"GET", "/recording/*/player", player},
                                {"GET", "/recording/*/download", ofBag<downloadBag>},
                                {"GET", "/recording/*/", ofBag<bagDetail>},
                                {"DELETE", "/recording/*/", ofBag<deleteBag>}};

}  // namespace

BagStore::BagStore(const RobotState& state, MapLibrary& library, const Options& options)
    : state_(state), library_(library), options_(options) {
  recordings_.push_back(recordingUntil(-1013, 120, "7002", true));
  Bag corrupt = recordingUntil(-86'400, 60, "1008", false);
  corrupt.condition = BagCondition::Corrupt;
  recordings_.insert(recordings_.begin(), corrupt);
}

std::vector<Bag> BagStore::bags() const {
  const double now_s = state_.time();
  const double newest_s = kBagS * std::floor(now_s / kBagS);
  std::vector<Bag> bags{bagFrom(kCorruptBagS, BagCondition::Corrupt)};
  if (options_.bags.odd) {
    for (const OddBag& odd : kOddBags)
      bags.push_back(
          {odd.name, {kFirstBagS - odd.long_s, kFirstBagS, false, odd.quirk}, BagCondition::Whole});
  }
  for (double from_s = std::max(kFirstBagS, newest_s - kKeptBags * kBagS); from_s < newest_s; from_s += kBagS)
    bags.push_back(bagFrom(from_s, BagCondition::Whole));
  bags.push_back(bagFrom(newest_s, BagCondition::Recording));
  bags.back().span.until_s = now_s;
  return bags;
}

std::vector<Bag> BagStore::list(BagFolder folder) const {
  const std::lock_guard lock(mutex_);
  if (folder == BagFolder::Recordings) return recordings_;
  std::vector<Bag> kept = bags();
  std::erase_if(kept, [&](const Bag& bag) { return removed_.contains(bag.name); });
  return kept;
}

std::optional<Bag> BagStore::find(BagFolder folder, std::string_view name) const {
  const std::vector<Bag> bags = list(folder);
  return copyOf(byName(bags, name));
}

Bag BagStore::record(std::string_view suffix, double duration_s, bool every_scan) {
  const Bag bag = recordingUntil(state_.time(), duration_s, suffix, every_scan);
  const std::lock_guard lock(mutex_);
  std::erase_if(recordings_, [&](const Bag& known) { return known.name == bag.name; });
  recordings_.push_back(bag);
  return bag;
}

void BagStore::remove(BagFolder folder, const std::string& name) {
  const std::lock_guard lock(mutex_);
  if (folder == BagFolder::Bags) {
    removed_.insert(name);
  } else {
    std::erase_if(recordings_, [&](const Bag& known) { return known.name == name; });
  }
}

void BagStore::removeAll(BagFolder folder) {
  const std::lock_guard lock(mutex_);
  if (folder == BagFolder::Recordings) recordings_.clear();
  if (folder == BagFolder::Recordings) return;
  for (const Bag& bag : bags()) {
    if (bag.condition != BagCondition::Recording) removed_.insert(bag.name);
  }
}

std::shared_ptr<const BagRecording> BagStore::recordingOf(const Bag& bag) {
  return read_.get(bag.span, [&] {
    return std::make_shared<const BagRecording>(
        state_, library_.atFirst(), bag.span.quirk == BagQuirk::Latched ? library_.livePicture() : nullptr,
        options_.seed, bag.span);
  });
}

std::span<const Route> bagRoutes() { return kBagRoutes; }

}  // namespace mapwright::simulator
