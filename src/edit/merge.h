// Three-way merge of items: the common base, my version and theirs. Pure functions, any thread.
// Items are values with independent fields (such as a name and a position): changes to different fields can
// be merged. Fields<Item> lists them:
//
//   template <> struct Fields<Thing> {
//     static constexpr std::tuple all{&Thing::name, &Thing::position};
//     /// Copies what is not a field but belongs to the store that `theirs` came from.
//     static void carry(Thing& into, const Thing& theirs);
//     /// Whether two different values of a field count as the same. Optional.
//     static bool alike(const Distance& a, const Distance& b);
//     /// The fields in which theirs is an intermediate step from base to mine. Optional.
//     static FieldMask onTheWay(const Thing& base, const Thing& mine, const Thing& theirs);
//   };
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace mapwright::edit {

/// Names an item of a document as long as the document is open.
using Key = std::string;
template <typename Item>
using Items = std::map<Key, Item>;
template <typename Item>
struct Fields;

/// One bit for each field, in the order of Fields<Item>::all.
using FieldMask = std::uint32_t;

/// Calls visit(member pointer, bit) for every field.
template <typename Item, typename Visit>
void eachField(Visit visit) {
  std::apply(
      [&](auto... member) {
        FieldMask bit = 1;
        ((visit(member, bit), bit <<= 1), ...);
      },
      Fields<Item>::all);
}

/// The fields in which they differ.
template <typename Item>
FieldMask difference(const Item& a, const Item& b) {
  FieldMask mask = 0;
  eachField<Item>([&](auto member, FieldMask bit) {
    bool is_same = a.*member == b.*member;
    if constexpr (requires { Fields<Item>::alike(a.*member, b.*member); })
      is_same = is_same || Fields<Item>::alike(a.*member, b.*member);
    if (!is_same) mask |= bit;
  });
  return mask;
}

/// Equal in every field, or both absent.
template <typename Item>
bool same(const std::optional<Item>& a, const std::optional<Item>& b) {
  return a.has_value() == b.has_value() && (!a || difference(*a, *b) == 0);
}

/// Sets those fields of `into` to what they are in `from`.
template <typename Item>
void assign(Item& into, const Item& from, FieldMask fields) {
  eachField<Item>([&](auto member, FieldMask bit) {
    if (fields & bit) into.*member = from.*member;
  });
}

enum class ConflictKind {
  BothChanged,   // the same field, differently
  DeletedHere,   // I deleted what they changed
  DeletedThere,  // they deleted what I changed
  BothAdded,     // the same key, differently
};

/// What is in conflict. nullopt = the item does not exist.
template <typename Item>
struct Conflict {
  ConflictKind kind = ConflictKind::BothChanged;
  std::optional<Item> base, mine, theirs;
  FieldMask fields = 0;  // of BothChanged and BothAdded: the conflicting fields
};

/// The merge of one item. In a conflict `item` is mine, with their changes to the other fields.
template <typename Item>
struct Merged {
  std::optional<Item> item;
  std::optional<Conflict<Item>> conflict;
};

template <typename Item>
Merged<Item> merge(const std::optional<Item>& base, const std::optional<Item>& mine,
                   const std::optional<Item>& theirs) {
  if (same(mine, base) || same(mine, theirs)) return {theirs, std::nullopt};
  if (same(theirs, base)) {
    Merged<Item> merged{mine, std::nullopt};
    if (merged.item && theirs) Fields<Item>::carry(*merged.item, *theirs);
    return merged;
  }
  if (!mine) return {mine, Conflict<Item>{ConflictKind::DeletedHere, base, mine, theirs}};
  if (!theirs) return {mine, Conflict<Item>{ConflictKind::DeletedThere, base, mine, theirs}};
  const FieldMask between = difference(*mine, *theirs);
  const FieldMask by_me = base ? difference(*mine, *base) : between;
  FieldMask by_them = base ? difference(*theirs, *base) : between;
  if constexpr (requires { Fields<Item>::onTheWay(*base, *mine, *theirs); }) {
    if (base) by_them &= ~Fields<Item>::onTheWay(*base, *mine, *theirs);
  }
  const FieldMask collide = by_me & by_them & between;
  Merged<Item> merged{mine, std::nullopt};
  assign(*merged.item, *theirs, by_them & ~collide);
  Fields<Item>::carry(*merged.item, *theirs);
  if (collide != 0) {
    const ConflictKind kind = base ? ConflictKind::BothChanged : ConflictKind::BothAdded;
    merged.conflict = Conflict<Item>{kind, base, mine, theirs, collide};
  }
  return merged;
}

/// Which version of conflicting fields to take; the others are merged in either case.
enum class Side { Mine, Theirs };
template <typename Item>
std::optional<Item> decided(const Conflict<Item>& conflict, Side side) {
  const bool both_there = conflict.mine && conflict.theirs;
  if (!both_there) return side == Side::Mine ? conflict.mine : conflict.theirs;
  std::optional<Item> item = merge(conflict.base, conflict.mine, conflict.theirs).item;
  if (side == Side::Theirs) assign(*item, *conflict.theirs, conflict.fields);
  return item;
}

}  // namespace mapwright::edit
