// A Cartographer state file (.pbstream): what is in it, without the cells of its submaps. Source:
// docs/protocols/pbstream.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "map/pose_graph.h"
#include "pbstream/record_file.h"

namespace mapwright::pbstream {

class RecordStream;

/// By the number of the member of SerializedData.
enum class RecordKind : std::uint8_t {
  Unknown = 0,  // none of those below
  PoseGraph = 1,
  Options,
  Submap,
  Node,
  TrajectoryData,
  Imu,
  Odometry,
  FixedFramePose,
  Landmark,
};
inline constexpr std::size_t kRecordKinds = 10;
/// "pose_graph": the name of the member.
const char* nameOf(RecordKind kind);

/// A submap, without its cells.
struct StoredSubmap {
  map::SubmapId id;
  Record record;
  std::int32_t version = 0;  // num_range_data: how many scans it holds
  bool finished = false;
  bool three_d = false;
  std::optional<double> resolution_m;  // of its finest grid; nullopt: it has none
  bool operator==(const StoredSubmap& other) const {
    return id == other.id && record.offset == other.record.offset;
  }
};

struct StateFile {
  static constexpr std::size_t kMostWarnings = 100;  // further ones are only counted

  std::shared_ptr<const RecordFile> file;
  std::uint32_t format_version = 0;
  std::array<std::uint64_t, kRecordKinds> records{};  // how many, by RecordKind; without the header
  std::vector<Fault> warnings;                        // whole sentences, or "Record 1 at byte 2: why"
  std::uint64_t further_warnings = 0;
  bool cut = false;                             // its end is missing
  std::shared_ptr<const map::PoseGraph> graph;  // never null; empty: it has none
  std::vector<StoredSubmap> submaps;            // in the order of their ids
  std::vector<map::NodeId> nodes;               // that have a record, in order
  std::size_t nodes_without_pose = 0;           // of those: not in the pose graph
  std::optional<std::size_t> option_lists;      // how many trajectories the options are for
  std::string uuid;                             // the same for the same content

  std::uint64_t recordsOf(RecordKind kind) const { return records[std::size_t(kind)]; }
  const StoredSubmap* find(map::SubmapId id) const;
  /// Where it lies; null: the pose graph does not say.
  const geometry::Pose3* poseOf(map::SubmapId id) const;
  /// What of it is missing or cannot be shown: the warnings, submaps without a place, places without a
  /// submap.
  std::vector<Fault> losses() const;
};

/// Asked now and then: true ends the reading with fault::Cancelled.
using Cancelled = std::function<bool()>;
/// Told now and then how much is done, 0 to 1.
using Progressed = std::function<void(double done)>;

/// Reads everything but cells, scans and sensor data. What comes before a cut is kept, and what is damaged is
/// left out: `warnings` says so. The error: nothing of it can be used.
tl::expected<StateFile, Fault> readStateFile(const std::string& path, const Cancelled& cancelled = {},
                                             const Progressed& progressed = {});

/// The kind of the record at which `stream` has just been started. More of its bytes may be consumed.
RecordKind kindOf(RecordStream& stream, Fault& wrong);

}  // namespace mapwright::pbstream
