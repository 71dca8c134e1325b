// The overlays of one map that are open for editing: read from the robot or file, merged when they change
// there, saved, and in doubt after a lost answer until they are read again. No widgets. GUI thread.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "edit/edit_session.h"
#include "edit/overlays/overlay_editing.h"
#include "jobs/change_overlays.h"
#include "robot/overlay_store.h"
#include "work/workers.h"

namespace mapwright::edit {

class OverlaySession : public EditSession {
  Q_OBJECT
 public:
  /// Whose overlays these are.
  struct Target {
    map::MapKey map;
    bool robots = false;   // the robot is in it
    std::string uid = {};  // of one that is not stored
    bool operator==(const Target&) const = default;
    bool isSameMap(const Target& other) const { return map == other.map && uid == other.uid; }
  };
  /// Null while the robot cannot be asked; it may come back.
  using StoreNow = std::function<robot::OverlayStore*()>;

  /// Reads nothing yet. `editing`, which is closed, holds the document; it outlives this object.
  OverlaySession(StoreNow store, Target target, const QString& address, OverlayEditing& editing,
                 const EditOptions& options);
  /// Unsaved changes stay as a draft. Closes the document.
  ~OverlaySession() override;

  const Target& target() const { return target_; }
  /// The same map; the robot has entered or left it.
  void setTarget(Target target) { target_ = std::move(target); }

  bool unsaved() const override { return editing_.isOpen() && editing_.document().unsaved(); }
  bool saving() const override { return saving_; }
  bool inConflict() const override { return !editing_.document().conflicts().empty(); }
  bool inDoubt() const override { return doubt_; }
  bool reading() const { return reading_; }
  /// What is held cannot be read: nothing can be merged with it.
  bool isBroken() const { return failure_ && failure_->kind == map::FailureKind::MalformedAnswer; }
  /// Why what is held is no collection of overlays; None: it is one, or nothing was read.
  const Fault& unreadable() const { return unreadable_; }
  /// That was read last.
  const robot::OverlayText& held() const { return held_; }

  void read();
  /// Looks at what is held and merges, for a review; ended() says what came of it.
  void look() { change(false, false); }
  /// Sends it. `still_held`: it is known that held() is what the store has now.
  void send(bool still_held) { change(true, still_held); }
  void restoreDraft(const QString& text) override;

 Q_SIGNALS:
  void opened();
  /// It was read, with what was sent (`sent`) or without.
  void seen(const mapwright::robot::OverlayText& held, bool sent);
  /// What was read is merged with what is here.
  void merged();
  /// Somebody else changed `features` of them.
  void changedThere(qsizetype features);
  /// What was sent with an unknown result was read again.
  void doubtSettled(bool stored);
  /// A look() or send() ended (`sent`).
  void ended(const mapwright::jobs::OverlayOutcome& outcome, bool sent);
  void failed(const mapwright::map::Failure& failure);

 private:
  void change(bool send, bool still_held);
  jobs::OverlayOrder::Elsewhere onAnotherThread();
  /// `read`: what is known of `text` already; null: nothing.
  void merge(const robot::OverlayText& text, bool sent, const jobs::OverlaysHeld* read = nullptr);
  void rebase(const overlays::OverlayDocument& held, const jobs::OverlaysHeld* read);

  StoreNow store_;
  Target target_;
  OverlayEditing& editing_;
  robot::Call call_;
  bool reading_ = false, read_again_ = false, saving_ = false, doubt_ = false;
  quint64 saves_ = 0;  // that have begun
  Fault unreadable_;
  robot::OverlayText held_;
  work::Tasks share_;  // last: waits for running work
};

}  // namespace mapwright::edit
