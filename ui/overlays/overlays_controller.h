// Editing the overlays of the map on screen: reading them, the tool, the dock, the review, saving, and what
// others change meanwhile.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include <QPointer>

#include "jobs/change_overlays.h"
#include "overlays/overlay_check.h"
#include "robot/overlay_store.h"
#include "ui/overlays/overlay_editing.h"
#include "ui/overlays/overlay_history.h"
#include "ui/overlays/overlay_marks.h"
#include "ui/overlays/overlays_on_map.h"
#include "ui/shell/editor_controller.h"
#include "work/workers.h"

namespace mapwright::window {

class OverlayActions;
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
  bool unsaved() const override { return editing_.isOpen() && editing_.document().unsaved(); }
  bool maySave() const override { return unsaved() && !busy_ && !broken(); }
  /// Looks at what the robot holds, and shows the review.
  void save() override;

  OverlayEditing* editing() { return &editing_; }
  OverlayTool* tool() const { return tool_; }
  OverlaysDock* dock() const { return dock_; }
  OverlaySnapping* snapping() const { return snapping_; }
  OverlayActions* actions() const { return actions_; }
  OverlayHistoryDock* historyDock() const { return history_dock_; }
  const OverlayMarks& marks() const { return marks_; }
  /// The way to the flaw that is selected.
  const OverlayMarks& way() const { return way_; }
  const OverlayMarks& states() const { return states_; }
  OverlayReview* review() const;  // null: none is open
  /// Something is on its way to or from the robot that has to end first.
  bool busy() const { return busy_; }
  /// The flaws shown are those of the overlays as they are.
  bool checked() const { return !checking_ && !check_again_; }

 Q_SIGNALS:
  /// The overlays were saved to a file: that it changes is no surprise.
  void fileWritten();

 private:
  /// Whose overlays can be edited now.
  struct Target {
    map::MapKey map;
    bool robots = false;   // the robot is in it
    std::string uid = {};  // of one that is not stored
    bool operator==(const Target&) const = default;
  };
  LeaveQuestion leaveQuestion() const override;
  void finishInput() override;
  void discardAll(std::function<void()> then) override;
  void syncMap() override;
  void closeMap() override;
  void addActions();
  std::optional<Target> target() const;
  /// A file with overlays was opened: they are what it is about.
  bool ofFile() const;
  /// What is held cannot be read: nothing can be merged with it.
  bool broken() const { return failure_ && failure_->kind == map::FailureKind::MalformedAnswer; }
  bool wanted() const;
  void read();
  /// What the robot holds now comes below what is here. `saved`: what was sent from here is in it.
  void mergeHeld(const robot::OverlayText& text, bool saved);
  void rebase(const overlays::OverlayDocument& held);
  /// Looks for the review, or sends what was reviewed.
  void carryOut(bool send);
  /// The robot tells that its overlays are those that were looked at. Of maps that it is not in it tells
  /// nothing.
  bool isStillHeld() const;
  void showReview();
  void onOutcome(const robot::Outcome<jobs::OverlayOutcome>& outcome, bool sent);
  /// Somebody else did the same, or what was sent and never answered turns out to be there.
  void reportHeld();
  void onLink();
  void setBusy(bool busy);
  void notSaved(const QString& sentence);
  QString decideText() const;
  void askToDecide();
  /// The review that is open shows what would be sent now, or is closed.
  void reviewAnew();
  QStringList changesToSave() const;
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
  void watchDrafts();
  void restoreDraft();
  void locate(FeatureKey key);
  QString mapName() const;
  void addHistory();
  history::MapName openMap() const;
  void restoreVersion(const overlays::OverlayDocument& version, const QString& called);
  void saveVersion(const QString& suggested, const std::string& text);

  OverlayEditing editing_;
  OverlaysOnMap* on_map_;
  OverlaySnapping* snapping_;
  OverlayTool* tool_;
  OverlaysDock* dock_;
  OverlayActions* actions_;
  OverlayHistory history_;
  OverlayMarks marks_, way_, states_;
  OverlayHistoryDock* history_dock_;
  QAction* tool_action_ = nullptr;
  std::optional<Target> target_;
  robot::Call call_;
  bool reading_ = false, read_again_ = false, busy_ = false;
  std::optional<map::Failure> failure_;  // of the last reading
  bool doubt_ = false;                   // it is not known whether what was sent was applied
  bool online_ = false;
  robot::OverlayText held_;  // that was read last
  QString trouble_;          // of saving
  quint64 opened_ = 0;       // counts maps: results about earlier ones are ignored
  QPointer<OverlayReview> review_;
  bool checking_ = false, check_again_ = false;
  std::shared_ptr<const grids::GridPyramid> checked_cells_;  // of the map that was checked last
  quint64 ways_ = 0;                                         // counts those that were asked for
  work::Tasks share_;                                        // last
};

}  // namespace mapwright::window
