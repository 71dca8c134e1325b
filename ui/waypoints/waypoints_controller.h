// The waypoints of the map on screen, in the window: which list is open, what is drawn, the dock, the tool
// and saving.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>

#include <QPointer>

#include "edit/open_waypoints.h"
#include "ui/shell/editor_controller.h"
#include "ui/waypoints/waypoint_editing.h"

class QMenu;

namespace mapwright::ui {

class NameEditor;
class WaypointCarrying;
class WaypointPlacing;
class WaypointReview;
class WaypointTool;
class WaypointTransfer;
class WaypointsDock;
class WaypointsOnMap;
struct LeftName;

class WaypointsController : public EditorController {
  Q_OBJECT
 public:
  explicit WaypointsController(WindowContext& context, QObject* parent = nullptr);
  ~WaypointsController() override;

  void setSession(session::Session* session) override;
  void recall(const QSettings& settings) override;
  void remember(QSettings& settings) override;
  /// Also during a conflict: then saving says what has to be decided.
  bool maySave() const override { return unsaved() && !list_->saving(); }
  void save() override;
  edit::EditSession* edited() const override { return list_.get(); }

  WaypointsDock* dock() const { return dock_; }
  WaypointTool* tool() const { return tool_; }
  WaypointEditing* editing() { return &editing_; }
  WaypointPlacing* placing() const { return placing_; }
  edit::OpenWaypoints* list() const { return list_.get(); }
  WaypointTransfer* transfer() const { return transfer_; }
  WaypointReview* review() const { return review_; }
  WaypointCarrying* carrying() const { return carrying_; }
  NameEditor* nameEditor() const { return name_editor_; }
  QMessageBox* discardQuestion() const { return discard_question_; }  // null: nothing is asked

 private:
  LeaveQuestion leaveQuestion() const override;
  void finishInput() override;
  void discardAll(std::function<void()> then) override;
  DraftWords draftWords() const override;
  QString amountText(qsizetype changes) const override;
  void syncMap() override;
  void closeMap() override;
  void addActions();
  void openList(const map::MapKey& key);
  void openReadOnly();
  bool comesFirst() const;  // waypoints are the main subject of what is open
  /// Adds one there, and asks for its name.
  void addAt(const Eigen::Vector2d& world_m);
  void onChange();
  void refresh();
  void refreshNotice();
  void acceptOffer();
  std::optional<LeftName> nameLeft() const;
  void askToDecide();
  QString decideText() const;  // empty: there is nothing to decide
  void revertAll();
  void askName(const edit::Key& key, edit::Gesture gesture);
  void addToMenu(QMenu& menu, const Eigen::Vector2d& world_m);
  void followNamed();  // it has moved, on the screen or on the map
  void onSavingChanged();
  void onLink();
  QString mapName() const;

  WaypointEditing editing_;
  std::unique_ptr<edit::WaypointDocument> shown_only_;  // of a robot whose waypoints can only be read
  std::unique_ptr<edit::OpenWaypoints> list_;
  std::optional<map::MapKey> open_map_;
  QPointer<QMessageBox> discard_question_;
  WaypointPlacing* placing_;
  WaypointsOnMap* on_map_;
  WaypointsDock* dock_;
  WaypointTool* tool_;
  NameEditor* name_editor_;
  edit::Key named_;  // by the line on the map
  WaypointTransfer* transfer_;
  WaypointReview* review_;
  WaypointCarrying* carrying_ = nullptr;
  QAction *tool_action_ = nullptr, *revert_action_ = nullptr;
  std::optional<map::Failure> reported_failure_;  // that of the last save
  bool said_decide_ = false;
  std::set<edit::Key> accepted_names_;  // that look temporary and may stay
};

}  // namespace mapwright::ui
