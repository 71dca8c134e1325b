#include "simulator/submap_source.h"

#include <array>
#include <numbers>

#include <Eigen/Geometry>

#include "simulator/encoding.h"
#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr double kSharedRangeM = 3;

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d planar(const geometry::Pose2& pose) {
  Isometry3d transform = Isometry3d::Identity();
  transform.linear() = AngleAxisd(pose.yaw_rad, Vector3d::UnitZ()).toRotationMatrix();
  transform.translation() = Vector3d(pose.x_m, pose.y_m, 0);
  return transform;
}

geometry::Pose3 poseOf(const Isometry3d& transform) {
  const Eigen::Quaterniond q(transform.linear());
  const Vector3d t = transform.translation();
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

Packing packingOf(map::SubmapId id) {
  // Neighbours differ, and eight consecutive submaps show every way of packing.
  constexpr std::array<Packing, kPackings> kOrder{
      Packing::PngGray,    Packing::GzipPairs, Packing::PngGrayAlpha, Packing::RawBytes,
      Packing::PngPalette, Packing::ZlibPairs, Packing::GzipBytes,    Packing::RawPairs};
  return kOrder[static_cast<std::size_t>(id.index + 3 * id.trajectory) % kOrder.size()];
}

/// Without those that leave the cells as they are.
Packing smallPackingOf(map::SubmapId id) {
  constexpr std::array<Packing, 4> kOrder{Packing::PngGray, Packing::GzipPairs, Packing::PngGrayAlpha,
                                          Packing::ZlibPairs};
  return kOrder[static_cast<std::size_t>(id.index) % kOrder.size()];
}

CellFormat formatOf(const SubmapSource& source) {
  if (source.nearby && source.id.index % 3 == 1) return CellFormat::Intensity;
  return source.id.index % 5 == 3 ? CellFormat::TsdfDelta : CellFormat::LogOdds;
}

void addTexture(ros_messages::slam::SubmapQueryV2Response& response, const SubmapSource& source,
                const ScanGrid& grid, Packing packing, CellFormat format, int z_level) {
  ros_messages::slam::SubmapTexture& texture = *response.add_textures();
  texture.set_cell_format(static_cast<int>(format));
  texture.set_cells(packCells(grid.cells, grid.width, grid.height, packing, format));
  texture.set_width(grid.width);
  texture.set_height(grid.height);
  texture.set_resolution(grid.resolution_m);
  texture.set_z_level(z_level);
  const Isometry3d world_from_submap = geometry::toIsometry(source.pose).value_or(Isometry3d::Identity());
  const Isometry3d slice = world_from_submap.inverse() * planar(grid.world_from_slice);
  *texture.mutable_slice_pose() = messageOf(poseOf(slice));
}

}  // namespace

geometry::Pose3 nominalPose(const geometry::Pose2& anchor, map::SubmapId id, std::uint64_t seed) {
  Dice dice(hashOf(seed, 11));
  Isometry3d transform = planar(anchor);
  if (id.index % 4 == 1) {
    transform.rotate(AngleAxisd(dice.uniform(-std::numbers::pi, std::numbers::pi), Vector3d::UnitZ()));
  } else if (id.index % 4 == 2) {
    transform.translation().z() = dice.uniform(-1.5, 1.5);
    transform.rotate(AngleAxisd(dice.uniform(-0.3, 0.3), Vector3d::UnitY()));
    transform.rotate(AngleAxisd(dice.uniform(-0.3, 0.3), Vector3d::UnitX()));
  }
  return poseOf(transform);
}

ros_messages::Pose messageOf(const geometry::Pose3& pose) {
  ros_messages::Pose wire;
  wire.set_x(pose.x);
  wire.set_y(pose.y);
  wire.set_z(pose.z);
  wire.set_qx(pose.qx);
  wire.set_qy(pose.qy);
  wire.set_qz(pose.qz);
  wire.set_qw(pose.qw);
  return wire;
}

std::string makeSubmapBody(const FloorPlan& plan, const SubmapSource& source) {
  ros_messages::slam::SubmapQueryV2Response response;
  response.mutable_status()->set_code(ros_messages::slam::OK);
  response.set_submap_version(source.version);
  const Eigen::Vector2d anchor(source.anchor.x_m, source.anchor.y_m);
  ScanSettings settings;
  settings.seed = source.seed;
  if (source.shared) settings.range_m = kSharedRangeM;
  addTexture(response, source,
             scanGrid(plan, source.extra, source.scans, anchor, source.anchor.yaw_rad, settings),
             source.shared ? smallPackingOf(source.id) : packingOf(source.id), formatOf(source), 0);
  if (source.id.index % 7 == 2) {  // the coarse grid that 3D SLAM keeps besides the fine one
    settings.resolution_m = 0.1;
    settings.range_m = 9;
    settings.rays = 180;
    const CellFormat format = source.id.index % 14 == 2 ? CellFormat::Intensity : CellFormat::LogOdds;
    addTexture(response, source,
               scanGrid(plan, source.extra, source.scans, anchor, source.anchor.yaw_rad, settings),
               Packing::PngGray, format, 1);
  }
  return response.SerializeAsString();
}

}  // namespace mapwright::simulator
