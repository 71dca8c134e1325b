// The waypoints of one map, opened to be edited: read from where they are kept, merged when they change
// there, kept as a draft while they are not saved, and saved. GUI-thread object.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QStringList>

#include "edit/draft_keeper.h"
#include "edit/submission.h"
#include "edit/waypoint_fields.h"
#include "robot/waypoint_store.h"
#include "work/workers.h"

namespace mapwright::edit {

using WaypointSubmission = Submission<robot::StoredWaypoints, robot::WaypointRequest, robot::WaypointReceipt>;
using WaypointDraft = Draft<map::Waypoint>;

/// A request that saving would send, as the store takes it and as people read it.
struct PlannedRequest {
  robot::WaypointRequest request;
  robot::WaypointCall call;
};

struct EditOptions {
  QString drafts_folder = {};  // empty = no drafts are kept
  Later later = byTheClock();
  std::function<QDateTime()> now = [] { return QDateTime::currentDateTime(); };
  std::shared_ptr<work::Workers> workers = {};  // null = a crew of its own
};

class OpenWaypoints : public QObject {
  Q_OBJECT
 public:
  enum class Phase { Reading, Ready, Failed };

  /// Reads at once. `store` must outlive this, or robotGone() be called before it goes.
  OpenWaypoints(robot::WaypointStore& store, map::MapKey map, const QString& address, EditOptions options,
                QObject* parent = nullptr);
  /// What is not saved stays as a draft.
  ~OpenWaypoints() override;

  const map::MapKey& map() const { return map_; }
  Phase phase() const { return phase_; }
  /// Why they could not be read the last time; nullopt when they could.
  const std::optional<map::Failure>& failure() const { return failure_; }
  const std::vector<Fault>& notes() const { return notes_; }  // what is odd about them
  /// Those that are kept with a quaternion of zero; one that has been turned here since has another yaw.
  std::set<Key> zeroTurns() const;
  const robot::KeptFields& keeps() const { return keeps_; }
  WaypointDocument& document() { return document_; }
  const WaypointDocument& document() const { return document_; }
  bool unsaved() const { return !document_.unsaved().empty(); }
  /// Those of what is not saved that are not sent, for they would be refused: another one has their name.
  std::set<Key> refused() const;

  void read();
  /// Sends what is not saved and would not be refused. Ends in saved() when that was all, or in
  /// submission().phase() Undecided or Stopped; then it is gone on with by save() again.
  void save(AtFailure at_failure = AtFailure::Stop);
  /// What save() would send of what was read last, in that order. Asks nobody.
  std::vector<PlannedRequest> planned() const;
  /// As people read it; empty without a robot.
  robot::WaypointCall callOf(const robot::WaypointRequest& request) const;
  /// Sends these calls and no others, and looks at the end what has become of them, however it ends. When
  /// they would not be the right ones any more (somebody else was there) nothing is sent: Undecided, without
  /// a conflict; planned() says what it takes now.
  void send(const std::vector<PlannedRequest>& reviewed, AtFailure at_failure);
  /// What became of all that has been sent has been read since.
  bool looked() const { return looked_; }
  bool saving() const { return submission_.running(); }
  /// Why saving stopped, as long as it stands in the way: a link that was lost does so until the list has
  /// been read again.
  std::optional<map::Failure> stoppedBy() const;
  /// There is something to be saved, it is not under way, and no conflict waits to be decided.
  bool maySave() const { return unsaved() && !saving() && document_.conflicts().empty(); }
  const WaypointSubmission& submission() const { return submission_; }
  void cancelSaving() { submission_.cancel(); }
  /// No answer comes any more; nothing can be saved.
  void robotGone();

  /// Drafts of programs that ended without saving, as they would change the document; the newest first.
  const std::vector<WaypointDraft>& offered() const { return offered_; }
  /// Merges the first one into the document, as one command, and forgets it once it is kept again.
  void takeUp(const QString& text);
  /// It is not wanted.
  void turnDown();
  /// Everything as it is kept where it came from; the draft goes.
  void discard();
  /// The draft of what is there now is on disk when this returns; else why not.
  std::optional<Fault> keepDraft();
  /// Why the draft is not on disk; None = nothing is wrong.
  Fault draftTrouble() const;

 Q_SIGNALS:
  void changed();  // phase, submission, offers; the document tells its own changes
  void saved();
  void draftTroubleChanged();
  /// Something about drafts that people have to know.
  void remarked(const mapwright::Fault& remark);

 private:
  void take(const robot::StoredWaypoints& stored);
  bool areReviewed(const std::vector<robot::WaypointRequest>& requests) const;
  void startSaving();
  WaypointSubmission::Store storeOf();
  WaypointSubmission::Listener listener();
  /// What is to be sent, as the store takes it.
  std::vector<robot::WaypointChange> wireChanges() const;
  std::vector<Change<map::Waypoint>> ownChanges(const std::vector<robot::WaypointChange>& changes) const;
  void lookForDrafts();
  void offer(LeftDrafts left);
  void noteSubmission();
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
  int conflicts_met_ = 0;                                     // in a row, while saving
  bool looked_ = true, read_since_ = false;                   // read_since_: saving stopped
  std::set<std::string> zero_turns_;                          // their ids
  std::string revision_;                                      // of what was read last
  std::optional<std::vector<robot::WaypointCall>> reviewed_;  // nullopt = all that it takes
  WaypointSubmission::Way way_;
  WaypointDocument document_;
  WaypointSubmission submission_;
  std::vector<WaypointDraft> offered_;
  std::vector<LeftDraft> left_;  // the files of `offered_`
  std::unique_ptr<DraftKeeper> keeper_;
  std::vector<LeftDraft> taken_up_;  // to be removed when the keeper has written
  work::Share looking_;              // for drafts
};

}  // namespace mapwright::edit
