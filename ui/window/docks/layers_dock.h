// The layers of the map: which are drawn, and how strongly.
#pragma once

#include <vector>

#include <QDockWidget>

#include "scene/map_scene.h"

class QSlider;
class QToolButton;

namespace mapwright::window {

class PlainLabel;

/// How a layer is called towards people, and its icon.
QString layerTitle(scene::Layer layer);
QString layerIcon(scene::Layer layer);

class LayersDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit LayersDock(scene::MapScene* scene, QWidget* parent = nullptr);
  /// Shows what the scene says.
  void sync();

  QToolButton* eye(scene::Layer layer) const;
  QSlider* opacity(scene::Layer layer) const;

 private:
  struct Row {
    scene::Layer layer;
    QToolButton* eye;
    PlainLabel* name;
    QSlider* opacity;
    PlainLabel* percent;
  };
  const Row* row(scene::Layer layer) const;

  scene::MapScene* scene_;
  std::vector<Row> rows_;
};

}  // namespace mapwright::window
