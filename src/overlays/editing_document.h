// Overlays that are edited: what the robot holds, what is made of it here, the steps from there to here, and
// what others changed meanwhile. Values, without a clock or a robot.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "overlays/overlay_document.h"
#include "overlays/overlay_merge.h"

namespace mapwright::overlays {

/// Names a feature as long as its document is open, in whatever way it changes.
using FeatureKey = std::size_t;

/// Names the members of the collection besides its features, as one text: its properties are edited, merged
/// and decided like those of a feature.
inline constexpr FeatureKey kCollectionKey = FeatureKey(-1);

/// A feature before and after a step; nullopt: it is not there.
struct FeatureEdit {
  FeatureKey key = 0;
  std::optional<Feature> before, after;
};

class EditingDocument {
 public:
  enum class State { Same, New, Changed, Deleted };

  EditingDocument();
  explicit EditingDocument(OverlayDocument base);

  /// What the robot holds, as far as known.
  const OverlayDocument& base() const { return base_; }
  /// As edited: whatever was not edited is as the robot wrote it, but for the box (`bbox`) of all features:
  /// if it was right, it is so again.
  OverlayDocument mine() const;
  /// Of the features of mine(), in their order.
  std::vector<FeatureKey> keysOfMine() const;

  /// All keys are below it.
  std::size_t size() const { return now_.size(); }
  /// nullopt: it is deleted, or there is none. The collection is always there.
  const std::optional<Feature>& find(FeatureKey key) const;
  const std::optional<Feature>& findBase(FeatureKey key) const;
  /// Another notation is no change.
  State state(FeatureKey key) const;
  bool isUnsaved(FeatureKey key) const { return state(key) != State::Same; }
  bool unsaved() const;
  std::size_t unsavedCount() const;

  /// A key for a feature that does not exist yet.
  FeatureKey newKey();
  /// Makes a step of these; those without effect are dropped. False: nothing was left. What was undone can
  /// not be redone any more. `joins`: it goes on with the step before it.
  bool change(std::vector<FeatureEdit> edits, bool joins = false);
  /// The edits that make `version` of it. What is the same keeps its bytes; what is only deleted here, and
  /// has the same id, is that feature again.
  std::vector<FeatureEdit> editsTo(const OverlayDocument& version);
  /// `changes`: those from mine() to it, where they are known.
  std::vector<FeatureEdit> editsTo(const OverlayDocument& version, const std::vector<OverlayChange>& changes);
  bool undo();
  bool redo();
  std::size_t stepsDone() const { return done_; }
  std::size_t steps() const { return steps_.size(); }
  /// The keys that a step changes.
  std::set<FeatureKey> keysOf(std::size_t step) const;

  /// The robot holds something else now: it comes below all that was done here, undone steps included. What
  /// both changed differently becomes a conflict.
  void rebase(const OverlayDocument& theirs);
  /// The robot holds what is here now.
  void markSaved();

  /// Features that others changed since the document was opened or saved.
  const std::set<FeatureKey>& changedThere() const { return changed_there_; }

  /// Part Whole: one of both deleted it.
  using Conflict = std::pair<FeatureKey, Part>;
  /// Those that are open: mine and theirs still differ. Mine is here, theirs in the base.
  std::vector<Conflict> conflicts() const;
  bool inConflict(FeatureKey key) const;
  /// What the feature was before they changed it; nullopt: it was not there.
  const std::optional<Feature>& beforeConflict(FeatureKey key) const;
  std::optional<std::string> mineOf(const Conflict& conflict) const;
  std::optional<std::string> theirsOf(const Conflict& conflict) const;
  /// Mine stays, and replaces theirs when it is saved.
  void keepMine(const Conflict& conflict) { met_.erase(conflict); }
  /// Theirs is taken, which is a step that can be undone.
  void useTheirs(const Conflict& conflict);

  /// What mine() has to be taken up on (restoreDraft()) so that nothing is lost of either: the base, with
  /// what was there before they changed what is in conflict.
  OverlayDocument draftBase() const;
  /// Changes that were made to an older state of the robot's: one step. What fits no more becomes a conflict.
  void restoreDraft(const OverlayDocument& old_base, const OverlayDocument& old_mine);

 private:
  bool boxIsTheirs() const;
  void apply(const std::vector<FeatureEdit>& edits, bool forward);
  Version& nowOf(FeatureKey key) { return key == kCollectionKey ? collection_now_ : now_[key]; }
  void resize(std::size_t size);

  OverlayDocument base_;
  std::vector<FeatureKey> base_keys_;         // of its features
  std::vector<Version> base_of_, now_;        // by key
  Version collection_base_, collection_now_;  // never nullopt
  std::vector<std::vector<FeatureEdit>> steps_;
  std::size_t done_ = 0;
  struct Compared {
    Feature was, now;
    bool same = false;
  };
  mutable std::unordered_map<FeatureKey, Compared>
      compared_;  // of those that were edited, as long as they are these
  std::set<FeatureKey> changed_there_;
  std::set<Conflict> met_;
  std::map<FeatureKey, Version> before_conflict_;  // the base, before they changed it
};

}  // namespace mapwright::overlays
