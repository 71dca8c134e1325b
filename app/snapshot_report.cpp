#include "app/snapshot_report.h"

#include <cmath>
#include <utility>

#include <QJsonArray>

#include "app/report.h"
#include "geometry/pose.h"

namespace mapwright::app {
namespace {

double toThousandths(double value) { return std::round(value * 1000) / 1000; }

QJsonValue secondsOrNull(double value) { return value < 0 ? QJsonValue() : QJsonValue(toThousandths(value)); }

}  // namespace

QJsonObject reportOf(const SnapshotFacts& facts) {
  const geometry::ViewTransform& view = facts.view;
  QJsonObject report{
      {QStringLiteral("complete"), facts.complete},
      {QStringLiteral("mode"), facts.whole ? QStringLiteral("whole") : QStringLiteral("submaps")},
      {QStringLiteral("uuid"), facts.uuid},
      {QStringLiteral("submaps"), submapsJson(facts.counts)},
      {QStringLiteral("painted"), toThousandths(facts.made)},
      {QStringLiteral("seconds"),
       QJsonObject{{QStringLiteral("connect"), secondsOrNull(facts.connected_s)},
                   {QStringLiteral("first_paint"), secondsOrNull(facts.first_paint_s)},
                   {QStringLiteral("complete"), secondsOrNull(facts.complete_s)}}},
      {QStringLiteral("view"),
       QJsonObject{{QStringLiteral("center"), QJsonArray{view.center_m.x(), view.center_m.y()}},
                   {QStringLiteral("scale"), view.scale_m_per_px},
                   {QStringLiteral("size"), QJsonArray{view.width_px, view.height_px}},
                   {QStringLiteral("rotation_deg"), geometry::degreesFromRadians(view.rotation_rad)}}},
      {QStringLiteral("peak_rss_bytes"), peakMemoryBytes()},
      {QStringLiteral("warnings"), QJsonArray::fromStringList(facts.warnings)},
  };
  const QJsonObject traffic = trafficJson(facts.counts);
  for (auto it = traffic.begin(); it != traffic.end(); ++it) report[it.key()] = it.value();
  if (facts.region) report[QStringLiteral("region")] = *facts.region;
  if (facts.map) report[QStringLiteral("map")] = *facts.map;
  return report;
}

void SnapshotBoard::put(SnapshotStanding standing) {
  const std::lock_guard lock(mutex_);
  standing_ = std::move(standing);
}

SnapshotStanding SnapshotBoard::take() const {
  const std::lock_guard lock(mutex_);
  return standing_;
}

}  // namespace mapwright::app
