// The SLAM inspector: what the robot's SLAM holds, submap by submap.
#pragma once

#include <set>

#include <QDockWidget>
#include <QPointer>

#include "scene/map_scene.h"
#include "window/docks/submap_filter_model.h"
#include "window/docks/submap_tree_model.h"

class QAction;
class QLabel;
class QTreeView;

namespace mapwright::window {

class InspectorControls;
class InspectorSummary;

class InspectorDock : public QDockWidget {
  Q_OBJECT
 public:
  InspectorDock(scene::MapScene* scene, QAction* show_ids, QAction* show_outlines, QWidget* parent = nullptr);

  ~InspectorDock() override;

  /// Not owned; null = none.
  void setSession(session::Session* session);
  void setColorMode(render::ColorMode mode);
  /// Selects a submap in the tree, as if clicked (without moving the map). What is selected is framed on the
  /// map.
  void select(map::SubmapId id);
  void clearSelection();
  std::optional<map::SubmapId> selected() const;  // when it is one alone

  QTreeView* tree() const { return tree_; }
  SubmapTreeModel* model() const { return model_; }
  SubmapFilterModel* filterModel() const { return filtered_; }
  InspectorControls* controls() const { return controls_; }
  QString detailsText() const;

 Q_SIGNALS:
  void locateWanted(mapwright::map::SubmapId id);
  void colorModeWanted(mapwright::render::ColorMode mode);
  void copyWanted(const QString& text, const QString& what);
  /// The submaps were counted outside of the session's own rhythm: whoever shows counts too counts with it.
  void counted();

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTree();
  void refresh();
  void takeRows(const session::TouchedRows& rows);
  void refreshDetails();
  void refreshGroups();
  void fitColumns();
  void takeSelection();
  void showSubmaps(const std::vector<map::SubmapId>& ids, bool visible);
  void setGroupVisible(bool SubmapFacts::*flag, bool visible);
  void keepHiddenGroups();
  void showMenu(const QPoint& at);
  std::optional<map::SubmapId> idAt(const QModelIndex& proxy_index) const;
  std::set<map::SubmapId> selectedLeaves() const;
  std::vector<map::SubmapId> selectedIds() const;  // with those below selected groups

  scene::MapScene* scene_;
  QPointer<session::Session> session_;
  SubmapTreeModel* model_;
  SubmapFilterModel* filtered_;
  InspectorSummary* summary_;
  InspectorControls* controls_;
  QTreeView* tree_;
  QLabel* details_;
  // Groups that were switched off as such: newcomers that belong to one start hidden.
  bool nearby_off_ = false, incremental_off_ = false;
  std::set<map::SubmapId> known_;
  bool missed_rows_ = true;  // changes that came while nobody could see them
};

/// Everything to say about one submap in two or three lines. Plain text.
QString submapDetails(const session::Session& session, map::SubmapId id);

}  // namespace mapwright::window
