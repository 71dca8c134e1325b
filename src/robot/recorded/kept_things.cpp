#include "robot/recorded/kept_things.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "map/submap_version.h"
#include "recorder/layout.h"
#include "robot/axbot/parse_maps.h"
#include "robot/recorded/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/picture_bytes.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::recorded {
namespace {

constexpr std::uint64_t kMostKeptBytes = std::uint64_t(512) << 20;  // of one attachment
constexpr char kNumberMark = '\n';  // never part of an attachment name written by us

void readGrid(const wire::Json& facts, map::WholeMap& whole) {
  if (const auto grid = wire::member(facts, {"grid"})) {
    whole.grid.width = wire::smallInteger(*grid, {"width"}).value_or(0);
    whole.grid.height = wire::smallInteger(*grid, {"height"}).value_or(0);
    whole.grid.resolution_m = wire::number(*grid, {"resolution_m"}).value_or(0);
    whole.grid.origin = {wire::number(*grid, {"x_m"}).value_or(0), wire::number(*grid, {"y_m"}).value_or(0),
                         wire::number(*grid, {"yaw_rad"}).value_or(0)};
  }
  if (const auto reading = wire::member(facts, {"reading"})) {
    using Mode = map::CellReading::Mode;
    const std::string mode = wire::text(*reading, {"mode"});
    whole.reading.mode = mode == "trinary" ? Mode::Trinary
                         : mode == "scale" ? Mode::Scale
                         : mode == "raw"   ? Mode::Raw
                                           : Mode::Picture;
    whole.reading.negate = wire::flag(*reading, {"negate"}).value_or(false);
    whole.reading.occupied_thresh = wire::number(*reading, {"occupied_thresh"}).value_or(0.65);
    whole.reading.free_thresh = wire::number(*reading, {"free_thresh"}).value_or(0.196);
  }
}

void readThingsOn(const wire::Json& facts, map::WholeMap& whole) {
  if (const auto lines = wire::list(facts, {"trajectories"})) {
    for (const wire::Json line : *lines) whole.trajectories.push_back(wire::asPolyline(line));
  }
  if (const auto marks = wire::list(facts, {"landmarks"})) {
    for (const wire::Json mark : *marks) {
      const auto x = wire::number(mark, {"x_m"}), y = wire::number(mark, {"y_m"});
      if (x && y) whole.landmarks.push_back({wire::text(mark, {"id"}), {*x, *y}});
    }
  }
}

std::vector<map::OverlayFeature> overlaysOf(const wire::Json& places) {
  std::vector<map::OverlayFeature> overlays;
  const auto list = wire::list(places, {"overlays"});
  if (!list) return overlays;
  for (const wire::Json item : *list) {
    map::OverlayFeature feature;
    const std::string shape = wire::text(item, {"shape"});
    feature.shape = shape == "line"      ? map::OverlayShape::Line
                    : shape == "polygon" ? map::OverlayShape::Polygon
                                         : map::OverlayShape::Point;
    feature.type = wire::smallInteger(item, {"type"}).value_or(0);
    feature.id = wire::text(item, {"id"});
    feature.name = wire::text(item, {"name"});
    feature.yaw_rad = wire::number(item, {"yaw_rad"});
    if (const auto parts = wire::list(item, {"parts"})) {
      for (const wire::Json part : *parts) feature.parts.push_back(wire::asPolyline(part));
    }
    if (!feature.parts.empty() && !feature.parts.front().empty()) overlays.push_back(std::move(feature));
  }
  return overlays;
}

}  // namespace

void KeptThings::look() {
  const std::vector<recording::AttachmentLocation>& all = file_.attachments();
  if (all.size() < looked_) {
    by_name_.clear();
    submaps_.clear();
    looked_ = 0;
  }
  const auto earlier = [&](std::size_t a, std::size_t b) { return all[a].log_time_ns < all[b].log_time_ns; };
  for (; looked_ < all.size(); ++looked_) {
    Indexes& indexes = by_name_[all[looked_].name];
    indexes.insert(std::upper_bound(indexes.begin(), indexes.end(), looked_, earlier), looked_);
    if (const auto submap = recorder::submapFrom(all[looked_].name))
      submaps_[{submap->uuid, submap->id}][submap->version] = looked_;
  }
}

std::optional<std::string> KeptThings::bytesAt(std::size_t index) {
  const recording::AttachmentLocation& at = file_.attachments()[index];
  if (at.size > kMostKeptBytes) return std::nullopt;
  auto attachment = file_.attachment(at);
  if (!attachment) return std::nullopt;
  return std::move(attachment->bytes);
}

std::optional<std::string> KeptThings::lastOf(const std::string& name) {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? std::nullopt : bytesAt(found->second.back());
}

map::SubmapAnswer KeptThings::submap(const map::SubmapKey& key) {
  map::SubmapAnswer answer;
  answer.key = key;
  answer.outcome = map::SubmapAnswer::Outcome::NotFound;
  answer.reason = faultText("recorded", "The recording does not contain this submap.");
  const auto found = submaps_.find({key.uuid, key.id});
  if (found == submaps_.end()) return answer;
  auto version =
      key.version == map::kNoVersion ? found->second.end() : found->second.upper_bound(key.version);
  if (version != found->second.begin()) --version;
  const auto bytes = bytesAt(version->second);
  if (!bytes) {
    answer.outcome = map::SubmapAnswer::Outcome::Failed;
    answer.reason = {fault::RecordingFileInItCorrupt, {file_.attachments()[version->second].name}};
    answer.failure = map::FailureKind::MalformedAnswer;
    return answer;
  }
  answer = axbot::parseSubmapResponse(key, *bytes);
  if (answer.version == 0) answer.version = version->first;
  answer.from_cache = true;  // and nothing newer will come
  return answer;
}

Outcome<map::WholeMap> KeptThings::wholeMap(const map::MapKey& key) {
  const std::string name = recorder::mapName(key), facts_name = recorder::mapFactsName(key);
  const map::Subject subject = map::subjectOf(key);
  if (!by_name_.contains(name)) return fail(wire::notThere(subject));
  auto picture = lastOf(name);
  if (!picture) return fail(wire::unfit(subject, {fault::RecordingFileInItCorrupt, {name}}));
  map::WholeMap whole;
  whole.key = key;
  whole.fingerprint = wire::fingerprint(*picture);
  whole.body_bytes = picture->size();
  whole.from_cache = true;
  whole.bytes = std::make_shared<const std::string>(std::move(*picture));
  wire::JsonReader json;
  const std::string text = lastOf(facts_name).value_or(std::string());
  const auto facts = json.read(text);
  if (!facts || !facts->is_object())
    return fail(wire::unfit(subject, {fault::RecordingFileInItCorrupt, {facts_name}}));
  whole.name = wire::text(*facts, {"name"});
  readGrid(*facts, whole);
  if (auto why = map::unusableReason(whole.grid)) return fail(wire::unfit(subject, std::move(*why)));
  whole.display_rotation_rad = wire::number(*facts, {"display_rotation_rad"});
  readThingsOn(*facts, whole);
  const std::string places = lastOf(recorder::waypointsName(key)).value_or(std::string());
  if (const auto list = json.read(places); list && list->is_object()) whole.overlays = overlaysOf(*list);
  return whole;
}

Outcome<map::WaypointList> KeptThings::waypoints(const map::MapKey& key) {
  const std::string name = recorder::waypointsName(key);
  const map::Subject subject = map::placesOf(key);
  if (!by_name_.contains(name)) return fail(wire::notThere(subject));
  const std::string text = lastOf(name).value_or(std::string());
  wire::JsonReader json;
  const auto root = json.readKeepingDigits(text);
  const auto rows = root ? wire::list(*root, {"waypoints"}) : std::nullopt;
  if (!rows) return fail(wire::unfit(subject, {fault::RecordingFileInItCorrupt, {name}}));
  map::WaypointList list;
  for (const wire::Json row : *rows) {
    const auto x = wire::number(row, {"x_m"}), y = wire::number(row, {"y_m"});
    if (!x || !y) continue;
    map::Waypoint point;
    point.id = wire::text(row, {"id"});
    point.name = wire::text(row, {"name"});
    point.type = wire::text(row, {"type"});
    point.position_m = {*x, *y};
    point.yaw_rad = wire::number(row, {"yaw_rad"});
    if (const auto tags = wire::list(row, {"tags"})) {
      for (const wire::Json tag : *tags) point.tags.push_back(wire::asText(tag));
    }
    list.points.push_back(std::move(point));
  }
  return list;
}

std::vector<map::CatalogueEntry> KeptThings::maps() {
  std::vector<map::CatalogueEntry> entries;
  std::int64_t current_ns = std::numeric_limits<std::int64_t>::min();
  for (const auto& [name, indexes] : by_name_) {
    const auto key = recorder::mapFrom(name);
    if (!key) continue;
    map::CatalogueEntry entry;
    entry.key = *key;
    entry.bytes = file_.attachments()[indexes.back()].size;
    wire::JsonReader json;
    const std::string facts_name = recorder::mapFactsName(*key);
    const std::string text = lastOf(facts_name).value_or(std::string());
    if (const auto facts = json.read(text); facts && facts->is_object()) {
      map::WholeMap whole;
      readGrid(*facts, whole);
      entry.name = wire::text(*facts, {"name"});
      entry.uid = wire::text(*facts, {"uid"});
      entry.map_version = wire::smallInteger(*facts, {"map_version"});
      // If it used several maps, the last one counts.
      const std::int64_t told_ns = file_.attachments()[by_name_.at(facts_name).back()].log_time_ns;
      if (wire::flag(*facts, {"current"}).value_or(false) && told_ns >= current_ns) {
        for (map::CatalogueEntry& other : entries) other.is_current = false;
        entry.is_current = true;
        current_ns = told_ns;
      }
      if (!map::unusableReason(whole.grid)) entry.grid = whole.grid;
    }
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
  return entries;
}

std::string KeptThings::pictureName(const std::string& url, std::int64_t at_ns) const {
  const auto found = by_name_.find(recorder::pictureName(url));
  if (found == by_name_.end()) return url;
  const Indexes& indexes = found->second;
  const auto later = std::upper_bound(
      indexes.begin(), indexes.end(), at_ns,
      [&](std::int64_t at, std::size_t index) { return at < file_.attachments()[index].log_time_ns; });
  const std::size_t which = later == indexes.begin() ? 0 : std::size_t(later - indexes.begin()) - 1;
  return url + kNumberMark + std::to_string(which);
}

Outcome<std::shared_ptr<const std::string>> KeptThings::picture(const std::string& topic,
                                                                const std::string& name) {
  const std::size_t mark = name.rfind(kNumberMark);
  const std::string url = name.substr(0, mark);
  std::size_t which = 0;
  if (mark != std::string::npos) std::from_chars(name.data() + mark + 1, name.data() + name.size(), which);
  const auto found = by_name_.find(recorder::pictureName(url));
  const map::Subject subject(map::SubjectKind::Topic, topic);
  if (found == by_name_.end())
    return fail(wire::unfit(
        subject,
        faultText("recorded", "The recording does not contain the picture that this message names.")));
  auto bytes = bytesAt(found->second[std::min(which, found->second.size() - 1)]);
  if (!bytes) return fail(wire::unfit(subject, {fault::RecordingFileInItCorrupt, {found->first}}));
  return std::make_shared<const std::string>(std::move(*bytes));
}

}  // namespace mapwright::robot::recorded
