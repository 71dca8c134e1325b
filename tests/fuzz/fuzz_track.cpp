// Tracks as `bags track` writes them.
#include "replay/track_file.h"
#include "target.h"

namespace mapwright::fuzz::track {
namespace {

void read(Input input) {
  const auto held = exactly(input);
  const auto track = replay::trackFrom(viewOf(held));
  if (!track) return;
  use(replay::tumOf(*track));
  use(replay::csvOf(*track));
  use(replay::geoJsonOf(*track));
}

}  // namespace
}  // namespace mapwright::fuzz::track

MAPWRIGHT_FUZZ_TARGET(track)
