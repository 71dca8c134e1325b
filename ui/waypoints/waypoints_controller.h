// The waypoints of the map on screen, in the window: which list is open, what is drawn, the dock, the tool,
// saving, drafts, and what is asked before a map is left.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include <QMessageBox>
#include <QPointer>

#include "ui/kit/controller.h"
#include "ui/shell/left_map.h"
#include "ui/shell/unsaved_question.h"
#include "ui/shell/window_context.h"
#include "ui/waypoints/waypoint_editing.h"

class QMenu;

namespace mapwright::window {

class NameEditor;
class WaypointPlacing;
class WaypointReview;
class WaypointTool;
class WaypointTransfer;
class WaypointsDock;
class WaypointsOnMap;
struct LeftName;

class WaypointsController : public Controller {
  Q_OBJECT
 public:
  explicit WaypointsController(WindowContext& context, QObject* parent = nullptr);
  ~WaypointsController() override;

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  bool unsaved() const override { return list_ && list_->unsaved(); }
  /// Also during a conflict: then saving says what has to be decided.
  bool maySave() const override { return unsaved() && !list_->saving(); }
  void save() override;
  void beforeLeaving(std::function<void()> then) override;

  WaypointsDock* dock() const { return dock_; }
  WaypointTool* tool() const { return tool_; }
  WaypointEditing* editing() { return &editing_; }
  WaypointPlacing* placing() const { return placing_; }
  edit::OpenWaypoints* list() const { return list_.get(); }
  WaypointTransfer* transfer() const { return transfer_; }
  WaypointReview* review() const { return review_; }
  NameEditor* nameEditor() const { return name_editor_; }
  QMessageBox* question() const { return question_; }  // null: nothing is asked

 private:
  void addActions();
  void syncMap();
  void openList(const map::MapKey& key);
  void openReadOnly();
  void closeList();
  bool comesFirst() const;  // waypoints are the main subject of what is open
  /// Adds one there, and asks for its name.
  void addAt(const Eigen::Vector2d& world_m);
  void takeChange();
  void refresh();
  void refreshNotice();
  void takeOffer();
  std::optional<LeftName> nameLeft() const;
  void askToDecide();
  QString decideText() const;  // empty: there is nothing to decide
  void revertAll();
  void askName(const edit::Key& key, edit::Gesture gesture);
  void addToMenu(QMenu& menu, const Eigen::Vector2d& world_m);
  void followNamed();  // it has moved, on the screen or on the map
  void noteSaving();
  void noteLink();
  void answer(Leaving leaving, const std::function<void()>& then);
  QString mapName() const;
  QString nameOf(const map::MapKey& map) const;

  WindowContext& context_;
  LeftMap left_map_;
  QPointer<session::Session> session_;
  WaypointEditing editing_;
  std::unique_ptr<edit::WaypointDocument> shown_only_;  // of a robot whose waypoints can only be read
  std::unique_ptr<edit::OpenWaypoints> list_;
  std::optional<map::MapKey> open_map_;
  QPointer<QMessageBox> question_;  // before unsaved waypoints are lost or left behind
  WaypointPlacing* placing_;
  WaypointsOnMap* on_map_;
  WaypointsDock* dock_;
  WaypointTool* tool_;
  NameEditor* name_editor_;
  edit::Key named_;  // by the line on the map
  WaypointTransfer* transfer_;
  WaypointReview* review_;
  QAction *tool_action_ = nullptr, *revert_action_ = nullptr;
  std::function<void()> when_saved_;
  std::optional<map::Failure> reported_failure_;  // that of the last save
  bool was_unsaved_ = false, could_save_ = false, said_decide_ = false;
  std::set<edit::Key> accepted_names_;  // that look temporary and may stay
  bool may_leave_ = false;              // the draft is to be kept as it is
  QString asked_;                       // the last request to decide, until it is answered
};

}  // namespace mapwright::window
