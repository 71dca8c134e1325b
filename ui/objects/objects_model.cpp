#include "ui/objects/objects_model.h"

#include <algorithm>

#include <QGuiApplication>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/objects/object_facts.h"

namespace mapwright::ui {

namespace {
constexpr int kRowSymbolPx = 16;
}

void ObjectsModel::setObjects(std::vector<scene::MapObject> objects) {
  const bool same =
      std::equal(objects.begin(), objects.end(), objects_.begin(), objects_.end(),
                 [](const scene::MapObject& a, const scene::MapObject& b) { return a.id.sameAs(b.id); });
  if (!same) beginResetModel();
  objects_ = std::move(objects);
  if (!same) return endResetModel();
  if (!objects_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ObjectsModel::rowOf(const scene::ObjectId& id) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(),
                                  [&](const scene::MapObject& object) { return object.id.sameAs(id); });
  return found == objects_.end() ? -1 : int(found - objects_.begin());
}

QVariant ObjectsModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const scene::MapObject& object = objects_[std::size_t(index.row())];
  if (role == Qt::DecorationRole && index.column() == NameColumn)
    return sharedPixmap(scene_.symbolOf(object, kRowSymbolPx, qApp->devicePixelRatio()));
  if (role == Qt::ToolTipRole) return plainToolTip(calledInFull(object));
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case NameColumn:
      return object.name.isEmpty() ? object.kind : object.name;
    case KindColumn:
      return object.kind;
    case LayerColumn:
      return scene::layerTitle(object.id.layer);
  }
  return {};
}

QVariant ObjectsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case NameColumn:
      return tr("Name");
    case KindColumn:
      return tr("Kind");
    case LayerColumn:
      return tr("Layer");
  }
  return {};
}

}  // namespace mapwright::ui

#include "moc_objects_model.cpp"
