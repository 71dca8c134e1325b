// Asks for a waypoint by its numbers, and for the distances that count while they are placed.
#pragma once

#include <QDialog>

#include "map/waypoint.h"

class QDoubleSpinBox;
class QLineEdit;

namespace mapwright::window {

class NewWaypointDialog : public QDialog {
  Q_OBJECT
 public:
  /// `present`: what the fields begin with.
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

/// What waypoints are caught by, and when they are warned of, in numbers.
struct PlacingNumbers {
  double grid_m = 0.5, wall_m = 0.5, radius_m = 0.3;
};

class PlacingDialog : public QDialog {
  Q_OBJECT
 public:
  /// `told_radius_m`: what the robot says of itself, 0 = nothing; then the typed one is not asked for.
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
