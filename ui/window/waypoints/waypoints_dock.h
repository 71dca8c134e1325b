// The waypoints of the open map: list, form, what is not saved, and what has to be decided.
#pragma once

#include <QDockWidget>

#include "window/waypoints/waypoint_editing.h"
#include "window/waypoints/waypoints_model.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace mapwright::edit {
class OpenWaypoints;
}

namespace mapwright::window {

class WaypointFilter;
class WaypointForm;

class WaypointsDock : public QDockWidget {
  Q_OBJECT
 public:
  /// `editing` must outlive this.
  explicit WaypointsDock(WaypointEditing* editing, QWidget* parent = nullptr);
  ~WaypointsDock() override;

  /// The list that is open to be changed; null = none, then `sentence` says what there is instead.
  void setList(const edit::OpenWaypoints* list, const QString& sentence);

  WaypointsModel* model() const { return model_; }
  QTableView* table() const { return table_; }
  QLineEdit* filterEdit() const { return filter_; }
  WaypointForm* form() const { return form_; }
  QPushButton* addButton() const { return add_; }
  QPushButton* removeButton() const { return remove_; }
  QPushButton* saveButton() const { return save_; }
  QPushButton* mineButton() const { return mine_; }
  QPushButton* theirsButton() const { return theirs_; }
  QString statusShown() const;
  QString conflictShown() const;  // empty = none
  /// What stands in the place of rows; empty while there are some.
  QString emptyShown() const;

 Q_SIGNALS:
  void addWanted();
  void saveWanted();
  void cancelWanted();
  void retryWanted();
  void locateWanted(const std::string& key);
  void decided(const std::string& key, bool mine);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* buildConflict();
  void buildTable();
  void refresh();
  void showSelection();
  void takeSelection();
  QString statusText() const;
  QString emptyText() const;

  WaypointEditing* editing_;
  const edit::OpenWaypoints* list_ = nullptr;
  QString sentence_;
  WaypointsModel* model_;
  WaypointFilter* sorted_;
  QLineEdit* filter_;
  QTableView* table_;
  QLabel *empty_, *status_, *conflict_;
  QWidget* conflict_box_;
  QPushButton *mine_, *theirs_, *add_, *remove_, *save_, *cancel_, *retry_;
  WaypointForm* form_;
  edit::Key shown_conflict_;
  bool showing_selection_ = false;
};

}  // namespace mapwright::window
