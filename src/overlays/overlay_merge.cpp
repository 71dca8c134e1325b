#include "overlays/overlay_merge.h"

#include <algorithm>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>

namespace mapwright::overlays {
namespace {

constexpr std::string_view kProperties = "properties";
constexpr std::string_view kFeaturesMember = "features";

const Part kAllProperties{Part::Of::Member, std::string(kProperties)};

using Parts = std::map<Part, JsonValue>;

Parts partsOf(const JsonValue& object) {
  Parts parts;
  if (!object.isObject()) {
    parts.insert_or_assign(Part{}, object);
    return parts;
  }
  for (const JsonValue& member : object.children()) {
    const std::string name = member.key();
    if (name == kProperties && member.isObject()) {
      for (const JsonValue& property : member.children())
        parts.insert_or_assign(Part{Part::Of::Property, property.key()}, property);
    } else if (name != kFeaturesMember) {
      parts.insert_or_assign(Part{Part::Of::Member, name}, member);
    }
  }
  return parts;
}

std::optional<std::string> written(const Parts& parts, const Part& part) {
  const auto found = parts.find(part);
  return found == parts.end() ? std::nullopt : std::optional(std::string(found->second.text()));
}

std::vector<PartChange> partChanges(const JsonValue& before, const JsonValue& after) {
  const Parts old = partsOf(before), now = partsOf(after);
  std::vector<PartChange> changes;
  for (const auto& [part, value] : old) {
    const auto found = now.find(part);
    if (found == now.end() || !sameValue(value, found->second))
      changes.push_back({part, std::string(value.text()), written(now, part)});
  }
  for (const auto& [part, value] : now) {
    if (!old.contains(part)) changes.push_back({part, std::nullopt, std::string(value.text())});
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

  Matches match() {
    pair([](const Feature& feature) { return feature.text(); }, false, false);
    pair([](const Feature& feature) { return feature.id(); }, false, false);
    pair(contentOf, true, false);
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
  using Key = std::function<std::string(const Feature&)>;

  /// Pairs those with the same key in their order. `without_id`: only where one of them has no id; `unique`:
  /// only where no other has that key. An empty key is none.
  void pair(const Key& key_of, bool without_id, bool unique) {
    std::unordered_map<std::string, std::vector<std::size_t>> left, right;
    for (std::size_t i = 0; i < a_.size(); ++i) {
      if (!to_b_[i]) left[key_of(a_[i])].push_back(i);
    }
    for (std::size_t i = 0; i < b_.size(); ++i) {
      if (!taken_[i]) right[key_of(b_[i])].push_back(i);
    }
    for (const auto& [key, ours] : left) {
      const auto found = right.find(key);
      if (key.empty() || found == right.end()) continue;
      const std::vector<std::size_t>& others = found->second;
      if (unique && (ours.size() > 1 || others.size() > 1)) continue;
      for (std::size_t i = 0; i < std::min(ours.size(), others.size()); ++i) {
        if (without_id && !a_[ours[i]].id().empty() && !b_[others[i]].id().empty()) continue;
        to_b_[ours[i]] = others[i];
        taken_[others[i]] = true;
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

/// The parts of the collections besides their features.
std::vector<PartChange> collectionChanges(const OverlayDocument& before, const OverlayDocument& after) {
  static const JsonText none = *JsonText::read("{}");
  const auto old = before.collection(), now = after.collection();
  std::vector<PartChange> changes = partChanges((old ? *old : none).root(), (now ? *now : none).root());
  // A list that becomes a collection says nothing new.
  std::erase_if(changes, [](const PartChange& change) {
    return change.part == Part{Part::Of::Member, "type"} && (!change.before || !change.after);
  });
  return changes;
}

class Merging {
 public:
  Merging(const OverlayDocument& base, const OverlayDocument& mine, const OverlayDocument& theirs)
      : base_(base), mine_(mine), theirs_(theirs) {
    merge_.document = theirs;
    merge_.mine = changesBetween(base, mine);
    merge_.theirs = changesBetween(base, theirs);
    in_theirs_ = Matching(base.features(), theirs.features()).match();
  }

  OverlayMerge merge() {
    for (const OverlayChange& change : merge_.mine) {
      if (change.collection) {
        mergeCollection(change);
      } else if (change.kind == ChangeKind::Add) {
        mergeAdded(mine_.features()[*change.to]);
      } else if (change.kind == ChangeKind::Remove) {
        mergeRemoved(*change.from);
      } else {
        mergeChanged(change);
      }
    }
    // From the last one on, so that the indices stay right.
    std::sort(removed_.rbegin(), removed_.rend());
    for (const std::size_t index : removed_) merge_.document.remove(index);
    for (Feature& feature : added_) merge_.document.add(std::move(feature));
    return std::move(merge_);
  }

 private:
  void mergeCollection(const OverlayChange& change) {
    const auto theirs = collectionChanges(base_, theirs_);
    for (const PartChange& part : change.parts) {
      if (clashes(part, theirs, {}, {})) continue;
      static const JsonText none = *JsonText::read("{}");
      const auto now = merge_.document.collection();
      const JsonText text = *JsonText::read(textWithPart((now ? *now : none).root(), part.part, part.after));
      const std::string member =
          part.part.of == Part::Of::Property ? std::string(kProperties) : part.part.name;
      auto value = text.root().member(member);
      // The last one of them goes with what held them, as it does in mine.
      const auto mine = mine_.collection();
      const bool emptied = value && value->isObject() && value->children().empty();
      if (emptied && !(mine && mine->root().member(member))) value.reset();
      merge_.document.setMember(member, value ? std::optional(std::string(value->text())) : std::nullopt);
    }
  }

  void mergeAdded(const Feature& feature) {
    const std::string id = feature.id();
    for (const OverlayChange& theirs : merge_.theirs) {
      if (theirs.kind != ChangeKind::Add) continue;
      const Feature& other = theirs_.features()[*theirs.to];
      if (contentOf(other) == contentOf(feature) && (id.empty() || other.id().empty() || id == other.id()))
        return;  // it is there already
      if (id.empty() || id != other.id()) continue;
      for (const PartChange& part : partChanges(other.root(), feature.root()))
        merge_.conflicts.push_back({id, feature.name(), part.part, std::nullopt, part.after, part.before});
      return;
    }
    added_.push_back(feature);
  }

  void mergeRemoved(std::size_t in_base) {
    const auto in_theirs = in_theirs_[in_base];
    if (!in_theirs) return;  // they removed it, too
    const Feature &base = base_.features()[in_base], &theirs = theirs_.features()[*in_theirs];
    if (!withoutNewId(partChanges(base.root(), theirs.root())).empty()) {
      merge_.conflicts.push_back({base.id(), base.name(), {}, base.text(), std::nullopt, theirs.text()});
    } else {
      removed_.push_back(*in_theirs);
    }
  }

  void mergeChanged(const OverlayChange& change) {
    const Feature& base = base_.features()[*change.from];
    const auto in_theirs = in_theirs_[*change.from];
    if (!in_theirs) {
      merge_.conflicts.push_back(
          {base.id(), base.name(), {}, base.text(), mine_.features()[*change.to].text(), std::nullopt});
      return;
    }
    const auto theirs = partChanges(base.root(), theirs_.features()[*in_theirs].root());
    for (const PartChange& part : change.parts) {
      if (clashes(part, theirs, base.id(), base.name())) continue;
      const Feature& now = merge_.document.features()[*in_theirs];
      merge_.document.replace(*in_theirs, withPart(now, part.part, part.after));
    }
  }

  /// They changed it, too: a conflict, or the same.
  bool clashes(const PartChange& part, const std::vector<PartChange>& theirs, const std::string& id,
               const std::string& name) {
    for (const PartChange& other : theirs) {
      // One of them made the properties something else than an object.
      const bool whole = (other.part == kAllProperties && part.part.of == Part::Of::Property) ||
                         (part.part == kAllProperties && other.part.of == Part::Of::Property);
      if (!whole && !(other.part == part.part)) continue;
      if (whole || !sameText(part.after, other.after))
        merge_.conflicts.push_back({id, name, part.part, part.before, part.after, other.after});
      return true;
    }
    return false;
  }

  static bool sameText(const std::optional<std::string>& a, const std::optional<std::string>& b) {
    if (!a || !b) return a == b;
    const auto left = JsonText::read(*a), right = JsonText::read(*b);
    return left && right && sameValue(left->root(), right->root());
  }

  /// Robots give an id to features that had none.
  static std::vector<PartChange> withoutNewId(std::vector<PartChange> changes) {
    std::erase_if(changes, [](const PartChange& change) {
      return !change.before && change.part.name == "id" && change.part.of != Part::Of::Whole;
    });
    return changes;
  }

  const OverlayDocument &base_, &mine_, &theirs_;
  Matches in_theirs_;
  OverlayMerge merge_;
  std::vector<std::size_t> removed_;
  std::vector<Feature> added_;
};

}  // namespace

std::vector<OverlayChange> changesBetween(const OverlayDocument& before, const OverlayDocument& after) {
  std::vector<OverlayChange> changes;
  if (std::vector<PartChange> parts = collectionChanges(before, after); !parts.empty()) {
    OverlayChange change;
    change.collection = true;
    change.parts = std::move(parts);
    changes.push_back(std::move(change));
  }
  const std::vector<Feature>&old = before.features(), &now = after.features();
  const Matches matches = Matching(old, now).match();
  std::vector<bool> known(now.size());
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (!matches[i]) {
      OverlayChange change = changeOf(ChangeKind::Remove, old[i]);
      change.from = i;
      changes.push_back(std::move(change));
      continue;
    }
    known[*matches[i]] = true;
    std::vector<PartChange> parts = old[i].text() == now[*matches[i]].text()
                                        ? std::vector<PartChange>()
                                        : partChanges(old[i].root(), now[*matches[i]].root());
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
  return Matching(a.features(), b.features()).match();
}

std::vector<PartChange> changesOf(const Feature& before, const Feature& after) {
  if (before.text() == after.text()) return {};
  return partChanges(before.root(), after.root());
}

std::optional<std::string> partOf(const Feature& feature, const Part& part) {
  return part.of == Part::Of::Whole ? feature.text() : written(partsOf(feature.root()), part);
}

Feature withPart(const Feature& feature, const Part& part, const std::optional<std::string>& value) {
  if (part.of != Part::Of::Whole && !feature.root().isObject()) return feature;
  return Feature(textWithPart(feature.root(), part, value));
}

OverlayMerge merge(const OverlayDocument& base, const OverlayDocument& mine, const OverlayDocument& theirs) {
  return Merging(base, mine, theirs).merge();
}

}  // namespace mapwright::overlays
