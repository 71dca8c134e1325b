// The waypoints of one map, opened for editing: read from the store, merged when they change there, saved as
// a draft while unsaved, and saved. GUI-thread object.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QPointer>

#include "edit/document.h"
#include "edit/drafts.h"
#include "edit/submission.h"
#include "robot/waypoint_store.h"
#include "work/workers.h"

namespace mapwright::edit {

/// A request that saving would send, for the store and as text.
struct PlannedRequest {
  robot::WaypointRequest request;
  robot::WaypointCall call;
};

struct EditOptions {
  QString drafts_folder = {};  // empty = no drafts
  Later later = byTheClock();
  std::function<QDateTime()> now = [] { return QDateTime::currentDateTime(); };
  std::shared_ptr<work::Workers> workers = {};  // null = threads of its own
};

class OpenWaypoints : public QObject {
  Q_OBJECT
 public:
  enum class Phase { Reading, Ready, Failed };

  /// Starts reading at once. `store` must outlive this object, unless robotGone() is called first.
  OpenWaypoints(robot::WaypointStore& store, map::MapKey map, const QString& address, EditOptions options,
                QObject* parent = nullptr);
  /// Unsaved changes stay as a draft.
  ~OpenWaypoints() override;

  const map::MapKey& map() const { return map_; }
  Phase phase() const { return phase_; }
  /// Why the last read failed; nullopt if it succeeded.
  const std::optional<map::Failure>& failure() const { return failure_; }
  const std::vector<Fault>& notes() const { return notes_; }  // warnings about them
  /// Those stored with a zero quaternion, unless they have been turned here since.
  std::set<Key> zeroTurns() const;
  const robot::KeptFields& keeps() const { return keeps_; }
  WaypointDocument& document() { return document_; }
  const WaypointDocument& document() const { return document_; }
  bool unsaved() const { return !document_.unsaved().empty(); }
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
  bool saving() const { return submission_.running(); }
  /// Why saving stopped, while it prevents further saving: after a lost connection that lasts until the list
  /// has been read again.
  std::optional<map::Failure> stoppedBy() const;
  /// There are unsaved changes, no save in progress, and no open conflict.
  bool maySave() const { return unsaved() && !saving() && document_.conflicts().empty(); }
  const WaypointSubmission& submission() const { return submission_; }
  void cancelSaving() { submission_.cancel(); }
  /// The robot is gone: no more answers, and nothing can be saved.
  void robotGone();

  /// Drafts of programs that ended without saving, as changes to the document; newest first.
  const std::vector<WaypointDraft>& offered() const { return offered_; }
  /// Merges the first one into the document as one command, and deletes it once its content is saved again.
  void restoreDraft(const QString& text);
  /// It is not wanted.
  void turnDown();
  /// Reverts everything to the stored state and removes the draft.
  void discard();
  /// Writes the current draft to disk before it returns; otherwise returns why not.
  std::optional<Fault> keepDraft();
  /// Why the draft of what is not saved is not on disk; None = nothing is wrong.
  Fault draftTrouble() const;

 Q_SIGNALS:
  void changed();  // phase, submission, offers; the document tells its own changes
  void saved();
  void draftTroubleChanged();
  /// A message about drafts for the user.
  void remarked(const mapwright::Fault& remark);

 private:
  void take(const robot::StoredWaypoints& stored);
  void onNamed(const QString& ours, const QString& theirs);
  bool areReviewed(const std::vector<robot::WaypointRequest>& requests) const;
  void startSaving();
  WaypointSubmission::Listener listener();
  /// What to send, in the form that the store takes.
  std::vector<robot::WaypointChange> wireChanges() const;
  std::vector<Change> ownChanges(const std::vector<robot::WaypointChange>& changes) const;
  void lookForDrafts();
  void offer(LeftDrafts left);
  void onSubmissionChanged();
  void forgetFirstOffer();

  QPointer<robot::WaypointStore> store_;
  map::MapKey map_;
  robot::KeptFields keeps_;
  EditOptions options_;
  DraftIdentity identity_;
  Phase phase_ = Phase::Reading;
  std::optional<map::Failure> failure_;
  std::vector<Fault> notes_;
  bool has_read_ = false, reading_ = false, read_again_ = false;
  bool read_overtaken_ = false;  // saving has begun since: what comes may be older than what is saved
  int conflicts_met_ = 0;        // in a row, while saving
  bool looked_ = true, read_since_ = false;                   // read_since_: read again since saving stopped
  std::set<std::string> zero_turns_;                          // their ids
  std::string revision_;                                      // of what was read last
  std::optional<std::vector<robot::WaypointCall>> reviewed_;  // nullopt = everything that is needed
  WaypointSubmission::Way way_;
  WaypointDocument document_;
  WaypointSubmission submission_;
  std::vector<WaypointDraft> offered_;
  std::vector<LeftDraft> left_;  // the files of `offered_`
  std::unique_ptr<DraftKeeper> keeper_;
  work::Tasks looking_;  // for drafts
};

}  // namespace mapwright::edit
