// The waypoints of one map, opened for editing: read from the store, merged when they change there, saved as
// a draft while unsaved, and saved. GUI-thread object.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QPointer>

#include "edit/document.h"
#include "edit/edit_session.h"
#include "edit/submission.h"
#include "robot/waypoint_store.h"
#include "work/workers.h"

namespace mapwright::edit {

/// A request that saving would send, for the store and as text.
struct PlannedRequest {
  robot::WaypointRequest request;
  robot::WaypointCall call;
};

class OpenWaypoints : public EditSession {
  Q_OBJECT
 public:
  /// Starts reading at once. `store` must outlive this object, unless robotGone() is called first.
  OpenWaypoints(robot::WaypointStore& store, map::MapKey map, const QString& address,
                const EditOptions& options, QObject* parent = nullptr);
  /// Unsaved changes stay as a draft.
  ~OpenWaypoints() override;

  const map::MapKey& map() const { return map_; }
  const std::vector<Fault>& notes() const { return notes_; }  // warnings about them
  /// Those stored with a zero quaternion, unless they have been turned here since.
  std::set<Key> zeroTurns() const;
  const robot::KeptFields& keeps() const { return keeps_; }
  WaypointDocument& document() { return document_; }
  const WaypointDocument& document() const { return document_; }
  bool unsaved() const override { return !document_.unsaved().empty(); }
  /// Unsaved waypoints that are not sent because the robot would refuse them: another one has their name.
  std::set<Key> refused() const;

  void read();
  /// Sends all unsaved changes that would not be refused. Emits saved() if that was all; otherwise
  /// submission().phase() is Undecided or Stopped, and save() continues.
  void save(AtFailure at_failure = AtFailure::Stop);
  /// What save() would send, based on the last read, in that order. Sends nothing.
  std::vector<PlannedRequest> planned() const;
  /// As text; empty without a robot.
  robot::WaypointCall callOf(const robot::WaypointRequest& request) const;
  /// Sends exactly these requests, and checks the result afterwards in any case. If they no longer fit
  /// because someone else changed something, nothing is sent: Undecided, without a conflict; planned() then
  /// gives the new requests.
  void send(const std::vector<PlannedRequest>& reviewed, AtFailure at_failure);
  /// The result of everything sent has been read since.
  bool looked() const { return looked_; }
  bool saving() const override { return submission_.running(); }
  bool inConflict() const override { return !document_.conflicts().empty(); }
  bool inDoubt() const override { return !looked_ && !saving(); }
  /// Why saving stopped, while it prevents further saving: after a lost connection that lasts until the list
  /// has been read again.
  std::optional<map::Failure> stoppedBy() const;
  /// There are unsaved changes, no save in progress, and no open conflict.
  bool maySave() const { return unsaved() && !saving() && !inConflict(); }
  const WaypointSubmission& submission() const { return submission_; }
  void cancelSaving() { submission_.cancel(); }
  /// The robot is gone: no more answers, and nothing can be saved.
  void robotGone();

  void restoreDraft(const QString& text) override;
  /// Reverts everything to the stored state and removes the draft.
  void discard();

 private:
  void onStored(const robot::StoredWaypoints& stored);
  void onNamed(const QString& ours, const QString& theirs);
  bool areReviewed(const std::vector<robot::WaypointRequest>& requests) const;
  void startSaving();
  WaypointSubmission::Listener listener();
  /// What to send, in the form that the store takes.
  std::vector<robot::WaypointChange> wireChanges() const;
  std::vector<Change> ownChanges(const std::vector<robot::WaypointChange>& changes) const;
  void openDrafts(const QString& address, const EditOptions& options);
  void onSubmissionChanged();

  QPointer<robot::WaypointStore> store_;
  map::MapKey map_;
  robot::KeptFields keeps_;
  std::vector<Fault> notes_;
  bool has_read_ = false, reading_ = false, read_again_ = false;
  bool read_overtaken_ = false;  // saving has begun since: what comes may be older than what is saved
  int conflicts_met_ = 0;        // in a row, while saving
  bool looked_ = true, read_since_ = false;                   // read_since_: read again since saving stopped
  std::set<std::string> zero_turns_;                          // their ids
  std::string revision_;                                      // of what was read last
  std::optional<std::vector<robot::WaypointCall>> reviewed_;  // nullopt = everything that is needed
  WaypointSubmission::Options options_;
  WaypointDocument document_;
  WaypointSubmission submission_;
};

}  // namespace mapwright::edit
