// What becomes of the waypoints of the reference map on the map on screen, and which of them go there.
#pragma once

#include <vector>

#include <QDockWidget>

#include "ui/waypoints/carry_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace mapwright::window {

struct CarryShown {
  QString said;
  bool again = false;     // it can be looked at again
  bool editable = false;  // the waypoints of the map on screen
};

class CarryDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit CarryDock(QWidget* parent = nullptr);
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
  QString said() const;

 Q_SIGNALS:
  void lookWanted();
  void placeWanted(int row);  // of the model; by a click or Enter
  void soundWanted();
  void selectedWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void allowButtons();

  CarryModel* model_;
  CarryFilter* filtered_;
  QLabel* said_;
  QPushButton* again_;
  QComboBox* filter_;
  QCheckBox* adjust_;
  QTableView* table_;
  QPushButton *sound_, *selected_;
  bool editable_ = false;
};

}  // namespace mapwright::window
