#include "pbstream/drop.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <sys/stat.h>
#include <vector>

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include "cartographer/state.pb.h"
#include "disk/written_file.h"
#include "packed/codec.h"
#include "pbstream/faults.h"
#include "pbstream/poses.h"
#include "pbstream/record_stream.h"
#include "pbstream/wire.h"
#include "words/figures.h"

namespace mapwright::pbstream {
namespace {

using google::protobuf::internal::WireFormatLite;

constexpr std::size_t kPieceBytes = 1 << 20;
constexpr int kStages = 4;  // read, write, read again, compare

tl::unexpected<Fault> no(Fault why) { return tl::unexpected(std::move(why)); }

/// One field of a message as bytes.
struct RawField {
  int number = 0;
  bool is_message = false;   // or text, or packed numbers
  std::string_view whole;    // with its tag
  std::string_view content;  // of a message
};

/// Calls `on` for each field, in order. False: these bytes are no message.
bool eachField(std::string_view bytes, const std::function<bool(const RawField&)>& on) {
  google::protobuf::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                            int(bytes.size()));
  while (true) {
    const int begin = in.CurrentPosition();
    const std::uint32_t tag = in.ReadTag();
    if (tag == 0) return in.ConsumedEntireMessage() && std::size_t(begin) == bytes.size();
    RawField field;
    field.number = int(tag >> 3);
    field.is_message = (tag & 7) == WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
    int inside = 0;
    if (field.is_message) {
      std::uint32_t length = 0;
      if (!in.ReadVarint32(&length) || length > bytes.size()) return false;
      inside = in.CurrentPosition();
      if (!in.Skip(int(length))) return false;
    } else if (!WireFormatLite::SkipField(&in, tag)) {
      return false;
    }
    const auto end = std::size_t(in.CurrentPosition());
    field.whole = bytes.substr(std::size_t(begin), end - std::size_t(begin));
    if (field.is_message) field.content = bytes.substr(std::size_t(inside), end - std::size_t(inside));
    if (!on(field)) return false;
  }
}

void appendVarint(std::string& to, std::uint64_t value) {
  for (; value > 0x7F; value >>= 7) to.push_back(char((value & 0x7F) | 0x80));
  to.push_back(char(value));
}

void appendMessage(std::string& to, int number, std::string_view content) {
  appendVarint(to, std::uint64_t(number) << 3 | WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
  appendVarint(to, content.size());
  to += content;
}

bool goes(const Dropped& what, map::SubmapId id) {
  return what.submaps.contains(id) || what.trajectories.contains(id.trajectory);
}

bool goes(const Dropped& what, const map::Constraint& constraint) {
  return goes(what, constraint.submap) || what.trajectories.contains(constraint.node.trajectory) ||
         (constraint.kind == map::ConstraintKind::Inter &&
          what.closures.contains({constraint.submap, constraint.node}));
}

/// The pose graph without what goes.
map::PoseGraph without(const Dropped& what, map::PoseGraph graph) {
  std::erase_if(graph.trajectories, [&](const auto& one) { return what.trajectories.contains(one.id); });
  std::erase_if(graph.submaps, [&](const auto& one) { return goes(what, one.id); });
  std::erase_if(graph.constraints, [&](const auto& one) { return goes(what, one); });
  return graph;
}

/// Why that cannot be left out of this file; none: it can.
Fault refusalOf(const StateFile& file, const Dropped& what) {
  if (const std::vector<Fault> losses = file.losses(); !losses.empty())
    return {faultText("pbstream", "The file is damaged, so nothing of it can be left out safely"),
            {},
            {losses.front()}};
  const map::PoseGraph& graph = *file.graph;
  const auto has = [&](std::int32_t trajectory) {
    return std::any_of(graph.trajectories.begin(), graph.trajectories.end(),
                       [&](const auto& one) { return one.id == trajectory; });
  };
  for (const std::int32_t id : what.trajectories) {
    if (!has(id)) return {faultText("pbstream", "There is no trajectory %1 in it."), {std::int64_t(id)}};
  }
  if (what.trajectories.size() == graph.trajectories.size())
    return faultText("pbstream", "Without its only trajectory nothing would be left.");
  for (const map::SubmapId id : what.submaps) {
    if (!file.find(id)) return {faultText("pbstream", "There is no submap %1 in it."), {map::toText(id)}};
  }
  for (const auto& closure : what.closures) {
    const map::SubmapId submap = closure.first;
    const map::NodeId node = closure.second;
    const auto among = [&](map::ConstraintKind kind) {
      return std::any_of(graph.constraints.begin(), graph.constraints.end(), [&](const map::Constraint& one) {
        return one.submap == submap && one.node == node && one.kind == kind;
      });
    };
    const std::vector<FaultArgument> ids{map::toText(submap), map::toText(node)};
    if (among(map::ConstraintKind::Inter)) continue;
    if (among(map::ConstraintKind::Intra))
      return {faultText("pbstream", "%1 and %2 are no loop closure: the scan was inserted into that submap."),
              ids};
    return {faultText("pbstream", "There is no constraint between submap %1 and node %2 in it."), ids};
  }
  if (what.trajectories.empty()) return {};
  // Cartographer matches the two by their order.
  if (file.option_lists != graph.trajectories.size())
    return {faultText("pbstream",
                      "It has options for %1 trajectories and holds %2. So the options of a single one "
                      "cannot be found."),
            {std::int64_t(file.option_lists.value_or(0)), std::int64_t(graph.trajectories.size())}};
  return {};
}

/// A constraint that stays refers to what is there.
Fault danglingIn(const map::PoseGraph& graph) {
  std::set<map::SubmapId> submaps;
  for (const map::SubmapPose& one : graph.submaps) submaps.insert(one.id);
  std::set<map::NodeId> nodes;
  for (const map::Trajectory& trajectory : graph.trajectories) {
    for (const map::TrajectoryNode& one : trajectory.nodes) nodes.insert(nodes.end(), one.id);
  }
  for (const map::Constraint& one : graph.constraints) {
    if (!submaps.contains(one.submap) || !nodes.contains(one.node))
      return {faultText("pbstream",
                        "The constraint between submap %1 and node %2 would refer to what is not there."),
              {map::toText(one.submap), map::toText(one.node)}};
  }
  return {};
}

Fault exists(const std::string& path) {
  return {
      faultText("pbstream", "%1 exists already. A state file is never written over: choose another name."),
      {path}};
}

/// The same poses, also those that are not a number.
bool sameBits(const geometry::Pose3& a, const geometry::Pose3& b) {
  const auto same = [](double one, double other) {
    return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z) && same(a.qx, b.qx) && same(a.qy, b.qy) &&
         same(a.qz, b.qz) && same(a.qw, b.qw);
}

template <typename Item, typename Same>
bool sameItems(const std::vector<Item>& a, const std::vector<Item>& b, Same same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool sameGraph(const map::PoseGraph& a, const map::PoseGraph& b) {
  const auto submap = [](const auto& one, const auto& other) {
    return one.id == other.id && sameBits(one.pose, other.pose);
  };
  const auto node = [](const auto& one, const auto& other) {
    return one.id == other.id && one.stamp_s == other.stamp_s && sameBits(one.pose, other.pose);
  };
  const auto trajectory = [&](const auto& one, const auto& other) {
    return one.id == other.id && sameItems(one.nodes, other.nodes, node);
  };
  // The weights are bytes that were kept, and are compared with them.
  const auto constraint = [](const auto& one, const auto& other) {
    return one.submap == other.submap && one.node == other.node && one.kind == other.kind &&
           sameBits(one.relative_pose, other.relative_pose);
  };
  return sameItems(a.trajectories, b.trajectories, trajectory) && sameItems(a.submaps, b.submaps, submap) &&
         sameItems(a.constraints, b.constraints, constraint) && sameItems(a.landmarks, b.landmarks, submap);
}

Progressed stageOf(const Progressed& whole, int stage) {
  if (!whole) return {};
  return [&whole, stage](double done) { whole((stage + done) / kStages); };
}

/// Makes the new file from the old one, record by record.
class Dropping {
 public:
  Dropping(const StateFile& file, const Dropped& what, const Cancelled& cancelled,
           const Progressed& progressed)
      : file_(file),
        what_(what),
        cancelled_(cancelled),
        progressed_(progressed),
        window_(*file.file),
        stream_(window_) {
    expected_ = without(what, *file.graph);
  }

  const map::PoseGraph& expected() const { return expected_; }
  DropReceipt receipt;

  Fault write(disk::WrittenFile& out) {
    if (Fault why = rewriteGraph(); why.any()) return why;
    if (Fault why = copy(0, kSignatureBytes, out); why.any()) return why;
    for (Record record = first(); record.offset < file_.file->size(); record = next(record)) {
      if (over(record, 1)) return fault::Cancelled;
      Fault why;
      switch (fateOf(record, why)) {
        case Fate::Goes:
          ++receipt.records;
          break;
        case Fate::Stays:
          noteDamage(record);
          if (!why.any()) why = copy(record.offset, record.end(), out);
          break;
        case Fate::Rewritten:
          ++receipt.rewritten;
          why = writeRecord(record, out);
          break;
      }
      if (why.any()) return inRecord(record, std::move(why));
    }
    return out.finish() ? Fault() : disk::notWritten(*out.place());
  }

  /// Reads the new file and compares it with what it should be.
  Fault compare(const std::string& path) {
    const Fault differs(faultText("pbstream", "The new file is not what it should be, and was removed."));
    const auto made = readStateFile(path, cancelled_, stageOf(progressed_, 2));
    if (cancelled_ && cancelled_()) return fault::Cancelled;
    if (!made) return {differs.code, {}, {made.error()}};
    if (!made->losses().empty()) return {differs.code, {}, {made->losses().front()}};
    std::vector<map::SubmapId> before, now;
    for (const StoredSubmap& one : file_.submaps) {
      if (!goes(what_, one.id)) before.push_back(one.id);
    }
    for (const StoredSubmap& one : made->submaps) now.push_back(one.id);
    if (before != now || !sameGraph(*made->graph, expected_) ||
        made->format_version != file_.format_version ||
        (file_.option_lists && made->option_lists != *file_.option_lists - receipt.trajectories))
      return differs;
    const bool same = sameBytes(*made->file);
    if (cancelled_ && cancelled_()) return fault::Cancelled;
    return same ? Fault() : differs;
  }

 private:
  enum class Fate { Stays, Goes, Rewritten };

  /// True: cancelled.
  bool over(const Record& record, int stage) const {
    if (progressed_) stageOf(progressed_, stage)(double(record.offset) / double(file_.file->size()));
    return cancelled_ && cancelled_();
  }

  Record first() { return sized({0, kSignatureBytes, 0}); }
  Record next(const Record& record) { return sized({record.number + 1, record.end(), 0}); }
  /// With its size, which has been checked when the file was read.
  Record sized(Record record) {
    if (record.offset < file_.file->size()) record.packed = sizeAt(window_, record.offset);
    return record;
  }

  std::string unpacked(const Record& record) {
    std::string bytes;
    stream_.start(record);
    const void* data = nullptr;
    int size = 0;
    while (stream_.Next(&data, &size)) bytes.append(static_cast<const char*>(data), std::size_t(size));
    return bytes;
  }

  RecordKind kindAt(const Record& record) {
    if (record.number == 0) return RecordKind::Unknown;
    stream_.start(record);
    Fault why;
    return kindOf(stream_, why);
  }

  Fate fateOf(const Record& record, Fault& why) {
    const RecordKind kind = kindAt(record);
    if (kind == RecordKind::PoseGraph) return Fate::Rewritten;
    if (kind == RecordKind::Options) return what_.trajectories.empty() ? Fate::Stays : Fate::Rewritten;
    if (kind == RecordKind::Submap) {
      const auto at = std::find_if(file_.submaps.begin(), file_.submaps.end(), [&](const StoredSubmap& one) {
        return one.record.offset == record.offset;
      });
      return at != file_.submaps.end() && goes(what_, at->id) ? Fate::Goes : Fate::Stays;
    }
    if (kind == RecordKind::Unknown || what_.trajectories.empty()) return Fate::Stays;
    const auto trajectory = trajectoryAt(record, kind, why);
    return trajectory && what_.trajectories.contains(*trajectory) ? Fate::Goes : Fate::Stays;
  }

  /// Whose scan or sensor data it is.
  std::optional<std::int32_t> trajectoryAt(const Record& record, RecordKind kind, Fault& why) {
    stream_.start(record);
    Wire wire(&stream_);
    std::int32_t trajectory = 0;  // which is not written
    cartographer_state::NodeId node;
    wire.fields([&](int member) {
      if (member != int(kind)) return false;
      wire.message([&](int number) {
        if (number != 1) return false;
        if (kind == RecordKind::Node) {
          wire.read(node);
          trajectory = node.trajectory_id();
        } else {
          trajectory = std::int32_t(wire.varint());
        }
        return true;
      });
      return true;
    });
    why = stream_.fault().any() ? stream_.fault() : wire.fault();
    return why.any() ? std::nullopt : std::optional(trajectory);
  }

  Fault rewriteGraph() {
    for (Record record = first(); record.offset < file_.file->size(); record = next(record)) {
      if (kindAt(record) != RecordKind::PoseGraph) continue;
      const std::string old = unpacked(record);
      if (stream_.fault().any()) return inRecord(record, stream_.fault());
      const bool fine = eachField(old, [&](const RawField& field) {
        if (field.number != int(RecordKind::PoseGraph)) {
          graph_ += field.whole;
          return true;
        }
        std::string content;
        if (!eachField(field.content, [&](const RawField& part) { return rewritePart(part, content); }))
          return false;
        appendMessage(graph_, field.number, content);
        return true;
      });
      return fine ? Fault() : inRecord(record, fault::NotReadable);
    }
    return fault::NotReadable;
  }

  bool rewritePart(const RawField& part, std::string& to) {
    if (part.number == 2) {
      cartographer_state::Constraint message;
      if (!message.ParseFromArray(part.content.data(), int(part.content.size()))) return false;
      map::Constraint constraint;
      constraint.submap = idFrom(message.submap_id());
      constraint.node = {message.node_id().trajectory_id(), message.node_id().node_index()};
      constraint.kind = message.tag() == cartographer_state::Constraint::INTRA_SUBMAP
                            ? map::ConstraintKind::Intra
                            : map::ConstraintKind::Inter;
      if (goes(what_, constraint)) {
        ++(constraint.kind == map::ConstraintKind::Inter ? receipt.inter : receipt.intra);
        return true;
      }
    }
    if (part.number == 4) return rewriteTrajectory(part, to);
    to += part.whole;
    return true;
  }

  bool rewriteTrajectory(const RawField& part, std::string& to) {
    cartographer_state::Trajectory trajectory;
    if (!trajectory.ParseFromArray(part.content.data(), int(part.content.size()))) return false;
    const std::int32_t id = trajectory.trajectory_id();
    const bool all = what_.trajectories.contains(id);
    order_.push_back(id);
    if (all) {
      ++receipt.trajectories;
      receipt.nodes += std::size_t(trajectory.node_size());
      receipt.submaps += std::size_t(trajectory.submap_size());
      return true;
    }
    if (std::none_of(what_.submaps.begin(), what_.submaps.end(),
                     [&](map::SubmapId submap) { return submap.trajectory == id; })) {
      to += part.whole;
      return true;
    }
    std::string content;
    const bool fine = eachField(part.content, [&](const RawField& field) {
      if (field.number == 2) {
        cartographer_state::TrajectorySubmap submap;
        if (!submap.ParseFromArray(field.content.data(), int(field.content.size()))) return false;
        if (what_.submaps.contains({id, submap.submap_index()})) {
          ++receipt.submaps;
          return true;
        }
      }
      content += field.whole;
      return true;
    });
    appendMessage(to, part.number, content);
    return fine;
  }

  Fault writeRecord(const Record& record, disk::WrittenFile& out) {
    std::string message = graph_;
    if (kindAt(record) == RecordKind::Options) {
      const std::string old = unpacked(record);
      if (stream_.fault().any()) return stream_.fault();
      message.clear();
      std::size_t index = 0;
      const bool fine = eachField(old, [&](const RawField& field) {
        if (field.number != int(RecordKind::Options)) {
          message += field.whole;
          return true;
        }
        std::string content;
        if (!eachField(field.content, [&](const RawField& part) {
              const bool of_dropped =
                  part.number == 1 && index < order_.size() && what_.trajectories.contains(order_[index]);
              if (part.number == 1) ++index;
              if (!of_dropped) content += part.whole;
              return true;
            }))
          return false;
        appendMessage(message, field.number, content);
        return true;
      });
      if (!fine) return fault::NotReadable;
    }
    const packed::ByteBuffer packed =
        packed::packGzip({reinterpret_cast<const std::uint8_t*>(message.data()), message.size()});
    if (packed.size == 0) return faultText("pbstream", "there is not enough memory to rewrite it");
    std::uint8_t size[kSizeBytes];
    for (std::size_t i = 0; i < kSizeBytes; ++i) size[i] = std::uint8_t(packed.size >> (8 * i));
    out.write(size, sizeof size);
    out.write(packed.data.get(), packed.size);
    return {};
  }

  /// When the file was read, only the beginning of most records was unpacked.
  void noteDamage(const Record& record) {
    stream_.start(record);
    stream_.finish();
    if (!stream_.fault().any()) return;
    if (receipt.damaged.size() == DropReceipt::kMostDamaged)
      ++receipt.more_damaged;
    else
      receipt.damaged.push_back(inRecord(record, stream_.fault()));
  }

  Fault copy(std::uint64_t from, std::uint64_t to, disk::WrittenFile& out) {
    std::vector<std::uint8_t> piece(std::size_t(std::min<std::uint64_t>(kPieceBytes, to - from)));
    while (from < to && out.good()) {
      piece.resize(std::size_t(std::min<std::uint64_t>(kPieceBytes, to - from)));
      if (!file_.file->read(piece, from)) return faultText("pbstream", "it cannot be read any more");
      out.write(piece.data(), piece.size());
      from += piece.size();
    }
    return {};
  }

  /// All records that stay, but for those that were written anew.
  bool sameBytes(const RecordFile& made) {
    FileWindow made_window(made);
    Record now{0, kSignatureBytes, 0};
    for (Record record = first(); record.offset < file_.file->size(); record = next(record)) {
      if (over(record, 3)) return false;
      Fault why;
      const Fate fate = fateOf(record, why);
      if (fate == Fate::Goes) continue;
      if (now.offset >= made.size()) return false;
      now.packed = sizeAt(made_window, now.offset);
      if (fate == Fate::Stays && !same(record, now, made)) return false;
      now = {now.number + 1, now.end(), 0};
    }
    return now.offset == made.size();
  }

  bool same(const Record& before, const Record& now, const RecordFile& made) const {
    if (before.packed != now.packed) return false;
    std::vector<std::uint8_t> a, b;
    for (std::uint64_t at = 0; at < before.packed; at += a.size()) {
      a.resize(std::size_t(std::min<std::uint64_t>(kPieceBytes, before.packed - at)));
      b.resize(a.size());
      if (!file_.file->read(a, before.begin() + at) || !made.read(b, now.begin() + at) || a != b)
        return false;
    }
    return true;
  }

  const StateFile& file_;
  const Dropped& what_;
  const Cancelled& cancelled_;
  const Progressed& progressed_;
  FileWindow window_;
  RecordStream stream_;
  map::PoseGraph expected_;
  std::string graph_;                // the record of the pose graph, unpacked, without what goes
  std::vector<std::int32_t> order_;  // of the trajectories in it
};

}  // namespace

tl::expected<DropReceipt, Fault> drop(const std::string& from, const Dropped& what, const std::string& to,
                                      const Cancelled& cancelled, const Progressed& progressed) {
  struct stat there {};
  // A link that leads nowhere counts as well.
  if (::lstat(to.c_str(), &there) == 0) return no(exists(to));
  const auto file = readStateFile(from, cancelled, stageOf(progressed, 0));
  if (!file) return no(file.error());
  if (Fault why = refusalOf(*file, what); why.any()) return no(std::move(why));
  Dropping dropping(*file, what, cancelled, progressed);
  if (Fault why = danglingIn(dropping.expected()); why.any()) return no(std::move(why));
  // What has not been compared does not have the name, also if the program is killed.
  disk::WrittenFile out(to, disk::Existing::Refuse);
  if (Fault why = dropping.write(out); why.any()) return no(std::move(why));
  if (Fault why = dropping.compare(out.whereNow()); why.any()) return no(std::move(why));
  if (const auto error = out.place()) return no(disk::notWritten(*error));
  return dropping.receipt;
}

}  // namespace mapwright::pbstream
