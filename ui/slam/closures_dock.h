// Which loop closures contradict the finished map, the worst first.
#pragma once

#include <optional>

#include <QDockWidget>

#include "ui/slam/closures_model.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTableView;

namespace mapwright::ui {

class DecimalBox;
class NameColumn;
class PlainLabel;

class ClosuresDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit ClosuresDock(QWidget* parent);
  ~ClosuresDock() override;

  ClosuresModel* model() const { return model_; }
  QTableView* table() const { return table_; }
  QLineEdit* filterEdit() const { return filter_; }
  /// Says that only one submap's constraints are listed; a click lists the others again.
  QPushButton* onlySubmap() const { return only_submap_; }
  void listAllSubmaps();
  /// What is known of the map as a whole: sentences.
  void setSummary(const QString& text);
  void setRows(std::vector<ClosureRow> rows);
  /// Of the closure on show, world: where the robot lies, and where it should lie.
  void setPlaces(const Eigen::Vector2d& at, const Eigen::Vector2d& expected);
  void hidePlaces();
  /// Whether the layer is on the map, and whether it leaves out what the list leaves out.
  void setOnMap(bool shown, bool follows);
  /// Makes its row the current one, as if it were chosen, but stays quiet.
  void point(const ClosureRow& closure);

 Q_SIGNALS:
  void chosen(const mapwright::ui::ClosureRow& row);  // by a click, Enter or the arrow keys
  void onMapWanted(bool shown);
  void filtered();
  /// The menu of a row is about to open: others may add entries. A row of a submap has no node.
  void menuOpening(QMenu* menu, const mapwright::ui::ClosureRow& row);
  void shown();

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void applyFilter();
  void count();
  void openSubmap();
  void showMenu(const QPoint& at);

  ClosuresModel* model_;
  QLabel *summary_, *places_;
  QLineEdit* filter_;
  QComboBox* kinds_;
  DecimalBox* least_;
  QCheckBox *by_submap_, *on_map_;
  QPushButton* only_submap_;
  std::optional<map::SubmapId> submap_;
  bool quiet_ = false, follows_ = false, shows_places_ = false;
  QTableView* table_;
  PlainLabel* count_;
  NameColumn* columns_ = nullptr;
};

}  // namespace mapwright::ui
