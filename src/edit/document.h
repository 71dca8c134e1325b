// A document: waypoints that can be changed, undone, compared with the stored ones, and merged with changes
// that others make there. GUI thread.
#pragma once

#include <functional>
#include <unordered_map>

#include <QObject>
#include <QUndoStack>

#include "edit/merge.h"

namespace mapwright::edit {

/// How an item relates to the stored one. Several flags may be set.
struct ItemState {
  bool unsaved = false;            // mine differs from theirs
  bool sent = false;               // sent, but not confirmed yet
  bool changed_elsewhere = false;  // theirs has changed, too, and conflicts with mine
  bool operator==(const ItemState&) const = default;
};

/// Changes with the same gesture number (one drag) become one command; 0 = separate.
using Gesture = std::uint64_t;

/// Keys of items that were added, that changed or have another state (saved, sent, …), and that were removed.
struct DocumentChange {
  std::vector<Key> added, changed, removed;
  bool everything = false;  // check everything; the lists are empty
  /// Which fields of `changed` may differ. Their state may differ in any case.
  FieldMask fields = ~FieldMask(0);
};

class WaypointDocument : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Turns an item into one that can be stored (the second: as it is stored, null = not at all); applied to
  /// every change made here.
  using Fit = std::function<void(map::Waypoint&, const map::Waypoint*)>;
  void setFit(Fit fit) { fit_ = std::move(fit); }

  /// Of a store that cannot delete: undoing the addition of what is stored by now leaves it there.
  void setRemoval(bool removal) { removal_ = removal; }

  /// Starts over with the stored items; nothing can be undone.
  void reset(Items stored);

  const Items& items() const { return items_; }
  const map::Waypoint* find(const Key& key) const;  // null = there is none
  /// As stored, as far as known; null = it does not exist there.
  const map::Waypoint* findKept(const Key& key) const;
  QUndoStack& undoStack() { return stack_; }

  /// Makes the changes as one command. Those without effect are dropped, and so is a command that ends where
  /// it began.
  void change(std::vector<Change> changes, const QString& text, Gesture gesture = 0);
  /// The change of one item to `after`.
  Change to(const Key& key, Item after) const;

  ItemState state(const Key& key) const {
    return {unsaved_.contains(key), sent_.contains(key), conflicts_.contains(key)};
  }
  /// Keys of all items that differ from the stored ones, including those that I deleted.
  const std::set<Key>& unsaved() const { return unsaved_; }
  std::size_t sent() const { return sent_.size(); }
  const std::map<Key, Conflict>& conflicts() const { return conflicts_; }
  /// The changes that make the stored items equal to these, in the order they were made here; without
  /// conflicts.
  std::vector<Change> changes() const;
  /// The same including conflicts: all that would be lost.
  std::vector<Change> allChanges() const;

  /// The stored items as of now. Merges them with mine; what cannot be merged becomes a conflict.
  void mergeStored(const Items& stored);
  /// The stored list disappeared as a whole; nobody removed single items. Everything here is unsaved now.
  void onGone();
  /// Ends a conflict. Taking theirs can be undone; then mine is back, unsaved.
  void decide(const Key& key, Side side, const QString& text);

  /// These have been sent.
  void markSent(const std::vector<Change>& changes);
  /// These are stored now.
  void confirm(const std::vector<Change>& changes);
  /// They are no longer in progress; whether they took effect is unknown.
  void endSending();
  /// In the store, the item of `key` is called `id`.
  void nameTheirs(const Key& key, const Key& id);
  /// Its name in the store, and the reverse.
  Key theirName(const Key& key) const;
  Key ourName(const Key& id) const;

  /// The stored items, as far as known.
  Items kept() const;
  /// Applies changes that were based on an older state, as one command. What conflicts with the stored items
  /// becomes a conflict; what has been changed here since stays as it is.
  void rebase(const std::vector<Change>& older, const QString& text);

 Q_SIGNALS:
  /// Covers items, their states, and the state of the whole.
  void changed(const mapwright::edit::DocumentChange& change);
  /// An undo would have deleted what the store cannot: it is still there.
  void removalLeftOut();

 private:
  class Command;

  Item mine(const Key& key) const;
  void set(DocumentChange& told, const Key& key, Item item);
  void refreshState(const Key& key);
  void updateUnsaved(const Key& key);
  void exchange(const std::vector<Change>& changes, bool forth);
  Items underOurKeys(const Items& stored);

  Items base_, items_;
  Fit fit_;
  bool removal_ = true;
  std::set<Key> unsaved_;
  std::unordered_map<Key, std::uint64_t> since_;  // since when each of unsaved_ has been unsaved
  std::uint64_t last_change_ = 0;
  std::map<Key, Item> sent_, in_doubt_;
  std::map<Key, Conflict> conflicts_;
  // Our names by theirs, if they differ, and the reverse.
  std::unordered_map<Key, Key> their_ids_, our_ids_;
  QUndoStack stack_;
};

}  // namespace mapwright::edit
