#include "overlays/overlay_box.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/rect.h"
#include "overlays/overlay_edits.h"
#include "overlays/overlay_shapes.h"

namespace mapwright::overlays {
namespace {

constexpr std::string_view kBox = "bbox", kGeometry = "geometry";

geometry::WorldRect boundsOf(const Feature& feature) {
  geometry::WorldRect bounds;
  for (const Path& path : shapesOf(feature).paths) {
    for (const Eigen::Vector2d& point : path.points) bounds.extend(point);
  }
  return bounds;
}

geometry::WorldRect boundsOf(const OverlayDocument& document) {
  geometry::WorldRect bounds;
  for (const Feature& feature : document.features()) bounds.extend(boundsOf(feature));
  return bounds;
}

/// Its numbers left, low, right and top; the heights between them stay. nullopt: it is no box.
std::optional<std::array<JsonValue, 4>> sidesOf(const JsonValue& box) {
  const auto numbers = box.isArray() ? box.children() : std::vector<JsonValue>();
  if (numbers.size() != 4 && numbers.size() != 6) return std::nullopt;
  const std::size_t half = numbers.size() / 2;
  return std::array{numbers[0], numbers[1], numbers[half], numbers[half + 1]};
}

std::array<double, 4> sidesOf(const geometry::WorldRect& bounds) {
  return {bounds.min_x, bounds.min_y, bounds.max_x, bounds.max_y};
}

bool isRight(const JsonValue& box, const geometry::WorldRect& bounds) {
  constexpr double kSame_m = 1e-3;  // positions are written with four decimals
  const auto sides = sidesOf(box);
  if (!sides || bounds.empty()) return false;
  const auto there = sidesOf(bounds);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (!(std::abs((*sides)[i].number() - there[i]) <= kSame_m)) return false;  // NaN is not right
  }
  return true;
}

/// The numbers of a box, as they are around `bounds`.
void put(std::vector<json::Rewrite>& rewrites, const JsonValue& box, const geometry::WorldRect& bounds) {
  const auto sides = sidesOf(box);
  const auto now = sidesOf(bounds);
  for (std::size_t i = 0; i < now.size(); ++i) rewrites.push_back({(*sides)[i], coordinateText(now[i])});
}

Feature withoutBoxOfGeometry(const Feature& feature) {
  const JsonValue root = feature.root();
  return Feature(json::withMember(root, kGeometry, json::withoutMember(*root.member(kGeometry), kBox)));
}

}  // namespace

std::optional<Reboxed> reboxed(const Feature& moved, const Feature& before) {
  const auto geometry = moved.root().member(kGeometry);
  const auto box = moved.root().member(kBox), inner = geometry ? geometry->member(kBox) : std::nullopt;
  if (!box && !inner) return std::nullopt;
  const geometry::WorldRect was = boundsOf(before), is = boundsOf(moved);
  const bool right = box && isRight(*box, was), inner_right = inner && isRight(*inner, was);
  std::vector<json::Rewrite> rewrites;
  if (right) put(rewrites, *box, is);
  if (inner_right) put(rewrites, *inner, is);
  Reboxed out{rewrites.empty() ? moved : Feature(JsonText::rewritten(std::move(rewrites)))};
  if (box && !right) out.feature = Feature(json::withoutMember(out.feature.root(), kBox)), out.removed = true;
  if (inner && !inner_right) out.feature = withoutBoxOfGeometry(out.feature), out.removed = true;
  return out;
}

bool rebox(OverlayDocument& after, const OverlayDocument& before) {
  const auto collection = before.collection();
  const auto box = collection ? collection->root().member(kBox) : std::nullopt;
  if (!box) return true;
  if (!isRight(*box, boundsOf(before))) return false;
  std::vector<json::Rewrite> rewrites;
  put(rewrites, *box, boundsOf(after));
  const JsonText now = JsonText::rewritten(std::move(rewrites));
  after.setMember(kBox, std::string(now.root().member(kBox)->text()));
  return true;
}

}  // namespace mapwright::overlays
