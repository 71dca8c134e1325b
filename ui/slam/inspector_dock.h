// The SLAM inspector: the content of the robot's SLAM, submap by submap.
#pragma once

#include <set>
#include <vector>

#include <QDockWidget>
#include <QPointer>

#include "ui/scene/map_scene.h"
#include "ui/slam/submap_tree_model.h"

class QAction;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QMenu;
class QSpinBox;
class QToolButton;
class QTreeView;

namespace mapwright::render {
enum class ColorMode;
}

namespace mapwright::ui {

class PlainLabel;

class InspectorDock : public QDockWidget {
  Q_OBJECT
 public:
  /// The two actions switch the ids and the outlines of the submaps.
  InspectorDock(scene::MapScene* scene, QAction* show_ids, QAction* show_outlines, QWidget* parent = nullptr);
  ~InspectorDock() override;

  /// Not owned; null = none.
  void setSession(session::Session* session);
  void setColorMode(render::ColorMode mode);
  /// Selects a submap in the tree, as if clicked (without moving the map).
  /// Selected ones are framed on the map.
  void select(map::SubmapId id);
  void clearSelection();
  std::optional<map::SubmapId> selected() const;  // if exactly one is selected

  QTreeView* tree() const { return tree_; }
  SubmapTreeModel* model() const { return model_; }
  SubmapFilterModel* filterModel() const { return filtered_; }
  QLineEdit* filterEdit() const { return filter_; }

 Q_SIGNALS:
  void locateWanted(mapwright::map::SubmapId id);
  void colorModeWanted(mapwright::render::ColorMode mode);
  void copyWanted(const QString& text, const QString& what);
  /// The menu of these submaps (at least one, ascending) is about to open: others may add entries. `whole`:
  /// of a trajectory as a whole.
  void menuOpening(QMenu* menu, const std::vector<mapwright::map::SubmapId>& ids, bool whole);
  /// The counters were updated outside the session's usual rhythm: other
  /// displays of counters should update, too.
  void counted();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* buildSummary();
  QWidget* buildControls(QAction* show_ids, QAction* show_outlines);
  PlainLabel* addRow(QGridLayout* grid, const QString& name, int columns = 2);
  QCheckBox* addGroup(const QString& name, const QString& tip, bool SubmapFacts::*flag);
  void buildTree();
  void refresh();
  void refreshSummary();
  void refreshSlices();
  void onRows(const session::TouchedRows& rows);
  void refreshDetails();
  void refreshGroups();
  void fitColumns();
  void onSelection();
  void showSubmaps(const std::vector<map::SubmapId>& ids, bool visible);
  void setGroupVisible(bool SubmapFacts::*flag, bool visible);
  void keepHiddenGroups();
  void showMenu(const QPoint& at);
  std::optional<map::SubmapId> idAt(const QModelIndex& proxy_index) const;
  std::set<map::SubmapId> selectedLeaves() const;
  std::vector<map::SubmapId> selectedIds() const;  // including those in selected groups

  scene::MapScene* scene_;
  QPointer<session::Session> session_;
  SubmapTreeModel* model_;
  SubmapFilterModel* filtered_;
  PlainLabel *state_, *uuid_, *submaps_, *cache_, *fetches_, *transferred_;
  std::vector<QWidget*> where_high_;  // what a low panel has no room for
  QToolButton* copy_;
  QLineEdit* filter_;
  QCheckBox *nearby_, *incremental_;
  QSpinBox* slice_;
  QComboBox* colors_;
  QTreeView* tree_ = nullptr;  // until it is made
  QLabel* details_;
  // Groups that were switched off as a whole: new members start hidden.
  bool nearby_off_ = false, incremental_off_ = false;
  std::set<map::SubmapId> known_;
  bool missed_rows_ = true;  // changes while it was invisible
};

/// "positioning, reliable": the SLAM state reported by the robot, in words.
QString slamStateText(const session::Session& session);
/// Details of one submap in two or three lines. Plain text.
QString submapDetails(const session::Session& session, map::SubmapId id);

}  // namespace mapwright::ui
