#include "map/world.h"

#include <utility>

namespace mapwright::map {

void reduceInto(World& world, const TopicMessage& message, double at_s) {
  if (at_s < world.at_s) std::erase_if(world.live.trail, [&](const TrailPoint& p) { return p.at_s > at_s; });
  reduceInto(world.live, message, at_s);
  if (const auto* list = std::get_if<SubmapList>(&message)) world.submaps = *list;
  world.at_s = at_s;
}

World reduce(World world, const StampedMessage& message) {
  reduceInto(world, message.message, message.at_s());
  return world;
}

}  // namespace mapwright::map
