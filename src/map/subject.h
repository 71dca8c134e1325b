// What a problem or a failed request is about, as a value. sentences::nameOf makes the text.
#pragma once

#include <string>
#include <utility>

namespace mapwright::map {

enum class SubjectKind {
  Other,         // nothing but a name
  Robot,         // the robot itself, or the connection to it
  Catalogue,     // the list of its maps, or a part of it (kMapsPart …)
  Map,           // one whole map
  Places,        // the named places of a map
  Overview,      // the coarse picture of the SLAM map
  SubmapList,    // what the robot lists
  Submap,        // one submap, whatever its version
  SubmapMemory,  // what holds the pictures of submaps
  Topic,         // a live topic
  Condition,     // a state of the robot that people must know of (an alert, a pressed emergency stop)
  DiskCache,
  Bag,  // a recording on the robot, or a recording file
};

/// Parts of a catalogue: ids of subjects of that kind.
inline constexpr const char* kMapsPart = "maps";
inline constexpr const char* kMappingsPart = "mappings";
inline constexpr const char* kCurrentMapPart = "current";
inline constexpr const char* kBagsPart = "bags";
inline constexpr const char* kRecordingsPart = "recordings";

/// The same thing always has the same subject: versions, times and numbers belong into the reason. Ids and
/// labels are untrusted plain text.
struct Subject {
  SubjectKind kind = SubjectKind::Other;
  std::string id;     // "1-593", "/map_v2", "mapping:48", "emergency-stop"
  std::string label;  // its name, if it has one besides the id; not part of the identity

  Subject() = default;
  Subject(SubjectKind its_kind, std::string its_id = {}, std::string its_label = {})
      : kind(its_kind), id(std::move(its_id)), label(std::move(its_label)) {}
  /// Something without a kind of its own, identified by its name.
  Subject(std::string name) : id(std::move(name)) {}
  Subject(const char* name) : id(name) {}

  bool operator==(const Subject& other) const { return kind == other.kind && id == other.id; }
};

}  // namespace mapwright::map
