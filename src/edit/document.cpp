#include "edit/document.h"

#include <algorithm>
#include <utility>

namespace mapwright::edit {
namespace {

template <typename Map>
auto valueOr(const Map& map, const Key& key, typename Map::mapped_type otherwise) {
  const auto found = map.find(key);
  return found == map.end() ? std::move(otherwise) : found->second;
}
const map::Waypoint* findIn(const Items& items, const Key& key) {
  const auto found = items.find(key);
  return found == items.end() ? nullptr : &found->second;
}
Item valueOf(const Items& items, const Key& key) {
  const map::Waypoint* const found = findIn(items, key);
  return found ? Item(*found) : std::nullopt;
}
void put(Items& items, const Key& key, const Item& item) {
  item ? void(items.insert_or_assign(key, *item)) : void(items.erase(key));
}
void dropUnchanged(std::vector<Change>& changes) {
  std::erase_if(changes, [](const Change& one) { return same(one.before, one.after); });
}

}  // namespace

class WaypointDocument::Command : public QUndoCommand {
 public:
  Command(WaypointDocument& document, std::vector<Change> changes, const QString& text, Gesture gesture)
      : QUndoCommand(text), document_(document), changes_(std::move(changes)), gesture_(gesture) {}
  void redo() override { document_.exchange(changes_, true); }
  void undo() override { document_.exchange(changes_, false); }
  int id() const override { return gesture_ == 0 ? -1 : 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const Command&>(*other);
    if (next.gesture_ != gesture_) return false;
    std::unordered_map<Key, std::size_t> at;
    for (std::size_t i = 0; i < changes_.size(); ++i) at.emplace(changes_[i].key, i);
    for (const Change& change : next.changes_) {
      const auto known = at.find(change.key);
      known == at.end() ? changes_.push_back(change) : void(changes_[known->second].after = change.after);
    }
    dropUnchanged(changes_);
    setObsolete(changes_.empty());
    return true;
  }

 private:
  WaypointDocument& document_;
  std::vector<Change> changes_;
  Gesture gesture_;
};

void WaypointDocument::reset(Items stored) {
  stack_.clear();
  base_ = stored;
  items_ = std::move(stored);
  unsaved_.clear();
  since_.clear();
  sent_.clear();
  conflicts_.clear();
  in_doubt_.clear();
  their_ids_.clear();
  our_ids_.clear();
  Q_EMIT changed({{}, {}, {}, true});
}

const map::Waypoint* WaypointDocument::find(const Key& key) const { return findIn(items_, key); }
const map::Waypoint* WaypointDocument::findKept(const Key& key) const { return findIn(base_, key); }
Item WaypointDocument::mine(const Key& key) const { return valueOf(items_, key); }
Change WaypointDocument::to(const Key& key, Item after) const { return {key, mine(key), std::move(after)}; }
Key WaypointDocument::theirName(const Key& key) const { return valueOr(our_ids_, key, key); }
Key WaypointDocument::ourName(const Key& id) const { return valueOr(their_ids_, id, id); }

void WaypointDocument::nameTheirs(const Key& key, const Key& id) {
  if (key == id) return;
  their_ids_[id] = key;
  our_ids_[key] = id;
}

void WaypointDocument::change(std::vector<Change> changes, const QString& text, Gesture gesture) {
  for (Change& one : changes) {
    if (fit_ && one.after) fit_(*one.after, findKept(one.key));
  }
  dropUnchanged(changes);
  if (!changes.empty()) stack_.push(new Command(*this, std::move(changes), text, gesture));
}

std::vector<Change> WaypointDocument::changes() const {
  std::vector<Change> changes = allChanges();
  std::erase_if(changes, [this](const Change& one) { return conflicts_.contains(one.key); });
  return changes;
}

std::vector<Change> WaypointDocument::allChanges() const {
  std::vector<std::pair<std::uint64_t, Key>> order;
  for (const Key& key : unsaved_) order.emplace_back(since_.at(key), key);
  std::sort(order.begin(), order.end());
  std::vector<Change> changes;
  for (auto& [since, key] : order) changes.push_back({key, valueOf(base_, key), mine(key)});
  return changes;
}

void WaypointDocument::mergeStored(const Items& stored) {
  const Items theirs = underOurKeys(stored);
  DocumentChange told;
  std::set<Key> keys;
  for (const Items& all : {std::cref(base_), std::cref(items_), std::cref(theirs)}) {
    for (const auto& [key, item] : all) keys.insert(key);
  }
  const std::map<Key, Conflict> conflicts_before = std::exchange(conflicts_, {});
  for (const Key& key : keys) {
    const Item of_them = valueOf(theirs, key);
    // What I sent equals what has arrived since: it is confirmed.
    if (const auto sent = sent_.find(key); sent != sent_.end() && same(sent->second, of_them)) {
      put(base_, key, of_them);
      in_doubt_.erase(key);
    }
    Merged merged = merge(valueOf(base_, key), mine(key), of_them);
    if (merged.conflict) {
      conflicts_.emplace(key, std::move(*merged.conflict));
      if (!conflicts_before.contains(key)) told.changed.push_back(key);
      continue;  // theirs is not applied before the conflict is decided
    }
    put(base_, key, of_them);
    set(told, key, std::move(merged.item));
  }
  for (const auto& [key, conflict] : conflicts_before) {
    if (!conflicts_.contains(key)) told.changed.push_back(key);
  }
  for (const auto& [key, sent] : std::exchange(sent_, {})) told.changed.push_back(key);
  Q_EMIT changed(told);
}

void WaypointDocument::onGone() {
  base_.clear();
  conflicts_.clear();
  sent_.clear();
  in_doubt_.clear();
  unsaved_.clear();
  DocumentChange told;
  for (const auto& [key, item] : items_) {
    updateUnsaved(key);
    told.changed.push_back(key);
  }
  Q_EMIT changed(told);
}

void WaypointDocument::decide(const Key& key, Side side, const QString& text) {
  const auto found = conflicts_.find(key);
  if (found == conflicts_.end()) return;
  const Conflict conflict = std::move(found->second);
  conflicts_.erase(found);
  put(base_, key, conflict.theirs);
  refreshState(key);
  change({to(key, decided(conflict, side))}, text);
  Q_EMIT changed({{}, {key}, {}});
}

void WaypointDocument::markSent(const std::vector<Change>& changes) {
  DocumentChange told;
  for (const Change& one : changes) {
    sent_[one.key] = one.after;
    in_doubt_.erase(one.key);
    told.changed.push_back(one.key);
  }
  Q_EMIT changed(told);
}

void WaypointDocument::confirm(const std::vector<Change>& changes) {
  DocumentChange told;
  for (const Change& one : changes) {
    put(base_, one.key, one.after);
    sent_.erase(one.key);
    refreshState(one.key);
    told.changed.push_back(one.key);
  }
  Q_EMIT changed(told);
}

void WaypointDocument::endSending() {
  DocumentChange told;
  for (const auto& [key, item] : sent_) told.changed.push_back(key);
  in_doubt_.merge(std::exchange(sent_, {}));
  Q_EMIT changed(told);
}

Items WaypointDocument::kept() const {
  Items kept = base_;
  for (const auto& [key, conflict] : conflicts_) put(kept, key, conflict.theirs);
  return kept;
}

void WaypointDocument::rebase(const std::vector<Change>& older, const QString& text) {
  std::vector<Change> here;
  for (Change change : older) {
    if (fit_ && change.after) fit_(*change.after, findKept(change.key));
    const Item now = mine(change.key);
    Merged merged = merge(change.before, change.after, now);
    if (merged.conflict && unsaved_.contains(change.key)) {
      merged.item = decided(*merged.conflict, Side::Theirs);
    } else if (merged.conflict) {
      put(base_, change.key, change.before);
      conflicts_.insert_or_assign(change.key, *merged.conflict);
    }
    here.push_back({change.key, now, std::move(merged.item)});
  }
  change(std::move(here), text);
}

void WaypointDocument::set(DocumentChange& told, const Key& key, Item item) {
  // Thousands pass through here at once: avoid copies.
  const auto before = items_.find(key);
  const bool was_there = before != items_.end(), is_there = item.has_value();
  const bool was_unsaved = unsaved_.contains(key);
  const bool same_value = was_there && is_there && difference(before->second, *item) == 0;
  if (is_there) {
    was_there ? void(before->second = std::move(*item)) : void(items_.emplace(key, std::move(*item)));
  } else if (was_there) {
    items_.erase(before);
  }
  refreshState(key);
  if (!was_there && is_there) told.added.push_back(key);
  if (was_there && !is_there) told.removed.push_back(key);
  if (was_there && is_there && !(same_value && was_unsaved == unsaved_.contains(key)))
    told.changed.push_back(key);
}

void WaypointDocument::refreshState(const Key& key) {
  const map::Waypoint *const kept = findKept(key), *const here = find(key);
  const bool alike = !kept == !here && (!kept || difference(*kept, *here) == 0);
  if (!alike) return updateUnsaved(key);
  unsaved_.erase(key);
  since_.erase(key);
}

void WaypointDocument::updateUnsaved(const Key& key) {
  unsaved_.insert(key);
  if (since_.try_emplace(key, last_change_ + 1).second) ++last_change_;
}

/// Only the fields that the command changed are swapped: changes that came from elsewhere since stay.
void WaypointDocument::exchange(const std::vector<Change>& changes, bool forth) {
  DocumentChange told;
  told.fields = 0;
  bool left_out = false;
  for (const Change& change : changes) {
    const Item &from = forth ? change.before : change.after, &into = forth ? change.after : change.before;
    Item now = mine(change.key);
    if (!from && now) continue;  // it is there again, as others have it
    if (!forth && now && !into && !removal_ && findKept(change.key)) {
      left_out = true;
      continue;
    }
    if (from && into) {
      if (!now) continue;  // it no longer exists: there is nothing to revert
      const FieldMask fields = difference(*from, *into);
      told.fields |= fields;
      assign(*now, *into, fields);
    } else {
      now = into;
    }
    set(told, change.key, std::move(now));
    // The user may have made it equal to theirs.
    if (const auto conflict = conflicts_.find(change.key); conflict != conflicts_.end()) {
      Merged merged = merge(conflict->second.base, mine(change.key), conflict->second.theirs);
      if (merged.conflict) {
        conflict->second = std::move(*merged.conflict);
      } else {
        put(base_, change.key, conflict->second.theirs);
        conflicts_.erase(conflict);
        told.fields = ~FieldMask(0);
        set(told, change.key, std::move(merged.item));
      }
    }
  }
  Q_EMIT changed(told);
  if (left_out) Q_EMIT removalLeftOut();
}

Items WaypointDocument::underOurKeys(const Items& stored) {
  // They stay in doubt until they are seen: a robot that was slow may carry them out after it was read.
  for (const auto& [key, item] : in_doubt_) sent_.try_emplace(key, item);
  // If the answer to a creation was lost, the new item has an unknown name there: recognize it by its
  // content.
  for (const auto& [key, item] : sent_) {
    if (!item || base_.contains(key) || stored.contains(key)) continue;
    for (const auto& [id, theirs] : stored) {
      if (base_.contains(id) || items_.contains(id) || their_ids_.contains(id) ||
          difference(theirs, *item) != 0)
        continue;
      nameTheirs(key, id);
      break;
    }
  }
  Items ours;
  for (const auto& [id, item] : stored) ours.emplace(ourName(id), item);
  return ours;
}

}  // namespace mapwright::edit

#include "moc_document.cpp"
