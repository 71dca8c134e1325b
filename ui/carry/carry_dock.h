// What becomes of the things of the reference map on the map on screen, and which of them go there.
#pragma once

#include <functional>
#include <vector>

#include <QDockWidget>

#include "ui/carry/carry_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace mapwright::ui {

struct CarryShown {
  QString said;
  bool again = false;     // it can be looked at again
  bool editable = false;  // what lies on the map on screen
};

class CarryDock : public QDockWidget {
  Q_OBJECT
 public:
  CarryDock(const CarryWords& words, const QString& name, QWidget* parent);
  ~CarryDock() override;

  void setState(const CarryShown& shown);
  CarryModel* model() const { return model_; }
  /// Rows of the model.
  std::vector<int> selected() const;

  QTableView* table() const { return table_; }
  QComboBox* filterBox() const { return filter_; }
  QCheckBox* adjustBox() const { return adjust_; }
  QPushButton* againButton() const { return again_; }
  QPushButton* soundButton() const { return sound_; }
  QPushButton* selectedButton() const { return selected_; }
  QPushButton* leaveOutButton() const { return leave_out_; }
  QString said() const;

 Q_SIGNALS:
  void lookWanted();
  void placeWanted(int row);  // of the model; by a click or Enter
  void soundWanted();
  void carryWanted(const std::vector<int>& rows);
  /// Or not any more, if none of them is open.
  void leaveOutWanted(const std::vector<int>& rows);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void allowButtons();
  /// What a key of the list does; null: nothing.
  std::function<void()> deedOf(int key);
  /// Rows of the model that are open, in the order in which they are listed from the current one on.
  std::vector<int> openFrom(bool forward) const;
  /// Selects the first that is open still, and shows it on the map.
  void showFirstOpen(const std::vector<int>& rows);

  CarryModel* model_;
  CarryFilter* filtered_;
  QLabel* said_;
  QPushButton* again_;
  QComboBox* filter_;
  QCheckBox* adjust_;
  QTableView* table_;
  QPushButton *sound_, *selected_, *leave_out_;
  bool editable_ = false;
};

}  // namespace mapwright::ui
