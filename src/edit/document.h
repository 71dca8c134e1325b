// A document: items that can be changed, undone, compared with the stored ones, and merged with changes that
// others make there. GUI thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include <QString>
#include <QUndoStack>

#include "edit/document_events.h"
#include "edit/merge.h"

namespace mapwright::edit {

/// An item before and after a change; nullopt = it does not exist.
template <typename Item>
struct Change {
  Key key;
  std::optional<Item> before = {}, after = {};
};

/// How an item relates to the stored one. Several flags may be set.
struct ItemState {
  bool unsaved = false;            // mine differs from theirs
  bool sent = false;               // sent, but not confirmed yet
  bool changed_elsewhere = false;  // theirs has changed, too, and conflicts with mine
  bool operator==(const ItemState&) const = default;
};

/// Changes with the same gesture number (one drag) become one command; 0 = separate.
using Gesture = std::uint64_t;

template <typename Item>
class Document : public DocumentEvents {
 public:
  explicit Document(QObject* parent = nullptr) : DocumentEvents(parent) {}

  /// Turns an item into one that can be stored; applied to every change made here.
  void setFit(std::function<void(Item&)> fit) { fit_ = std::move(fit); }

  /// Starts over with the stored items; nothing can be undone.
  void reset(Items<Item> stored) {
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

  const Items<Item>& items() const { return items_; }
  const Item* find(const Key& key) const {
    const auto found = items_.find(key);
    return found == items_.end() ? nullptr : &found->second;
  }
  /// As stored, as far as known; null = it does not exist there.
  const Item* findKept(const Key& key) const {
    const auto found = base_.find(key);
    return found == base_.end() ? nullptr : &found->second;
  }
  QUndoStack& undoStack() { return stack_; }

  /// Makes the changes as one command. Those without effect are dropped, and so is a command that ends where
  /// it began.
  void change(std::vector<Change<Item>> changes, const QString& text, Gesture gesture = 0) {
    for (Change<Item>& one : changes) {
      if (fit_ && one.after) fit_(*one.after);
    }
    std::erase_if(changes, [](const auto& one) { return same(one.before, one.after); });
    if (!changes.empty()) stack_.push(new Command(*this, std::move(changes), text, gesture));
  }
  /// The change of one item to `after`.
  Change<Item> to(const Key& key, std::optional<Item> after) const {
    return {key, mine(key), std::move(after)};
  }

  ItemState state(const Key& key) const {
    return {unsaved_.contains(key), sent_.contains(key), conflicts_.contains(key)};
  }
  /// Keys of all items that differ from the stored ones, including those that I deleted.
  const std::set<Key>& unsaved() const { return unsaved_; }
  std::size_t sent() const { return sent_.size(); }
  const std::map<Key, Conflict<Item>>& conflicts() const { return conflicts_; }
  /// The changes that make the stored items equal to these, in the order they were made here; without
  /// conflicts.
  std::vector<Change<Item>> changes() const {
    std::vector<Change<Item>> changes = allChanges();
    std::erase_if(changes, [this](const auto& one) { return conflicts_.contains(one.key); });
    return changes;
  }
  /// The same including conflicts: all that would be lost.
  std::vector<Change<Item>> allChanges() const {
    std::vector<std::pair<std::uint64_t, Key>> order;
    for (const Key& key : unsaved_) order.emplace_back(since_.at(key), key);
    std::sort(order.begin(), order.end());
    std::vector<Change<Item>> changes;
    for (auto& [since, key] : order) changes.push_back({key, valueOf(base_, key), mine(key)});
    return changes;
  }

  /// The stored items as of now. Merges them with mine; what cannot be merged becomes a conflict.
  void take(const Items<Item>& stored) {
    const Items<Item> theirs = underOurKeys(stored);
    DocumentChange told;
    std::set<Key> keys;
    for (const Items<Item>& all : {std::cref(base_), std::cref(items_), std::cref(theirs)}) {
      for (const auto& [key, item] : all) keys.insert(key);
    }
    const std::map<Key, Conflict<Item>> conflicts_before = std::exchange(conflicts_, {});
    for (const Key& key : keys) {
      const std::optional<Item> of_them = valueOf(theirs, key);
      // What I sent equals what has arrived since: it is confirmed.
      if (const auto sent = sent_.find(key); sent != sent_.end() && same(sent->second, of_them))
        put(base_, key, of_them);
      Merged<Item> merged = merge(valueOf(base_, key), mine(key), of_them);
      if (merged.conflict) {
        conflicts_.emplace(key, std::move(*merged.conflict));
        if (!conflicts_before.contains(key)) told.changed.push_back(key);
        continue;  // theirs is not applied before the conflict is decided
      }
      put(base_, key, of_them);
      note(told, key, set(key, std::move(merged.item)));
    }
    for (const auto& [key, conflict] : conflicts_before) {
      if (!conflicts_.contains(key)) told.changed.push_back(key);
    }
    for (const auto& [key, sent] : std::exchange(sent_, {})) told.changed.push_back(key);
    tell(std::move(told));
  }

  /// The stored list disappeared as a whole; nobody removed single items. Everything here is unsaved now.
  void takeGone() {
    base_.clear();
    conflicts_.clear();
    sent_.clear();
    in_doubt_.clear();
    unsaved_.clear();
    DocumentChange told;
    for (const auto& [key, item] : items_) {
      noteUnsaved(key);
      told.changed.push_back(key);
    }
    tell(std::move(told));
  }

  /// Ends a conflict. Taking theirs can be undone; then mine is back, unsaved.
  void decide(const Key& key, Side side, const QString& text) {
    const auto found = conflicts_.find(key);
    if (found == conflicts_.end()) return;
    const Conflict<Item> conflict = std::move(found->second);
    conflicts_.erase(found);
    put(base_, key, conflict.theirs);
    refreshState(key);
    change({to(key, decided(conflict, side))}, text);
    tell({{}, {key}, {}});
  }

  /// These have been sent.
  void markSent(const std::vector<Change<Item>>& changes) {
    DocumentChange told;
    for (const Change<Item>& one : changes) {
      sent_[one.key] = one.after;
      told.changed.push_back(one.key);
    }
    tell(std::move(told));
  }
  /// These are stored now.
  void confirm(const std::vector<Change<Item>>& changes) {
    DocumentChange told;
    for (const Change<Item>& one : changes) {
      put(base_, one.key, one.after);
      sent_.erase(one.key);
      refreshState(one.key);
      told.changed.push_back(one.key);
    }
    tell(std::move(told));
  }
  /// They are no longer in progress; whether they took effect is unknown.
  void endSending() {
    DocumentChange told;
    for (const auto& [key, item] : sent_) told.changed.push_back(key);
    in_doubt_.merge(std::exchange(sent_, {}));
    tell(std::move(told));
  }
  /// In the store, the item of `key` is called `id`.
  void nameTheirs(const Key& key, const Key& id) {
    if (key == id) return;
    their_ids_[id] = key;
    our_ids_[key] = id;
  }
  /// It was sent, but it is not known yet whether it took effect.
  bool inDoubt(const Key& key) const { return in_doubt_.contains(key); }
  /// Its name in the store, and the reverse.
  Key theirName(const Key& key) const {
    const auto known = our_ids_.find(key);
    return known == our_ids_.end() ? key : known->second;
  }
  Key ourName(const Key& id) const {
    const auto known = their_ids_.find(id);
    return known == their_ids_.end() ? id : known->second;
  }

  /// The stored items, as far as known.
  Items<Item> kept() const {
    Items<Item> kept = base_;
    for (const auto& [key, conflict] : conflicts_) put(kept, key, conflict.theirs);
    return kept;
  }
  /// Applies changes that were based on an older state, as one command. What conflicts with the stored items
  /// becomes a conflict; what has been changed here since stays as it is.
  void rebase(const std::vector<Change<Item>>& older, const QString& text) {
    std::vector<Change<Item>> here;
    for (Change<Item> change : older) {
      if (fit_ && change.after) fit_(*change.after);
      const std::optional<Item> now = mine(change.key);
      Merged<Item> merged = merge(change.before, change.after, now);
      if (merged.conflict && unsaved_.contains(change.key)) {
        merged.item = decided(*merged.conflict, Side::Theirs);
      } else if (merged.conflict) {
        put(base_, change.key, change.before);
        conflicts_.insert_or_assign(change.key, *merged.conflict);
      }
      here.push_back({change.key, now, std::move(merged.item)});
    }
    this->change(std::move(here), text);
  }

 private:
  class Command : public QUndoCommand {
   public:
    Command(Document& document, std::vector<Change<Item>> changes, const QString& text, Gesture gesture)
        : QUndoCommand(text), document_(document), changes_(std::move(changes)), gesture_(gesture) {}
    void redo() override { document_.exchange(changes_, true); }
    void undo() override { document_.exchange(changes_, false); }
    int id() const override { return gesture_ == 0 ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override {
      const auto& next = static_cast<const Command&>(*other);
      if (next.gesture_ != gesture_) return false;
      std::unordered_map<Key, std::size_t> at;
      for (std::size_t i = 0; i < changes_.size(); ++i) at.emplace(changes_[i].key, i);
      for (const Change<Item>& change : next.changes_) {
        const auto known = at.find(change.key);
        known == at.end() ? changes_.push_back(change) : void(changes_[known->second].after = change.after);
      }
      std::erase_if(changes_, [](const auto& one) { return same(one.before, one.after); });
      setObsolete(changes_.empty());
      return true;
    }

   private:
    Document& document_;
    std::vector<Change<Item>> changes_;
    Gesture gesture_;
  };

  static std::optional<Item> valueOf(const Items<Item>& items, const Key& key) {
    const auto found = items.find(key);
    return found == items.end() ? std::nullopt : std::optional(found->second);
  }
  static void put(Items<Item>& items, const Key& key, const std::optional<Item>& item) {
    item ? void(items.insert_or_assign(key, *item)) : void(items.erase(key));
  }
  std::optional<Item> mine(const Key& key) const { return valueOf(items_, key); }

  enum class Became { Nothing, Added, Changed, Removed };
  Became set(const Key& key, std::optional<Item> item) {
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
    if (was_there && is_there)
      return same_value && was_unsaved == unsaved_.contains(key) ? Became::Nothing : Became::Changed;
    return is_there ? Became::Added : was_there ? Became::Removed : Became::Nothing;
  }
  static void note(DocumentChange& told, const Key& key, Became became) {
    if (became == Became::Added) told.added.push_back(key);
    if (became == Became::Changed) told.changed.push_back(key);
    if (became == Became::Removed) told.removed.push_back(key);
  }
  void refreshState(const Key& key) {
    const Item *const kept = findKept(key), *const here = find(key);
    const bool alike = !kept == !here && (!kept || difference(*kept, *here) == 0);
    if (!alike) return noteUnsaved(key);
    unsaved_.erase(key);
    since_.erase(key);
  }
  void noteUnsaved(const Key& key) {
    unsaved_.insert(key);
    if (since_.try_emplace(key, last_change_ + 1).second) ++last_change_;
  }
  void tell(DocumentChange told) { Q_EMIT changed(told); }

  /// Only the fields that the command changed are swapped: changes that came from elsewhere since stay.
  void exchange(const std::vector<Change<Item>>& changes, bool forth) {
    DocumentChange told;
    told.fields = 0;
    for (const Change<Item>& change : changes) {
      const std::optional<Item>&from = forth ? change.before : change.after,
            &into = forth ? change.after : change.before;
      std::optional<Item> now = mine(change.key);
      if (from && into) {
        if (!now) continue;  // it no longer exists: there is nothing to revert
        const FieldMask fields = difference(*from, *into);
        told.fields |= fields;
        assign(*now, *into, fields);
      } else {
        now = into;
      }
      note(told, change.key, set(change.key, std::move(now)));
      // The user may have made it equal to theirs.
      if (const auto conflict = conflicts_.find(change.key); conflict != conflicts_.end()) {
        Merged<Item> merged = merge(conflict->second.base, mine(change.key), conflict->second.theirs);
        if (merged.conflict) {
          conflict->second = std::move(*merged.conflict);
        } else {
          put(base_, change.key, conflict->second.theirs);
          conflicts_.erase(conflict);
          told.fields = ~FieldMask(0);
          note(told, change.key, set(change.key, std::move(merged.item)));
        }
      }
    }
    tell(std::move(told));
  }

  Items<Item> underOurKeys(const Items<Item>& stored) {
    for (auto& [key, item] : in_doubt_) sent_.try_emplace(key, std::move(item));
    in_doubt_.clear();
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
    if (their_ids_.empty()) return stored;
    Items<Item> ours;
    for (const auto& [id, item] : stored) {
      const auto known = their_ids_.find(id);
      ours.emplace(known == their_ids_.end() ? id : known->second, item);
    }
    return ours;
  }

  Items<Item> base_, items_;
  std::function<void(Item&)> fit_;
  std::set<Key> unsaved_;
  std::unordered_map<Key, std::uint64_t> since_;  // since when each of unsaved_ has been unsaved
  std::uint64_t last_change_ = 0;
  std::map<Key, std::optional<Item>> sent_, in_doubt_;
  std::map<Key, Conflict<Item>> conflicts_;
  // Our names by theirs, if they differ, and the reverse.
  std::unordered_map<Key, Key> their_ids_, our_ids_;
  QUndoStack stack_;
};

}  // namespace mapwright::edit
