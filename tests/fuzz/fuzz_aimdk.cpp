// What Agibot robots answer.
#include "robot/aimdk/parse_rpc.h"
#include "target.h"

namespace mapwright::fuzz::aimdk {
namespace {

using namespace robot::aimdk;

void read(Input input) {
  const auto held = exactly(input);
  const std::string_view body = viewOf(held);
  use(parseMapNames(body));
  use(parseCurrentMap(body));
  auto map = parseWholeMap(body, {map::MapKind::Stored, "1"});
  use(parseTopology(body, map ? &*map : nullptr));
  if (map) place(*map, untoldScale(*map));
  use(parseRealtimeMap(body));
  use(parseAcceptance(body));
  use(createdPoint(body));
  use(knowsService(404, body));
}

}  // namespace
}  // namespace mapwright::fuzz::aimdk

MAPWRIGHT_FUZZ_TARGET(aimdk)
