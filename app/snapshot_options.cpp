#include "app/snapshot_options.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "app/bag_reading.h"
#include "app/map_region.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/robot_factory.h"
#include "geometry/pose.h"
#include "geometry/view_transform.h"
#include "scene/layer_topic.h"
#include "submap/submap_store.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class SnapshotOptionsText {
  Q_DECLARE_TR_FUNCTIONS(SnapshotOptions)
};

constexpr qint64 kMaxPixels = 200'000'000;
constexpr int kMaxEdge = 32'000;

using words::text;

std::optional<Eigen::Vector2d> parsePoint(const QString& word) {
  const auto numbers = numbersFrom(word.toStdString());
  if (!numbers || numbers->size() != 2) return std::nullopt;
  const Eigen::Vector2d point((*numbers)[0], (*numbers)[1]);
  if (point.cwiseAbs().maxCoeff() > submap::kMaxCoordinateM) return std::nullopt;
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

/// X,Y,LX,LY: the centre and the side lengths. Options that cannot be combined with --region.
std::optional<QString> whyNotWithRegion(const SnapshotWords& words, const SnapshotOptions& options) {
  if (options.mode == SnapshotMode::Submaps)
    return SnapshotOptionsText::tr("--region needs a robot that sends its map by region, and --mode grid.");
  if (!words.map.empty())
    return SnapshotOptionsText::tr(
        "--region shows a part of the robot's own map and cannot be combined with --map.");
  if (!words.bag.empty())
    return SnapshotOptionsText::tr("A bag has no map by region: --region and --bag cannot be combined.");
  if (!words.center.empty() || words.fit || words.rotate_deg != 0)
    return SnapshotOptionsText::tr(
        "--region already sets the view: it cannot be combined with --center, --fit and --rotate.");
  if (words.size != SnapshotWords().size)
    return SnapshotOptionsText::tr(
        "With --region a pixel is one cell of the map, or as large as --scale says: --size cannot be set.");
  if (words.average) return SnapshotOptionsText::tr("--average only applies to whole maps, not to --region.");
  return std::nullopt;
}

/// For "path=/my_plan" takes the topic; the name stays.
tl::expected<void, QString> takeTopic(QString& word, robot::TopicChoices& topics) {
  const auto split = word.indexOf(QLatin1Char('='));
  if (split < 0) return {};
  const QString topic = word.mid(split + 1).trimmed(), name = word.left(split).trimmed();
  const auto every = scene::allLayers();
  const auto layer = std::find_if(every.begin(), every.end(),
                                  [&](scene::Layer one) { return scene::layerName(one) == name; });
  word = name;
  if (layer == every.end()) return {};  // reported below
  const std::optional<map::Stream> stream = scene::chosenStream(*layer);
  if (!stream) {
    QStringList choosable;
    for (const scene::Layer one : every) {
      if (scene::chosenStream(one)) choosable << scene::layerName(one);
    }
    return tl::make_unexpected(SnapshotOptionsText::tr("--layers: \"%1\" has no choice of topic, only %2.")
                                   .arg(name, choosable.join(QLatin1String(", "))));
  }
  if (topic.isEmpty())
    return tl::make_unexpected(
        SnapshotOptionsText::tr("--layers %1=: the topic is missing, for example %1=/topic.").arg(name));
  topics.insert_or_assign(*stream, topic.startsWith(QLatin1Char('/')) ? topic : QLatin1Char('/') + topic);
  return {};
}

tl::expected<std::set<scene::Layer>, QString> parseLayers(const QString& words, robot::TopicChoices& topics) {
  using scene::Layer;
  // The layers that do not change from run to run.
  if (words.isEmpty())
    return std::set{Layer::Grid, Layer::Trail, Layer::Footprint, Layer::Robot, Layer::ScaleBar};
  const auto every = scene::allLayers();
  std::set<Layer> chosen;
  if (words == QLatin1String("all")) {
    chosen.insert(every.begin(), every.end());
    chosen.erase(Layer::Submaps);
    chosen.erase(Layer::WholeMap);
    chosen.erase(Layer::Regions);          // --region says which
    chosen.erase(Layer::Track);            // it needs the whole bag
    chosen.erase(Layer::DispatchedCloud);  // its size is not known in advance
    return chosen;
  }
  if (words == QLatin1String("none")) return chosen;
  QStringList known;
  for (const Layer layer : every) known << scene::layerName(layer);
  for (QString word : words.split(QLatin1Char(','))) {
    if (const auto taken = takeTopic(word, topics); !taken) return tl::make_unexpected(taken.error());
    const auto position = known.indexOf(word.trimmed());
    if (position < 0) {
      return tl::make_unexpected(
          SnapshotOptionsText::tr("--layers: there is no layer \"%1\". Known: %2, or all, or none.")
              .arg(word, known.join(QLatin1String(", "))));
    }
    chosen.insert(every[std::size_t(position)]);
  }
  return chosen;
}

/// An option without effect is a mistake that the picture would not show.
std::optional<QString> whyWithoutEffect(const SnapshotWords& words, const SnapshotOptions& options) {
  if (words.average && options.mode == SnapshotMode::Submaps) {
    return SnapshotOptionsText::tr(
        "--average only applies to whole maps: submaps are always averaged when zoomed out.");
  }
  const bool whole = options.mode == SnapshotMode::Whole;
  if (whole && words.slice != 0) {
    return SnapshotOptionsText::tr("--slice only applies to submaps: a whole map has no slices.");
  }
  if (whole && options.colors != render::ColorMode::Normal) {
    return SnapshotOptionsText::tr("--colors %1 only applies to submaps, not to a whole map.")
        .arg(text(words.colors));
  }
  if (!words.raw) return std::nullopt;
  if (options.dark || options.colors != render::ColorMode::Normal) {
    return SnapshotOptionsText::tr("--raw has no colours: it cannot be combined with --theme or --colors.");
  }
  if (words.layers.empty()) return std::nullopt;
  for (const scene::Layer layer : options.layers) {
    if (layer != scene::Layer::Submaps && layer != scene::Layer::WholeMap) {
      return SnapshotOptionsText::tr("--raw draws only the map, without the layer \"%1\" of --layers.")
          .arg(scene::layerName(layer));
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<QSize> pixelsOf(const geometry::WorldRect& region, double scale_m_per_px) {
  constexpr double kRounding = 1e-6;
  const double wide = std::max(1.0, std::ceil(region.width() / scale_m_per_px - kRounding));
  const double high = std::max(1.0, std::ceil(region.height() / scale_m_per_px - kRounding));
  if (!(wide <= kMaxEdge && high <= kMaxEdge && wide * high <= double(kMaxPixels))) return std::nullopt;
  return QSize(int(wide), int(high));
}

tl::expected<SnapshotOptions, QString> parseSnapshotOptions(const SnapshotWords& words) {
  const auto wrong = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  SnapshotOptions options;
  options.robot = placedFile(text(words.robot), words.resolution, words.origin);
  options.output = text(words.output);
  options.report = text(words.report);
  options.raw = words.raw;
  options.json = words.json;
  options.force = words.force;
  if (options.robot.isEmpty()) {
    return wrong(SnapshotOptionsText::tr(
        "Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; demo: is the built-in simulated robot."));
  }
  if (words.bag.empty() != words.at.empty())
    return wrong(SnapshotOptionsText::tr("--bag NAME and --at TIME must be used together."));
  if (!words.bag.empty()) {
    const auto at_s = timeFrom(words.at, QStringLiteral("--at"));
    if (!at_s) return wrong(at_s.error().sentence);
    options.bag = words.bag;
    options.at_s = *at_s;
  }
  if (words.mode == "submaps") {
    options.mode = SnapshotMode::Submaps;
  } else if (words.mode == "whole" || words.mode == "grid") {
    // The occupancy grids of robots and files are their whole maps.
    options.mode = SnapshotMode::Whole;
  } else if (!words.mode.empty()) {
    return wrong(
        SnapshotOptionsText::tr("--mode must be submaps, whole or grid, not \"%1\".").arg(text(words.mode)));
  }
  if (!words.map.empty()) {
    if (options.mode == SnapshotMode::Submaps) {
      return wrong(SnapshotOptionsText::tr(
          "--map needs --mode whole: only the submaps of the robot's current SLAM session can be shown."));
    }
    options.mode = SnapshotMode::Whole;
    options.map = map::mapKeyFromText(words.map);
  }
  if (!words.region.empty()) {
    const auto region = gridRegionFrom(words.region);
    if (!region) return wrong(region.error());
    const Eigen::Vector2d low = region->centre_m - region->size_m / 2, high = low + region->size_m;
    options.region = geometry::WorldRect{low.x(), low.y(), high.x(), high.y()};
    if (const auto why = whyNotWithRegion(words, options)) return wrong(*why);
    options.mode = SnapshotMode::Whole;
  }
  if (const auto why = whyNoPlace(text(words.robot), words.resolution, words.origin)) return wrong(*why);
  options.average = words.average;
  options.robot_anyway = words.robot_anyway;
  const auto size = parseSize(text(words.size));
  if (!size) {
    return wrong(
        SnapshotOptionsText::tr("--size %1: give WIDTHxHEIGHT, for example 1920x1080, with at most %2 pixels "
                                "per edge and %3 million in total.")
            .arg(text(words.size), QString::number(kMaxEdge), QString::number(kMaxPixels / 1'000'000)));
  }
  options.size_px = *size;
  const bool has_center = !words.center.empty(), has_scale = words.scale.has_value();
  if (words.fit && (has_center || has_scale)) {
    return wrong(SnapshotOptionsText::tr(
        "--fit chooses centre and scale itself: it cannot be combined with --center and --scale."));
  }
  if (options.region && has_scale) {
    if (!(*words.scale >= geometry::kMinScaleMPerPx && *words.scale <= geometry::kMaxScaleMPerPx)) {
      return wrong(SnapshotOptionsText::tr("--scale must be between %1 and %2 metres per pixel.")
                       .arg(geometry::kMinScaleMPerPx)
                       .arg(geometry::kMaxScaleMPerPx));
    }
    options.scale_m_per_px = *words.scale;
  } else if (has_center != has_scale) {
    return wrong(SnapshotOptionsText::tr("--center X,Y and --scale METRES_PER_PIXEL must be used together."));
  }
  if (has_center) {
    options.center_m = parsePoint(text(words.center));
    if (!options.center_m) {
      return wrong(SnapshotOptionsText::tr("--center %1: give X,Y in metres, for example 12.5,-3.")
                       .arg(text(words.center)));
    }
    if (!(*words.scale >= geometry::kMinScaleMPerPx && *words.scale <= geometry::kMaxScaleMPerPx)) {
      return wrong(SnapshotOptionsText::tr("--scale must be between %1 and %2 metres per pixel.")
                       .arg(geometry::kMinScaleMPerPx)
                       .arg(geometry::kMaxScaleMPerPx));
    }
    options.scale_m_per_px = *words.scale;
  }
  if (!std::isfinite(words.rotate_deg))
    return wrong(SnapshotOptionsText::tr("--rotate must be a number of degrees."));
  options.rotation_rad = geometry::normalizeAngle(geometry::radiansFromDegrees(words.rotate_deg));
  const auto layers = parseLayers(text(words.layers), options.topics);
  if (!layers) return wrong(layers.error());
  options.layers = *layers;
  if (!words.layers.empty() && words.layers != "all") options.named = *layers;
  options.without_submaps = !words.layers.empty() && words.layers != "all" && words.layers != "none" &&
                            !layers->contains(scene::Layer::Submaps);
  if (words.slice < 0) return wrong(SnapshotOptionsText::tr("--slice must be 0 or more."));
  options.slice = words.slice;
  if (words.colors == "normal")
    options.colors = render::ColorMode::Normal;
  else if (words.colors == "incremental")
    options.colors = render::ColorMode::Incremental;
  else if (words.colors == "active")
    options.colors = render::ColorMode::Active;
  else
    return wrong(SnapshotOptionsText::tr("--colors must be normal, incremental or active, not \"%1\".")
                     .arg(text(words.colors)));
  if (words.theme != "light" && words.theme != "dark") {
    return wrong(
        SnapshotOptionsText::tr("--theme must be light or dark, not \"%1\".").arg(text(words.theme)));
  }
  options.dark = words.theme == "dark";
  if (!(words.timeout_s > 0 && words.timeout_s <= 86'400)) {
    return wrong(SnapshotOptionsText::tr("--timeout must be greater than 0 and at most 86400 seconds."));
  }
  options.timeout_s = words.timeout_s;
  if (words.settle != "complete") {
    bool ok = false;
    const double seconds = text(words.settle).toDouble(&ok);
    if (!ok || !(seconds >= 0 && seconds <= 86'400)) {
      return wrong(SnapshotOptionsText::tr("--settle must be complete or a number of seconds, not \"%1\".")
                       .arg(text(words.settle)));
    }
    if (seconds > words.timeout_s) {
      return wrong(SnapshotOptionsText::tr("--settle %1 is longer than --timeout %2.")
                       .arg(seconds)
                       .arg(words.timeout_s));
    }
    options.settle_s = seconds;
  }
  if (const auto why = whyWithoutEffect(words, options)) return wrong(*why);
  // Layers that --raw never draws are neither requested nor waited for.
  if (options.raw) {
    std::erase_if(options.layers, [](scene::Layer layer) {
      return layer != scene::Layer::Submaps && layer != scene::Layer::WholeMap;
    });
  }
  for (const QString& path : {options.output, options.report}) {
    if (path.isEmpty()) continue;
    if (const auto why = whyNotWritable(path)) return wrong(*why);
  }
  const QString printed = options.json && !isStandardOutput(options.report) ? QStringLiteral("-") : QString();
  if (const auto why = whyNotTogether({options.output, options.report, printed})) return wrong(*why);
  return options;
}

}  // namespace mapwright::app
