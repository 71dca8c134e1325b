#include "edit/merge.h"

#include "map/waypoint.h"

namespace mapwright::edit {

using namespace waypoint_field;

Items itemsOf(const std::vector<map::Waypoint>& points) {
  Items items;
  for (const map::Waypoint& point : points) items.emplace(point.id, point);
  return items;
}

FieldMask difference(const map::Waypoint& a, const map::Waypoint& b) {
  FieldMask mask = 0;
  if (a.name != b.name) mask |= kName;
  if (a.position_m != b.position_m && !map::samePlace(a.position_m, b.position_m)) mask |= kPosition;
  if (a.yaw_rad != b.yaw_rad && !map::sameHeading(a.yaw_rad, b.yaw_rad)) mask |= kYaw;
  if (a.tags != b.tags) mask |= kTags;
  if (a.type != b.type) mask |= kType;
  return mask;
}

bool same(const Item& a, const Item& b) {
  return a.has_value() == b.has_value() && (!a || difference(*a, *b) == 0);
}

void assign(map::Waypoint& into, const map::Waypoint& from, FieldMask fields) {
  if (fields & kName) into.name = from.name;
  if (fields & kPosition) into.position_m = from.position_m;
  if (fields & kYaw) into.yaw_rad = from.yaw_rad;
  if (fields & kTags) into.tags = from.tags;
  if (fields & kType) into.type = from.type;
}

Merged merge(const Item& base, const Item& mine, const Item& theirs) {
  if (same(mine, base) || same(mine, theirs)) return {theirs, std::nullopt};
  Merged merged{mine, std::nullopt};
  if (merged.item && theirs) {
    merged.item->id = theirs->id;
    merged.item->source = theirs->source;
  }
  if (same(theirs, base)) return merged;
  if (!mine) return {mine, Conflict{ConflictKind::DeletedHere, base, mine, theirs}};
  if (!theirs) return {mine, Conflict{ConflictKind::DeletedThere, base, mine, theirs}};
  const FieldMask between = difference(*mine, *theirs);
  const FieldMask by_me = base ? difference(*mine, *base) : between;
  FieldMask by_them = base ? difference(*theirs, *base) : between;
  // Swapped names go through a temporary name: that is on the way from the base to mine.
  if (base && base->name != mine->name && map::isTemporaryFor(theirs->name, base->name)) by_them &= ~kName;
  const FieldMask collide = by_me & by_them & between;
  assign(*merged.item, *theirs, by_them & ~collide);
  if (collide != 0) {
    const ConflictKind kind = base ? ConflictKind::BothChanged : ConflictKind::BothAdded;
    merged.conflict = Conflict{kind, base, mine, theirs, collide};
  }
  return merged;
}

Item decided(const Conflict& conflict, Side side) {
  if (!conflict.mine || !conflict.theirs) return side == Side::Mine ? conflict.mine : conflict.theirs;
  Item item = merge(conflict.base, conflict.mine, conflict.theirs).item;
  if (side == Side::Theirs) assign(*item, *conflict.theirs, conflict.fields);
  return item;
}

void fit(map::Waypoint& point, const robot::KeptFields& keeps, const map::Waypoint* kept) {
  if (!keeps.type) point.type.clear();
  if (!keeps.tags) point.tags.clear();
  if (point.type.empty()) point.type = keeps.usual_type;
  if (!keeps.no_heading && !point.yaw_rad) point.yaw_rad = 0;
  if (kept && (point.position_m - kept->position_m).cwiseAbs().maxCoeff() <= keeps.pixel_m / 2)
    point.position_m = kept->position_m;
}

std::set<Key> refusedNames(const Items& kept, const std::vector<Change>& changes,
                           const robot::KeptFields& keeps) {
  std::set<Key> refused;
  if (keeps.name_twice) return refused;
  std::map<Key, std::string> names;  // afterwards
  for (const auto& [key, point] : kept) names[key] = point.name;
  for (const Change& one : changes) {
    one.after ? void(names[one.key] = one.after->name) : void(names.erase(one.key));
  }
  // A refused waypoint keeps its name, for which another one may be waiting.
  for (bool any = true; any;) {
    any = false;
    std::map<std::string, int> bearers;
    for (const auto& [key, name] : names) ++bearers[name];
    for (const Change& one : changes) {
      const bool named = one.after && (!one.before || one.before->name != one.after->name);
      if (!named || refused.contains(one.key) || bearers[one.after->name] < 2) continue;
      refused.insert(one.key);
      one.before ? void(names[one.key] = one.before->name) : void(names.erase(one.key));
      any = true;
    }
  }
  return refused;
}

}  // namespace mapwright::edit
