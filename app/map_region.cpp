// MapReading: maps from a map dispatcher, by region or whole.
#include "app/map_region.h"

#include <algorithm>
#include <vector>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/map_reading.h"
#include "app/option_words.h"
#include "grids/grid_pyramid.h"
#include "regions/map_regions.h"
#include "robot/map_dispatch.h"
#include "sentences/fault_sentence.h"

namespace mapwright::app {
namespace {

class MapRegionText {
  Q_DECLARE_TR_FUNCTIONS(MapRegion)
};

constexpr double kRoundingCells = 2;

QString lengths(const geometry::WorldRect& rect) {
  return MapRegionText::tr("%1 × %2").arg(rect.width(), 0, 'f', 2).arg(rect.height(), 0, 'f', 2);
}

/// The first row of a part is the lowest, that of a pyramid the uppermost. -1 is 255 in both.
std::shared_ptr<const grids::GridPyramid> pyramidOf(const map::GridPart& part,
                                                    const std::shared_ptr<work::Workers>& workers) {
  const auto builder = grids::buildGrid(part.grid.width, part.grid.height, grids::CellCode::Occupancy,
                                        grids::Reduction::OccupiedWins, {workers, nullptr});
  const auto width = std::size_t(part.grid.width);
  for (std::size_t row = std::size_t(part.grid.height); row-- > 0;) {
    const auto* const cells = reinterpret_cast<const std::uint8_t*>(part.cells->data() + row * width);
    builder->pushRow({cells, width});
  }
  builder->finish();
  return builder->pyramid();
}

}  // namespace

tl::expected<map::GridRegion, QString> gridRegionFrom(const std::string& typed) {
  const auto given = numbersFrom(typed);
  const std::vector<double> numbers = given && given->size() == 4 ? *given : std::vector<double>(4);
  if (!(numbers[2] > 0) || !(numbers[3] > 0)) {
    return tl::make_unexpected(MapRegionText::tr("--region %1: give the centre and the side lengths in "
                                                 "metres, X,Y,LX,LY, for example 10,-5,40,30.")
                                   .arg(QString::fromStdString(typed)));
  }
  return map::GridRegion{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

bool givesMapWhenAsked(robot::Robot& robot) {
  robot::MapDispatch* const dispatch = robot.mapDispatch();
  if (!dispatch || !robot.liveTopics() || !dispatch->offered(robot::DispatchService::Grid)) return false;
  const auto offers = dispatch->offers();
  const QStringList by = robot.liveTopics()->topicsOf(map::Stream::WholeMap);
  return std::all_of(by.begin(), by.end(), [&](const QString& name) {
    return std::any_of(offers.begin(), offers.end(), [&](const robot::DispatchOffer& offer) {
      return offer.service == robot::DispatchService::Grid && offer.name == name.toStdString();
    });
  });
}

CommandResult<render::PlacedGrid> MapReading::part(const std::optional<map::GridRegion>& region) {
  robot::MapDispatch* const dispatch = session_.robot().mapDispatch();
  if (!dispatch) return tl::make_unexpected(lacks(robot::Capability::Dispatch));
  const auto part = ask<map::GridPart>(
      [&](robot::OutcomeTo<map::GridPart> reply) { return dispatch->grid(region, std::move(reply)); });
  if (!part) return tl::make_unexpected(failure(part.error()));
  for (const Fault& note : part->notes) notes_ << failure(kDone, sentences::wordsOf(note)).sentence;
  if (part->grid.width == 0) {
    return tl::make_unexpected(
        failure(kIncomplete, region ? MapRegionText::tr("Its map is empty in this region.")
                                    : MapRegionText::tr("Its map is empty.")));
  }
  if (part->grid.width > grids::kMaxGridEdge || part->grid.height > grids::kMaxGridEdge)
    return tl::make_unexpected(
        failure(kRobotError, MapRegionText::tr("Its answer has too many cells in a row.")));
  const geometry::WorldRect bounds = part->grid.bounds();
  if (region) {
    const Eigen::Vector2d low = region->centre_m - region->size_m / 2,
                          high = region->centre_m + region->size_m / 2;
    const geometry::WorldRect asked{low.x(), low.y(), high.x(), high.y()};
    const geometry::WorldRect common = regions::commonGround(part->grid, asked);
    const double rounding = kRoundingCells * part->grid.resolution_m;
    if (regions::liesElsewhere(part->grid, asked)) {
      complete_ = false;
      notes_ << failure(kDone,
                        MapRegionText::tr("It answered with another part of its map, around %1 m, %2 m.")
                            .arg(bounds.center().x(), 0, 'f', 2)
                            .arg(bounds.center().y(), 0, 'f', 2))
                    .sentence;
    } else if (part->grid.origin.yaw_rad == 0 &&
               (common.width() < asked.width() - rounding || common.height() < asked.height() - rounding)) {
      notes_ << failure(kDone, MapRegionText::tr("Its answer covers %1 of the %2 m requested: either its map "
                                                 "ends there, or it does not send more at once.")
                                   .arg(lengths(common), lengths(asked)))
                    .sentence;
    }
  }
  const auto offers = dispatch->offers();
  const auto service = region ? robot::DispatchService::GridRegion : robot::DispatchService::Grid;
  for (const robot::DispatchOffer& offer : offers) {
    if (offer.service == service) name_ = QString::fromStdString(offer.name);
  }
  facts_[QStringLiteral("map")] = mapJson({map::MapKind::Live, {}}, name_, part->grid);
  return render::PlacedGrid{pyramidOf(*part, workers_), part->grid};
}

}  // namespace mapwright::app
