#include "app/snapshot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QJsonArray>
#include <QJsonDocument>
#include <QStringList>

#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/display.h"
#include "app/map_request.h"
#include "app/output.h"
#include "app/report.h"
#include "app/robot_factory.h"
#include "app/snapshot_run.h"
#include "geometry/pose.h"
#include "geometry/view_transform.h"
#include "replay/replay_robot.h"
#include "ui/scene/layer.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

constexpr qint64 kMaxPixels = 200'000'000;
constexpr int kMaxEdge = 32'000;

using words::text;

std::optional<Eigen::Vector2d> parsePoint(const QString& word) {
  const auto numbers = numbersFrom(word.toStdString());
  if (!numbers || numbers->size() != 2) return std::nullopt;
  const Eigen::Vector2d point((*numbers)[0], (*numbers)[1]);
  return point;
}

std::optional<QSize> parseSize(const QString& word) {
  const QStringList parts = word.toLower().split(QLatin1Char('x'));
  bool ok_w = false, ok_h = false;
  if (parts.size() != 2) return std::nullopt;
  const QSize size(parts[0].toInt(&ok_w), parts[1].toInt(&ok_h));
  if (!ok_w || !ok_h || size.width() < 1 || size.height() < 1) return std::nullopt;
  if (std::max(size.width(), size.height()) > kMaxEdge || qint64(size.width()) * size.height() > kMaxPixels) {
    return std::nullopt;
  }
  return size;
}

/// Options that cannot be combined with --region.
std::optional<QString> notWithRegionReason(const SnapshotArguments& args, const SnapshotOptions& options) {
  if (options.mode == SnapshotMode::Submaps)
    return Text::tr("--region needs a robot that sends its map by region, and --mode grid.");
  if (!args.map.empty())
    return Text::tr("--region shows a part of the robot's own map and cannot be combined with --map.");
  if (!args.bag.empty())
    return Text::tr("A bag has no map by region: --region and --bag cannot be combined.");
  if (!args.center.empty() || args.fit || args.rotate_deg != 0)
    return Text::tr(
        "--region already sets the view: it cannot be combined with --center, --fit and --rotate.");
  if (args.size != SnapshotArguments().size)
    return Text::tr(
        "With --region a pixel is one cell of the map, or as large as --scale says: --size cannot be set.");
  if (args.average) return Text::tr("--average only applies to whole maps, not to --region.");
  return std::nullopt;
}

/// For "path=/my_plan" takes the topic; the name stays.
tl::expected<void, QString> onTopic(QString& word, robot::TopicChoices& topics) {
  const auto split = word.indexOf(QLatin1Char('='));
  if (split < 0) return {};
  const QString topic = word.mid(split + 1).trimmed(), name = word.left(split).trimmed();
  const std::optional<ui::scene::Layer> layer = ui::scene::layerNamed(name);
  word = name;
  if (!layer) return {};  // reported below
  const std::optional<map::Stream> stream = ui::scene::chosenStream(*layer);
  if (!stream) {
    QStringList choosable;
    for (const ui::scene::Layer one : ui::scene::allLayers()) {
      if (ui::scene::chosenStream(one)) choosable << ui::scene::layerName(one);
    }
    return tl::make_unexpected(
        Text::tr("--layers: \"%1\" has no choice of topic, only %2.").arg(name, words::listed(choosable)));
  }
  if (topic.isEmpty())
    return tl::make_unexpected(
        Text::tr("--layers %1=: the topic is missing, for example %1=/topic.").arg(name));
  topics.insert_or_assign(*stream, topic.startsWith(QLatin1Char('/')) ? topic : QLatin1Char('/') + topic);
  return {};
}

QStringList namesOfLayers() {
  QStringList names;
  for (const ui::scene::Layer layer : ui::scene::allLayers()) names << ui::scene::layerName(layer);
  return names;
}

tl::expected<std::set<ui::scene::Layer>, QString> parseLayers(const QString& args,
                                                              robot::TopicChoices& topics) {
  using ui::scene::Layer;
  // The layers that do not change from run to run.
  if (args.isEmpty()) return ui::scene::layersIn(ui::scene::LayerSet::Snapshot);
  const auto& every = ui::scene::allLayers();
  std::set<Layer> chosen;
  if (args == QLatin1String("all")) {
    std::copy_if(every.begin(), every.end(), std::inserter(chosen, chosen.end()),
                 [](Layer layer) { return ui::scene::specOf(layer).in_all; });
    return chosen;
  }
  if (args == QLatin1String("none")) return chosen;
  for (QString word : args.split(QLatin1Char(','))) {
    if (const auto taken = onTopic(word, topics); !taken) return passOn(taken);
    const std::optional<Layer> layer = ui::scene::layerNamed(word.trimmed());
    if (!layer) {
      return tl::make_unexpected(Text::tr("--layers: there is no layer \"%1\". Known: %2, or all, or none.")
                                     .arg(word, words::listed(namesOfLayers())));
    }
    chosen.insert(*layer);
  }
  return chosen;
}

/// An option without effect is a mistake that the picture would not show.
std::optional<QString> withoutEffectReason(const SnapshotArguments& args, const SnapshotOptions& options) {
  if (args.average && options.mode == SnapshotMode::Submaps) {
    return Text::tr("--average only applies to whole maps: submaps are always averaged when zoomed out.");
  }
  const bool whole = options.mode == SnapshotMode::Whole;
  if (whole && args.slice != 0) {
    return Text::tr("--slice only applies to submaps: a whole map has no slices.");
  }
  if (whole && options.colors != render::ColorMode::Normal) {
    return Text::tr("--colors %1 only applies to submaps, not to a whole map.").arg(text(args.colors));
  }
  if (!args.raw) return std::nullopt;
  if (options.dark || options.colors != render::ColorMode::Normal) {
    return Text::tr("--raw has no colours: it cannot be combined with --theme or --colors.");
  }
  if (args.layers.empty()) return std::nullopt;
  for (const ui::scene::Layer layer : options.layers) {
    if (layer != ui::scene::Layer::Submaps && layer != ui::scene::Layer::WholeMap) {
      return Text::tr("--raw draws only the map, without the layer \"%1\" of --layers.")
          .arg(ui::scene::layerName(layer));
    }
  }
  return std::nullopt;
}

QString layersHelp() {
  QStringList not_in_all;
  for (const ui::scene::Layer layer : ui::scene::allLayers()) {
    if (const char* const reason = ui::scene::specOf(layer).not_in_all_reason)
      not_in_all << Text::tr("%1, which %2")
                        .arg(ui::scene::layerName(layer), QCoreApplication::translate("scene", reason));
  }
  return Text::tr(
             "Layers, separated by commas: %1; or all (except %2); or none (only the map). NAME=TOPIC "
             "selects the topic for a grid, path or target of a ROS robot")
      .arg(namesOfLayers().join(QLatin1Char(',')), words::joined(not_in_all));
}

/// Called at the deadline if the run is not finished: reports it, also in the report.
int giveUp(const SnapshotOptions& options, const SnapshotStanding& standing) {
  if (!options.report.isEmpty()) writeReportInHaste(options.report, standing.report);
  if (options.json && !isStandardOutput(options.report)) {
    const QByteArray json = words::escapedJson(QJsonDocument(standing.report).toJson());
    if (write(STDOUT_FILENO, json.constData(), std::size_t(json.size())) < 0) return kIncomplete;
  }
  sayAtTheEnd(oneLine(standing.sentence).toStdString());
  return standing.exit_code;
}

QString summaryOf(const SnapshotRun& run) {
  const QJsonObject report = run.report();
  if (const QJsonObject region = report[QLatin1String("region")].toObject(); !region.isEmpty()) {
    return Text::tr("%1: regions of the map: %2 of %3")
        .arg(run.options().output, QString::number(region[QLatin1String("answered")].toInt()),
             QString::number(region[QLatin1String("parts")].toInt()));
  }
  if (report[QLatin1String("mode")].toString() == QLatin1String("whole")) {
    const QJsonObject map = report[QLatin1String("map")].toObject();
    if (map.isEmpty()) return Text::tr("%1: no map").arg(run.options().output);
    const QJsonArray size = map[QLatin1String("size")].toArray();
    const QString name = words::plainName(map[QLatin1String("name")].toString());
    return Text::tr("%1: map %2%3, %4 x %5 cells")
        .arg(run.options().output, map[QLatin1String("id")].toString(),
             name.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(name),
             QString::number(size.at(0).toInt()), QString::number(size.at(1).toInt()));
  }
  const QJsonObject submaps = report[QLatin1String("submaps")].toObject();
  QString line = Text::tr("%1: %2 of %3 submaps")
                     .arg(run.options().output, QString::number(submaps[QLatin1String("drawn")].toInt()),
                          QString::number(submaps[QLatin1String("listed")].toInt()));
  for (const auto& [kind, counted] :
       {std::pair{"missing", Text::tr(", %1 missing")}, std::pair{"failed", Text::tr(", %1 failed")},
        std::pair{"pending", Text::tr(", %1 not there in time")},
        std::pair{"corrupt", Text::tr(", %1 corrupt")},
        std::pair{"without_slice", Text::tr(", %1 without this slice")}}) {
    if (const int count = submaps[QLatin1String(kind)].toInt()) line += counted.arg(count);
  }
  return line;
}

/// Writes the report and the terminal output; returns the exit code.
int sayWhatCame(const SnapshotRun& run, int exit_code) {
  const QJsonObject report = run.report();
  const QString& report_path = run.options().report;
  if (!report_path.isEmpty() && !run.overItsSource()) {
    if (const auto problem = writeReport(report_path, report)) return refuse(kUsage, *problem);
  }
  const bool printed = isStandardOutput(report_path) || isStandardOutput(run.options().output);
  if (run.options().json && !isStandardOutput(report_path)) printJson(report);
  if (!run.error().isEmpty()) return refuse(exit_code, run.error());
  if (!run.options().json && !printed) printLine(oneLine(summaryOf(run)));
  if (exit_code == kDone) {
    if (!run.shownInstead().isEmpty()) say(run.shownInstead());
    return kDone;
  }
  return refuse(exit_code, Text::tr("Incomplete. %1").arg(firstOf(run.warnings())));
}

}  // namespace

bool SnapshotOptions::wantsSubmaps() const {
  return mode == SnapshotMode::Submaps || layers.contains(ui::scene::Layer::Submaps);
}

bool SnapshotOptions::wantsWhole() const {
  return !region && (mode == SnapshotMode::Whole || layers.contains(ui::scene::Layer::WholeMap));
}

void addSnapshotOptions(CLI::App* command, SnapshotArguments& args) {
  addRobot(*command, args,
           Text::tr("Robot address, for example axbot+http://192.168.25.25:8090 or demo: (or "
                    "MAPWRIGHT_ROBOT)"));
  command
      ->add_option("-o,--output", args.output, help(Text::tr("The PNG to write; - is the standard output")))
      ->required();
  command->add_flag("--force", args.force,
                    help(Text::tr("Overwrite a file even if the map was read from it")));
  command->add_option("--mode", args.mode,
                      help(Text::tr("submaps, or whole (or grid, the same for robots and files whose whole "
                                    "map is an occupancy grid). Default: submaps if there are any")));
  command->add_option("--map", args.map,
                      help(Text::tr("Id of a stored map, or mapping:ID (see mapwright maps "
                                    "list); by default the live or current one")));
  command->add_flag(
      "--average", args.average,
      help(Text::tr(
          "When zoomed out, show the average of the cells of a whole map; by default occupied cells win")));
  command->add_flag("--robot-anyway", args.robot_anyway,
                    help(Text::tr("Draw the robot and its sensor data even on a map that it is not in")));
  command->add_flag("--fit", args.fit, help(Text::tr("Show the whole map (default without --center)")));
  command->add_option(
      "--region", args.region,
      help(Text::tr(
          "A part of the map of a robot that sends its map by region (rep130+ws://): X,Y,LX,LY in metres, "
          "its centre and side lengths. A pixel is a cell, or as large as --scale says")));
  command->add_option("--center", args.center,
                      help(Text::tr("Position at the centre of the picture: X,Y in metres")));
  command->add_option("--scale", args.scale, help(Text::tr("Metres per pixel")));
  command->add_option("--size", args.size, help(Text::tr("Picture size: WIDTHxHEIGHT in pixels")))
      ->capture_default_str();
  command->add_option("--rotate", args.rotate_deg,
                      help(Text::tr("Rotate the picture counter-clockwise by this many degrees")));
  command->add_option("--layers", args.layers, help(layersHelp()));
  command->add_option("--resolution", args.resolution,
                      help(Text::tr("Metres per pixel of a plain picture file")));
  command->add_option(
      "--origin", args.origin,
      help(Text::tr("Lower left corner of a plain picture file: X,Y or X,Y,YAW in metres and radians")));
  command->add_option("--slice", args.slice, help(Text::tr("Which slice of each submap to draw")))
      ->capture_default_str();
  command
      ->add_option("--colors", args.colors,
                   help(Text::tr("normal, incremental, active, trajectory, age or version")))
      ->capture_default_str();
  command->add_option("--theme", args.theme, help(Text::tr("light or dark")))->capture_default_str();
  command->add_flag("--raw", args.raw,
                    help(Text::tr("Only the map pixels: gray = intensity, alpha 0 = not observed")));
  command->add_option("--settle", args.settle, help(Text::tr("complete, or seconds to collect data")))
      ->capture_default_str();
  addTimeout(*command, args.timeout_s);
  command->add_option("--report", args.report,
                      help(Text::tr("Write a summary as JSON; - is the standard output")));
  command->add_flag("--json", args.json, help(Text::tr("Print the report on standard output")));
}

void addSnapshotBag(CLI::App* command, SnapshotArguments& args) {
  command->add_option("--bag", args.bag,
                      help(Text::tr("Draw recorded data: the name of a bag, or a file, with --at; "
                                    "FILE?ns=/NAMESPACE is one robot of several")));
  addTime(*command, "--at", args.at);
}

std::optional<QSize> pixelsOf(const geometry::WorldRect& region, double scale_m_per_px) {
  constexpr double kRounding = 1e-6;
  const double wide = std::max(1.0, std::ceil(region.width() / scale_m_per_px - kRounding));
  const double high = std::max(1.0, std::ceil(region.height() / scale_m_per_px - kRounding));
  if (!(wide <= kMaxEdge && high <= kMaxEdge && wide * high <= double(kMaxPixels))) return std::nullopt;
  return QSize(int(wide), int(high));
}

tl::expected<SnapshotOptions, QString> parseSnapshotOptions(const SnapshotArguments& args) {
  const auto wrong = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  SnapshotOptions options;
  options.robot = placedFile(text(args.robot), args.resolution, args.origin);
  options.output = text(args.output);
  options.report = text(args.report);
  options.raw = args.raw;
  options.json = args.json;
  options.force = args.force;
  if (options.robot.isEmpty()) {
    return wrong(Text::tr(
        "Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; demo: is the built-in simulated robot."));
  }
  if (args.bag.empty() != args.at.empty())
    return wrong(Text::tr("--bag NAME and --at TIME must be used together."));
  if (!args.bag.empty()) {
    options.bag = args.bag;
    options.at = args.at;
  }
  if (args.mode == "submaps") {
    options.mode = SnapshotMode::Submaps;
  } else if (args.mode == "whole" || args.mode == "grid") {
    // The occupancy grids of robots and files are their whole maps.
    options.mode = SnapshotMode::Whole;
  } else if (!args.mode.empty()) {
    return wrong(Text::tr("--mode must be submaps, whole or grid, not \"%1\".").arg(text(args.mode)));
  }
  if (!args.map.empty()) {
    if (options.mode == SnapshotMode::Submaps) {
      return wrong(Text::tr(
          "--map needs --mode whole: only the submaps of the robot's current SLAM session can be shown."));
    }
    options.mode = SnapshotMode::Whole;
    options.map = map::mapKeyFromText(args.map);
  }
  if (!args.region.empty()) {
    const auto region = gridRegionFrom(args.region);
    if (!region) return wrong(region.error());
    const Eigen::Vector2d low = region->centre_m - region->size_m / 2, high = low + region->size_m;
    options.region = geometry::WorldRect{low.x(), low.y(), high.x(), high.y()};
    if (const auto why = notWithRegionReason(args, options)) return wrong(*why);
    options.mode = SnapshotMode::Whole;
  }
  if (const auto why = noPlaceReason(text(args.robot), args.resolution, args.origin)) return wrong(*why);
  options.average = args.average;
  options.robot_anyway = args.robot_anyway;
  const auto size = parseSize(text(args.size));
  if (!size) {
    return wrong(
        Text::tr("--size %1: give WIDTHxHEIGHT, for example 1920x1080, with at most %2 pixels "
                 "per edge and %3 million in total.")
            .arg(text(args.size), QString::number(kMaxEdge), QString::number(kMaxPixels / 1'000'000)));
  }
  options.size_px = *size;
  const bool has_center = !args.center.empty(), has_scale = args.scale.has_value();
  if (args.fit && (has_center || has_scale)) {
    return wrong(
        Text::tr("--fit chooses centre and scale itself: it cannot be combined with --center and --scale."));
  }
  if (has_center != has_scale && !(options.region && has_scale))
    return wrong(Text::tr("--center X,Y and --scale METRES_PER_PIXEL must be used together."));
  if (has_center) {
    options.center_m = parsePoint(text(args.center));
    if (!options.center_m) {
      return wrong(Text::tr("--center %1: give X,Y in metres, for example 12.5,-3, at most a million "
                            "kilometres away.")
                       .arg(text(args.center)));
    }
  }
  if (has_scale) {
    if (!(*args.scale >= geometry::kMinScaleMPerPx && *args.scale <= geometry::kMaxScaleMPerPx)) {
      return wrong(Text::tr("--scale must be between %1 and %2 metres per pixel.")
                       .arg(geometry::kMinScaleMPerPx)
                       .arg(geometry::kMaxScaleMPerPx));
    }
    options.scale_m_per_px = *args.scale;
  }
  if (!std::isfinite(args.rotate_deg)) return wrong(Text::tr("--rotate must be a number of degrees."));
  options.rotation_rad = geometry::normalizeAngle(geometry::radiansFromDegrees(args.rotate_deg));
  const auto layers = parseLayers(text(args.layers), options.topics);
  if (!layers) return wrong(layers.error());
  options.layers = *layers;
  if (!args.layers.empty() && args.layers != "all") options.named = *layers;
  if (args.slice < 0) return wrong(Text::tr("--slice must be 0 or more."));
  options.slice = args.slice;
  const auto colors = render::colorModeFrom(args.colors);
  if (!colors) {
    return wrong(
        Text::tr("--colors must be normal, incremental, active, trajectory, age or version, not \"%1\".")
            .arg(text(args.colors)));
  }
  options.colors = *colors;
  if (args.theme != "light" && args.theme != "dark") {
    return wrong(Text::tr("--theme must be light or dark, not \"%1\".").arg(text(args.theme)));
  }
  options.dark = args.theme == "dark";
  if (const auto why = noTimeoutReason(args.timeout_s)) return wrong(*why);
  options.timeout_s = args.timeout_s;
  if (args.settle != "complete") {
    bool ok = false;
    const double seconds = text(args.settle).toDouble(&ok);
    if (!ok || !(seconds >= 0 && seconds <= 86'400)) {
      return wrong(
          Text::tr("--settle must be complete or a number of seconds, not \"%1\".").arg(text(args.settle)));
    }
    if (seconds > args.timeout_s) {
      return wrong(Text::tr("--settle %1 is longer than --timeout %2.").arg(seconds).arg(args.timeout_s));
    }
    options.settle_s = seconds;
  }
  if (const auto why = withoutEffectReason(args, options)) return wrong(*why);
  // Layers that --raw never draws are neither requested nor waited for.
  if (options.raw) {
    std::erase_if(options.layers, [](ui::scene::Layer layer) {
      return layer != ui::scene::Layer::Submaps && layer != ui::scene::Layer::WholeMap;
    });
  }
  if (const auto why = options.output.isEmpty() ? std::nullopt : pngNotWritableReason(options.output))
    return wrong(*why);
  if (const auto why = options.report.isEmpty() ? std::nullopt : notWritableReason(options.report))
    return wrong(*why);
  const QString printed = options.json && !isStandardOutput(options.report) ? QStringLiteral("-") : QString();
  if (const auto why = notTogetherReason({options.output, options.report, printed})) return wrong(*why);
  return options;
}

int snapshot(const SnapshotArguments& args, int& argc, char** argv) {
  const CommandStart start = commandStart(args.timeout_s, processAge());
  auto options = parseSnapshotOptions(args);
  if (!options) return refuse(kUsage, options.error());
  // Outlives everything that may take time, including destruction.
  Deadline deadline(
      app::later(start.begun, options->timeout_s + start.grace.end_s),
      [late = Text::tr("%1: no connection was made in time.").arg(oneLine(options->robot)).toStdString()] {
        sayAtTheEnd(late);
        return int(kUnreachable);
      });
  OffscreenApplication application(argc, argv);
  const auto access = RobotAccess::read(args.access, options->robot);
  if (!access) return refuse(kUsage, access.error());
  auto robot = makeRobot(options->robot, access->forAddress(options->robot), DemoTime::Frozen);
  if (!robot) return refuse(kUsage, robot.error());

  if (!options->bag.empty()) *robot = std::make_unique<replay::ReplayRobot>(std::move(*robot), options->bag);
  SnapshotRun run(std::move(*options), std::move(*robot), start);
  deadline.setLastWords(
      [options = run.options(), standing = run.standing()] { return giveUp(options, standing->take()); });
  int exit_code = kDone;
  ProgressLine progress;
  if (progress.shown())
    QObject::connect(&run, &SnapshotRun::progressed, [&](const QString& line) { progress.tell(line); });
  QObject::connect(
      &run, &SnapshotRun::finished, &application,
      [&](int code) {
        exit_code = code;
        application.quit();
      },
      Qt::QueuedConnection);
  run.start();
  QApplication::exec();
  progress.clear();
  exit_code = sayWhatCame(run, exit_code);
  std::fflush(stdout);
  // Everything has been reported: cleaning up must not take longer than the remaining time.
  deadline.setLastWords([exit_code] { return exit_code; });
  return exit_code;
}

int snapshotOf(SnapshotArguments& args, const Invocation& before) {
  onRecording(args.robot, args.bag, before.robot);
  inherit(args, before);
  if (const auto why = recordingWithoutTimeReason(words::text(args.robot), args.bag))
    return refuse(kUsage, *why);
  return snapshot(args, before.argc, before.argv);
}

void addSnapshot(Commands& commands) {
  const auto args = std::make_shared<SnapshotArguments>();
  CLI::App* const command = commands.program().add_subcommand(
      "snapshot", help(Text::tr("Draw a robot's map to a PNG, without a window")));
  addSnapshotOptions(command, *args);
  addSnapshotBag(command, *args);
  commands.add(command, [args](const Invocation& before) { return snapshotOf(*args, before); });
}

}  // namespace mapwright::app
