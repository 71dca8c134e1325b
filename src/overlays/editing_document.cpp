#include "overlays/editing_document.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "overlays/overlay_box.h"

namespace mapwright::overlays {
namespace {

const Version kNowhere;
const Part kBoxOfAll{Part::Of::Member, "bbox"};

/// The document with the members of the collection that `after` has other than `before`.
OverlayDocument withCollection(OverlayDocument document, const Feature& before, const Feature& after) {
  std::set<std::string> members;
  for (const PartChange& change : changesOf(before, after))
    members.insert(change.part.of == Part::Of::Property ? "properties" : change.part.name);
  for (const std::string& member : members)
    document.setMember(member, partOf(after, {Part::Of::Member, member}));
  return document;
}

}  // namespace

EditingDocument::EditingDocument() : EditingDocument(OverlayDocument()) {}

EditingDocument::EditingDocument(OverlayDocument base)
    : base_(std::move(base)), collection_base_(collectionOf(base_)), collection_now_(collection_base_) {
  for (const Feature& feature : base_.features()) {
    base_keys_.push_back(now_.size());
    base_of_.emplace_back(feature);
    now_.emplace_back(feature);
  }
}

const Version& EditingDocument::find(FeatureKey key) const {
  if (key == kCollectionKey) return collection_now_;
  return key < now_.size() ? now_[key] : kNowhere;
}
const Version& EditingDocument::findBase(FeatureKey key) const {
  if (key == kCollectionKey) return collection_base_;
  return key < base_of_.size() ? base_of_[key] : kNowhere;
}

OverlayDocument EditingDocument::mine() const {
  OverlayDocument document = base_;
  const std::set<FeatureKey> placed(base_keys_.begin(), base_keys_.end());
  // From the last one on, so that the indices stay right.
  for (std::size_t i = base_keys_.size(); i-- > 0;) {
    const Version& now = now_[base_keys_[i]];
    if (!now) {
      document.remove(i);
    } else if (now->text() != base_.features()[i].text()) {
      document.replace(i, *now);
    }
  }
  for (FeatureKey key = 0; key < now_.size(); ++key) {
    if (now_[key] && !placed.contains(key)) document.add(*now_[key]);
  }
  document = withCollection(std::move(document), *collection_base_, *collection_now_);
  if (boxIsTheirs()) rebox(document, base_);
  return document;
}

/// It was not put there by hand, so it follows the features. It is no edit: others who move features change
/// it as well, and nobody would have to decide that.
bool EditingDocument::boxIsTheirs() const {
  return partOf(*collection_now_, kBoxOfAll) == partOf(*collection_base_, kBoxOfAll);
}

std::vector<FeatureKey> EditingDocument::keysOfMine() const {
  std::vector<FeatureKey> keys;
  for (const FeatureKey key : base_keys_) {
    if (now_[key]) keys.push_back(key);
  }
  const std::set<FeatureKey> placed(base_keys_.begin(), base_keys_.end());
  for (FeatureKey key = 0; key < now_.size(); ++key) {
    if (now_[key] && !placed.contains(key)) keys.push_back(key);
  }
  return keys;
}

EditingDocument::State EditingDocument::state(FeatureKey key) const {
  const Version &was = findBase(key), &now = find(key);
  if (!was) return now ? State::New : State::Same;
  if (!now) return State::Deleted;
  if (&was->text() == &now->text()) return State::Same;
  auto known = compared_.find(key);
  if (known == compared_.end() || &known->second.was.text() != &was->text() ||
      &known->second.now.text() != &now->text())
    known = compared_.insert_or_assign(key, Compared{*was, *now, areSame(was, now)}).first;
  return known->second.same ? State::Same : State::Changed;
}

std::size_t EditingDocument::unsavedCount() const {
  std::size_t count = 0;
  for (FeatureKey key = 0; key < now_.size(); ++key) count += isUnsaved(key) ? 1 : 0;
  return count + (isUnsaved(kCollectionKey) ? 1 : 0);
}

bool EditingDocument::unsaved() const { return unsavedCount() > 0; }

void EditingDocument::resize(std::size_t size) {
  base_of_.resize(std::max(size, base_of_.size()));
  now_.resize(std::max(size, now_.size()));
}

FeatureKey EditingDocument::newKey() {
  resize(now_.size() + 1);
  return now_.size() - 1;
}

void EditingDocument::apply(const std::vector<FeatureEdit>& edits, bool forward) {
  for (const FeatureEdit& edit : edits) nowOf(edit.key) = forward ? edit.after : edit.before;
}

bool EditingDocument::change(std::vector<FeatureEdit> edits, bool joins) {
  std::erase_if(edits, [](const FeatureEdit& edit) {
    return edit.before && edit.after ? edit.before->text() == edit.after->text()
                                     : !edit.before && !edit.after;
  });
  if (edits.empty()) return false;
  steps_.resize(done_);
  apply(edits, true);
  if (!joins || steps_.empty()) {
    steps_.push_back(std::move(edits));
    done_ = steps_.size();
    return true;
  }
  auto& last = steps_.back();
  std::unordered_map<FeatureKey, std::size_t> index_of;
  for (std::size_t i = 0; i < last.size(); ++i) index_of.emplace(last[i].key, i);
  for (FeatureEdit& edit : edits) {
    const auto [known, is_new] = index_of.try_emplace(edit.key, last.size());
    if (is_new) {
      last.push_back(std::move(edit));
    } else {
      last[known->second].after = std::move(edit.after);
    }
  }
  return true;
}

bool EditingDocument::undo() {
  if (done_ == 0) return false;
  apply(steps_[--done_], false);
  return true;
}

bool EditingDocument::redo() {
  if (done_ == steps_.size()) return false;
  apply(steps_[done_++], true);
  return true;
}

std::set<FeatureKey> EditingDocument::keysOf(std::size_t step) const {
  std::set<FeatureKey> keys;
  if (step >= steps_.size()) return keys;
  for (const FeatureEdit& edit : steps_[step]) keys.insert(edit.key);
  return keys;
}

std::vector<FeatureEdit> EditingDocument::editsTo(const OverlayDocument& version) {
  return editsTo(version, changesBetween(mine(), version));
}

std::vector<FeatureEdit> EditingDocument::editsTo(const OverlayDocument& version,
                                                  const std::vector<OverlayChange>& changes) {
  const std::vector<FeatureKey> keys = keysOfMine();
  std::vector<FeatureEdit> edits;
  std::vector<Feature> added;
  for (const OverlayChange& change : changes) {
    if (change.collection) continue;
    const Version before = change.from ? now_[keys[*change.from]] : std::nullopt;
    if (change.kind == ChangeKind::Add) {
      added.push_back(version.features()[*change.to]);
    } else if (change.kind == ChangeKind::Remove) {
      edits.push_back({keys[*change.from], before, std::nullopt});
    } else {
      edits.push_back(
          {keys[*change.from], before, withChanges(*before, change.parts, version.features()[*change.to])});
    }
  }
  // What is only deleted here is that feature again.
  std::map<std::string, FeatureKey> deleted;
  for (FeatureKey key = 0; key < now_.size(); ++key) {
    if (base_of_[key] && !now_[key] && !base_of_[key]->id().empty())
      deleted.emplace(base_of_[key]->id(), key);
  }
  for (const Feature& feature : added) {
    const auto again = deleted.extract(feature.id());
    edits.push_back({again.empty() ? newKey() : again.mapped(), std::nullopt, feature});
  }
  Feature collection = collectionOf(version);
  if (boxIsTheirs() && boxFits(base_) && boxFits(version))
    collection = withPart(collection, kBoxOfAll, partOf(*collection_now_, kBoxOfAll));
  if (const auto parts = changesOf(*collection_now_, collection); !parts.empty())
    edits.push_back({kCollectionKey, collection_now_, withChanges(*collection_now_, parts, collection)});
  return edits;
}

void EditingDocument::rebase(const OverlayDocument& theirs) {
  std::vector<std::optional<FeatureKey>> keys(theirs.features().size());
  const auto known = matchesOf(base_, theirs);
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i]) keys[*known[i]] = base_keys_[i];
  }
  // What both added is one feature.
  std::vector<FeatureKey> added_keys;
  std::vector<std::size_t> added_there;
  std::vector<Feature> added, others;
  for (FeatureKey key = 0; key < now_.size(); ++key) {
    if (base_of_[key] || !now_[key]) continue;
    added_keys.push_back(key);
    added.push_back(*now_[key]);
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i]) continue;
    added_there.push_back(i);
    others.push_back(theirs.features()[i]);
  }
  const auto equal = equalOf(added, others);
  for (std::size_t i = 0; i < equal.size(); ++i) {
    if (equal[i]) keys[added_there[*equal[i]]] = added_keys[i];
  }
  for (auto& key : keys) {
    if (!key) key = newKey();
  }
  std::vector<Version> there(now_.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    // The same text stays the same feature: whoever made something of it need not do so again.
    const Version& base = base_of_[*keys[i]];
    const Feature& feature = theirs.features()[i];
    there[*keys[i]] = base && base->text() == feature.text() ? base : Version(feature);
  }

  const auto ignored = [](const Part&) {};
  const Version collection_there = collectionOf(theirs);
  for (auto& step : steps_) {
    for (FeatureEdit& edit : step) {
      const bool whole = edit.key == kCollectionKey;
      const Version &base = whole ? collection_base_ : base_of_[edit.key],
                    &now = whole ? collection_there : there[edit.key];
      edit.before = merged(base, edit.before, now, ignored);
      edit.after = merged(base, edit.after, now, ignored);
    }
  }
  std::set<FeatureKey> undecided;
  for (const Conflict& conflict : conflicts()) undecided.insert(conflict.first);
  std::erase_if(before_conflict_, [&](const auto& each) { return !undecided.contains(each.first); });
  for (FeatureKey key = 0; key < now_.size(); ++key) {
    const Version base = base_of_[key];
    if (!areSame(base, there[key]) && !areSame(now_[key], there[key]) &&
        !(base && there[key] && onlyNewId(changesOf(*base, *there[key]))))
      changed_there_.insert(key);
    now_[key] = merged(base, now_[key], there[key], [&](const Part& part) {
      met_.emplace(key, part);
      before_conflict_.emplace(key, base);
    });
    base_of_[key] = there[key];
  }
  collection_now_ = merged(collection_base_, collection_now_, collection_there, [&](const Part& part) {
    met_.emplace(kCollectionKey, part);
    before_conflict_.emplace(kCollectionKey, collection_base_);
  });
  collection_base_ = collection_there;
  base_ = theirs;
  base_keys_.clear();
  for (const auto& key : keys) base_keys_.push_back(*key);
}

void EditingDocument::markSaved() {
  std::vector<FeatureKey> keys = keysOfMine();
  base_ = mine();
  base_keys_ = std::move(keys);
  base_of_ = now_;
  collection_base_ = collection_now_ = collectionOf(base_);
  changed_there_.clear();
  met_.clear();
  before_conflict_.clear();
}

std::vector<EditingDocument::Conflict> EditingDocument::conflicts() const {
  std::vector<Conflict> open;
  for (const Conflict& conflict : met_) {
    const Version &mine = find(conflict.first), &theirs = findBase(conflict.first);
    if (areSame(mine, theirs)) continue;
    if (conflict.second.of != Part::Of::Whole) {
      if (!mine || !theirs) continue;
      const auto changes = changesOf(*theirs, *mine);
      if (std::none_of(changes.begin(), changes.end(),
                       [&](const PartChange& change) { return meet(change.part, conflict.second); }))
        continue;
    }
    open.push_back(conflict);
  }
  return open;
}

bool EditingDocument::inConflict(FeatureKey key) const {
  const auto open = conflicts();
  return std::any_of(open.begin(), open.end(), [&](const Conflict& each) { return each.first == key; });
}

const Version& EditingDocument::beforeConflict(FeatureKey key) const {
  const auto before = before_conflict_.find(key);
  return before == before_conflict_.end() ? kNowhere : before->second;
}

std::optional<std::string> EditingDocument::mineOf(const Conflict& conflict) const {
  const Version& mine = find(conflict.first);
  return mine ? partOf(*mine, conflict.second) : std::nullopt;
}

std::optional<std::string> EditingDocument::theirsOf(const Conflict& conflict) const {
  const Version& theirs = findBase(conflict.first);
  return theirs ? partOf(*theirs, conflict.second) : std::nullopt;
}

void EditingDocument::useTheirs(const Conflict& conflict) {
  const auto& [key, part] = conflict;
  const Version &mine = find(key), &theirs = findBase(key);
  Version after = theirs;
  if (part.of != Part::Of::Whole && mine && theirs) {
    after = withPart(*mine, part, partOf(*theirs, part));
    if (areSame(after, theirs)) after = theirs;  // to the byte
  }
  change({{key, mine, after}});
}

OverlayDocument EditingDocument::draftBase() const {
  OverlayDocument document = base_;
  std::set<FeatureKey> undecided;
  for (const Conflict& conflict : conflicts()) undecided.insert(conflict.first);
  for (std::size_t i = base_keys_.size(); i-- > 0;) {
    const auto before = before_conflict_.find(base_keys_[i]);
    if (undecided.erase(base_keys_[i]) == 0 || before == before_conflict_.end()) continue;
    before->second ? document.replace(i, *before->second) : document.remove(i);
  }
  // They deleted these.
  for (const FeatureKey key : undecided) {
    if (key == kCollectionKey) continue;
    const auto before = before_conflict_.find(key);
    if (before != before_conflict_.end() && before->second) document.add(*before->second);
  }
  if (const auto before = before_conflict_.find(kCollectionKey); before != before_conflict_.end())
    document = withCollection(std::move(document), *collection_base_, *before->second);
  return document;
}

void EditingDocument::restoreDraft(const OverlayDocument& old_base, const OverlayDocument& old_mine) {
  // As if it had been done before they changed theirs.
  EditingDocument old(old_base);
  old.change(old.editsTo(old_mine));
  old.rebase(mine());
  // Its keys become ours: its base is what is here.
  std::map<FeatureKey, FeatureKey> ours{{kCollectionKey, kCollectionKey}};
  const std::vector<FeatureKey> here = keysOfMine();
  for (std::size_t i = 0; i < here.size(); ++i) ours[old.base_keys_[i]] = here[i];
  for (FeatureKey key = 0; key < old.size(); ++key) {
    if (old.now_[key] && !ours.contains(key)) ours[key] = newKey();
  }
  std::vector<FeatureEdit> taken;
  for (const auto& [of_old, key] : ours) taken.push_back({key, find(key), old.find(of_old)});
  change(std::move(taken));
  for (const auto& [of_old, part] : old.met_) {
    const auto key = ours.find(of_old);
    if (key == ours.end()) continue;
    met_.emplace(key->second, part);
    before_conflict_.emplace(key->second, old.before_conflict_.at(of_old));
  }
}

}  // namespace mapwright::overlays
