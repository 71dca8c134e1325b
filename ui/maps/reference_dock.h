// The reference map: which one, how it lies, and by which pairs of points.
#pragma once

#include <vector>

#include <QDockWidget>

#include "geometry/pose.h"
#include "placing/align.h"

class QDoubleSpinBox;
class QPushButton;
class QStandardItemModel;
class QTableView;

namespace mapwright::window {

class PlainLabel;

class ReferenceDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit ReferenceDock(QWidget* parent = nullptr);
  ~ReferenceDock() override;

  /// `said`: the map, or why there is none.
  void setMap(const QString& said, bool there);
  /// Shows how it lies, without telling.
  void setState(const geometry::Pose2& world_from_map, const std::vector<placing::PointPair>& pairs);
  void setTool(bool moving, bool pairing);

  QPushButton* removeButton() const { return remove_; }
  QPushButton* moveButton() const { return move_; }
  QPushButton* pairsButton() const { return pair_; }
  QTableView* table() const { return table_; }
  QDoubleSpinBox* xBox() const { return x_; }
  QDoubleSpinBox* yBox() const { return y_; }
  QDoubleSpinBox* yawBox() const { return yaw_; }
  QString told() const;

 Q_SIGNALS:
  void chooseWanted();
  void removeWanted();
  void moveWanted(bool on);
  void pairsWanted(bool on);
  void typed(const mapwright::geometry::Pose2& world_from_map);
  void pairUnwanted(int index);
  void pairsUnwanted();
  void fitWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void applyTyped();
  void removeSelected();

  PlainLabel *map_, *told_;
  QPushButton *choose_, *remove_, *move_, *pair_, *fit_, *remove_pair_, *clear_;
  QDoubleSpinBox *x_, *y_, *yaw_;
  QStandardItemModel* model_;
  QTableView* table_;
  bool setting_ = false;
};

}  // namespace mapwright::window
