#include "map/world.h"

#include <utility>

namespace mapwright::map {

World reduce(World world, const StampedMessage& message) {
  const double at_s = message.at_s();
  if (at_s < world.at_s) std::erase_if(world.live.trail, [&](const TrailPoint& p) { return p.at_s > at_s; });
  world.live = reduce(std::move(world.live), message.message, at_s);
  if (const auto* list = std::get_if<SubmapList>(&message.message)) world.submaps = *list;
  world.at_s = at_s;
  return world;
}

}  // namespace mapwright::map
