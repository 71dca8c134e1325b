// New names for the selected waypoints, all at once: counted, or with a part replaced. Shows what every name
// becomes, and which ones collide, before anything changes. GUI thread.
#pragma once

#include <functional>
#include <vector>

#include <QAbstractTableModel>
#include <QDialog>

#include "exchange/waypoint_names.h"
#include "ui/waypoints/waypoint_editing.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTableView;

namespace mapwright::ui {

class NewNamesModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NowColumn, NewColumn, TroubleColumn, kColumns };
  using QAbstractTableModel::QAbstractTableModel;
  void show(std::vector<exchange::NewName> names);
  const std::vector<exchange::NewName>& names() const { return names_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<exchange::NewName> names_;
};

class RenameDialog : public QDialog {
  Q_OBJECT
 public:
  /// `list_order`: the selected ones as they are listed. `editing` must outlive this.
  RenameDialog(WaypointEditing* editing, std::function<std::vector<edit::Key>()> list_order,
               QWidget* parent = nullptr);

  QComboBox* howChoice() const { return how_; }
  QLineEdit* patternEdit() const { return pattern_; }
  QSpinBox* stepBox() const { return step_; }
  QComboBox* orderChoice() const { return order_; }
  QCheckBox* reverseBox() const { return reverse_; }
  QLineEdit* findEdit() const { return find_; }
  QLineEdit* replacementEdit() const { return replacement_; }
  QPushButton* renameButton() const { return rename_; }
  NewNamesModel* model() const { return model_; }
  QString statusShown() const;

 private:
  QWidget* patternPage();
  QWidget* replacePage();
  exchange::Renaming renaming() const;
  std::vector<edit::Key> ordered() const;
  void look();
  void refreshStatus();
  void apply();

  WaypointEditing* editing_;
  std::function<std::vector<edit::Key>()> list_order_;
  QComboBox* how_;
  QStackedWidget* pages_;
  QLineEdit *pattern_, *find_, *replacement_;
  QSpinBox *first_, *step_;
  QComboBox* order_;
  QCheckBox *reverse_, *case_;
  NewNamesModel* model_;
  QTableView* table_;
  QLabel* status_;
  QPushButton* rename_;
  std::vector<edit::Key> keys_;  // of the rows
};

}  // namespace mapwright::ui
