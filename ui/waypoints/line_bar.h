// The strip over the map with spacing, names and Create for waypoints along a line.
#pragma once

#include <optional>

#include <QFrame>

#include "exchange/waypoint_names.h"
#include "ui/waypoints/line_tool.h"
#include "ui/waypoints/waypoint_editing.h"

class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace mapwright::ui {

class PlainLabel;

class LineBar : public QFrame {
  Q_OBJECT
 public:
  /// A child of `map`, at its lower edge. `tool` and `editing` must outlive this.
  LineBar(LineTool* tool, WaypointEditing* editing, QWidget* map);
  QDoubleSpinBox* spacing() const { return spacing_; }
  QLineEdit* prefixEdit() const { return prefix_; }
  QLineEdit* firstEdit() const { return first_; }
  QSpinBox* stepBox() const { return step_; }
  QPushButton* createButton() const { return create_; }
  QString countShown() const;
  QString namesShown() const;
  QString notFromReason() const;
  /// Of as many waypoints as there will be.
  QStringList names() const;
  /// They have been created: the next line goes on counting.
  void onCreated();

 Q_SIGNALS:
  void createWanted();
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void refreshNames();
  void layOut();
  exchange::SeriesNames series() const;
  const exchange::TakenNames& taken() const;

  LineTool* tool_;
  WaypointEditing* editing_;
  QDoubleSpinBox* spacing_;
  QLineEdit *prefix_, *first_;
  QSpinBox* step_;
  PlainLabel *count_, *names_;
  QPushButton *create_, *close_;
  mutable std::optional<exchange::TakenNames> taken_;  // made when they are asked for
};

}  // namespace mapwright::ui
