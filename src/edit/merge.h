// Waypoints as items of a document: compared field by field, and merged three ways (the common base, mine and
// theirs). Changes to different fields can be merged. Pure functions, any thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "map/waypoint.h"
#include "robot/waypoint_store.h"

namespace mapwright::edit {

/// nullopt = it does not exist.
using Item = std::optional<map::Waypoint>;
/// Names an item as long as its document is open.
using Key = std::string;
using Items = std::map<Key, map::Waypoint>;
Items itemsOf(const std::vector<map::Waypoint>& points);  // by their ids

/// The fields of a waypoint, one bit each. The other members belong to the store.
using FieldMask = std::uint32_t;
namespace waypoint_field {
inline constexpr FieldMask kName = 1, kPosition = 2, kYaw = 4, kTags = 8, kType = 16;
}

/// An item before and after a change.
struct Change {
  Key key;
  Item before = {}, after = {};
};

/// The fields in which they differ by more than rounding (map/waypoint.h).
FieldMask difference(const map::Waypoint& a, const map::Waypoint& b);
/// Equal in every field, or both absent.
bool same(const Item& a, const Item& b);
/// Sets those fields of `into` to what they are in `from`.
void assign(map::Waypoint& into, const map::Waypoint& from, FieldMask fields);

enum class ConflictKind {
  BothChanged,   // the same field, differently
  DeletedHere,   // I deleted what they changed
  DeletedThere,  // they deleted what I changed
  BothAdded,     // the same key, differently
};

/// What is in conflict.
struct Conflict {
  ConflictKind kind = ConflictKind::BothChanged;
  Item base, mine, theirs;
  FieldMask fields = 0;  // of BothChanged and BothAdded: the conflicting fields
};

/// The merge of one item. In a conflict `item` is mine, with their changes to the other fields.
struct Merged {
  Item item;
  std::optional<Conflict> conflict;
};
Merged merge(const Item& base, const Item& mine, const Item& theirs);

/// Which version of conflicting fields to take; the others are merged in either case.
enum class Side { Mine, Theirs };
Item decided(const Conflict& conflict, Side side);

/// Makes it fit for the store: drops unsupported fields, and sets a missing heading to 0 if one is required.
/// `kept`: the one that is stored, if any. What would come back on its pixel has not moved.
void fit(map::Waypoint& point, const robot::KeptFields& keeps, const map::Waypoint* kept = nullptr);
/// Which changes the store would certainly refuse because another waypoint has that name.
std::set<Key> refusedNames(const Items& kept, const std::vector<Change>& changes,
                           const robot::KeptFields& keeps);

}  // namespace mapwright::edit
