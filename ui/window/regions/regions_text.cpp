#include "window/regions/regions_text.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "sentences/region_sentence.h"

namespace mapwright::window {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(MapByRegions)
};

constexpr double kMostCells = 1e15;  // more is no map

QString metres(double value) { return QLocale::c().toString(value, 'f', value < 100 ? 1 : 0); }

qint64 whole(double value) { return qint64(std::clamp(value, 0.0, kMostCells)); }

}  // namespace

QString regionsStatus(const regions::MapRegions& map) {
  const regions::RegionCounts counts = map.counts();
  const QString bytes = bytesText(qint64(map.bytes()));
  if (counts.in_view == 0 && !map.plan().tooFar() && map.bytes() > 0)
    return Words::tr("regions: %1 held").arg(bytes);
  if (map.plan().tooFar()) return Words::tr("regions: zoom in, %1").arg(bytes);
  return Words::tr("%1 of %2 regions, %3").arg(countText(counts.answered), countText(counts.in_view), bytes);
}

QString areaText(const geometry::WorldRect& rect) {
  return Words::tr("%1 × %2 m").arg(metres(rect.width()), metres(rect.height()));
}

QString rectangleText(const regions::MapRegions& map, const geometry::WorldRect& rect) {
  const auto resolution = map.plan().resolution();
  if (!resolution) return areaText(rect);
  const double wide = std::ceil(rect.width() / *resolution), high = std::ceil(rect.height() / *resolution);
  return Words::tr("%1: %2 × %3 cells, about %4")
      .arg(areaText(rect), countText(whole(wide)), countText(whole(high)), bytesText(whole(wide * high)));
}

QString wholeSizeText(const regions::MapRegions& map) {
  if (map.reach().empty()) return Words::tr("How large it is, is not known yet.");
  return Words::tr("What is known of it reaches over %1. It may be larger.")
      .arg(rectangleText(map, map.reach()));
}

RegionsNotice regionsNotice(const regions::MapRegions& map, bool whole) {
  using Offer = RegionsNotice::Offer;
  if (map.plan().tooFar()) {
    if (!whole) return {Mark::Neutral, Words::tr("Too much of the map is in view to be fetched. Zoom in.")};
    return {Mark::Neutral,
            Words::tr("Too much of the map is in view to be fetched by regions. Zoom in, or fetch the whole "
                      "map. %1")
                .arg(wholeSizeText(map)),
            Offer::Whole};
  }
  const auto kNone = regions::RegionTrouble::Kind::None;
  if (const auto& trouble = map.plan().probeTrouble(); !map.plan().resolution() && trouble.kind != kNone) {
    return {Mark::Bad,
            Words::tr("No region of the map could be fetched: %1").arg(sentences::sentenceOf(trouble)),
            Offer::Retry};
  }
  const int failed = map.counts().failed;
  if (failed == 0 && map.counts().smaller > 0) {
    return {Mark::Warning, Words::tr("The robot's answers are smaller than the regions asked for (%1 of %2): "
                                     "what is missing is blank.")
                               .arg(countText(map.counts().smaller), countText(map.counts().in_view))};
  }
  if (failed == 0) return {};
  QString why;
  for (const regions::RegionView& region : map.inView()) {
    if (why.isEmpty()) why = sentences::sentenceOf(region.trouble);
  }
  return {Mark::Warning,
          Words::tr("Not every region in view could be fetched (%1 of %2 are missing or old): %3")
              .arg(countText(failed), countText(map.counts().in_view), why),
          Offer::Retry};
}

}  // namespace mapwright::window
