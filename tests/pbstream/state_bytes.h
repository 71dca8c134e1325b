// State files as bytes, made of messages.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>
#include <zlib.h>

#include <QFile>
#include <QTemporaryDir>

#include "cartographer/state.pb.h"
#include "pbstream/state_file.h"

namespace mapwright::pbstream::tests {

inline std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value > 0x7F; value >>= 7) bytes.push_back(char((value & 0x7F) | 0x80));
  bytes.push_back(char(value));
  return bytes;
}

inline std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, uLong(bytes.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::string sized(const std::string& packed, std::uint64_t size) {
  std::string record(8, '\0');
  for (std::size_t i = 0; i < 8; ++i) record[i] = char(size >> (8 * i));
  return record + packed;
}
inline std::string record(const std::string& message) {
  const std::string packed = gzipped(message);
  return sized(packed, packed.size());
}
inline std::string record(const google::protobuf::Message& message) {
  return record(message.SerializeAsString());
}

inline std::string signature() { return std::string("\xDB\x01\xF5\x5B\x7B\x1F\x1D\x7B", 8); }
inline std::string header(std::uint32_t version = 2) {
  cartographer_state::SerializationHeader header;
  header.set_format_version(version);
  return signature() + record(header);
}

inline void place(cartographer_state::Rigid3d& pose, double x, double y, double yaw = 0) {
  pose.mutable_translation()->set_x(x);
  pose.mutable_translation()->set_y(y);
  pose.mutable_rotation()->set_z(std::sin(yaw / 2));
  pose.mutable_rotation()->set_w(std::cos(yaw / 2));
}

/// Cells of a room of 1 x 1 m at 5 cm, its walls known.
inline void fill(cartographer_state::Submap2D& submap, int trajectory_of_cells = 1) {
  place(*submap.mutable_local_pose(), 0.5, 0.5);
  submap.set_num_range_data(40);
  submap.set_finished(true);
  auto& grid = *submap.mutable_grid();
  grid.mutable_limits()->set_resolution(0.05);
  grid.mutable_limits()->mutable_max()->set_x(1.5);
  grid.mutable_limits()->mutable_max()->set_y(1.5);
  grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(20);
  grid.mutable_limits()->mutable_cell_limits()->set_num_y_cells(20);
  for (int i = 0; i < 400; ++i) grid.add_cells((i * 37 * trajectory_of_cells) % 32768);
  grid.mutable_known_cells_box()->set_max_x(19);
  grid.mutable_known_cells_box()->set_max_y(19);
  grid.mutable_probability_grid_2d();
  grid.set_min_correspondence_cost(0.1f);
  grid.set_max_correspondence_cost(0.9f);
}

inline cartographer_state::SerializedData submapRecord(int trajectory, int index) {
  cartographer_state::SerializedData data;
  auto& submap = *data.mutable_submap();
  submap.mutable_submap_id()->set_trajectory_id(trajectory);
  submap.mutable_submap_id()->set_submap_index(index);
  fill(*submap.mutable_submap_2d(), index + 1);
  return data;
}

inline cartographer_state::SerializedData nodeRecord(int trajectory, int index) {
  cartographer_state::SerializedData data;
  data.mutable_node()->mutable_node_id()->set_trajectory_id(trajectory);
  data.mutable_node()->mutable_node_id()->set_node_index(index);
  return data;
}

inline cartographer_state::SerializedData imuRecord(int trajectory) {
  cartographer_state::SerializedData data;
  data.mutable_imu_data()->set_trajectory_id(trajectory);
  return data;
}

/// Two trajectories, 0 with submaps 0 and 1 and nodes 0 to 3, 1 with submap 0 and nodes 0 and 1; constraints
/// within and between them.
inline cartographer_state::SerializedData graphRecord() {
  cartographer_state::SerializedData data;
  auto& graph = *data.mutable_pose_graph();
  const auto add = [&](int st, int s, int nt, int n, bool inter, double x) {
    auto& constraint = *graph.add_constraint();
    constraint.mutable_submap_id()->set_trajectory_id(st);
    constraint.mutable_submap_id()->set_submap_index(s);
    constraint.mutable_node_id()->set_trajectory_id(nt);
    constraint.mutable_node_id()->set_node_index(n);
    place(*constraint.mutable_relative_pose(), x, 0);
    constraint.set_tag(inter ? cartographer_state::Constraint::INTER_SUBMAP
                             : cartographer_state::Constraint::INTRA_SUBMAP);
    constraint.set_translation_weight(10);
    constraint.set_rotation_weight(20);
  };
  for (const int t : {0, 1}) {
    auto& trajectory = *graph.add_trajectory();
    trajectory.set_trajectory_id(t);
    for (int n = 0; n < (t == 0 ? 4 : 2); ++n) {
      auto& node = *trajectory.add_node();
      node.set_node_index(n);
      node.set_timestamp(621'355'968'000'000'000 + (1'700'000'000LL + n) * 10'000'000 + 5'000'000);
      place(*node.mutable_pose(), n, t);
    }
    for (int s = 0; s < (t == 0 ? 2 : 1); ++s) {
      auto& submap = *trajectory.add_submap();
      submap.set_submap_index(s);
      place(*submap.mutable_pose(), 2 * s, t);
    }
  }
  for (int n = 0; n < 4; ++n) add(0, n / 2, 0, n, false, n % 2);
  add(1, 0, 1, 0, false, 0);
  add(1, 0, 1, 1, false, 1);
  add(0, 0, 0, 3, true, 5);   // lies at 3
  add(0, 1, 1, 1, true, -1);  // another trajectory
  return data;
}

inline cartographer_state::SerializedData optionsRecord(int trajectories) {
  cartographer_state::SerializedData data;
  data.mutable_all_trajectory_builder_options();
  for (int i = 0; i < trajectories; ++i)
    data.mutable_all_trajectory_builder_options()->add_options_with_sensor_ids();
  return data;
}

/// All of it, as Cartographer writes it.
inline std::string wholeFile() {
  std::string file = header() + record(graphRecord()) + record(optionsRecord(2)) +
                     record(submapRecord(0, 0)) + record(submapRecord(0, 1)) + record(submapRecord(1, 0));
  for (int n = 0; n < 4; ++n) file += record(nodeRecord(0, n));
  for (int n = 0; n < 2; ++n) file += record(nodeRecord(1, n));
  for (int i = 0; i < 5; ++i) file += record(imuRecord(i % 2));
  return file;
}

/// A message with its fields from the last to the first, as protobuf allows; what is repeated keeps its
/// order.
inline std::string backwards(const google::protobuf::Message& message) {
  std::vector<const google::protobuf::FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  std::string bytes;
  for (auto field = fields.rbegin(); field != fields.rend(); ++field) {
    const std::unique_ptr<google::protobuf::Message> alone(message.New());
    alone->CopyFrom(message);
    for (const auto* const other : fields) {
      if (other != *field) alone->GetReflection()->ClearField(alone.get(), other);
    }
    if ((*field)->cpp_type() != google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE) {
      bytes += alone->SerializeAsString();
      continue;
    }
    const auto& reflection = *alone->GetReflection();
    const int count = (*field)->is_repeated() ? reflection.FieldSize(*alone, *field) : 1;
    for (int i = 0; i < count; ++i) {
      const std::string inner =
          backwards((*field)->is_repeated() ? reflection.GetRepeatedMessage(*alone, *field, i)
                                            : reflection.GetMessage(*alone, *field));
      bytes += varint(std::uint64_t((*field)->number()) << 3 | 2) + varint(inner.size()) + inner;
    }
  }
  return bytes;
}

/// Files that are removed with it.
class Folder {
 public:
  std::string write(const std::string& bytes, const char* name = "map.pbstream") const {
    const QString path = dir_.filePath(QLatin1String(name));
    QFile file(path);
    (void)file.remove();  // some file systems wait for the disk where a file is cut to nothing
    (void)file.open(QIODevice::WriteOnly);
    file.write(bytes.data(), qint64(bytes.size()));
    return path.toStdString();
  }
  std::string path(const char* name) const { return dir_.filePath(QLatin1String(name)).toStdString(); }

 private:
  QTemporaryDir dir_;
};

}  // namespace mapwright::pbstream::tests
