#include "overlays/overlay_merge.h"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "overlays/editing_document.h"

namespace mapwright::overlays {
namespace {

constexpr std::string_view kProperties = "properties";
constexpr std::string_view kFeaturesMember = "features";

const Part kAllProperties{Part::Of::Member, std::string(kProperties)};
const Part kType{Part::Of::Member, "type"};

/// In their order, each once.
using Parts = std::vector<std::pair<Part, JsonValue>>;

Parts partsOf(const JsonValue& object) {
  Parts parts;
  if (!object.isObject()) {
    parts.emplace_back(Part{}, object);
    return parts;
  }
  std::optional<JsonValue> properties;
  for (auto& [name, member] : json::membersOf(object)) {
    if (name == kProperties && member.isObject()) {
      properties = member;
    } else if (name != kFeaturesMember) {
      parts.emplace_back(Part{Part::Of::Member, std::move(name)}, member);
    }
  }
  if (!properties) return parts;
  for (auto& [name, value] : json::membersOf(*properties))
    parts.emplace_back(Part{Part::Of::Property, std::move(name)}, value);
  return parts;
}

std::vector<PartChange> partChanges(const JsonValue& before, const JsonValue& after) {
  const Parts old = partsOf(before), now = partsOf(after);
  const auto part = [](const auto& each) -> const Part& { return each.first; };
  const auto valueOf = [&](const Parts& parts, const Part& wanted) {
    const auto found = std::ranges::lower_bound(parts, wanted, {}, part);
    return found == parts.end() || found->first != wanted ? nullptr : &found->second;
  };
  std::vector<PartChange> changes;
  for (const auto& [which, value] : old) {
    const JsonValue* const other = valueOf(now, which);
    if (other && sameValue(value, *other)) continue;
    changes.push_back({which, std::string(value.text()), std::nullopt});
    if (other) changes.back().after = other->text();
  }
  for (const auto& [which, value] : now) {
    if (!valueOf(old, which)) changes.push_back({which, std::nullopt, std::string(value.text())});
  }
  return changes;
}

/// JSON; nullopt: removed.
std::string textWithPart(const JsonValue& object, const Part& part, const std::optional<std::string>& value) {
  if (part.of == Part::Of::Whole) return value.value_or("null");
  if (part.of == Part::Of::Member)
    return value ? withMember(object, part.name, *value) : withoutMember(object, part.name);
  const auto properties = object.member(kProperties);
  if (!properties || !properties->isObject()) {
    if (!value) return std::string(object.text());
    return withMember(object, kProperties, '{' + json::quoted(part.name) + ": " + *value + '}');
  }
  return withMember(
      object, kProperties,
      value ? withMember(*properties, part.name, *value) : withoutMember(*properties, part.name));
}

std::string contentOf(const Feature& feature) {
  const JsonValue root = feature.root();
  if (!root.isObject()) return canonical(root);
  std::string content;
  for (const auto& [part, value] : partsOf(root)) {
    if (!(part == Part{Part::Of::Member, "id"} || part == Part{Part::Of::Property, "id"}))
      content += json::quoted(part.text()) + ':' + canonical(value) + ',';
  }
  return content;
}

using Matches = std::vector<std::optional<std::size_t>>;

class Matching {
 public:
  Matching(const std::vector<Feature>& a, const std::vector<Feature>& b)
      : a_(a), b_(b), to_b_(a.size()), taken_(b.size()) {}

  /// `guess`: also by name and type, and by place.
  Matches match(bool guess) {
    pair([](const Feature& feature) { return std::string_view(feature.text()); }, false, false);
    pair([](const Feature& feature) { return feature.id(); }, false, false);
    pair(contentOf, true, false);
    if (!guess) return std::move(to_b_);
    pair(
        [](const Feature& feature) {
          const std::string name = feature.name();
          return name.empty() ? name
                              : std::to_string(int(feature.shape())) + ' ' + std::to_string(feature.type()) +
                                    ' ' + name;
        },
        true, true);
    pair(
        [](const Feature& feature) {
          const auto geometry = feature.root().member("geometry");
          return geometry ? canonical(*geometry) : std::string();
        },
        true, true);
    return std::move(to_b_);
  }

 private:
  /// Pairs those with the same key in their order. `without_id`: only where one of them has no id; `unique`:
  /// only where no other has that key. An empty key is none.
  template <typename KeyOf>
  void pair(const KeyOf& key_of, bool without_id, bool unique) {
    using Key = std::invoke_result_t<KeyOf, const Feature&>;
    struct Others {
      std::vector<std::size_t> of_b;
      std::size_t next = 0;  // all before it are taken
      std::size_t of_a = 0;
    };
    std::vector<std::pair<std::size_t, Key>> ours;
    for (std::size_t i = 0; i < a_.size(); ++i) {
      if (to_b_[i]) continue;
      if (Key key = key_of(a_[i]); !key.empty()) ours.emplace_back(i, std::move(key));
    }
    if (ours.empty()) return;
    std::unordered_map<Key, Others> by_key;
    for (std::size_t i = 0; i < b_.size(); ++i) {
      if (!taken_[i]) by_key[key_of(b_[i])].of_b.push_back(i);
    }
    if (unique) {
      for (const auto& [mine, key] : ours) {
        if (const auto found = by_key.find(key); found != by_key.end()) ++found->second.of_a;
      }
    }
    for (const auto& [mine, key] : ours) {
      const auto found = by_key.find(key);
      if (found == by_key.end()) continue;
      auto& [others, next, of_a] = found->second;
      if (unique && (of_a > 1 || others.size() > 1)) continue;
      while (next < others.size() && taken_[others[next]]) ++next;
      const bool has_id = without_id && !a_[mine].id().empty();
      for (std::size_t i = next; i < others.size(); ++i) {
        if (taken_[others[i]] || (has_id && !b_[others[i]].id().empty())) continue;
        to_b_[mine] = others[i];
        taken_[others[i]] = true;
        break;
      }
    }
  }

  const std::vector<Feature>&a_, &b_;
  Matches to_b_;
  std::vector<bool> taken_;
};

OverlayChange changeOf(ChangeKind kind, const Feature& feature) {
  OverlayChange change;
  change.kind = kind;
  change.id = feature.id();
  change.name = feature.name();
  return change;
}

bool sameText(const std::optional<std::string>& a, const std::optional<std::string>& b) {
  if (a == b) return true;
  if (!a || !b) return false;
  const auto one = JsonText::read(*a), other = JsonText::read(*b);
  return one && other && sameValue(one->root(), other->root());
}

bool isOfProperties(const PartChange& change) {
  return change.part == kAllProperties || change.part.of == Part::Of::Property;
}

}  // namespace

std::vector<OverlayChange> changesBetween(const OverlayDocument& before, const OverlayDocument& after) {
  std::vector<OverlayChange> changes;
  if (auto parts = changesOf(collectionOf(before), collectionOf(after)); !parts.empty()) {
    OverlayChange change;
    change.collection = true;
    change.parts = std::move(parts);
    changes.push_back(std::move(change));
  }
  const std::vector<Feature>&old = before.features(), &now = after.features();
  const Matches matches = matchesOf(before, after);
  std::vector<bool> known(now.size());
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (!matches[i]) {
      OverlayChange change = changeOf(ChangeKind::Remove, old[i]);
      change.from = i;
      changes.push_back(std::move(change));
      continue;
    }
    known[*matches[i]] = true;
    std::vector<PartChange> parts = changesOf(old[i], now[*matches[i]]);
    if (parts.empty()) continue;
    OverlayChange change = changeOf(ChangeKind::Change, now[*matches[i]]);
    change.parts = std::move(parts);
    change.from = i;
    change.to = matches[i];
    changes.push_back(std::move(change));
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (known[i]) continue;
    OverlayChange change = changeOf(ChangeKind::Add, now[i]);
    change.to = i;
    changes.push_back(std::move(change));
  }
  return changes;
}

std::vector<std::optional<std::size_t>> matchesOf(const OverlayDocument& a, const OverlayDocument& b) {
  return Matching(a.features(), b.features()).match(true);
}

std::vector<std::optional<std::size_t>> equalOf(const std::vector<Feature>& a,
                                                const std::vector<Feature>& b) {
  return Matching(a, b).match(false);
}

Feature collectionOf(const OverlayDocument& document) {
  const Feature plain(R"({"type":"FeatureCollection"})");
  auto json = document.collection();
  if (!json) return plain;
  const Feature collection(std::move(*json));
  return partOf(collection, kType) ? collection : withPart(collection, kType, partOf(plain, kType));
}

std::vector<PartChange> changesOf(const Feature& before, const Feature& after) {
  if (before.text() == after.text()) return {};
  return partChanges(before.root(), after.root());
}

std::optional<std::string> partOf(const Feature& feature, const Part& part) {
  if (part.of == Part::Of::Whole) return feature.text();
  const auto value =
      part.of == Part::Of::Property ? feature.property(part.name) : feature.root().member(part.name);
  return value ? std::optional(std::string(value->text())) : std::nullopt;
}

Feature withPart(const Feature& feature, const Part& part, const std::optional<std::string>& value) {
  if (part.of != Part::Of::Whole && !feature.root().isObject()) return feature;
  return Feature(textWithPart(feature.root(), part, value));
}

Feature withChanges(Feature onto, const std::vector<PartChange>& changes, const Feature& after) {
  for (const PartChange& change : changes) onto = withPart(onto, change.part, change.after);
  // What held the properties goes with the last of them.
  const auto held = onto.root().member(kProperties);
  const bool emptied = held && held->isObject() && held->children().empty();
  return emptied && !after.root().member(kProperties) ? withPart(onto, kAllProperties, std::nullopt) : onto;
}

bool areSame(const Version& a, const Version& b) {
  if (!a || !b) return !a && !b;
  if (&a->text() == &b->text()) return true;  // the very same: features are shared
  if (a->text() == b->text()) return true;
  // What was only moved is found out soon.
  const auto was = a->root().member("geometry"), now = b->root().member("geometry");
  if (was && now && !sameValue(*was, *now)) return false;
  const Parts one = partsOf(a->root()), other = partsOf(b->root());
  return std::ranges::equal(one, other, [](const auto& part, const auto& same) {
    return part.first == same.first && sameValue(part.second, same.second);
  });
}

bool onlyNewId(const std::vector<PartChange>& changes) {
  return std::all_of(changes.begin(), changes.end(), [](const PartChange& change) {
    return !change.before && change.part.name == "id" && change.part.of != Part::Of::Whole;
  });
}

bool meet(const Part& a, const Part& b) {
  return a == b || (a == kAllProperties && b.of == Part::Of::Property) ||
         (b == kAllProperties && a.of == Part::Of::Property);
}

Version merged(const Version& base, const Version& mine, const Version& theirs,
               const std::function<void(const Part&)>& clash) {
  if (areSame(base, mine)) return theirs;
  if (base && theirs && base->text() == theirs->text()) return mine;
  if (!mine || !theirs) {
    const bool kept = theirs && base && onlyNewId(changesOf(*base, *theirs));
    if (base && (mine || theirs) && !kept) clash({});
    return mine;
  }
  const Feature before = base.value_or(Feature("{}"));
  std::vector<PartChange> ours = changesOf(before, *mine);
  const std::vector<PartChange> others = changesOf(before, *theirs);
  // Properties that one of them made something else than an object are one value.
  const auto is_all = [](const PartChange& change) { return change.part == kAllProperties; };
  const auto any = [](const std::vector<PartChange>& changes, const auto& is) {
    return std::any_of(changes.begin(), changes.end(), is);
  };
  bool all_of_mine = false;
  if ((any(ours, is_all) || any(others, is_all)) && any(ours, isOfProperties) &&
      any(others, isOfProperties)) {
    std::erase_if(ours, isOfProperties);
    all_of_mine = !sameText(partOf(*mine, kAllProperties), partOf(*theirs, kAllProperties));
    if (all_of_mine) clash(kAllProperties);
  }
  // What both made the same stays as they wrote it.
  std::erase_if(ours, [&](const PartChange& change) {
    return change.part != kAllProperties && sameText(partOf(*theirs, change.part), change.after);
  });
  for (const PartChange& change : ours) {
    if (any(others, [&](const PartChange& other) { return other.part == change.part; })) clash(change.part);
  }
  Feature merged = withChanges(*theirs, ours, *mine);
  return all_of_mine ? withPart(merged, kAllProperties, partOf(*mine, kAllProperties)) : merged;
}

OverlayMerge merge(const OverlayDocument& base, const OverlayDocument& mine, const OverlayDocument& theirs) {
  OverlayMerge merge{{}, changesBetween(base, mine), {}, {}};
  EditingDocument document(base);
  document.change(document.editsTo(mine, merge.mine));
  if (!theirs.isSameText(base)) {
    merge.theirs = changesBetween(base, theirs);
    document.rebase(theirs);
  }
  const auto conflicts = document.conflicts();
  for (const auto& conflict : conflicts) {
    const auto& [key, part] = conflict;
    const Version& was = document.beforeConflict(key);
    const Version& named = was ? was : document.find(key);
    OverlayConflict& told = merge.conflicts.emplace_back();
    if (key != kCollectionKey) told = {named->id(), named->name(), {}, {}, {}, {}};
    told.part = part;
    told.base = was ? partOf(*was, part) : std::nullopt;
    told.mine = document.mineOf(conflict);
    told.theirs = document.theirsOf(conflict);
  }
  for (const auto& conflict : conflicts) document.useTheirs(conflict);
  merge.document = document.mine();
  return merge;
}

}  // namespace mapwright::overlays
