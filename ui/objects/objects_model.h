// The things on the map as a table. Updates in place, so that selection and scroll bar stay.
#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "ui/scene/map_scene.h"

namespace mapwright::ui {

class ObjectsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NameColumn, KindColumn, LayerColumn, kColumns };

  explicit ObjectsModel(const scene::MapScene& scene, QObject* parent = nullptr)
      : QAbstractTableModel(parent), scene_(scene) {}
  void setObjects(std::vector<scene::MapObject> objects);
  const scene::MapObject& object(int row) const { return objects_[std::size_t(row)]; }
  /// -1 = not listed.
  int rowOf(const scene::ObjectId& id) const;

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(objects_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const scene::MapScene& scene_;
  std::vector<scene::MapObject> objects_;
};

}  // namespace mapwright::ui
