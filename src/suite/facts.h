// What made a picture: kept beside it, so that a picture that differs can be explained. Values.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>
#include <tl/expected.hpp>

#include "geometry/pose.h"
#include "geometry/rect.h"
#include "geometry/view_transform.h"
#include "map/overlay.h"
#include "map/submap.h"
#include "map/waypoint.h"
#include "suite/cell_blocks.h"

namespace mapwright::suite {

struct SubmapFact {
  int version = 0;
  geometry::Pose2 pose;
  geometry::WorldRect box;  // empty: unknown
};

struct MapFact {
  std::string id, name, uid;
  std::optional<int> version, overlays_version;
  std::string cells;  // a checksum of all of them; empty: unknown
  geometry::WorldRect box;
  std::optional<geometry::Pose2> origin = {};  // its lower left corner; none: its cells are not drawn
  std::optional<double> resolution_m = {};     // of a cell
  CellBlocks blocks = {};                      // of its cells; files of earlier versions have none
};

/// Figures of the SLAM session, where the view sets a limit to them: they alter no pixel.
struct ClosuresFact {
  std::int64_t inter = 0;           // loop closures
  std::optional<double> largest_m;  // the largest residual of one; nullopt: there is none
  bool operator==(const ClosuresFact&) const = default;
};
struct DisagreementFact {
  int tolerance_cells = 0;
  std::int64_t occupied_cells = 0, contradicted_cells = 0;
  double share() const {
    return occupied_cells > 0 ? double(contradicted_cells) / double(occupied_cells) : 0;
  }
  bool operator==(const DisagreementFact&) const = default;
};

/// Of what is drawn.
struct Facts {
  std::string picture = {};  // sumOf() its file; empty: unknown, as in files of earlier versions
  std::optional<geometry::ViewTransform> view;
  std::string session;  // uuid of the SLAM session; empty = none
  std::map<map::SubmapId, SubmapFact> submaps;
  std::optional<MapFact> map;
  std::string overlays;  // a FeatureCollection; empty = none are drawn
  std::vector<map::Waypoint> waypoints;
  std::optional<geometry::Pose2> robot;
  std::string theme;                // light or dark; empty = unknown
  std::vector<std::string> layers;  // by name
  std::optional<ClosuresFact> closures = {};
  std::optional<DisagreementFact> disagreement = {};
  std::map<std::string, double> stamps;  // of the messages of a bag, by topic: seconds since the epoch
};

/// As a FeatureCollection.
std::string overlaysText(const std::vector<map::OverlayFeature>& features);

/// A checksum of the bytes of this file; empty: it cannot be read. Blocks.
std::string sumOf(const QString& file);

/// JSON, the same bytes for the same facts.
QByteArray factsBytes(const Facts& facts);
/// The error is a sentence without the name of the file.
tl::expected<Facts, QString> factsFrom(const QByteArray& bytes);

}  // namespace mapwright::suite
