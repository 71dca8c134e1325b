// The waypoints of the map on screen, in the window: which list is open, what is drawn, the dock, the tool,
// saving, drafts, and what is asked before a map is left.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QPointer>

#include "window/controller.h"
#include "window/waypoints/waypoint_editing.h"
#include "window/window_context.h"

class QMessageBox;

namespace mapwright::window {

class NameEditor;
class WaypointTool;
class WaypointsDock;

class WaypointsController : public Controller {
  Q_OBJECT
 public:
  explicit WaypointsController(WindowContext& context, QObject* parent = nullptr);
  ~WaypointsController() override;

  void setSession(session::Session* session) override;
  bool unsaved() const override { return list_ && list_->unsaved(); }
  bool maySave() const override { return list_ && list_->maySave(); }
  void save() override;
  void beforeLeaving(std::function<void()> then) override;

  WaypointsDock* dock() const { return dock_; }
  WaypointTool* tool() const { return tool_; }
  WaypointEditing* editing() { return &editing_; }
  edit::OpenWaypoints* list() const { return list_.get(); }
  NameEditor* nameEditor() const { return name_editor_; }
  QMessageBox* question() const;  // null: nothing is asked

 private:
  void addActions();
  void syncMap();
  void openList(const map::MapKey& key);
  void openReadOnly();
  void closeList();
  /// A new one there, and its name asked for.
  void addAt(const Eigen::Vector2d& world_m);
  void drawAll();
  void indexAll();
  void takeChange(const edit::DocumentChange& change);
  void refresh();
  void refreshNotice();
  void revertAll();
  void askName(const edit::Key& key, edit::Gesture gesture);
  void noteSaving();
  void answer(int button);
  QString mapName() const;

  WindowContext& context_;
  QPointer<session::Session> session_;
  WaypointEditing editing_;
  std::unique_ptr<edit::WaypointDocument> shown_only_;  // of a robot whose waypoints can only be read
  std::unique_ptr<edit::OpenWaypoints> list_;
  std::optional<map::MapKey> open_map_;
  PointIndex places_;
  WaypointsDock* dock_;
  WaypointTool* tool_;
  NameEditor* name_editor_;
  QAction *tool_action_ = nullptr, *revert_action_ = nullptr;
  QPointer<QMessageBox> question_;
  std::function<void()> when_left_, when_saved_;
  std::optional<map::Failure> told_failure_;  // that of the last save
  bool was_unsaved_ = false, could_save_ = false, said_decide_ = false;
  bool may_leave_ = false;  // the draft is to be kept as it is
};

}  // namespace mapwright::window
