// The data in a recording besides its messages: submaps, whole maps, pictures and waypoints fetched during
// recording. Source: recorder/layout.h (names and contents of attachments). One thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "map/catalogue.h"
#include "map/submap.h"
#include "map/waypoint.h"
#include "recording/source.h"
#include "robot/call.h"

namespace mapwright::robot::recorded {

class KeptThings {
 public:
  explicit KeptThings(recording::Source& file) : file_(file) {}
  /// The file may have grown: reads the list of attachments again.
  void look();

  /// That version; if it is missing the last one before it, otherwise the first one after it. NotFound if
  /// there is none of that submap.
  map::SubmapAnswer submap(const map::SubmapKey& key);
  Outcome<map::WholeMap> wholeMap(const map::MapKey& key);
  Outcome<map::WaypointList> waypoints(const map::MapKey& key);
  std::vector<map::CatalogueEntry> maps();
  /// For an address in a message of `at_ns`: of several versions the one of that time. Empty: none.
  std::string pictureName(const std::string& url, std::int64_t at_ns) const;
  /// `name` is one of pictureName().
  Outcome<std::shared_ptr<const std::string>> picture(const std::string& topic, const std::string& name);

 private:
  using Indexes = std::vector<std::size_t>;  // with the same name, by log time
  std::optional<std::string> bytesAt(std::size_t index);
  std::optional<std::string> lastOf(const std::string& name);

  recording::Source& file_;
  std::size_t looked_ = 0;
  std::unordered_map<std::string, Indexes> by_name_;
  /// By uuid and id, then by version.
  std::map<std::pair<std::string, map::SubmapId>, std::map<std::int32_t, std::size_t>> submaps_;
};

}  // namespace mapwright::robot::recorded
