#include <limits>
#include <tuple>

#include "robot/axbot/faults.h"
#include "robot/axbot/topic_subjects.h"
#include "robot/wire/base64.h"
#include "robot/wire/picture_facts.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

constexpr std::size_t kMaxPictureBytes = std::size_t(256) << 20;

struct NamedKind {
  std::string_view topic;
  map::GridKind kind;
};
constexpr NamedKind kKinds[] = {
    {"/map", map::GridKind::WholeMap},
    {"/map_v2", map::GridKind::WholeMap},
    {"/chassis/occupancy_grid", map::GridKind::WholeMap},
    {"/map/costmap", map::GridKind::CostmapLow},
    {"/map/costmap_v2", map::GridKind::CostmapLow},
    {"/maps/5cm/1hz", map::GridKind::CostmapLow},
    {"/maps/1cm/1hz", map::GridKind::CostmapHigh},
    {"/incremental_map", map::GridKind::Incremental},
    {"/incremental_map_v2", map::GridKind::Incremental},
    {"/env_match_map", map::GridKind::EnvMatch},
    {"/env_symmetry_map", map::GridKind::EnvSymmetry},
};

int size(const wire::JsonList& pair, std::size_t at) {
  Json value;
  if (pair.at(at).get(value)) return 0;
  const auto cells = wire::asInteger(value);
  return cells && *cells > 0 && *cells <= std::numeric_limits<int>::max() ? int(*cells) : 0;
}

map::GridReference gridOf(const Json& message) {
  map::GridReference grid;
  grid.resolution_m = wire::number(message, {"resolution"}).value_or(wire::kNaN);
  if (const auto pair = wire::list(message, {"size"}); pair && pair->size() >= 2) {
    grid.width = size(*pair, 0);
    grid.height = size(*pair, 1);
  }
  const auto origin = wire::member(message, {"origin"});
  grid.origin =
      (origin ? wire::asPose(*origin) : std::nullopt).value_or(geometry::Pose2{wire::kNaN, wire::kNaN, 0});
  return grid;
}

}  // namespace

std::optional<map::GridKind> gridKindOf(const std::string& topic) {
  for (const NamedKind& named : kKinds) {
    if (named.topic == topic) return named.kind;
  }
  return std::nullopt;
}

void readGridTopic(map::GridKind kind, const Json& message, TextFrame& frame) {
  const auto refuse = [&](Fault why) {
    frame.message =
        map::UnreadableMessage{frame.topic, std::move(why).followedBy(Consequence::PictureBeforeStays)};
  };
  map::GridMessage grid;
  grid.topic = frame.topic;
  grid.kind = kind;
  grid.grid = gridOf(message);
  if (const auto why = map::whyUnusable(grid.grid)) return refuse(*why);
  std::string_view data, url;
  if (const auto given = wire::member(message, {"data"})) std::ignore = given->get(data);
  if (const auto given = wire::member(message, {"data_url"})) std::ignore = given->get(url);
  if (data.empty() && url.starts_with("data:")) data = url;
  if (!data.empty()) {
    auto picture = wire::fromBase64(data, kMaxPictureBytes);
    if (!picture || picture->empty()) {
      return refuse(fault::PictureInMessageNotBase64);
    }
    grid.fingerprint = wire::fingerprint(*picture);
    grid.png = std::make_shared<const std::string>(std::move(*picture));
    frame.message = std::move(grid);
  } else if (!url.empty()) {
    frame.grid_to_fetch = GridToFetch{std::move(grid), std::string(url)};
  } else {
    refuse(fault::NoPictureNorAddress);
  }
}

}  // namespace mapwright::robot::axbot
