#include "robot/files/waypoint_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include <simdjson.h>

#include "map/waypoint.h"
#include "robot/files/faults.h"
#include "robot/wire/faults.h"

namespace mapwright::robot::files {
namespace {

using simdjson::dom::element;

/// One member of an object, verbatim.
struct Member {
  std::string name;
  std::string_view raw_name, raw_value;  // the name with its quotes
};

constexpr std::string_view kBlanks = " \t\r\n";

/// Splits valid JSON into verbatim parts, so that reassembling them gives exactly the same text.
class Cutter {
 public:
  explicit Cutter(std::string_view valid) : rest_(valid) {}

  std::vector<Member> members() {
    std::vector<Member> members;
    skip();  // the bracket
    while (peek() != '}') {
      Member member;
      member.raw_name = value();
      skip();  // the colon
      member.raw_value = value();
      member.name = textOf(member.raw_name);
      members.push_back(std::move(member));
      if (peek() == ',') skip();
    }
    return members;
  }
  std::vector<std::string_view> elements() {
    std::vector<std::string_view> elements;
    skip();  // the bracket
    while (peek() != ']') {
      elements.push_back(value());
      if (peek() == ',') skip();
    }
    return elements;
  }
  static std::string textOf(std::string_view raw) {
    simdjson::dom::parser parser;
    std::string_view text;
    // A single value is a document.
    if (parser.parse(raw.data(), raw.size()).get(text) != simdjson::SUCCESS) return {};
    return std::string(text);
  }

 private:
  void blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size())); }
  char peek() {
    blanks();
    return rest_.empty() ? '}' : rest_.front();
  }
  void skip() {
    blanks();
    if (!rest_.empty()) rest_.remove_prefix(1);
  }
  /// Behind the text that begins at `at`.
  std::size_t endOfText(std::size_t at) const {
    for (++at; at < rest_.size() && rest_[at] != '"'; ++at) at += rest_[at] == '\\';
    return at + 1;
  }
  std::size_t endOfValue() const {
    if (rest_.starts_with('"')) return endOfText(0);
    if (!rest_.starts_with('{') && !rest_.starts_with('[')) return rest_.find_first_of(",:]} \t\r\n");
    std::size_t at = 0;
    for (int depth = 0; at == 0 || (depth > 0 && at < rest_.size());) {
      const char c = rest_[at];
      depth += (c == '{' || c == '[') - (c == '}' || c == ']');
      at = c == '"' ? endOfText(at) : at + 1;
    }
    return at;
  }
  std::string_view value() {
    blanks();
    const std::string_view cut = rest_.substr(0, endOfValue());
    rest_.remove_prefix(cut.size());
    return cut;
  }

  std::string_view rest_;
};

std::string jsonText(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      json += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      json += "\\u00";
      json += {kDigits[std::size_t(c) >> 4], kDigits[std::size_t(c) & 15]};
    } else {
      json += c;
    }
  }
  return json + '"';
}

std::string number(double value) {
  std::array<char, 64> digits;
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e15);  // 400000, not 4e+05
  const auto end =
      plain ? std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr
            : std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

/// A feature as a waypoint; nullopt if it is not one.
struct Understood {
  map::Waypoint point;
  bool has_id = false;  // the feature has an id, and no other has the same
  std::vector<FaultCode> odd;
  std::string unread_heading;  // the property that may be one
};

std::optional<double> finite(const simdjson::simdjson_result<element>& value) {
  double number = 0;
  if (value.get(number) != simdjson::SUCCESS || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string textOr(const simdjson::simdjson_result<element>& value) {
  std::string_view text;
  if (value.get(text) == simdjson::SUCCESS) return std::string(text);
  element other;
  if (value.get(other) != simdjson::SUCCESS) return {};
  return other.is_number() ? simdjson::minify(other) : std::string();
}

std::optional<Understood> understand(const element& feature) {
  std::string_view type;
  if (feature["type"].get(type) != simdjson::SUCCESS || type != "Feature") return std::nullopt;
  if (feature["geometry"]["type"].get(type) != simdjson::SUCCESS || type != "Point") return std::nullopt;
  const auto x = finite(feature["geometry"]["coordinates"].at(0)),
             y = finite(feature["geometry"]["coordinates"].at(1));
  if (!x || !y) return std::nullopt;
  Understood read;
  read.point.position_m = {*x, *y};
  const auto properties = feature["properties"];
  read.point.name = textOr(properties["name"]);
  read.point.type = textOr(properties["type"]);
  read.point.id = textOr(properties["id"]);
  if (read.point.id.empty()) read.point.id = textOr(feature["id"]);
  read.has_id = !read.point.id.empty();
  element yaw;
  if (properties["yaw_rad"].get(yaw) == simdjson::SUCCESS && !yaw.is_null()) {
    read.point.yaw_rad = finite(properties["yaw_rad"]);
    if (!read.point.yaw_rad)
      read.odd.push_back(
          faultText("files", "The yaw_rad of waypoint %1 is not a number. It is shown without a heading."));
  }
  if (const std::string frame = textOr(properties["frame"]); !frame.empty() && frame != "map")
    read.odd.push_back(
        faultText("files", "The frame of waypoint %1 is not the map. It is shown as if it were."));
  if (!read.point.yaw_rad) {
    for (const char* other : {"yaw", "yaw_deg", "heading", "theta", "orientation"}) {
      if (properties[other].get(yaw) == simdjson::SUCCESS && !yaw.is_null()) read.unread_heading = other;
    }
  }
  element tags;
  simdjson::dom::array list;
  if (properties["tags"].get(tags) != simdjson::SUCCESS || tags.is_null()) return read;
  const bool listed = tags.get(list) == simdjson::SUCCESS;
  bool all = listed;
  if (listed) {
    for (const element& tag : list) {
      std::string_view text;
      if (tag.get(text) == simdjson::SUCCESS) {
        read.point.tags.emplace_back(text);
      } else {
        all = false;
      }
    }
  }
  if (!all)
    read.odd.push_back(
        faultText("files", "The tags of waypoint %1 are not a list of texts. What is no text is not shown."));
  return read;
}

/// Lines and outlines may be kept among them; other programs may know what has no place.
bool mayBePoint(const element& feature) {
  element geometry;
  if (feature["geometry"].get(geometry) == simdjson::SUCCESS && geometry.is_null()) return false;
  const std::string type = textOr(feature["geometry"]["type"]);
  return !feature.is_null() && !type.ends_with("LineString") && !type.ends_with("Polygon");
}

/// Gives every feature a unique id.
class Names {
 public:
  std::string assign(const Understood& read) {
    const std::string wanted = read.has_id ? read.point.id : "unnamed " + read.point.name;
    std::string id = wanted;
    for (int turn = 2; !taken_.insert(id).second; ++turn) id = wanted + " #" + std::to_string(turn);
    return id;
  }

 private:
  std::unordered_set<std::string> taken_;
};

struct Collection {
  std::vector<Member> members;  // of the file
  std::vector<std::string_view> features;
  std::vector<std::optional<Understood>> understood;  // of each
  std::vector<Fault> notes;
};

std::string_view withoutMark(std::string_view json) {
  return json.starts_with("\xef\xbb\xbf") ? json.substr(3) : json;
}

/// The coordinate system of GeoJSON of 2008; else empty.
std::string systemOf(const element& file) {
  element crs;
  if (file["crs"].get(crs) != simdjson::SUCCESS) return {};
  const std::string name = textOr(crs["properties"]["name"]);
  return name.empty() ? textOr(file["crs"]) : name;
}

bool isInDegrees(const std::string& system) {
  return system.find("CRS84") != system.npos || system.ends_with(":4326") || system.ends_with("/4326");
}

tl::expected<Collection, Fault> cut(std::string_view json) {
  // Read twice: by a parser that finds all errors, and verbatim.
  simdjson::dom::parser parser;
  const simdjson::padded_string padded(json);
  element file;
  if (const auto error = parser.parse(padded).get(file); error != simdjson::SUCCESS)
    return refused({faultText("files", "it is not JSON (%1)"), {simdjson::error_message(error)}});
  std::string_view type;
  simdjson::dom::array features;
  if (file["type"].get(type) != simdjson::SUCCESS || type != "FeatureCollection" ||
      file["features"].get(features) != simdjson::SUCCESS) {
    return refused(fault::NotAFeatureCollection);
  }
  if (const std::string system = systemOf(file); isInDegrees(system))
    return refused(
        {faultText("files",
                   "its coordinates are longitude and latitude (crs %1), not metres of the map. If "
                   "they are metres, remove \"crs\" from it"),
         {system.substr(0, 80)}});
  Collection collection;
  collection.members = Cutter(json).members();
  int lists = 0;
  for (const Member& member : collection.members) {
    if (member.name != "features") continue;
    ++lists;
    collection.features = Cutter(member.raw_value).elements();
  }
  if (lists != 1) return refused(faultText("files", "it has more than one list of features"));
  if (const std::string system = systemOf(file); !system.empty() && system != "map")
    collection.notes.push_back({faultText("files", "Its coordinates (crs %1) are read as metres of the map."),
                                {system.substr(0, 80)}});
  Names names;
  std::size_t points = 0;
  std::int64_t unread_points = 0;
  for (const element& feature : features) {
    auto read = understand(feature);
    if (read) {
      if (++points > kMaxWaypoints) {
        return refused(
            {faultText("files", "it has more than %1 waypoints"), {std::to_string(kMaxWaypoints)}});
      }
      const std::string id = names.assign(*read);
      if (read->has_id && id != read->point.id)
        collection.notes.push_back({robot::wire::fault::WaypointIdTwice, {read->point.id.substr(0, 80)}});
      read->has_id = read->has_id && id == read->point.id;
      read->point.id = id;
      const Fault unread(fault::WaypointHeadingUnread, {read->unread_heading});
      const bool said =
          std::find(collection.notes.begin(), collection.notes.end(), unread) != collection.notes.end();
      if (!read->unread_heading.empty() && !said) collection.notes.push_back(unread);
      for (const FaultCode odd : read->odd) collection.notes.push_back({odd, {id.substr(0, 80)}});
    } else if (mayBePoint(feature)) {
      ++unread_points;
    }
    collection.understood.push_back(std::move(read));
  }
  if (unread_points > 0) collection.notes.push_back({fault::WaypointsUnread, {unread_points}});
  if (collection.understood.size() != collection.features.size())
    return refused(faultText("files", "it has two lists of features"));
  for (std::size_t i = 0; i < collection.features.size(); ++i) {
    if (collection.understood[i]) collection.understood[i]->point.source = collection.features[i];
  }
  return collection;
}

/// An object made of verbatim members: known ones are set, the rest and the order stay.
class Object {
 public:
  explicit Object(std::string_view json) {
    if (json.starts_with('{')) {
      for (const Member& member : Cutter(json).members())
        members_.emplace_back(member.name,
                              std::string(member.raw_name) + ": " + std::string(member.raw_value));
    }
  }
  void set(const std::string& name, const std::optional<std::string>& raw) {
    const auto found =
        std::find_if(members_.begin(), members_.end(), [&](const auto& one) { return one.first == name; });
    if (!raw) {
      if (found != members_.end()) members_.erase(found);
    } else if (found != members_.end()) {
      found->second = jsonText(name) + ": " + *raw;
    } else {
      members_.emplace_back(name, jsonText(name) + ": " + *raw);
    }
  }
  std::string text() const {
    std::string json = "{";
    for (const auto& [name, raw] : members_) {
      if (json.size() > 1) json += ", ";
      json += raw;
    }
    return json + "}";
  }

 private:
  std::vector<std::pair<std::string, std::string>> members_;
};

/// Of several the first one, as the parser reads it.
std::string_view rawMember(std::string_view object, std::string_view name) {
  if (!object.starts_with('{')) return {};
  for (const Member& member : Cutter(object).members()) {
    if (member.name == name) return member.raw_value;
  }
  return {};
}

std::string coordinates(const Eigen::Vector2d& at, std::string_view before) {
  std::string json = "[" + number(at.x()) + ", " + number(at.y());
  if (before.starts_with('[')) {
    const auto elements = Cutter(before).elements();
    for (std::size_t i = 2; i < elements.size(); ++i) json += ", " + std::string(elements[i]);
  }
  return json + "]";
}

std::string tagList(const std::vector<std::string>& tags, std::string_view before) {
  std::string json = "[";
  const auto add = [&](std::string_view raw) { json += (json.size() > 1 ? ", " : "") + std::string(raw); };
  for (const std::string& tag : tags) add(jsonText(tag));
  // Entries that are not texts must be kept.
  if (before.starts_with('[')) {
    for (const std::string_view element : Cutter(before).elements()) {
      if (!element.starts_with('"')) add(element);
    }
  }
  return json + "]";
}

/// The feature `source` (empty: a new one) with the differences between `from` and `to`. Its own data, such
/// as a numeric id, stays verbatim.
std::string feature(std::string_view source, const std::optional<map::Waypoint>& from,
                    const map::Waypoint& to, bool has_id) {
  const bool fresh = source.empty() || !from;
  Object whole(source);
  if (source.empty()) whole.set("type", jsonText("Feature"));
  const std::string_view old_geometry = rawMember(source, "geometry"),
                         old_properties = rawMember(source, "properties");
  if (fresh || !map::samePlace(from->position_m, to.position_m)) {
    Object geometry(old_geometry);
    if (source.empty()) geometry.set("type", jsonText("Point"));
    geometry.set("coordinates", coordinates(to.position_m, rawMember(old_geometry, "coordinates")));
    whole.set("geometry", geometry.text());
  }
  Object properties(old_properties);
  if (!has_id) properties.set("id", jsonText(to.id));
  if (fresh || from->name != to.name) properties.set("name", jsonText(to.name));
  if (fresh || !map::sameHeading(from->yaw_rad, to.yaw_rad)) {
    if (!fresh || to.yaw_rad)
      properties.set("yaw_rad", to.yaw_rad ? std::optional(number(*to.yaw_rad)) : std::nullopt);
  }
  if (fresh || from->tags != to.tags)
    properties.set("tags", tagList(to.tags, rawMember(old_properties, "tags")));
  if ((fresh && !to.type.empty()) || (!fresh && from->type != to.type))
    properties.set("type", jsonText(to.type));
  whole.set("properties", properties.text());
  return whole.text();
}

/// A deleted waypoint that is added again keeps its original data.
std::string added(const map::Waypoint& point) {
  simdjson::dom::parser parser;
  element source;
  const simdjson::padded_string padded{std::string_view(point.source)};
  const bool whole = !point.source.empty() && parser.parse(padded).get(source) == simdjson::SUCCESS;
  const auto read = whole ? understand(source) : std::nullopt;
  if (!read) return feature({}, std::nullopt, point, false);
  return feature(point.source, read->point, point, read->has_id && read->point.id == point.id);
}

}  // namespace

std::string waypointPathOf(const std::string& map_path) {
  const std::size_t slash = map_path.rfind('/'), dot = map_path.rfind('.');
  const bool suffix = dot != std::string::npos && (slash == std::string::npos || dot > slash + 1);
  return (suffix ? map_path.substr(0, dot) : map_path) + ".waypoints.geojson";
}

tl::expected<StoredWaypoints, Fault> parseWaypoints(std::string_view json) {
  auto collection = cut(withoutMark(json));
  if (!collection) return tl::make_unexpected(collection.error());
  StoredWaypoints stored;
  stored.notes = std::move(collection->notes);
  for (auto& read : collection->understood) {
    if (read) stored.points.push_back(std::move(read->point));
  }
  return stored;
}

tl::expected<std::string, Fault> patchWaypoints(std::string_view json,
                                                const std::vector<WaypointChange>& changes) {
  constexpr std::string_view kEmpty = R"({"type": "FeatureCollection", "features": []})";
  const std::string_view mark = json.substr(0, json.size() - withoutMark(json).size());
  const std::string_view file = json.empty() ? kEmpty : withoutMark(json);
  const auto collection = cut(file);
  if (!collection) return tl::make_unexpected(collection.error());
  std::unordered_map<std::string, const WaypointChange*> waiting;
  for (const WaypointChange& change : changes) waiting[change.id] = &change;
  std::vector<std::string> features;
  for (std::size_t i = 0; i < collection->features.size(); ++i) {
    const auto& read = collection->understood[i];
    const auto change = read ? waiting.find(read->point.id) : waiting.end();
    if (change == waiting.end()) {
      features.emplace_back(collection->features[i]);
      continue;
    }
    const std::optional<map::Waypoint>& after = change->second->after;
    if (after) features.push_back(feature(collection->features[i], read->point, *after, read->has_id));
    waiting.erase(change);
  }
  for (const WaypointChange& change : changes) {
    if (waiting.contains(change.id) && change.after) features.push_back(added(*change.after));
  }
  std::string list = "[";
  for (const std::string& one : features) list += (list.size() > 1 ? ",\n  " : "\n  ") + one;
  list += features.empty() ? "]" : "\n]";
  std::string written = std::string(mark) + "{";
  bool first = true;
  for (const Member& member : collection->members) {
    written += first ? "" : ",";
    first = false;
    written += "\n" + std::string(member.raw_name) + ": " +
               (member.name == "features" ? list : std::string(member.raw_value));
  }
  return written + "\n}\n";
}

}  // namespace mapwright::robot::files
