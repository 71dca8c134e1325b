// The maps that a robot (or a folder) keeps, and one whole map as a picture.
// Source: docs/protocols/autoxing.md, "Requests", docs/protocols/agibot-aimdk.md, ROS map_server (map.yaml).
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "map/grid_reference.h"
#include "map/overlay.h"
#include "map/problem.h"

namespace mapwright::map {

enum class MapKind {
  Live,     // what the robot sends now (/map, /map_v2)
  Stored,   // a map that it keeps
  Mapping,  // the result of a mapping task
  File,     // a local file
};

/// Which map. `id` is text, whatever it looks like: 13-digit numbers keep every digit.
struct MapKey {
  MapKind kind = MapKind::Stored;
  std::string id;
  auto operator<=>(const MapKey&) const = default;
};

/// As people type and read it: "12", "mapping:48", "live", "file" (the only one) or a file's name.
std::string toText(const MapKey& key);
/// The reverse; "12" is a stored map.
MapKey mapKeyFromText(const std::string& text);

/// The map as the subject of a problem, called by its name where it is known.
Subject subjectOf(const MapKey& key, const std::string& name = {});
/// Its named places likewise.
Subject placesOf(const MapKey& key, const std::string& name = {});

/// A row of the catalogue. Empty or nullopt where the robot did not say. Names are untrusted plain text.
struct CatalogueEntry {
  MapKey key;
  std::string name, uid;
  std::optional<double> created_s, modified_s;  // seconds since the epoch
  std::optional<int> map_version, overlays_version;
  std::string state;                   // of a mapping task: running, finished, cancelled, failed
  std::optional<int> index;            // the robot's own order
  std::optional<GridReference> grid;   // where it is known without opening the map
  std::optional<std::uint64_t> bytes;  // size of the picture, where known
  bool has_thumbnail = false;
  bool is_current = false;   // the robot works with it now
  bool is_archived = false;  // put away: kept, and not to be worked with before it is taken out again
};

/// How the bytes of a picture become cells. Source: ROS map_server / nav2 map_io.
struct CellReading {
  enum class Mode {
    Picture,  // gray levels as they are: 0 occupied .. 255 free, middle gray and transparent = unknown
    Trinary,
    Scale,
    Raw,
  };
  Mode mode = Mode::Picture;
  bool negate = false;
  double occupied_thresh = 0.65, free_thresh = 0.196;
  bool operator==(const CellReading&) const = default;
};

/// A whole map as it came: nothing in the picture is checked yet.
struct WholeMap {
  MapKey key;
  std::optional<MapKey> state_of;  // it is an earlier state of that map
  std::string name;
  GridReference grid;  // width and height as declared; the picture's own size wins
  CellReading reading;
  std::shared_ptr<const std::string> bytes;    // the picture file (PNG, PGM, BMP); null when `path` is set
  std::string path;                            // a local picture file
  std::size_t body_bytes = 0;                  // of the answer that brought the picture; 0 = no robot sent it
  bool from_cache = false;                     // that body did not travel: disk, or 304
  std::string fingerprint;                     // names exactly this content, for side-car files; empty = none
  std::optional<double> display_rotation_rad;  // a hint of the robot, never part of coordinates
  std::vector<Problem> notes;                  // what is odd about it
  std::vector<std::vector<Eigen::Vector2d>> trajectories;  // of a mapping, world metres
  std::vector<OverlayFeature> overlays;
  struct Landmark {
    std::string id;
    Eigen::Vector2d position_m{0, 0};
  };
  std::vector<Landmark> landmarks;  // of a mapping
};

}  // namespace mapwright::map
