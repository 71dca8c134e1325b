#include "robot/recorded/kept_things.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include <QByteArray>

#include "robot/axbot/parse_maps.h"
#include "robot/recorded/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/picture_bytes.h"
#include "robot/wire/read_json.h"

namespace mapwright::robot::recorded {
namespace {

constexpr std::uint64_t kMostKeptBytes = std::uint64_t(512) << 20;  // of one attachment
constexpr char kNumberMark = '\n';  // never part of an attachment name written by us

/// RFC 3986: everything except A-Z a-z 0-9 - . _ ~; an empty one is "-".
std::string encoded(const std::string& text) {
  if (text.empty()) return "-";
  return QByteArray(text.data(), qsizetype(text.size())).toPercentEncoding().toStdString();
}

std::string decoded(std::string_view text) {
  if (text == "-") return {};
  return QByteArray::fromPercentEncoding(QByteArray(text.data(), qsizetype(text.size()))).toStdString();
}

struct MapKindName {
  map::MapKind kind;
  std::string_view name;
};
constexpr MapKindName kMapKinds[] = {{map::MapKind::Live, "live"},
                                     {map::MapKind::Stored, "stored"},
                                     {map::MapKind::Mapping, "mapping"},
                                     {map::MapKind::File, "file"}};

std::string placeOf(const map::MapKey& key) {
  const auto* const kind = std::find_if(std::begin(kMapKinds), std::end(kMapKinds),
                                        [&](const MapKindName& one) { return one.kind == key.kind; });
  return std::string(kind->name) + '/' + encoded(key.id);
}

/// "maps/KIND/ID", nothing else.
std::optional<map::MapKey> keyFrom(std::string_view name) {
  constexpr std::string_view kMaps = "maps/", kFacts = ".json";
  if (!name.starts_with(kMaps) || name.ends_with(kFacts)) return std::nullopt;
  name.remove_prefix(kMaps.size());
  for (const MapKindName& kind : kMapKinds) {
    if (name.size() > kind.name.size() && name.starts_with(kind.name) && name[kind.name.size()] == '/')
      return map::MapKey{kind.kind, decoded(name.substr(kind.name.size() + 1))};
  }
  return std::nullopt;
}

std::optional<std::int32_t> number(std::string_view text) {
  std::int32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(value) : std::nullopt;
}

struct SubmapName {
  std::string uuid;
  std::int32_t trajectory = 0, index = 0, version = 0;
};
/// "submaps/UUID/TRAJECTORY/INDEX/VERSION".
std::optional<SubmapName> submapFrom(std::string_view name) {
  constexpr std::string_view kSubmaps = "submaps/";
  if (!name.starts_with(kSubmaps)) return std::nullopt;
  name.remove_prefix(kSubmaps.size());
  std::vector<std::string_view> parts;
  for (std::size_t slash = name.find('/'); slash != std::string_view::npos; slash = name.find('/')) {
    parts.push_back(name.substr(0, slash));
    name.remove_prefix(slash + 1);
  }
  parts.push_back(name);
  if (parts.size() != 4) return std::nullopt;
  const auto trajectory = number(parts[1]), index = number(parts[2]), version = number(parts[3]);
  if (!trajectory || !index || !version) return std::nullopt;
  return SubmapName{decoded(parts[0]), *trajectory, *index, *version};
}

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
  const std::vector<recording::AttachmentPlace>& all = file_.attachments();
  if (all.size() < looked_) {
    by_name_.clear();
    submaps_.clear();
    looked_ = 0;
  }
  const auto earlier = [&](std::size_t a, std::size_t b) { return all[a].log_time_ns < all[b].log_time_ns; };
  for (; looked_ < all.size(); ++looked_) {
    Places& places = by_name_[all[looked_].name];
    places.insert(std::upper_bound(places.begin(), places.end(), looked_, earlier), looked_);
    if (const auto submap = submapFrom(all[looked_].name))
      submaps_[{submap->uuid, submap->trajectory, submap->index}][submap->version] = looked_;
  }
}

std::optional<std::string> KeptThings::bytesAt(std::size_t place) {
  const recording::AttachmentPlace& at = file_.attachments()[place];
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
  answer.reason = fault::RecordingLacksSubmap;
  const auto found = submaps_.find({key.uuid, key.id.trajectory, key.id.index});
  if (found == submaps_.end()) return answer;
  auto version = found->second.upper_bound(key.version);
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
  return answer;
}

Outcome<map::WholeMap> KeptThings::wholeMap(const map::MapKey& key) {
  const std::string name = "maps/" + placeOf(key);
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
  const std::string text = lastOf(name + ".json").value_or(std::string());
  const auto facts = json.read(text);
  if (!facts || !facts->is_object())
    return fail(wire::unfit(subject, {fault::RecordingFileInItCorrupt, {name + ".json"}}));
  whole.name = wire::text(*facts, {"name"});
  readGrid(*facts, whole);
  if (auto why = map::whyUnusable(whole.grid)) return fail(wire::unfit(subject, std::move(*why)));
  whole.display_rotation_rad = wire::number(*facts, {"display_rotation_rad"});
  readThingsOn(*facts, whole);
  const std::string places = lastOf("waypoints/" + placeOf(key) + ".json").value_or(std::string());
  if (const auto list = json.read(places); list && list->is_object()) whole.overlays = overlaysOf(*list);
  return whole;
}

Outcome<map::WaypointList> KeptThings::waypoints(const map::MapKey& key) {
  const std::string name = "waypoints/" + placeOf(key) + ".json";
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
  for (const auto& [name, places] : by_name_) {
    const auto key = keyFrom(name);
    if (!key) continue;
    map::CatalogueEntry entry;
    entry.key = *key;
    entry.bytes = file_.attachments()[places.back()].size;
    wire::JsonReader json;
    const std::string text = lastOf(name + ".json").value_or(std::string());
    if (const auto facts = json.read(text); facts && facts->is_object()) {
      map::WholeMap whole;
      readGrid(*facts, whole);
      entry.name = wire::text(*facts, {"name"});
      entry.uid = wire::text(*facts, {"uid"});
      entry.map_version = wire::smallInteger(*facts, {"map_version"});
      // If it used several maps, the last one counts.
      const auto facts_of = by_name_.find(name + ".json");
      const std::int64_t told_ns = file_.attachments()[facts_of->second.back()].log_time_ns;
      if (wire::flag(*facts, {"current"}).value_or(false) && told_ns >= current_ns) {
        for (map::CatalogueEntry& other : entries) other.is_current = false;
        entry.is_current = true;
        current_ns = told_ns;
      }
      if (!map::whyUnusable(whole.grid)) entry.grid = whole.grid;
    }
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
  return entries;
}

std::string KeptThings::pictureName(const std::string& url, std::int64_t at_ns) const {
  const auto found = by_name_.find("pictures/" + url);
  if (found == by_name_.end()) return url;
  const Places& places = found->second;
  const auto later = std::upper_bound(
      places.begin(), places.end(), at_ns,
      [&](std::int64_t at, std::size_t place) { return at < file_.attachments()[place].log_time_ns; });
  const std::size_t which = later == places.begin() ? 0 : std::size_t(later - places.begin()) - 1;
  return url + kNumberMark + std::to_string(which);
}

Outcome<std::shared_ptr<const std::string>> KeptThings::picture(const std::string& topic,
                                                                const std::string& name) {
  const std::size_t mark = name.rfind(kNumberMark);
  const std::string url = name.substr(0, mark);
  const auto which =
      mark == std::string::npos ? std::nullopt : number(std::string_view(name).substr(mark + 1));
  const auto found = by_name_.find("pictures/" + url);
  const map::Subject subject(map::SubjectKind::Topic, topic);
  if (found == by_name_.end()) return fail(wire::unfit(subject, fault::RecordingLacksPicture));
  const std::size_t place = std::min(std::size_t(std::max(which.value_or(0), 0)), found->second.size() - 1);
  auto bytes = bytesAt(found->second[place]);
  if (!bytes) return fail(wire::unfit(subject, {fault::RecordingFileInItCorrupt, {found->first}}));
  return std::make_shared<const std::string>(std::move(*bytes));
}

}  // namespace mapwright::robot::recorded
