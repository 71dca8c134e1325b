#include "app/stream_words.h"

#include <algorithm>
#include <iterator>

#include "recorder/recorder.h"

namespace mapwright::app {
namespace {

using map::Stream;

struct Word {
  Stream stream;
  const char* word;
};
constexpr Word kWords[] = {{Stream::Pose, "pose"},
                           {Stream::Model, "model"},
                           {Stream::WholeMap, "map"},
                           {Stream::Incremental, "incremental-map"},
                           {Stream::EnvMatch, "env-match"},
                           {Stream::EnvSymmetry, "env-symmetry"},
                           {Stream::CostmapLow, "costmap-low"},
                           {Stream::CostmapHigh, "costmap-high"},
                           {Stream::MapInfo, "map-info"},
                           {Stream::Landmarks, "landmarks"},
                           {Stream::Doors, "doors"},
                           {Stream::Pallets, "pallets"},
                           {Stream::Racks, "racks"},
                           {Stream::SeenObjects, "objects"},
                           {Stream::Constraints, "constraints"},
                           {Stream::Trajectory, "trajectory"},
                           {Stream::Path, "path"},
                           {Stream::LocalPath, "local-path"},
                           {Stream::Planning, "planning"},
                           {Stream::Cloud, "cloud"},
                           {Stream::NearbyRobots, "robots"},
                           {Stream::NearbyFootprints, "footprints"},
                           {Stream::Battery, "battery"},
                           {Stream::Wheels, "wheels"},
                           {Stream::Alerts, "alerts"},
                           {Stream::Sensors, "sensors"},
                           {Stream::GlobalPositioning, "positioning"}};

}  // namespace

QStringList streamWords() {
  QStringList words;
  for (const Word& one : kWords) words << QLatin1String(one.word);
  return words;
}

tl::expected<map::Streams, QString> streamsFrom(const QString& typed) {
  map::Streams streams;
  if (typed == QLatin1String("none")) return streams;
  if (typed == QLatin1String("all")) return recorder::everyStream();
  for (const QString& part : typed.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const auto known = std::find_if(std::begin(kWords), std::end(kWords), [&](const Word& one) {
      return part.trimmed() == QLatin1String(one.word);
    });
    if (known == std::end(kWords)) return tl::make_unexpected(part.trimmed());
    streams.insert(known->stream);
  }
  return streams;
}

}  // namespace mapwright::app
