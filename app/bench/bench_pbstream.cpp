// Cartographer's state files: how soon it is known what is in one, and how soon all its submaps are textures.
// The baselines unpack every record whole with zlib and parse it with protobuf, in the same run.
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>
#include <zlib.h>

#include <QTemporaryDir>
#include <benchmark/benchmark.h>

#include "cartographer/state.pb.h"
#include "pbstream/state_file.h"
#include "pbstream/submap_texture.h"
#include "robots_words.h"

namespace {

using namespace mapwright;
namespace proto = cartographer_state;

constexpr int kCells = 200, kNodesPerSubmap = 40, kImuPerSubmap = 2'000;

void appendRecord(std::string& file, const std::string& message) {
  std::string packed(compressBound(uLong(message.size())) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(message.data()));
  stream.avail_in = uInt(message.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  for (int i = 0; i < 8; ++i) file += char(std::uint64_t(packed.size()) >> (8 * i));
  file += packed;
}

proto::SerializedData submapOf(int index, std::mt19937& random) {
  proto::SerializedData data;
  auto& submap = *data.mutable_submap();
  submap.mutable_submap_id()->set_submap_index(index);
  auto& stored = *submap.mutable_submap_2d();
  stored.mutable_local_pose()->mutable_rotation()->set_w(1);
  stored.set_num_range_data(90);
  stored.set_finished(true);
  auto& grid = *stored.mutable_grid();
  grid.mutable_limits()->set_resolution(0.05);
  grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(kCells);
  grid.mutable_limits()->mutable_cell_limits()->set_num_y_cells(kCells);
  for (int at = 0; at < kCells * kCells; ++at) {
    const bool wall = at % kCells % 40 < 2, known = random() % 10 < 4;
    grid.add_cells(!known ? 0 : wall ? 1 + int(random() % 9'000) : 25'000 + int(random() % 7'000));
  }
  grid.mutable_known_cells_box()->set_max_x(kCells - 1);
  grid.mutable_known_cells_box()->set_max_y(kCells - 1);
  grid.mutable_probability_grid_2d();
  grid.set_min_correspondence_cost(0.1f);
  grid.set_max_correspondence_cost(0.9f);
  return data;
}

/// Submaps with nodes, whose scans are left out of the messages here and stand in as bytes of an unknown
/// field, and IMU records, of which a file has by far the most.
std::string stateFile(int submaps) {
  std::mt19937 random(5);
  std::string file("\xDB\x01\xF5\x5B\x7B\x1F\x1D\x7B", 8);
  proto::SerializationHeader header;
  header.set_format_version(2);
  appendRecord(file, header.SerializeAsString());
  proto::SerializedData graph;
  auto& trajectory = *graph.mutable_pose_graph()->add_trajectory();
  for (int s = 0; s < submaps; ++s) {
    auto& submap = *trajectory.add_submap();
    submap.set_submap_index(s);
    submap.mutable_pose()->mutable_translation()->set_x(2.0 * s);
    submap.mutable_pose()->mutable_rotation()->set_w(1);
    for (int n = s * kNodesPerSubmap; n < (s + 1) * kNodesPerSubmap; ++n) {
      auto& node = *trajectory.add_node();
      node.set_node_index(n);
      *node.mutable_pose() = submap.pose();
      auto& constraint = *graph.mutable_pose_graph()->add_constraint();
      constraint.mutable_submap_id()->set_submap_index(s);
      constraint.mutable_node_id()->set_node_index(n);
      constraint.mutable_relative_pose()->mutable_rotation()->set_w(1);
    }
  }
  appendRecord(file, graph.SerializeAsString());
  for (int s = 0; s < submaps; ++s) appendRecord(file, submapOf(s, random).SerializeAsString());
  std::string scan(4'000, '\0');
  for (char& byte : scan) byte = char(random());
  for (int n = 0; n < submaps * kNodesPerSubmap; ++n) {
    proto::SerializedData data;
    data.mutable_node()->mutable_node_id()->set_node_index(n);
    auto* const node = data.mutable_node();
    node->GetReflection()->MutableUnknownFields(node)->AddLengthDelimited(5, scan);
    appendRecord(file, data.SerializeAsString());
  }
  proto::SerializedData imu;
  auto* const measured = imu.mutable_imu_data();
  measured->GetReflection()->MutableUnknownFields(measured)->AddLengthDelimited(2, scan.substr(0, 80));
  const std::string imu_bytes = imu.SerializeAsString();
  for (int i = 0; i < submaps * kImuPerSubmap; ++i) appendRecord(file, imu_bytes);
  return file;
}

class StoredState {
 public:
  explicit StoredState(int submaps)
      : folder_(bench::folderOnDisk()), path_(folder_.filePath(QStringLiteral("a.pbstream")).toStdString()) {
    const std::string bytes = stateFile(submaps);
    std::ofstream(path_, std::ios::binary) << bytes;
    bytes_ = bytes.size();
  }
  const std::string& path() const { return path_; }
  double bytes() const { return double(bytes_); }

 private:
  QTemporaryDir folder_;
  std::string path_;
  std::size_t bytes_ = 0;
};

void countBytes(benchmark::State& state, const StoredState& file) {
  state.counters["file_mb"] = file.bytes() / 1e6;
  state.SetBytesProcessed(std::int64_t(file.bytes()) * std::int64_t(state.iterations()));
}

/// What is in the file: all records, poses and constraints, without cells.
void PbstreamOpen(benchmark::State& state) {
  const StoredState file(int(state.range(0)));
  for (auto _ : state) {
    const auto read = pbstream::readStateFile(file.path());
    if (!read || read->submaps.size() != std::size_t(state.range(0)) || !read->warnings.empty())
      state.SkipWithError("the file is not read as it was written");
  }
  countBytes(state, file);
}
BENCHMARK(PbstreamOpen)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

/// And the textures of all submaps, on one core.
void PbstreamOpenWithTextures(benchmark::State& state) {
  const StoredState file(int(state.range(0)));
  for (auto _ : state) {
    const auto read = pbstream::readStateFile(file.path());
    for (const pbstream::StoredSubmap& submap : read->submaps) {
      const auto textures = pbstream::readTextures(*read->file, submap, *read->poseOf(submap.id));
      if (!textures || textures->slices.size() != 1) state.SkipWithError("a submap has no texture");
    }
  }
  countBytes(state, file);
}
BENCHMARK(PbstreamOpenWithTextures)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The baseline, as private scripts do it: every record unpacked and parsed whole.
void PbstreamPlain(benchmark::State& state) {
  const StoredState file(int(state.range(0)));
  for (auto _ : state) {
    std::ifstream in(file.path(), std::ios::binary);
    in.seekg(8);
    std::string packed, unpacked(std::size_t(16) << 20, '\0');
    std::int64_t submaps = -1, cells = 0;  // the first record is the header
    for (std::array<unsigned char, 8> size; in.read(reinterpret_cast<char*>(size.data()), 8);) {
      std::uint64_t length = 0;
      for (std::size_t i = 8; i-- > 0;) length = length << 8 | size[i];
      packed.resize(length);
      in.read(packed.data(), std::streamsize(length));
      z_stream stream{};
      inflateInit2(&stream, 16 + MAX_WBITS);
      stream.next_in = reinterpret_cast<Bytef*>(packed.data());
      stream.avail_in = uInt(length);
      stream.next_out = reinterpret_cast<Bytef*>(unpacked.data());
      stream.avail_out = uInt(unpacked.size());
      inflate(&stream, Z_FINISH);
      const auto parsed_bytes = int(stream.total_out);
      inflateEnd(&stream);
      if (submaps < 0) {
        submaps = 0;
        continue;
      }
      proto::SerializedData data;
      data.ParseFromArray(unpacked.data(), parsed_bytes);
      if (!data.has_submap()) continue;
      ++submaps;
      for (const std::int32_t cell : data.submap().submap_2d().grid().cells()) cells += cell;
    }
    benchmark::DoNotOptimize(cells);
    if (submaps != state.range(0)) state.SkipWithError("submaps are missing");
  }
  countBytes(state, file);
}
BENCHMARK(PbstreamPlain)->Arg(100)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
