// What a recorded way crosses on the map on screen, as a list.
#pragma once

#include <vector>

#include <QDockWidget>
#include <QPen>

#include "carry/rehearsal.h"
#include "ui/scene/map_theme.h"

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
  void setStretches(const std::vector<carry::Stretch>& stretches, const scene::MapTheme& theme);
  /// Of a way that was chosen.
  void setChosen(bool chosen);

  QTableView* table() const { return table_; }
  QPushButton* againButton() const { return again_; }
  QPushButton* removeButton() const { return remove_; }
  QString said() const;

 Q_SIGNALS:
  void chooseWanted();
  void againWanted();
  void removeWanted();
  void placeWanted(int row);  // by a click or Enter

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QLabel* said_;
  QPushButton *choose_, *again_, *remove_;
  QStandardItemModel* model_;
  QTableView* table_;
};

}  // namespace mapwright::ui
