// What a recorded way crosses on the map on screen, as a list.
#pragma once

#include <optional>
#include <vector>

#include <QDockWidget>
#include <QPen>

#include "carry/rehearsal.h"
#include "ui/scene/map_theme.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QStandardItemModel;
class QTableView;

namespace mapwright::ui {

/// Kinds differ by width and dashes, too, not only by colour.
QPen penOf(carry::Crossing what, const scene::MapTheme& theme);

class RehearsalDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit RehearsalDock(QWidget* parent = nullptr);
  ~RehearsalDock() override;

  void setSaid(const QString& said);
  void setStretches(const std::vector<carry::Stretch>& stretches);
  /// Of a way that was chosen.
  void setChosen(bool chosen);
  /// It is being read or looked at.
  void setBusy(bool busy);
  /// Why none of the robot's recordings can be chosen; empty: they can.
  void setWhyNoRecordings(const QString& why);
  /// Of the robot, if one was set; otherwise its own counts, which is `told_m`.
  std::optional<double> radius() const;
  void setToldRadius(double told_m);
  /// Without a signal. 0: its own.
  void setRadius(double radius_m);

  QTableView* table() const { return table_; }
  QPushButton* recordingsButton() const { return recordings_; }
  QPushButton* cancelButton() const { return cancel_; }
  QDoubleSpinBox* radiusBox() const { return radius_; }
  QPushButton* againButton() const { return again_; }
  QPushButton* removeButton() const { return remove_; }
  QString said() const;

 Q_SIGNALS:
  void chooseWanted();
  void recordingsWanted();
  void cancelWanted();
  void radiusChanged();
  void againWanted();
  void removeWanted();
  void placeWanted(int row);  // by a click or Enter

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QLabel* said_;
  QPushButton *choose_, *recordings_, *again_, *cancel_, *remove_;
  QDoubleSpinBox* radius_;
  QStandardItemModel* model_;
  QTableView* table_;
};

}  // namespace mapwright::ui
