#include "ui/regions/regions_text.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "regions/region_sentence.h"
#include "regions/region_sheet.h"
#include "words/listed.h"

namespace mapwright::ui {
namespace {

class MapByRegionsText {
  Q_DECLARE_TR_FUNCTIONS(MapByRegions)
};

constexpr double kMostCells = 1e15;  // larger values are invalid

QString metres(double value) { return QLocale::c().toString(value, 'f', value < 100 ? 1 : 0); }

/// Along its own axes, whatever its rotation.
geometry::WorldRect extentOf(const robot::MapExtent& extent) {
  return {0, 0, extent.grid.width * extent.grid.resolution_m, extent.grid.height * extent.grid.resolution_m};
}

qint64 whole(double value) { return qint64(std::clamp(value, 0.0, kMostCells)); }

/// "8,000 × 8,000 cells, about 224 MB"; empty if unknown.
QString shortSizeText(const regions::MapRegions& map, const std::optional<robot::MapExtent>& extent) {
  const auto cells = [](double wide, double high, qint64 bytes) {
    return MapByRegionsText::tr("%1 × %2 cells, about %3")
        .arg(countText(whole(wide)), countText(whole(high)), bytesText(bytes));
  };
  if (extent) return cells(extent->grid.width, extent->grid.height, extent->about_bytes);
  const auto resolution = map.plan().resolution();
  if (!resolution || map.reach().empty()) return {};
  const double wide = std::ceil(map.reach().width() / *resolution),
               high = std::ceil(map.reach().height() / *resolution);
  return MapByRegionsText::tr("at least %1").arg(cells(wide, high, whole(wide * high)));
}

}  // namespace

QString regionsStatus(const regions::MapRegions& map) {
  const regions::RegionCounts counts = map.counts();
  const QString bytes = bytesText(qint64(map.bytes()));
  if (counts.in_view == 0 && !map.plan().tooFar() && map.bytes() > 0)
    return MapByRegionsText::tr("regions: %1 loaded").arg(bytes);
  if (map.plan().tooFar()) return MapByRegionsText::tr("regions: zoom in, %1").arg(bytes);
  return MapByRegionsText::tr("%1 of %2 regions, %3")
      .arg(countText(counts.answered), countText(counts.in_view), bytes);
}

QString areaText(const geometry::WorldRect& rect) {
  return MapByRegionsText::tr("%1 × %2 m").arg(metres(rect.width()), metres(rect.height()));
}

geometry::WorldRect wholeCells(const regions::MapRegions& map, const geometry::WorldRect& rect) {
  for (const auto& sheet : map.sheets()) {
    if (sheet->reference().origin.yaw_rad != 0) continue;
    const double cell_m = sheet->reference().resolution_m;
    const auto edge = [cell_m](double at, double zero) {
      return zero + std::round((at - zero) / cell_m) * cell_m;
    };
    const Eigen::Vector2d& zero = sheet->zero();
    geometry::WorldRect cells;
    cells.extend(Eigen::Vector2d(edge(rect.min_x, zero.x()), edge(rect.min_y, zero.y())));
    cells.extend(Eigen::Vector2d(edge(rect.max_x, zero.x()), edge(rect.max_y, zero.y())));
    if (cells.width() > 0 && cells.height() > 0) return cells;
  }
  return rect;
}

QString rectangleText(const regions::MapRegions& map, const geometry::WorldRect& rect) {
  const auto resolution = map.plan().resolution();
  if (!resolution) return areaText(rect);
  constexpr double kRounding = 1e-6;
  const double wide = std::ceil(rect.width() / *resolution - kRounding),
               high = std::ceil(rect.height() / *resolution - kRounding);
  return MapByRegionsText::tr("%1: %2 × %3 cells, about %4")
      .arg(areaText(rect), countText(whole(wide)), countText(whole(high)), bytesText(whole(wide * high)));
}

QString wholeSizeText(const regions::MapRegions* map, const std::optional<robot::MapExtent>& extent) {
  const geometry::WorldRect reach = map ? map->reach() : geometry::WorldRect{};
  if (!extent) {
    if (reach.empty()) return MapByRegionsText::tr("Its size is unknown: the robot does not report it.");
    return MapByRegionsText::tr(
               "The known part covers %1. It may be larger: the robot does not report its size.")
        .arg(rectangleText(*map, reach));
  }
  QStringList said{
      MapByRegionsText::tr("The robot reports its size as %1: %2 × %3 cells, about %4 over the network.")
          .arg(areaText(extentOf(*extent)), countText(extent->grid.width), countText(extent->grid.height),
               bytesText(extent->about_bytes))};
  const geometry::WorldRect told = extent->grid.bounds().grown(extent->grid.resolution_m);
  if (!reach.empty() && !(told.contains(Eigen::Vector2d(reach.min_x, reach.min_y)) &&
                          told.contains(Eigen::Vector2d(reach.max_x, reach.max_y))))
    said << MapByRegionsText::tr("Regions outside of that have been received: it is larger.");
  if (extent->most_bytes > 0 && extent->about_bytes > extent->most_bytes)
    said << MapByRegionsText::tr(
                "The link accepts at most %1 per message: the transfer may fail, and then nothing is "
                "received.")
                .arg(bytesText(extent->most_bytes));
  return words::paragraph(said);
}

QString notWholeReason(const std::optional<robot::MapExtent>& extent) {
  if (!extent || !extent->beyondLink()) return {};
  return MapByRegionsText::tr(
             "The whole map is too large to be fetched at once: its %1 × %2 cells are at least %3 over the "
             "network, but the limit is %4. Fetch a region instead.")
      .arg(countText(extent->grid.width), countText(extent->grid.height), bytesText(extent->least_bytes),
           bytesText(extent->most_bytes));
}

QString wholeProgressText(qint64 bytes, qint64 seconds, const std::optional<robot::MapExtent>& extent) {
  const QString time = countText(seconds);
  if (bytes <= 0)
    return MapByRegionsText::tr("Fetching the whole map, for %1 s. Nothing has arrived yet.").arg(time);
  if (extent && bytes < extent->about_bytes) {
    return MapByRegionsText::tr("Fetching the whole map: %1 of about %2 so far, for %3 s.")
        .arg(bytesText(bytes), bytesText(extent->about_bytes), time);
  }
  return MapByRegionsText::tr("Fetching the whole map: %1 so far, for %2 s.").arg(bytesText(bytes), time);
}

QString regionReason(const regions::MapRegions& map, const Eigen::Vector2d& world_m, bool offered,
                     bool online) {
  using regions::RegionState;
  const auto kNone = regions::RegionTrouble::Kind::None;
  std::optional<regions::RegionView> region = map.at(world_m);
  for (const regions::RegionView& one :
       map.answeredIn(geometry::WorldRect{world_m.x(), world_m.y(), world_m.x(), world_m.y()}.grown(1e-3))) {
    if (!region && one.rect.contains(world_m)) region = one;
  }
  const QString why = region ? regions::sentenceOf(region->trouble) : QString();
  if (region && region->state == RegionState::Held) {
    if (region->trouble.kind == kNone) return {};
    return MapByRegionsText::tr("Old: this region could not be fetched again. %1").arg(why);
  }
  if (region && region->state == RegionState::Nothing)
    return MapByRegionsText::tr("Empty: the robot says that its map has nothing in this region.");
  if (!online) return MapByRegionsText::tr("Not fetched: there is no connection to the robot.");
  if (!offered) return MapByRegionsText::tr("Not fetched: the robot no longer sends its map by region.");
  if (map.plan().tooFar())
    return MapByRegionsText::tr("Not fetched: too much of the map is visible. Zoom in.");
  if (region && region->state == RegionState::Failed)
    return MapByRegionsText::tr("This region could not be fetched and will be tried again automatically. %1")
        .arg(why);
  if (region && region->state == RegionState::Fetching)
    return MapByRegionsText::tr("This region is being fetched.");
  if (region) return MapByRegionsText::tr("Not fetched yet: this region is waiting for the ones before it.");
  if (const auto& trouble = map.plan().probeTrouble(); !map.plan().resolution() && trouble.kind != kNone)
    return MapByRegionsText::tr("No region of the map could be fetched: %1")
        .arg(regions::sentenceOf(trouble));
  return MapByRegionsText::tr("Not fetched yet: waiting for the robot's first answer.");
}

RegionsNotice regionsNotice(const regions::MapRegions& map, bool whole,
                            const std::optional<robot::MapExtent>& extent) {
  using Offer = RegionsNotice::Offer;
  if (map.plan().tooFar()) {
    if (extent && extent->beyondLink()) {
      return {Mark::Neutral,
              MapByRegionsText::tr("Too much of the map is visible, and the whole map is too large to fetch "
                                   "at once. Zoom in, or fetch a region."),
              Offer::Region};
    }
    if (!whole)
      return {Mark::Neutral, MapByRegionsText::tr("Too much of the map is visible to be fetched. Zoom in.")};
    // The strip is one line; the question has more detail.
    const QString size = shortSizeText(map, extent);
    return {Mark::Neutral,
            size.isEmpty()
                ? MapByRegionsText::tr("Too much of the map is visible. Zoom in, or fetch the whole map.")
                : MapByRegionsText::tr("Too much of the map is visible. Zoom in, or fetch the whole map: %1.")
                      .arg(size),
            Offer::Whole};
  }
  const auto kNone = regions::RegionTrouble::Kind::None;
  if (const auto& trouble = map.plan().probeTrouble(); !map.plan().resolution() && trouble.kind != kNone) {
    return {
        Mark::Bad,
        MapByRegionsText::tr("No region of the map could be fetched: %1").arg(regions::sentenceOf(trouble)),
        Offer::Retry};
  }
  const int failed = map.counts().failed;
  if (failed == 0 && map.counts().smaller > 0) {
    return {Mark::Warning, MapByRegionsText::tr("The robot's answers are smaller than the requested regions "
                                                "(%1 of %2): the missing parts are blank.")
                               .arg(countText(map.counts().smaller), countText(map.counts().in_view))};
  }
  if (failed == 0) return {};
  QString why;
  for (const regions::RegionView& region : map.inView()) {
    if (why.isEmpty()) why = regions::sentenceOf(region.trouble);
  }
  return {Mark::Warning,
          MapByRegionsText::tr(
              "Some of the visible regions could not be fetched (%1 of %2 are missing or old): %3")
              .arg(countText(failed), countText(map.counts().in_view), why),
          Offer::Retry};
}

}  // namespace mapwright::ui
