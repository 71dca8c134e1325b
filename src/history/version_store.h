// Versions of the overlays of maps, kept on this computer in one SQLite database: every one that was read
// from a robot or stored there. Also for several programs at once. One thread each.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"

struct sqlite3;

namespace mapwright::history {

enum class Origin {
  Read,   // the robot held it
  Saved,  // it was stored from here
};

struct MapName {
  std::string robot;  // its address, without secrets
  std::string uid;    // of the map; or its id, if the robot tells no uid
  std::string id;     // of the map on that robot
  std::string name;   // for people, may be empty
  auto operator<=>(const MapName&) const = default;
};
/// `uid` and `name` may be empty.
MapName mapName(std::string robot, std::string id, std::string uid, std::string name);
/// Whether versions of one are versions of the other: a uid is the map's own, an id is that of one robot.
bool isSameMap(const MapName& a, const MapName& b);

struct KeptVersion {
  std::int64_t number = 0;  // given here, grows
  MapName map;
  std::optional<int> version;  // the robot's own
  Origin origin = Origin::Read;
  double kept_s = 0;  // seconds since the epoch
  std::int64_t bytes = 0;
};

class VersionStore {
 public:
  struct Limits {
    int of_map = 500;                              // versions of each map
    std::int64_t bytes = std::int64_t(256) << 20;  // of all
  };

  /// Made if it is not there, with its folder. The fault names the file.
  static tl::expected<VersionStore, Fault> open(const std::string& path, Limits limits);
  static tl::expected<VersionStore, Fault> open(const std::string& path) { return open(path, Limits()); }
  VersionStore(VersionStore&&) noexcept;
  VersionStore& operator=(VersionStore&&) noexcept;
  ~VersionStore();

  /// Nothing happens if the newest version of that map has the same text. The oldest go beyond the limits,
  /// never the one that is kept now.
  std::optional<Fault> keep(const MapName& map, std::optional<int> version, Origin origin,
                            const std::string& text, double now_s);
  /// The newest first. An empty robot or uid: of all.
  tl::expected<std::vector<KeptVersion>, Fault> list(const std::string& robot, const std::string& uid) const;
  /// Of one; nullopt: there is no such number.
  tl::expected<std::optional<KeptVersion>, Fault> find(std::int64_t number) const;
  /// To the byte as it was kept, or it is said to be damaged.
  tl::expected<std::string, Fault> text(std::int64_t number) const;

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  class Question;

  VersionStore(std::unique_ptr<sqlite3, Close> database, std::string path, Limits limits);
  Fault problem() const;
  std::optional<Fault> run(const char* sql) const;
  std::optional<Fault> forget(const MapName& map, std::int64_t kept);

  std::unique_ptr<sqlite3, Close> database_;
  std::string path_;
  Limits limits_;
};

}  // namespace mapwright::history
