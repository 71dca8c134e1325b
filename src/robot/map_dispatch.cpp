#include "robot/map_dispatch.h"

#include <algorithm>

namespace mapwright::robot {

bool MapDispatch::offered(DispatchService service) const {
  const std::vector<DispatchOffer> all = offers();
  return std::any_of(all.begin(), all.end(), [service](const DispatchOffer& offer) {
    return offer.service == service && offer.offered;
  });
}

}  // namespace mapwright::robot

#include "moc_map_dispatch.cpp"
