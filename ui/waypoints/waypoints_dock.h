// The waypoints of the open map: list, form, what is not saved, and what has to be decided.
#pragma once

#include <QDockWidget>

#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoints_model.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QKeyEvent;
class QTableView;
class QToolButton;

namespace mapwright::edit {
class OpenWaypoints;
}

namespace mapwright::ui {

class ConflictBox;
enum class ConflictChoice;
class GroupForm;
class WaypointFilter;
class WaypointForm;
class WaypointWarnings;

class WaypointsDock : public QDockWidget {
  Q_OBJECT
 public:
  /// `editing` must outlive this.
  explicit WaypointsDock(WaypointEditing* editing, QWidget* parent = nullptr);
  ~WaypointsDock() override;

  /// The list that can be edited; null = none, and `sentence` says why.
  void setList(const edit::OpenWaypoints* list, const QString& sentence, const QString& remark = {});

  /// To what has to be decided: the selected one, otherwise the first.
  void goToConflict();

  /// Must outlive this.
  void setWarnings(const WaypointWarnings* warnings);

  WaypointsModel* model() const { return model_; }
  QTableView* table() const { return table_; }
  QLineEdit* filterEdit() const { return filter_; }
  QComboBox* pendingChoice() const { return pending_; }
  WaypointForm* form() const { return form_; }
  GroupForm* groupForm() const { return group_; }
  QPushButton* addButton() const { return add_; }
  QPushButton* removeButton() const { return remove_; }
  QPushButton* saveButton() const { return save_; }
  ConflictBox* conflicts() const { return conflicts_; }
  QToolButton* warningsButton() const { return next_warning_; }
  QString statusShown() const;
  bool statusIsBad() const { return status_bad_; }  // in red
  /// Keys of the rows that are selected and that I deleted.
  std::vector<edit::Key> selectedDeleted() const;
  /// Those that are selected, in the order of the rows.
  std::vector<edit::Key> selectedAsListed() const;
  /// The text in place of rows; empty if there are rows.
  QString emptyShown() const;

 Q_SIGNALS:
  void addWanted();
  void saveWanted();
  void cancelWanted();
  void retryWanted();
  void nextWarningWanted();
  void locateWanted(const std::string& key);
  void decided(const std::string& key, mapwright::ui::ConflictChoice choice);
  void copyWanted();
  void pasteWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTable();
  void buildFilter();
  bool pressed(QKeyEvent* press);
  void rename();
  void showMenu(const QPoint& at);
  void refresh();
  void showSelection();
  void onSelection();
  void showWarnings();
  QString statusText() const;
  QString emptyText() const;

  WaypointEditing* editing_;
  const edit::OpenWaypoints* list_ = nullptr;
  QString sentence_, remark_;
  WaypointsModel* model_;
  WaypointFilter* sorted_;
  QLineEdit* filter_;
  QTableView* table_;
  QComboBox* pending_;
  QLabel *empty_, *status_;
  ConflictBox* conflicts_;
  QPushButton *add_, *remove_, *save_, *cancel_, *retry_;
  QToolButton* next_warning_;
  WaypointForm* form_;
  GroupForm* group_;
  const WaypointWarnings* warnings_ = nullptr;
  bool showing_selection_ = false, status_bad_ = false;
};

}  // namespace mapwright::ui
