// Places waypoints along a line: two clicks or a drag define it, with a preview of the result; a strip over
// the map has spacing, names and Create.
#pragma once

#include <optional>

#include <QFrame>

#include "exchange/waypoint_names.h"
#include "placing/arrange.h"
#include "scene/map_scene.h"
#include "ui/view/map_tool.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_snapping.h"

class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace mapwright::window {

class PlainLabel;

class LineTool : public MapTool {
  Q_OBJECT
 public:
  static constexpr double kLeastSpacingM = 0.05, kMostSpacingM = 100;

  /// Both must outlive this.
  LineTool(const scene::MapScene* scene, WaypointSnapping* snapping, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("waypointLine"); }
  void activate() override;
  void deactivate() override;
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  void clicked(const MapPoint& at) override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  double spacing() const { return spacing_m_; }
  void setSpacing(double spacing_m);
  /// The waypoints for the present line; empty = none, or too many.
  std::vector<placing::Spot> spots() const;
  /// Both ends are set.
  bool ready() const { return from_ && to_ && fixed_; }
  double length() const { return from_ && to_ ? (*to_ - *from_).norm() : 0; }
  void forget();  // begins anew

 Q_SIGNALS:
  void activated(bool active);
  void lineChanged();
  void lineEnded();   // by the hand: its second end is set
  void madeWanted();  // Enter

 private:
  Eigen::Vector2d caught(const MapPoint& at);
  void end(const MapPoint& at);
  void tell();

  const scene::MapScene* scene_;
  WaypointSnapping* snapping_;
  double spacing_m_ = 1;
  std::optional<Eigen::Vector2d> from_, to_;
  bool fixed_ = false;     // the second end is final
  bool dragging_ = false;  // from the first to the second end
  placing::SnappedPlace landing_;
};

/// The strip over the map.
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
  QString whyNotFrom() const;
  /// Of as many waypoints as there will be.
  QStringList names() const;
  /// They have been created: the next line goes on counting.
  void noteCreated();

 Q_SIGNALS:
  void createWanted();
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void refresh();
  void refreshNames();
  void place();
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

}  // namespace mapwright::window
