#include "robot/ros/dispatch_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "robot/ros/faults.h"
#include "robot/ros/parts.h"
#include "words/text.h"

namespace mapwright::robot::ros {
namespace {

QByteArray json(const QJsonObject& object) { return QJsonDocument(object).toJson(QJsonDocument::Compact); }

using words::text;

bool hasSize(const auto& size_m) {
  return size_m.allFinite() && (size_m.array() > 0).all() && (size_m.array() <= kFarthestM * 2).all();
}

}  // namespace

bool isSound(const map::GridRegion& region) { return isPlace(region.centre_m) && hasSize(region.size_m); }

bool isSound(const map::CloudRegion& region) {
  if (!isPlace(region.centre_m) || !std::isfinite(region.radius_m) || region.radius_m < 0) return false;
  return region.radius_m > 0 ? region.radius_m <= kFarthestM * 2 : hasSize(region.size_m);
}

bool isSound(const map::Projection& projection) {
  const Eigen::Vector2d heights(projection.min_z_m, projection.max_z_m);
  return isPlace(projection.corner_m) && hasSize(projection.size_m) && isPlace(heights) &&
         projection.min_z_m < projection.max_z_m;
}

QByteArray regionArgs(const map::GridRegion& region) {
  return json({{QStringLiteral("x"), region.centre_m.x()},
               {QStringLiteral("y"), region.centre_m.y()},
               {QStringLiteral("l_x"), region.size_m.x()},
               {QStringLiteral("l_y"), region.size_m.y()}});
}

QByteArray regionArgs(const map::CloudRegion& region) {
  const bool sphere = region.radius_m > 0;
  const Eigen::Vector3d size = sphere ? Eigen::Vector3d(0, 0, 0) : region.size_m;
  return json({{QStringLiteral("x"), region.centre_m.x()},
               {QStringLiteral("y"), region.centre_m.y()},
               {QStringLiteral("z"), region.centre_m.z()},
               {QStringLiteral("r"), sphere ? region.radius_m : 0.0},
               {QStringLiteral("l_x"), size.x()},
               {QStringLiteral("l_y"), size.y()},
               {QStringLiteral("l_z"), size.z()}});
}

QByteArray saveArgs(const std::string& filename) {
  return json({{QStringLiteral("filename"), QJsonObject{{QStringLiteral("data"), text(filename)}}}});
}

QByteArray projectionArgs(const std::vector<map::Projection>& projections) {
  QJsonArray rows;
  for (const map::Projection& one : projections) {
    rows << QJsonObject{
        {QStringLiteral("frame_id"), text(one.frame)}, {QStringLiteral("x"), one.corner_m.x()},
        {QStringLiteral("y"), one.corner_m.y()},       {QStringLiteral("width"), one.size_m.x()},
        {QStringLiteral("height"), one.size_m.y()},    {QStringLiteral("min_z"), one.min_z_m},
        {QStringLiteral("max_z"), one.max_z_m}};
  }
  return json({{QStringLiteral("projected_maps_info"), rows}});
}

std::optional<map::GridReference> readMapExtent(const Field& msg) {
  constexpr std::int64_t kMostAcross = 1'000'000'000;
  constexpr double kLargestM = 1e6;
  const auto size = readGridSize(msg, {}, kMostAcross * kMostAcross, EmptyGrids::Refused);
  if (!size || size->width > kMostAcross || size->height > kMostAcross) return std::nullopt;
  const map::GridReference grid{int(size->width), int(size->height), resolutionOf(msg),
                                poseOf(msg["origin"]).pose.flat()};
  if (map::unusableReason(grid) || !std::isfinite(grid.origin.yaw_rad)) return std::nullopt;
  if (grid.width * grid.resolution_m > kLargestM || grid.height * grid.resolution_m > kLargestM)
    return std::nullopt;
  return grid;
}

std::int64_t leastBytesOfCells(std::int64_t cells) { return 2 * cells; }  // "0,"

// Most servers write "0, ", "-1, " and "100, ".
std::int64_t aboutBytesOfCells(std::int64_t cells) { return 7 * cells / 2; }

Read<map::GridPart> readGridPart(const Field& msg) {
  auto grid = readGridOf(msg, kMostPartCells, EmptyGrids::Taken, OddCells::Nearest);
  if (!grid) return tl::unexpected(grid.error());
  map::GridPart part;
  part.frame = grid->header.frame;
  part.grid = {grid->width, grid->height, grid->resolution_m, grid->origin};
  part.cells = std::make_shared<const std::vector<std::int8_t>>(std::move(grid->cells));
  part.notes = std::move(grid->notes);
  return part;
}

Read<ProjectedPart> readProjectedPart(const Field& msg, int index) {
  auto part = readGridPart(msg["map"]);
  if (!part) return tl::unexpected(part.error());
  ProjectedPart projected{index, std::move(*part), numberOr(msg["min_z"], kNaN),
                          numberOr(msg["max_z"], kNaN)};
  if (!std::isfinite(projected.min_z_m)) return fieldMissing("min_z");
  if (!std::isfinite(projected.max_z_m)) return fieldMissing("max_z");
  return projected;
}

Read<std::vector<map::Projection>> readProjections(const Field& values) {
  Field list = values["projected_maps_info"];
  if (!list.isList()) list = values["projected_maps"];
  if (!list.isList()) return fieldMissing("projected_maps_info");
  std::vector<map::Projection> all;
  std::optional<Fault> wrong;
  list.each([&](const Field& row) {
    if (wrong || all.size() >= kMostProjections) return;
    const auto number = [&](const char* name) {
      const double value = numberOr(row[name], kNaN);
      if (!std::isfinite(value) && !wrong) wrong = fieldMissing(name).value();
      return value;
    };
    map::Projection one;
    one.frame = frameName(row["frame_id"].text());
    one.corner_m = {number("x"), number("y")};
    one.size_m = {number("width"), number("height")};
    one.min_z_m = number("min_z");
    one.max_z_m = number("max_z");
    all.push_back(std::move(one));
  });
  if (wrong) return tl::unexpected(*wrong);
  return all;
}

map::Projection projectionOf(const ProjectedPart& part) {
  map::Projection projection;
  projection.frame = part.part.frame;
  const geometry::WorldRect bounds = part.part.grid.bounds();
  if (!bounds.empty()) {
    // A 32-bit resolution turns 2 m into 2.00000003 m.
    const auto whole = [](double value) { return std::round(value * 1e6) / 1e6; };
    projection.corner_m = {whole(bounds.min_x), whole(bounds.min_y)};
    projection.size_m = {whole(bounds.width()), whole(bounds.height())};
  }
  projection.min_z_m = part.min_z_m;
  projection.max_z_m = part.max_z_m;
  return projection;
}

}  // namespace mapwright::robot::ros
