// Everything that is known of the thing that was chosen on the map.
#pragma once

#include <optional>
#include <vector>

#include <QDockWidget>

#include "ui/scene/map_object.h"

class QLabel;
class QPushButton;
class QStandardItemModel;
class QTableView;

namespace mapwright::ui::scene {
class MapScene;
}

namespace mapwright::ui {

class NameColumn;
class PlainLabel;

class PropertiesDock : public QDockWidget {
  Q_OBJECT
 public:
  PropertiesDock(const scene::MapScene& scene, QWidget* parent);
  ~PropertiesDock() override;

  /// `gone`: it is no longer on the map; this is what was known of it last.
  void setObject(const scene::MapObject& object, const std::vector<scene::ObjectProperty>& facts, bool gone);
  void clear();
  QTableView* table() const { return table_; }

 Q_SIGNALS:
  void copyWanted(const QString& text, const QString& said);
  void locateWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void copySelected();

  const scene::MapScene& scene_;
  QLabel* symbol_;
  PlainLabel *title_, *state_;
  QStandardItemModel* model_;
  QTableView* table_;
  QPushButton *copy_, *locate_;
  NameColumn* columns_ = nullptr;
  std::optional<scene::MapObject> object_;
  std::vector<scene::ObjectProperty> facts_;
};

}  // namespace mapwright::ui
