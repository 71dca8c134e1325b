#include "window/docks/layers_dock.h"

#include <QGridLayout>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "window/look/icons.h"
#include "window/look/plain_label.h"
#include "window/look/ui_colors.h"

namespace mapwright::window {

using scene::Layer;

QString layerTitle(Layer layer) {
  switch (layer) {
    case Layer::Submaps:
      return QStringLiteral("Submaps");
    case Layer::Grid:
      return QStringLiteral("Grid");
    case Layer::Outlines:
      return QStringLiteral("Outlines");
    case Layer::Ids:
      return QStringLiteral("Ids");
    case Layer::Trail:
      return QStringLiteral("Trail");
    case Layer::Robot:
      return QStringLiteral("Robot");
    case Layer::ScaleBar:
      return QStringLiteral("Scale bar");
  }
  return {};
}

QString layerIcon(Layer layer) {
  switch (layer) {
    case Layer::Submaps:
      return QStringLiteral("submaps");
    case Layer::Grid:
      return QStringLiteral("grid");
    case Layer::Outlines:
      return QStringLiteral("outlines");
    case Layer::Ids:
      return QStringLiteral("ids");
    case Layer::Trail:
      return QStringLiteral("trail");
    case Layer::Robot:
      return QStringLiteral("robot");
    case Layer::ScaleBar:
      return QStringLiteral("scalebar");
  }
  return {};
}

LayersDock::LayersDock(scene::MapScene* scene, QWidget* parent)
    : QDockWidget(QStringLiteral("Layers"), parent), scene_(scene) {
  setObjectName(QStringLiteral("layers"));
  auto* body = new QWidget;
  auto* grid = new QGridLayout(body);
  grid->setContentsMargins(4, 4, 8, 4);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(0);
  grid->setColumnStretch(1, 1);
  const std::vector<Layer> layers = scene::allLayers();
  int line = 0;
  // The list reads like the map: what lies on top stands on top.
  for (auto it = layers.rbegin(); it != layers.rend(); ++it, ++line) {
    const Layer layer = *it;
    Row row{layer, new QToolButton(body), new PlainLabel(layerTitle(layer), body),
            new QSlider(Qt::Horizontal, body), new PlainLabel(body)};
    row.eye->setCheckable(true);
    row.eye->setObjectName(QStringLiteral("eye-") + scene::layerName(layer));
    row.eye->setStyleSheet(
        QStringLiteral("QToolButton:checked { background: transparent; border-color: transparent; }"));
    row.eye->setIconSize({16, 16});
    row.eye->setFixedSize(24, 24);
    row.eye->setAccessibleName(QStringLiteral("Show %1").arg(layerTitle(layer)));
    row.name->setFixedHeight(24);
    row.opacity->setRange(0, 100);
    row.opacity->setPageStep(10);
    row.opacity->setFixedWidth(56);
    row.opacity->setObjectName(QStringLiteral("opacity-") + scene::layerName(layer));
    row.opacity->setAccessibleName(QStringLiteral("Opacity of %1").arg(layerTitle(layer)));
    row.opacity->setToolTip(QStringLiteral("Opacity"));
    row.percent->setSample(QStringLiteral("100 %"));
    row.percent->setAlignment(Qt::AlignRight);
    row.percent->setSecondary(true);
    row.percent->setFixedWidth(row.percent->sizeHint().width());
    grid->addWidget(row.eye, line, 0);
    grid->addWidget(row.name, line, 1);
    grid->addWidget(row.opacity, line, 2);
    grid->addWidget(row.percent, line, 3);
    connect(row.eye, &QToolButton::toggled, this,
            [this, layer](bool on) { scene_->setLayerVisible(layer, on); });
    connect(row.opacity, &QSlider::valueChanged, this, [this, layer](int value) {
      scene_->setLayerOpacity(layer, value / 100.0);
      sync();
    });
    rows_.push_back(row);
  }
  grid->setRowStretch(line, 1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(body);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(180);
  setWidget(scroll);
  connect(scene_, &scene::MapScene::layersChanged, this, &LayersDock::sync);
  sync();
}

void LayersDock::sync() {
  for (const Row& row : rows_) {
    const bool visible = scene_->layerVisible(row.layer);
    const int percent = qRound(scene_->layerOpacity(row.layer) * 100);
    const QSignalBlocker quiet_eye(row.eye), quiet_slider(row.opacity);
    row.eye->setChecked(visible);
    row.eye->setIcon(themedIcon(visible ? QStringLiteral("eye") : QStringLiteral("eye-off")));
    row.eye->setToolTip(visible ? QStringLiteral("Hide this layer") : QStringLiteral("Show this layer"));
    row.name->setSecondary(!visible);
    row.opacity->setValue(percent);
    row.opacity->setEnabled(visible);
    row.percent->setText(QStringLiteral("%1 %").arg(percent));
  }
}

const LayersDock::Row* LayersDock::row(Layer layer) const {
  for (const Row& row : rows_) {
    if (row.layer == layer) return &row;
  }
  return nullptr;
}

QToolButton* LayersDock::eye(Layer layer) const { return row(layer) ? row(layer)->eye : nullptr; }
QSlider* LayersDock::opacity(Layer layer) const { return row(layer) ? row(layer)->opacity : nullptr; }

}  // namespace mapwright::window
