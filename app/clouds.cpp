#include "app/clouds.h"

#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "clouds/write_cloud.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "jobs/fetch_cloud.h"
#include "robot/map_dispatch.h"
#include "sentences/fault_sentence.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

struct CloudOrder {
  std::optional<map::CloudRegion> region;
  clouds::CloudFormat format = clouds::CloudFormat::PcdBinary;
  QString path;
};

CommandResult<CloudOrder> orderFrom(const CloudsArguments& args) {
  CloudOrder order;
  const auto region = cloudRegionFrom(args);
  if (!region) return wrong(region.error());
  order.region = *region;
  order.path = text(args.output);
  const auto format = clouds::formatOf(args.output);
  if (!format) return wrong(Text::tr("-o must name a file that ends in .pcd, .ply or .csv."));
  order.format =
      args.ascii && *format == clouds::CloudFormat::PcdBinary ? clouds::CloudFormat::PcdAscii : *format;
  if (args.ascii && *format != clouds::CloudFormat::PcdBinary)
    return wrong(Text::tr("--ascii applies only to PCD files."));
  if (const auto why = notCreatedReason(order.path, args.force)) return wrong(*why);
  return order;
}

QJsonObject jsonOf(const CloudsArguments& args, const jobs::FetchedCloud& came,
                   const clouds::CloudWritten& written) {
  const map::SpatialCloud& cloud = *came.cloud;
  QJsonObject json{
      {QStringLiteral("points"), qint64(written.points)},
      {QStringLiteral("left_out"), qint64(cloud.left_out)},
      {QStringLiteral("beyond"), qint64(came.beyond)},
      {QStringLiteral("missing"), qint64(cloud.missing)},
      {QStringLiteral("frame"), words::plainName(cloud.frame)},
      {QStringLiteral("kind"), args.occupancy ? QStringLiteral("occupancy") : QStringLiteral("points")},
      {QStringLiteral("file"), text(args.output)},
      {QStringLiteral("intensity"), written.intensity},
      {QStringLiteral("rgb"), written.rgb},
      {QStringLiteral("doubles"), written.doubles},
      {QStringLiteral("notes"), QJsonArray::fromStringList(came.notes())}};
  if (cloud.points.empty()) return json;
  Eigen::Vector3f low = cloud.points.front(), high = low;
  for (const Eigen::Vector3f& point : cloud.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const auto place = [&cloud](const Eigen::Vector3f& at) {
    const Eigen::Vector3d world = cloud.origin_m + at.cast<double>();
    return QJsonArray{world.x(), world.y(), world.z()};
  };
  json[QStringLiteral("from")] = place(low);
  json[QStringLiteral("to")] = place(high);
  return json;
}

CommandResult<int> exportCloud(RobotCommand& command, const CloudsArguments& args) {
  const auto order = orderFrom(args);
  if (!order) return passOn(order);
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  robot::MapDispatch* const dispatch = reading.session().robot().mapDispatch();
  if (!dispatch) return reading.lacks(robot::Capability::Dispatch);
  const auto came = reading.ask<jobs::FetchedCloud>([&](robot::OutcomeTo<jobs::FetchedCloud> reply) {
    return jobs::fetchCloud(*dispatch,
                            args.occupancy ? robot::CloudKind::Occupancy : robot::CloudKind::Points,
                            order->region, reading.workers(), std::move(reply));
  });
  if (!came) return reading.failure(came.error());
  if (came->elsewhere()) {
    return reading.failure(kIncomplete,
                           Text::tr("The robot answered with another region: none of the points lies in the "
                                    "requested one. Nothing was written."));
  }
  for (const QString& note : came->notes()) reading.addRemark(note);
  disk::WrittenFile file(order->path.toStdString(), existingBy(args.force));
  const auto written = clouds::writeCloud(*came->cloud, order->format, [&](std::string_view bytes) {
    file.write(bytes);
    return file.good() && !reading.time().over();
  });
  if (!written && file.good()) {
    return reading.failure(kIncomplete, Text::tr("The time ran out before the file was written."));
  }
  if (const auto fault = file.place()) {
    return wrong(sentences::sentenceOf(disk::notWritten(*fault)));
  }
  if (args.json) printJson(jsonOf(args, *came, *written));
  return came->complete() ? kDone : kIncomplete;
}

}  // namespace

tl::expected<std::optional<map::CloudRegion>, QString> cloudRegionFrom(const CloudsArguments& args) {
  const int given = int(!args.box.empty()) + int(!args.sphere.empty()) + int(args.all);
  if (given != 1) {
    return tl::make_unexpected(
        Text::tr("Which part? Pass --box or --sphere, or --all for the whole map (its size is not "
                 "known in advance)."));
  }
  if (args.all) return std::optional<map::CloudRegion>();
  map::CloudRegion region;
  if (!args.box.empty()) {
    const auto typed = numbersFrom(args.box);
    const std::vector<double> box = typed && typed->size() == 6 ? *typed : std::vector<double>(6);
    if (!(box[3] > 0 && box[4] > 0 && box[5] > 0)) {
      return tl::make_unexpected(Text::tr(
          "--box is X,Y,Z,LX,LY,LZ: its centre and the lengths of its sides (greater than 0), in metres."));
    }
    region.centre_m = {box[0], box[1], box[2]};
    region.size_m = {box[3], box[4], box[5]};
    return std::optional(region);
  }
  const auto typed = numbersFrom(args.sphere);
  const std::vector<double> sphere = typed && typed->size() == 4 ? *typed : std::vector<double>(4);
  if (!(sphere[3] > 0)) {
    return tl::make_unexpected(
        Text::tr("--sphere is X,Y,Z,R: its centre and its radius (greater than 0), in metres."));
  }
  region.centre_m = {sphere[0], sphere[1], sphere[2]};
  region.radius_m = sphere[3];
  return std::optional(region);
}

void addClouds(Commands& commands) {
  const auto shared = std::make_shared<CloudsArguments>();
  CloudsArguments& args = *shared;
  CLI::App* const clouds =
      commands.program().add_subcommand("clouds", help(Text::tr("The robot's 3D map as points: export")));
  clouds->require_subcommand(1);
  CLI::App* const command = clouds->add_subcommand(
      "export", help(Text::tr("Write the points of a region or of the whole map to a PCD, PLY or CSV file")));
  addRobot(*command, args, Text::tr("Robot address, for example rep130+ws://HOST:9090 (or MAPWRIGHT_ROBOT)"));
  command->add_option(
      "--box", args.box,
      help(Text::tr("X,Y,Z,LX,LY,LZ: the centre of a box and the lengths of its sides, in metres")));
  command->add_option("--sphere", args.sphere,
                      help(Text::tr("X,Y,Z,R: the centre of a sphere and its radius, in metres")));
  command->add_flag("--all", args.all, help(Text::tr("The whole map, regardless of its size")));
  command->add_flag("--occupancy", args.occupancy,
                    help(Text::tr("The centres of occupied cells instead of measured points")));
  command->add_option("-o,--output", args.output, help(Text::tr("Output file: .pcd, .ply or .csv")))
      ->required();
  command->add_flag("--ascii", args.ascii, help(Text::tr("Write the PCD file as text")));
  addForce(*command, args.force);
  command->add_flag("--json", args.json, help(Text::tr("Print a summary on standard output")));
  addTimeout(*command, args.timeout_s);
  addReading(commands, command, shared, exportCloud);
}

}  // namespace mapwright::app
