// The reference map: which one, how it lies, and by which pairs of points.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QDockWidget>
#include <QString>

#include "align/align.h"
#include "geometry/pose.h"
#include "placing/align.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QStandardItemModel;
class QTableView;

namespace mapwright::ui {

class PlainLabel;

/// What the dock says about aligning by the walls.
struct AlignmentShown {
  bool running = false;
  QString said, figures;                      // empty = nothing
  std::optional<align::Agreement> agreement;  // of what is laid, or would be
  bool offers = false;                        // candidates to look at
  bool best_laid = false, second_laid = false, has_second = false;
};

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
  void setAlignment(const AlignmentShown& shown);
  void setProgress(double done);
  /// Empty: differences can be shown.
  void setWhyNoDifferences(const QString& why);
  /// nullopt: nothing is known of the walls that are off, or nobody wants to know.
  void setWallsOff(std::optional<bool> none);
  /// Empty: its waypoints, or overlays, can be carried over.
  void setWhyNotCarried(const QString& why);
  void setWhyOverlaysNotCarried(const QString& why);

  QPushButton* removeButton() const { return remove_; }
  QPushButton* moveButton() const { return move_; }
  QPushButton* pairsButton() const { return pair_; }
  QPushButton* alignButton() const { return align_; }
  QPushButton* cancelButton() const { return cancel_; }
  QPushButton* bestButton() const { return best_; }
  QPushButton* secondButton() const { return second_; }
  QPushButton* partButton() const { return part_; }
  QCheckBox* differencesBox() const { return differences_; }
  QCheckBox* wallsOffBox() const { return walls_off_; }
  QPushButton* swipeButton() const { return swipe_; }
  QWidget* wallsOffLegend() const { return legend_; }
  QPushButton* carryButton() const { return carry_; }
  QPushButton* carryOverlaysButton() const { return carry_overlays_; }
  QTableView* table() const { return table_; }
  QDoubleSpinBox* xBox() const { return x_; }
  QDoubleSpinBox* yBox() const { return y_; }
  QDoubleSpinBox* yawBox() const { return yaw_; }
  QString told() const;
  /// About aligning: the sentence, and the figures.
  QString alignmentSaid() const;
  QString alignmentFigures() const;

 Q_SIGNALS:
  void chooseWanted();
  void removeWanted();
  void moveWanted(bool on);
  void pairsWanted(bool on);
  void typed(const mapwright::geometry::Pose2& world_from_map);
  void pairUnwanted(int index);
  void pairsUnwanted();
  void fitWanted();
  void alignWanted();
  void alignCancelled();
  void candidateWanted(bool second);
  void placeWanted(const Eigen::Vector2d& world_m);  // on the map on screen
  void differencesWanted(bool shown);
  void swipeWanted();
  void carryWanted();
  void carryOverlaysWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeAgreement();
  void applyTyped();
  void removeSelected();

  PlainLabel *map_, *told_;
  QPushButton *choose_, *remove_, *move_, *pair_, *align_, *fit_, *remove_pair_, *clear_;
  QWidget* running_;  // the progress, and what ends it
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel *said_, *figures_;
  QWidget* agreement_;  // how far the walls of each map are off
  std::array<std::array<QLabel*, 2>, 5> distances_{};
  QWidget* candidates_;
  QPushButton *best_, *second_;
  QPushButton* part_;  // that lies beside
  Eigen::Vector2d part_m_{0, 0};
  QCheckBox* differences_;
  QCheckBox* walls_off_;
  QPushButton* swipe_;
  QWidget* legend_;  // of its marks
  QLabel* none_off_;
  QPushButton *carry_, *carry_overlays_;
  QDoubleSpinBox *x_, *y_, *yaw_;
  QStandardItemModel* model_;
  QTableView* table_;
  bool setting_ = false;
};

}  // namespace mapwright::ui
