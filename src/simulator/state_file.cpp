#include "simulator/state_file.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "cartographer/state.pb.h"
#include "simulator/encoding.h"
#include "simulator/noise.h"
#include "simulator/value.h"

namespace mapwright::simulator {
namespace {

constexpr std::int64_t kMostStateCells = 1'000'000;
constexpr int kSubmapCells = 300, kOverlapCells = 60;
constexpr std::uint8_t kDarkest = 90, kBrightest = 170;  // what is between is unknown
constexpr std::int64_t kBegunTicks = 637'000'000'000'000'000, kTicksPerS = 10'000'000;  // 100 ns since year 1
constexpr double kClosureOffM = 0.02;

/// One submap, in cells from the upper left corner of the picture.
struct Piece {
  int left = 0, top = 0, right = 0, bottom = 0;
};

std::string recordOf(const google::protobuf::Message& message) {
  const std::string packed = gzip(message.SerializeAsString());
  std::string record;
  appendNumber(record, std::uint64_t{packed.size()});
  return record + packed;
}

void place(cartographer_state::Rigid3d& pose, double x_m, double y_m) {
  pose.mutable_translation()->set_x(x_m);
  pose.mutable_translation()->set_y(y_m);
  pose.mutable_rotation()->set_w(1);
}

/// 0 unknown, 1 certainly occupied ... 32,767 certainly free, never twice quite the same.
int costOf(std::uint8_t level, std::uint64_t noise) {
  if (level > kDarkest && level < kBrightest) return 0;
  return (level <= kDarkest ? 1'000 : 28'000) + static_cast<int>(noise % 16) * 100;
}

class StateFile {
 public:
  StateFile(const MapPicture& picture, const GrayPicture& gray) : picture_(picture), gray_(gray) {
    while (std::int64_t(gray.width / step_) * (gray.height / step_) > kMostStateCells) step_ *= 2;
    cell_m_ = picture.resolution_m * step_;
    constexpr int kStride = kSubmapCells - kOverlapCells;
    const int width = gray.width / step_, height = gray.height / step_;
    for (int top = 0; top < height; top += kStride) {
      for (int left = 0; left < width; left += kStride)
        add({left, top, std::min(left + kSubmapCells, width), std::min(top + kSubmapCells, height)});
    }
  }

  std::string bytes() const {
    cartographer_state::SerializationHeader header;
    header.set_format_version(2);
    cartographer_state::SerializedData options;
    options.mutable_all_trajectory_builder_options()->add_options_with_sensor_ids();
    std::string bytes("\xDB\x01\xF5\x5B\x7B\x1F\x1D\x7B", 8);
    bytes += recordOf(header) + recordOf(graph_) + recordOf(options);
    for (const cartographer_state::SerializedData& data : submaps_) bytes += recordOf(data);
    for (int index = 0; index < static_cast<int>(submaps_.size()); ++index) {
      cartographer_state::SerializedData node;
      node.mutable_node()->mutable_node_id()->set_node_index(index);
      bytes += recordOf(node);
    }
    return bytes;
  }

 private:
  void add(const Piece& piece) {
    const int index = static_cast<int>(submaps_.size());
    cartographer_state::SerializedData data;
    cartographer_state::Submap2D& submap = *data.mutable_submap()->mutable_submap_2d();
    data.mutable_submap()->mutable_submap_id()->set_submap_index(index);
    cartographer_state::Grid2D& grid = *submap.mutable_grid();
    bool any = false;
    // Rows of the grid run along -x, its columns along -y.
    for (int column = piece.right - 1; column >= piece.left; --column) {
      for (int row = piece.top; row < piece.bottom; ++row) {
        const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(step_) *
                                   static_cast<std::size_t>(gray_.width) +
                               static_cast<std::size_t>(column) * static_cast<std::size_t>(step_);
        const int cost = costOf(gray_.levels[at], hashOf(index, at));
        grid.add_cells(cost);
        any = any || cost != 0;
      }
    }
    if (!any) return;
    const double right_m = picture_.origin_m.x() + piece.right * cell_m_;
    const double top_m =
        picture_.origin_m.y() + picture_.height * picture_.resolution_m - piece.top * cell_m_;
    const int wide = piece.right - piece.left, high = piece.bottom - piece.top;
    grid.mutable_limits()->set_resolution(cell_m_);
    grid.mutable_limits()->mutable_max()->set_x(right_m);
    grid.mutable_limits()->mutable_max()->set_y(top_m);
    grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(high);
    grid.mutable_limits()->mutable_cell_limits()->set_num_y_cells(wide);
    grid.mutable_known_cells_box()->set_max_x(high - 1);
    grid.mutable_known_cells_box()->set_max_y(wide - 1);
    grid.mutable_probability_grid_2d();
    grid.set_min_correspondence_cost(0.1f);
    grid.set_max_correspondence_cost(0.9f);
    const double x_m = right_m - wide * cell_m_ / 2, y_m = top_m - high * cell_m_ / 2;
    place(*submap.mutable_local_pose(), x_m, y_m);
    submap.set_num_range_data(kSubmapCells);
    submap.set_finished(true);
    submaps_.push_back(std::move(data));
    addToGraph(index, x_m, y_m);
  }

  void addToGraph(int index, double x_m, double y_m) {
    cartographer_state::PoseGraph& graph = *graph_.mutable_pose_graph();
    cartographer_state::Trajectory& way =
        graph.trajectory_size() > 0 ? *graph.mutable_trajectory(0) : *graph.add_trajectory();
    const auto constrain = [&](int submap, double along_x_m, double along_y_m,
                               cartographer_state::Constraint::Tag tag) {
      cartographer_state::Constraint& constraint = *graph.add_constraint();
      constraint.mutable_submap_id()->set_submap_index(submap);
      constraint.mutable_node_id()->set_node_index(index);
      place(*constraint.mutable_relative_pose(), along_x_m, along_y_m);
      constraint.set_tag(tag);
      constraint.set_translation_weight(1e4);
      constraint.set_rotation_weight(1e4);
    };
    constrain(index, 0, 0, cartographer_state::Constraint::INTRA_SUBMAP);
    if (index > 0) {
      const auto& before = way.submap(index - 1).pose().translation();
      constrain(index - 1, x_m - before.x() + kClosureOffM * (index % 3), y_m - before.y(),
                cartographer_state::Constraint::INTER_SUBMAP);
    }
    cartographer_state::TrajectorySubmap& submap = *way.add_submap();
    submap.set_submap_index(index);
    place(*submap.mutable_pose(), x_m, y_m);
    cartographer_state::TrajectoryNode& node = *way.add_node();
    node.set_node_index(index);
    node.set_timestamp(kBegunTicks + index * kTicksPerS);
    place(*node.mutable_pose(), x_m, y_m);
  }

  const MapPicture& picture_;
  const GrayPicture& gray_;
  int step_ = 1;  // pixels for one cell
  double cell_m_ = 0;
  cartographer_state::SerializedData graph_;
  std::vector<cartographer_state::SerializedData> submaps_;
};

}  // namespace

std::string stateFileOf(const MapPicturePtr& picture) {
  const std::optional<GrayPicture> gray = picture ? readPng(*picture->png) : std::nullopt;
  return picture && gray ? StateFile(*picture, *gray).bytes() : StateFile({}, {}).bytes();
}

}  // namespace mapwright::simulator
