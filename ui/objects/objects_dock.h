// Everything that is on the map, to search and to go to.
#pragma once

#include <vector>

#include <QDockWidget>

#include "ui/scene/map_object.h"

class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace mapwright::ui::scene {
class MapScene;
}

namespace mapwright::ui {

class NameColumn;
class ObjectsModel;
class PlainLabel;

class ObjectsDock : public QDockWidget {
  Q_OBJECT
 public:
  ObjectsDock(const scene::MapScene& scene, QWidget* parent);
  ~ObjectsDock() override;

  /// `more`: there are others that are not listed.
  void setObjects(std::vector<scene::MapObject> objects, bool more);
  /// Selects its row, if it has one, without telling.
  void point(const std::optional<scene::ObjectId>& id);
  QLineEdit* filterEdit() const { return filter_; }
  QTableView* table() const { return table_; }

 Q_SIGNALS:
  void chosen(const mapwright::ui::scene::ObjectId& id);        // by a click or the arrow keys
  void locateWanted(const mapwright::ui::scene::ObjectId& id);  // by a double click or Enter
  void shown();

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void count();

  ObjectsModel* model_;
  QSortFilterProxyModel* filtered_;
  QLineEdit* filter_;
  QTableView* table_;
  PlainLabel* count_;
  NameColumn* columns_ = nullptr;
  bool more_ = false, pointing_ = false;
};

}  // namespace mapwright::ui
