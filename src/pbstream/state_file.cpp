#include "pbstream/state_file.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QCryptographicHash>

#include "cartographer/state.pb.h"
#include "pbstream/faults.h"
#include "pbstream/poses.h"
#include "pbstream/read_pose_graph.h"
#include "pbstream/record_stream.h"
#include "pbstream/wire.h"
#include "words/figures.h"

namespace mapwright::pbstream {
namespace {

constexpr std::size_t kTrailerBytes = 8;  // of a gzip stream: checksum and length
constexpr int kAskEvery = 256;            // records
constexpr std::size_t kMostSubmaps = 1'000'000;
constexpr std::size_t kMostNodeRecords = 8'000'000;

QByteArrayView viewOf(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
}

/// A submap without its cells. Cartographer writes them last; as protobuf allows any order, all of it is read
/// unless nothing can be missing any more.
Fault readSubmapHead(RecordStream& stream, StoredSubmap& submap) {
  Wire wire(&stream);
  cartographer_state::SubmapId id;
  cartographer_state::MapLimits limits;
  bool named = false;
  const auto head = [&](int number) {
    if (number == 2) submap.version = std::int32_t(wire.varint());
    if (number == 3) submap.finished = wire.varint() != 0;
    return number == 2 || number == 3;
  };
  // Before the cells: true, they are not read. What is 0 or false is not written.
  const auto enough = [&] {
    if (named && submap.version != 0 && submap.finished && submap.resolution_m) wire.stop();
    return !wire.good();
  };
  wire.fields([&](int member) {
    if (member != int(RecordKind::Submap)) return false;
    wire.message([&](int number) {
      if (number == 1) {
        wire.read(id);
        submap.id = idFrom(id);
        named = true;
      } else if (number == 2) {
        wire.message([&](int field) {
          if (field != 4) return head(field);
          wire.message([&](int of_grid) {
            if (of_grid != 1) return enough();
            wire.read(limits);
            submap.resolution_m = limits.resolution();
            return true;
          });
          return true;
        });
      } else if (number == 3) {
        submap.three_d = true;
        bool finest = false;  // is known
        wire.message([&](int field) {
          if (field != 4 && field != 5) return head(field);
          wire.message([&](int of_grid) {
            if (of_grid != 1) return finest && enough();
            const double resolution_m = double(wire.fixed32());
            if (field == 4 || !finest) submap.resolution_m = resolution_m;
            finest = finest || field == 4;
            return true;
          });
          return true;
        });
      } else {
        return false;
      }
      return true;
    });
    return true;
  });
  return wire.fault();
}

class Reading {
 public:
  Reading(std::shared_ptr<const RecordFile> file, const Cancelled& cancelled, const Progressed& progressed)
      : cancelled_(cancelled), progressed_(progressed), window_(*file), stream_(window_) {
    state_.file = std::move(file);
  }

  tl::expected<StateFile, Fault> run() {
    Record record;
    record.offset = kSignatureBytes;
    bool first = true;
    while (const auto next = sizeOf(record)) {
      record.packed = *next;
      if (record.packed == 0 && !first) {
        record = afterZeros(record);
        if (cancelled_ && cancelled_()) return tl::unexpected(Fault(fault::Cancelled));
        continue;
      }
      if (first) {
        if (Fault why = readHeader(record); why.any()) return tl::unexpected(std::move(why));
      } else {
        readRecord(record);
      }
      first = false;
      noteContent(record);
      if (record.number % kAskEvery == 0) {
        if (cancelled_ && cancelled_()) return tl::unexpected(Fault(fault::Cancelled));
        if (progressed_) progressed_(double(record.end()) / double(state_.file->size()));
      }
      record = {record.number + 1, record.end(), 0};
    }
    if (first)
      return tl::unexpected(state_.warnings.empty() ? Fault(faultText("pbstream", "It holds no records."))
                                                    : state_.warnings.front());
    finish();
    return std::move(state_);
  }

 private:
  /// The size of the next record; nullopt: there is none, or it is cut.
  std::optional<std::uint64_t> sizeOf(const Record& record) {
    const std::uint64_t left = state_.file->size() - std::min(record.offset, state_.file->size());
    if (left == 0) return std::nullopt;
    const auto bytes = window_.at(record.offset, kSizeBytes);
    if (left >= kSizeBytes && bytes.size() >= kSizeBytes) {
      const std::uint64_t packed = sizeAt(window_, record.offset);
      if (packed <= left - kSizeBytes) return packed;
    }
    warn({fault::CutOff,
          {words::grouped(std::int64_t(record.number)), words::grouped(std::int64_t(record.offset))}});
    state_.cut = true;
    hash_.addData(viewOf(bytes.first(std::min(bytes.size(), kSizeBytes))));
    return std::nullopt;
  }

  /// Sizes that are 0, as a file has them that was not written to its end when the power went: one loss.
  Record afterZeros(const Record& from) {
    std::uint64_t zeros = 0;
    for (bool more = true; more;) {
      const auto bytes = window_.at(from.offset + zeros, kSizeBytes);
      const auto end = std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte != 0; });
      zeros += std::uint64_t(end - bytes.begin());
      more = end == bytes.end() && !bytes.empty() && !(cancelled_ && cancelled_());
    }
    const std::uint64_t count = std::max<std::uint64_t>(zeros / kSizeBytes, 1);
    warn(inRecord(from, {faultText("pbstream", "from there on %1 bytes are zero"),
                         {words::grouped(std::int64_t(count * kSizeBytes))}}));
    const std::uint64_t zero = 0;
    hash_.addData({reinterpret_cast<const char*>(&zero), qsizetype(sizeof zero)});
    Record record = from;
    record.number += decltype(record.number)(count);
    record.offset += count * kSizeBytes;
    return record;
  }

  /// The checksum of what a record holds stands at its end.
  void noteContent(const Record& record) {
    hash_.addData({reinterpret_cast<const char*>(&record.packed), qsizetype(sizeof record.packed)});
    const std::size_t most = std::size_t(std::min<std::uint64_t>(kTrailerBytes, record.packed));
    const auto trailer = window_.at(record.end() - most, most + kSizeBytes);
    hash_.addData(viewOf(trailer.first(std::min(most, trailer.size()))));
  }

  void warn(Fault why) {
    if (state_.warnings.size() < StateFile::kMostWarnings) return state_.warnings.push_back(std::move(why));
    ++state_.further_warnings;
  }

  Fault readHeader(const Record& record) {
    stream_.start(record);
    Wire wire(&stream_);
    bool old = false;
    std::optional<std::uint64_t> version;
    wire.fields([&](int number) {
      // Before 1.0 the first record was the pose graph itself.
      if (!version && (number == 2 || number == 4 || number == 5)) {
        old = true;
        wire.stop();
        return true;
      }
      if (number != 1) return false;
      version = wire.varint();
      return true;
    });
    if (old) return {fault::VersionNotSupported, {std::int64_t(0)}};
    if (!version || !wire.good()) {
      const Fault of_stream = stream_.fault();
      return inRecord(record, of_stream.any()
                                  ? of_stream
                                  : Fault(faultText("pbstream", "it is not the header of a state file")));
    }
    if (*version != 1 && *version != 2)
      return {fault::VersionNotSupported, {std::int64_t(std::min<std::uint64_t>(*version, 0xFFFFFFFF))}};
    state_.format_version = std::uint32_t(*version);
    return {};
  }

  void readRecord(const Record& record) {
    stream_.start(record);
    Fault why;
    const RecordKind kind = kindOf(stream_, why);
    if (why.any()) return warn(inRecord(record, std::move(why)));
    ++state_.records[std::size_t(kind)];
    stream_.start(record);
    if (kind == RecordKind::PoseGraph) why = takeGraph();
    if (kind == RecordKind::Submap) why = takeSubmap(record);
    if (kind == RecordKind::Node) why = takeNode();
    if (kind == RecordKind::Options) why = takeOptions();
    if (kind == RecordKind::Unknown) why = faultText("pbstream", "it is of a kind that is not known");
    // What breaks a stream breaks the message in it.
    if (why.any()) warn(inRecord(record, stream_.fault().any() ? stream_.fault() : std::move(why)));
  }

  Fault takeGraph() {
    if (state_.graph) return faultText("pbstream", "there is another pose graph before it: that one counts");
    Wire wire(&stream_);
    ReadGraph read;
    wire.fields([&](int member) {
      if (member != int(RecordKind::PoseGraph)) return false;
      read = readPoseGraph(wire);
      return true;
    });
    stream_.finish();
    Fault why = stream_.fault().any() ? stream_.fault() : wire.fault();
    if (!why.any() && !read.odd.empty()) why = read.odd.front();
    // What was read before it broke off is kept, like the records before a cut.
    state_.graph = std::make_shared<const map::PoseGraph>(std::move(read.graph));
    return why;
  }

  Fault takeSubmap(const Record& record) {
    StoredSubmap submap;
    submap.record = record;
    if (Fault why = readSubmapHead(stream_, submap); why.any()) return why;
    if (state_.submaps.size() >= kMostSubmaps)
      return faultText("pbstream", "there are too many submaps before it");
    state_.submaps.push_back(submap);
    return {};
  }

  Fault takeNode() {
    Wire wire(&stream_);
    cartographer_state::NodeId id;
    wire.fields([&](int member) {
      if (member != int(RecordKind::Node)) return false;
      wire.message([&](int number) {
        if (number != 1) return false;
        wire.read(id);
        wire.stop();
        return true;
      });
      return true;
    });
    if (wire.fault().any()) return wire.fault();
    if (state_.nodes.size() < kMostNodeRecords) state_.nodes.push_back({id.trajectory_id(), id.node_index()});
    return {};
  }

  Fault takeOptions() {
    Wire wire(&stream_);
    std::size_t lists = 0;
    wire.fields([&](int member) {
      if (member != int(RecordKind::Options)) return false;
      wire.message([&](int number) {
        if (number == 1) ++lists;
        return false;
      });
      return true;
    });
    if (!wire.fault().any()) state_.option_lists = lists;
    return wire.fault();
  }

  void finish() {
    auto& submaps = state_.submaps;
    std::stable_sort(submaps.begin(), submaps.end(),
                     [](const StoredSubmap& a, const StoredSubmap& b) { return a.id < b.id; });
    std::vector<StoredSubmap> kept;
    for (const StoredSubmap& submap : submaps) {
      if (kept.empty() || kept.back().id != submap.id)
        kept.push_back(submap);
      else
        warn(inRecord(submap.record,
                      {faultText("pbstream", "submap %1 is in the file before it: that one counts"),
                       {map::toText(submap.id)}}));
    }
    submaps = std::move(kept);
    if (!state_.graph) {
      warn(faultText("pbstream", "It holds no pose graph, so nothing in it has a place."));
      state_.graph = std::make_shared<const map::PoseGraph>();
    }
    std::sort(state_.nodes.begin(), state_.nodes.end());
    for (const map::NodeId id : state_.nodes) {
      if (!hasPose(id)) ++state_.nodes_without_pose;
    }
    state_.uuid = hash_.result().toHex().left(32).toStdString();
  }

  bool hasPose(map::NodeId id) const {
    const auto& all = state_.graph->trajectories;
    const auto of =
        std::lower_bound(all.begin(), all.end(), id.trajectory,
                         [](const map::Trajectory& one, std::int32_t wanted) { return one.id < wanted; });
    return of != all.end() && of->id == id.trajectory &&
           std::binary_search(of->nodes.begin(), of->nodes.end(), map::TrajectoryNode{id, {}, {}},
                              [](const auto& a, const auto& b) { return a.id < b.id; });
  }

  const Cancelled& cancelled_;
  const Progressed& progressed_;
  FileWindow window_;
  RecordStream stream_;
  QCryptographicHash hash_{QCryptographicHash::Sha256};
  StateFile state_;
};

}  // namespace

const char* nameOf(RecordKind kind) {
  static constexpr std::array<const char*, kRecordKinds> kNames{
      "unknown",      "pose_graph",    "all_trajectory_builder_options",
      "submap",       "node",          "trajectory_data",
      "imu_data",     "odometry_data", "fixed_frame_pose_data",
      "landmark_data"};
  return kNames[std::size_t(kind)];
}

RecordKind kindOf(RecordStream& stream, Fault& wrong) {
  Wire wire(&stream);
  RecordKind kind = RecordKind::Unknown;
  wire.fields([&](int number) {
    if (number >= int(kRecordKinds)) return false;
    kind = RecordKind(number);
    wire.mustBeMessage();
    wire.stop();
    return true;
  });
  wrong = wire.fault();
  if (const Fault of_stream = stream.fault(); of_stream.any() && kind == RecordKind::Unknown)
    wrong = of_stream;
  return kind;
}

const StoredSubmap* StateFile::find(map::SubmapId id) const {
  const auto at =
      std::lower_bound(submaps.begin(), submaps.end(), id,
                       [](const StoredSubmap& one, map::SubmapId wanted) { return one.id < wanted; });
  return at != submaps.end() && at->id == id ? &*at : nullptr;
}

const geometry::Pose3* StateFile::poseOf(map::SubmapId id) const {
  const auto& all = graph->submaps;
  const auto at =
      std::lower_bound(all.begin(), all.end(), id,
                       [](const map::SubmapPose& one, map::SubmapId wanted) { return one.id < wanted; });
  return at != all.end() && at->id == id ? &at->pose : nullptr;
}

std::vector<Fault> StateFile::losses() const {
  std::vector<Fault> all = warnings;
  if (further_warnings > 0)
    all.push_back({faultText("pbstream", "There are more of these: %1."),
                   {words::grouped(std::int64_t(further_warnings))}});
  const auto add = [&](std::vector<std::string> names, FaultCode code) {
    constexpr std::size_t kMostNamed = 5;
    if (names.empty()) return;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i)
      text += (i > 0 ? ", " : "") + names[i];
    if (names.size() > kMostNamed) text += " …";
    all.push_back({code, {words::grouped(std::int64_t(names.size())), text}});
  };
  std::vector<std::string> unplaced, missing;
  for (const StoredSubmap& submap : submaps) {
    if (!poseOf(submap.id)) unplaced.push_back(map::toText(submap.id));
  }
  for (const map::SubmapPose& submap : graph->submaps) {
    if (!find(submap.id)) missing.push_back(map::toText(submap.id));
  }
  add(std::move(unplaced), faultText("pbstream", "Submaps without a place in the pose graph: %1 (%2)."));
  add(std::move(missing),
      faultText("pbstream", "Submaps that are missing although the pose graph gives them a place: %1 (%2)."));
  return all;
}

tl::expected<StateFile, Fault> readStateFile(const std::string& path, const Cancelled& cancelled,
                                             const Progressed& progressed) {
  auto file = RecordFile::open(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  return Reading(std::move(*file), cancelled, progressed).run();
}

}  // namespace mapwright::pbstream
