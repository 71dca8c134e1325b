// Dialogs for a waypoint by its numbers, and for the distances used while placing.
#pragma once

#include <QDialog>

#include "map/waypoint.h"

class QDoubleSpinBox;
class QLineEdit;

namespace mapwright::window {

class NewWaypointDialog : public QDialog {
  Q_OBJECT
 public:
  /// `present`: the initial values.
  explicit NewWaypointDialog(const map::Waypoint& present, QWidget* parent = nullptr);
  /// As typed, without an id.
  map::Waypoint waypoint() const;
  QLineEdit* nameEdit() const { return name_; }
  QDoubleSpinBox* x() const { return x_; }
  QDoubleSpinBox* y() const { return y_; }
  QDoubleSpinBox* heading() const { return heading_; }

 private:
  QLineEdit* name_;
  QDoubleSpinBox *x_, *y_, *heading_;
};

/// The numbers for snapping and warnings.
struct PlacingNumbers {
  double grid_m = 0.5, wall_m = 0.5, radius_m = 0.3;
};

class PlacingDialog : public QDialog {
  Q_OBJECT
 public:
  /// `told_radius_m`: from the robot's footprint, 0 = unknown; then the typed one is hidden.
  PlacingDialog(const PlacingNumbers& present, double told_radius_m, QWidget* parent = nullptr);
  PlacingNumbers numbers() const;
  QDoubleSpinBox* grid() const { return grid_; }
  QDoubleSpinBox* wall() const { return wall_; }
  QDoubleSpinBox* radius() const { return radius_; }

 private:
  PlacingNumbers present_;
  QDoubleSpinBox *grid_, *wall_, *radius_;
};

}  // namespace mapwright::window
