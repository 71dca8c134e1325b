// Editing the overlays of the map on screen: reading them, the tool, the dock, the review, saving, and what
// others change meanwhile.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include <QPointer>

#include "edit/overlays/overlay_editing.h"
#include "edit/overlays/overlay_session.h"
#include "jobs/change_overlays.h"
#include "overlays/overlay_check.h"
#include "session/session.h"
#include "ui/overlays/overlay_history.h"
#include "ui/overlays/overlay_marks.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlays_on_map.h"
#include "ui/shell/editor_controller.h"
#include "work/workers.h"

namespace mapwright::ui {

class OverlayActions;
class OverlayCarrying;
class OverlayHistoryDock;
class OverlayReview;
class OverlaySnapping;
class OverlaysDock;
class OverlayTool;

class OverlaysController : public EditorController {
  Q_OBJECT
 public:
  /// `history`: the file that keeps the versions that are seen; empty: none are kept.
  OverlaysController(WindowContext& context, const std::string& history, QObject* parent = nullptr);
  ~OverlaysController() override;

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  bool maySave() const override { return unsaved() && !busy() && !overlays_->isBroken(); }
  /// Looks at what the robot holds, and shows the review.
  void save() override;
  edit::EditSession* edited() const override { return overlays_.get(); }

  edit::OverlayEditing* editing() { return &editing_; }
  OverlayTool* tool() const { return tool_; }
  OverlaysDock* dock() const { return dock_; }
  OverlaySnapping* snapping() const { return snapping_; }
  OverlayActions* actions() const { return actions_; }
  OverlayHistoryDock* historyDock() const { return history_dock_; }
  OverlayCarrying* carrying() const { return carrying_; }
  const OverlayMarks& marks() const { return marks_; }
  /// The way to the flaw that is selected.
  const OverlayMarks& way() const { return way_; }
  const OverlayMarks& states() const { return states_; }
  OverlayReview* review() const;  // null: none is open
  /// Something is on its way to or from the robot that has to end first.
  bool busy() const { return overlays_ && overlays_->saving(); }
  /// The flaws shown are those of the overlays as they are.
  bool checked() const { return !checking_ && !check_again_; }

 Q_SIGNALS:
  /// The overlays were saved to a file: that it changes is no surprise.
  void fileWritten();

 private:
  using Target = edit::OverlaySession::Target;
  DraftWords draftWords() const override;
  QString amountText(qsizetype changes) const override;
  LeaveQuestion leaveQuestion() const override;
  void finishInput() override;
  void discardAll(std::function<void()> then) override;
  void syncMap() override;
  void closeMap() override;
  void addActions();
  /// Whose overlays can be edited now.
  std::optional<Target> target() const;
  const Target* openTarget() const { return overlays_ ? &overlays_->target() : nullptr; }
  void openTargetNow(Target target);
  /// A file with overlays was opened: they are what it is about.
  bool ofFile() const;
  bool wanted() const;
  void read();
  void onSeen(const robot::OverlayText& text, bool sent);
  void onDoubtSettled(bool stored);
  /// Looks for the review, or sends what was reviewed.
  void carryOut(bool send);
  /// The robot tells that its overlays are those that were looked at. Of maps that it is not in it tells
  /// nothing.
  bool isStillHeld() const;
  /// `looked`: what came of a look just now; null: there was none.
  void showReview(const jobs::OverlayOutcome* looked);
  void onOutcome(const jobs::OverlayOutcome& outcome, bool sent);
  void onFailed(const map::Failure& failure);
  void readIfChanged();
  /// Somebody else did the same, or what was sent and never answered turns out to be there.
  void reportHeld();
  void onLink();
  void notSaved(const QString& sentence);
  QString decideText() const;
  void askToDecide();
  /// The review that is open shows what would be sent now, or is closed.
  void reviewAnew();
  void onChange();
  void check();
  /// The whole map that the overlays lie on, read to its end; null: there is none yet.
  const session::MapSlot* mapToCheck() const;
  /// Why what lies on the map is not checked; empty: it is.
  QString notChecked() const;
  void readMapToCheck();
  overlays::CheckOptions checkOptions() const;
  void showWay(FeatureKey key);
  void refresh();
  QString unavailableReason() const;
  QString unreadableText() const;
  void locate(FeatureKey key);
  QString mapName() const;
  void addHistory();
  history::MapName openMap() const;
  void restoreVersion(const overlays::OverlayDocument& version, const QString& called);
  void saveVersion(const QString& suggested, const std::string& text);

  edit::OverlayEditing editing_;
  OverlaysOnMap* on_map_;
  OverlaySnapping* snapping_;
  OverlayTool* tool_;
  OverlaysDock* dock_;
  OverlayActions* actions_;
  OverlayCarrying* carrying_;
  OverlayHistory history_;
  OverlayMarks marks_, way_, states_;
  OverlayHistoryDock* history_dock_;
  QAction* tool_action_ = nullptr;
  std::unique_ptr<edit::OverlaySession> overlays_;  // of the map that can be edited; null: none can
  bool online_ = false;
  QString trouble_;     // of saving
  quint64 opened_ = 0;  // counts maps: results about earlier ones are ignored
  QPointer<OverlayReview> review_;
  bool checking_ = false, check_again_ = false;
  std::shared_ptr<const grids::GridPyramid> checked_cells_;  // of the map that was checked last
  quint64 way_requests_ = 0;                                 // counts those that were asked for
  work::Tasks share_;                                        // last
};

}  // namespace mapwright::ui
