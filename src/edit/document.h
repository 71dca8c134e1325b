// A document: items that can be changed, undone, compared with where they are kept, and merged with what
// others make of them there. GUI thread.
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

/// One item as it was and as it is to be; nullopt = it is not there.
template <typename Item>
struct Change {
  Key key;
  std::optional<Item> before = {}, after = {};
};

/// How an item stands towards where it is kept. Several may be so at once.
struct ItemState {
  bool unsaved = false;            // mine is another one than theirs
  bool sent = false;               // it has been sent, and nobody has confirmed it yet
  bool changed_elsewhere = false;  // theirs has changed, too, and does not go together with mine
  bool operator==(const ItemState&) const = default;
};

/// Moves of a hand that belong together carry the same gesture and become one command; 0 = alone.
using Gesture = std::uint64_t;

template <typename Item>
class Document : public DocumentEvents {
 public:
  explicit Document(QObject* parent = nullptr) : DocumentEvents(parent) {}

  /// Makes of an item what can be kept; whatever is changed here goes through it.
  void setFit(std::function<void(Item&)> fit) { fit_ = std::move(fit); }

  /// Begins anew with what is kept; nothing can be undone.
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
  /// As it is kept, as far as is known; null = it is not there.
  const Item* findKept(const Key& key) const {
    const auto found = base_.find(key);
    return found == base_.end() ? nullptr : &found->second;
  }
  QUndoStack& undoStack() { return stack_; }

  /// Makes the changes as one command. Those that change nothing are left out; a command that ends where it
  /// began vanishes.
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
  /// Keys of all items that are not as they are kept, those that I deleted among them.
  const std::set<Key>& unsaved() const { return unsaved_; }
  std::size_t sent() const { return sent_.size(); }
  const std::map<Key, Conflict<Item>>& conflicts() const { return conflicts_; }
  /// What is to be done where they are kept so that they are as here, in the order in which it was done here;
  /// without what is in conflict.
  std::vector<Change<Item>> changes() const {
    std::vector<Change<Item>> changes = allChanges();
    std::erase_if(changes, [this](const auto& one) { return conflicts_.contains(one.key); });
    return changes;
  }
  /// The same with what is in conflict: all that would be lost.
  std::vector<Change<Item>> allChanges() const {
    std::vector<std::pair<std::uint64_t, Key>> order;
    for (const Key& key : unsaved_) order.emplace_back(since_.at(key), key);
    std::sort(order.begin(), order.end());
    std::vector<Change<Item>> changes;
    for (auto& [since, key] : order) changes.push_back({key, valueOf(base_, key), mine(key)});
    return changes;
  }

  /// What is kept is this now. Goes together with mine where that is possible; else there are conflicts.
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
      // What I sent and what has arrived since is the same: it is confirmed.
      if (const auto sent = sent_.find(key); sent != sent_.end() && same(sent->second, of_them))
        put(base_, key, of_them);
      Merged<Item> merged = merge(valueOf(base_, key), mine(key), of_them);
      if (merged.conflict) {
        conflicts_.emplace(key, std::move(*merged.conflict));
        if (!conflicts_before.contains(key)) told.changed.push_back(key);
        continue;  // nothing of theirs comes in before it is decided
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

  /// What was kept is gone as a whole: nobody took items out of it. All that is here is unsaved now.
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

  /// Ends a conflict. Taking theirs can be undone; then mine is there again, unsaved.
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

  /// These are on their way to where they are kept.
  void markSent(const std::vector<Change<Item>>& changes) {
    DocumentChange told;
    for (const Change<Item>& one : changes) {
      sent_[one.key] = one.after;
      told.changed.push_back(one.key);
    }
    tell(std::move(told));
  }
  /// These are kept now.
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
  /// They are not under way any more; whether they have arrived is not known.
  void endSending() {
    DocumentChange told;
    for (const auto& [key, item] : sent_) told.changed.push_back(key);
    in_doubt_.merge(std::exchange(sent_, {}));
    tell(std::move(told));
  }
  /// Where they are kept, the item of `key` is called `id`.
  void nameTheirs(const Key& key, const Key& id) {
    if (key == id) return;
    their_ids_[id] = key;
    our_ids_[key] = id;
  }
  /// It was sent, and neither an answer nor a look has told yet whether it has arrived.
  bool inDoubt(const Key& key) const { return in_doubt_.contains(key); }
  /// What it is called there, and the reverse.
  Key theirName(const Key& key) const {
    const auto known = our_ids_.find(key);
    return known == our_ids_.end() ? key : known->second;
  }
  Key ourName(const Key& id) const {
    const auto known = their_ids_.find(id);
    return known == their_ids_.end() ? id : known->second;
  }

  /// What is kept now, as far as is known.
  Items<Item> kept() const {
    Items<Item> kept = base_;
    for (const auto& [key, conflict] : conflicts_) put(kept, key, conflict.theirs);
    return kept;
  }
  /// Changes that were made of an older state are made here, too, as one command. What does not go together
  /// with what is kept now becomes a conflict; what has been changed here meanwhile stays as it is here.
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
    // Thousands at once pass here: nothing is copied that need not be.
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

  /// Of a changed item only the fields that the command changed are exchanged: what came from elsewhere since
  /// stays.
  void exchange(const std::vector<Change<Item>>& changes, bool forth) {
    DocumentChange told;
    told.fields = 0;
    for (const Change<Item>& change : changes) {
      const std::optional<Item>&from = forth ? change.before : change.after,
            &into = forth ? change.after : change.before;
      std::optional<Item> now = mine(change.key);
      if (from && into) {
        if (!now) continue;  // it is gone: there is nothing to change back
        const FieldMask fields = difference(*from, *into);
        told.fields |= fields;
        assign(*now, *into, fields);
      } else {
        now = into;
      }
      note(told, change.key, set(change.key, std::move(now)));
      // By hand it may have been brought together with theirs.
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
    // A created one whose answer was lost has got a name of its own there: it is told by what it is like.
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
  std::unordered_map<Key, std::uint64_t> since_;  // since when each of unsaved_ is
  std::uint64_t last_change_ = 0;
  std::map<Key, std::optional<Item>> sent_, in_doubt_;
  std::map<Key, Conflict<Item>> conflicts_;
  // Ours by theirs, where they differ, and the reverse.
  std::unordered_map<Key, Key> their_ids_, our_ids_;
  QUndoStack stack_;
};

}  // namespace mapwright::edit
