// The maps stored on a robot (or in a folder), and one whole map as a picture. Source:
// docs/protocols/autoxing.md, "Requests", docs/protocols/agibot-aimdk.md, ROS map_server (map.yaml).
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

/// Identifies a map. `id` is text even if it looks like a number: 13-digit ids keep every digit.
struct MapKey {
  MapKind kind = MapKind::Stored;
  std::string id;
  auto operator<=>(const MapKey&) const = default;
};

/// As typed and displayed: "12", "mapping:48", "live", "file" (the only one) or a file name.
std::string toText(const MapKey& key);
/// The reverse; "12" is a stored map.
MapKey mapKeyFromText(const std::string& text);

/// The map as the subject of a problem, with its name if known.
Subject subjectOf(const MapKey& key, const std::string& name = {});
/// The same for its waypoints.
Subject placesOf(const MapKey& key, const std::string& name = {});

/// An entry of the catalogue. Empty or nullopt if the robot did not say. Names are untrusted plain text.
struct CatalogueEntry {
  MapKey key;
  std::string name, uid;
  std::string file_name = {};  // the robot's own name for its files, besides the shown one; empty = none
  std::optional<double> created_s, modified_s;  // seconds since the epoch
  std::optional<int> map_version, overlays_version;
  /// Of a mapping task: running, finished, cancelled, failed. Of KABAM's current map that of the map manager:
  /// IDLE, MAPPING, ACTIVE.
  std::string state;
  std::optional<int> index;            // the robot's own order
  std::optional<GridReference> grid;   // if known without opening the map
  std::optional<std::uint64_t> bytes;  // size of the picture, if known
  bool has_thumbnail = false;
  bool is_current = false;   // the robot uses it now
  bool is_archived = false;  // archived: kept, but must be restored before it can be used
};

/// The entry with this key, and the one that the robot uses; nullptr if there is none.
const CatalogueEntry* entryOf(const std::vector<CatalogueEntry>& entries, const MapKey& key);
const CatalogueEntry* currentOf(const std::vector<CatalogueEntry>& entries);

/// How the bytes of a picture are converted to cells. Source: ROS map_server / nav2 map_io.
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

/// A whole map as received: nothing in the picture is checked yet.
struct WholeMap {
  MapKey key;
  std::optional<MapKey> state_of;  // an earlier state of that map
  std::string name;
  GridReference grid;  // width and height as declared; the picture's own size takes precedence
  CellReading reading;
  /// One of these: the picture file (PNG, PGM, BMP), where it is, or the cells themselves.
  std::shared_ptr<const std::string> bytes;
  std::string path;
  OccupancyCells cells;
  std::size_t body_bytes = 0;  // of the answer with the picture; 0 = not from a robot
  bool from_cache = false;     // nothing was transferred: disk cache, or 304
  std::string fingerprint;     // identifies exactly this content, for side-car files; empty = none
  std::optional<double> display_rotation_rad;              // a hint from the robot, never part of coordinates
  std::vector<Problem> notes;                              // what is odd about it
  std::vector<std::vector<Eigen::Vector2d>> trajectories;  // of a mapping, world metres
  std::vector<OverlayFeature> overlays;
  std::vector<BrokenOverlay> broken_overlays;  // left out of them
  struct Landmark {
    std::string id;
    Eigen::Vector2d position_m{0, 0};
  };
  std::vector<Landmark> landmarks;  // of a mapping
};

}  // namespace mapwright::map
