#include "overlays/overlay_box.h"

#include <algorithm>
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

/// What may have a box: a feature, its geometry, and those in a collection of geometries.
struct Boxed {
  std::vector<std::size_t> path;  // empty: the feature; else its geometry, and places in "geometries"
  JsonValue object;
  std::optional<JsonValue> box;
  geometry::WorldRect bounds() const {
    return boundsOf(Feature(path.empty() ? std::string(object.text())
                                         : "{\"geometry\":" + std::string(object.text()) + '}'));
  }
};

constexpr std::size_t kDeepestPart = 8;  // as far as edits move it

void eachBoxed(const JsonValue& geometry, const std::vector<std::size_t>& path, std::vector<Boxed>& all) {
  all.push_back({path, geometry, geometry.member(kBox)});
  const auto parts = geometry.member("geometries");
  if (!parts || path.size() > kDeepestPart) return;
  const auto children = parts->children();
  for (std::size_t i = 0; i < children.size(); ++i) {
    auto inner = path;
    inner.push_back(i);
    eachBoxed(children[i], inner, all);
  }
}

std::vector<Boxed> boxedOf(const Feature& feature) {
  std::vector<Boxed> all{{{}, feature.root(), feature.root().member(kBox)}};
  if (const auto geometry = feature.root().member(kGeometry)) eachBoxed(*geometry, {0}, all);
  return all;
}

const Boxed* find(const std::vector<Boxed>& all, const std::vector<std::size_t>& path) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Boxed& one) { return one.path == path; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Reboxed> reboxed(const Feature& moved, const Feature& before) {
  const std::vector<Boxed> now = boxedOf(moved), was = boxedOf(before);
  std::vector<json::Rewrite> rewrites;
  std::vector<std::vector<std::size_t>> wrong;
  bool any = false;
  for (const Boxed& one : now) {
    const Boxed* const old = one.box ? find(was, one.path) : nullptr;
    // Another box than before was put there on purpose.
    if (!old || !old->box || old->box->text() != one.box->text()) continue;
    any = true;
    const geometry::WorldRect bounds = one.bounds();
    if (isRight(*one.box, bounds)) continue;
    if (isRight(*old->box, old->bounds()) && !bounds.empty()) {
      put(rewrites, *one.box, bounds);
    } else {
      wrong.push_back(one.path);
    }
  }
  if (!any) return std::nullopt;
  Reboxed out{rewrites.empty() ? moved : Feature(JsonText::rewritten(std::move(rewrites))), !wrong.empty()};
  for (const auto& path : wrong) {
    const std::vector<Boxed> there = boxedOf(out.feature);
    const JsonValue object = find(there, path)->object;
    std::string text = out.feature.text();
    text.replace(object.begin(), object.end() - object.begin(), json::withoutMember(object, kBox));
    out.feature = Feature(std::move(text));
  }
  return out;
}

Feature withItsBoxes(const Feature& moved, const Feature& before) {
  const auto geometry = moved.root().member(kGeometry), geometry_before = before.root().member(kGeometry);
  if (!geometry || !geometry_before || geometry->text() == geometry_before->text()) return moved;
  const auto out = reboxed(moved, before);
  return out ? out->feature : moved;
}

bool boxFits(const OverlayDocument& document) {
  const auto collection = document.collection();
  const auto box = collection ? collection->root().member(kBox) : std::nullopt;
  return !box || isRight(*box, boundsOf(document));
}

bool rebox(OverlayDocument& after, const OverlayDocument& before) {
  const auto collection = before.collection();
  const auto box = collection ? collection->root().member(kBox) : std::nullopt;
  if (!box) return true;
  if (!isRight(*box, boundsOf(before))) return false;
  const geometry::WorldRect bounds = boundsOf(after);
  if (bounds.empty()) {
    after.setMember(kBox, std::nullopt);
  } else if (!isRight(*box, bounds)) {
    std::vector<json::Rewrite> rewrites;
    put(rewrites, *box, bounds);
    const JsonText now = JsonText::rewritten(std::move(rewrites));
    after.setMember(kBox, std::string(now.root().member(kBox)->text()));
  }
  return true;
}

}  // namespace mapwright::overlays
