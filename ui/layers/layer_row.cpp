#include "ui/layers/layer_row.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/icons.h"
#include "ui/kit/opacity_slider.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "ui/layers/layer_style_editor.h"

namespace mapwright::window {

namespace {
constexpr int kLayerRowPx = 24;
}

LayerRow::LayerRow(scene::MapScene* scene, scene::Layer layer, QWidget* parent)
    : QFrame(parent),
      scene_(scene),
      layer_(layer),
      eye_(new QToolButton(this)),
      name_(new PlainLabel(scene::layerTitle(layer), this)),
      opacity_(new OpacitySlider(this)) {
  const QString title = scene::layerTitle(layer);
  setObjectName(QStringLiteral("layer-") + scene::layerName(layer));
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(title);
  eye_->setCheckable(true);
  eye_->setObjectName(QStringLiteral("eye-") + scene::layerName(layer));
  eye_->setStyleSheet(
      QStringLiteral("QToolButton:checked { background: transparent; border-color: transparent; }"));
  eye_->setIconSize({16, 16});
  eye_->setFixedSize(kLayerRowPx, kLayerRowPx);
  eye_->setFocusPolicy(Qt::TabFocus);
  eye_->setAccessibleName(tr("Show %1").arg(title));
  name_->setFixedHeight(kLayerRowPx);
  name_->setSample(QStringLiteral("xxxx"));  // the row must not determine the dock's width
  name_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  opacity_->setObjectName(QStringLiteral("opacity-") + scene::layerName(layer));
  opacity_->setAccessibleName(tr("Opacity of %1").arg(title));

  auto* head = new QHBoxLayout;
  head->setContentsMargins(4, 0, 4, 0);
  head->setSpacing(3);
  head->addWidget(eye_);
  head->addWidget(name_, 1);
  head->addWidget(opacity_);
  if (scene::layerTraits(layer).any() || scene::chosenStream(layer)) {
    settings_ = new QToolButton(this);
    settings_->setObjectName(QStringLiteral("settings-") + scene::layerName(layer));
    settings_->setCheckable(true);
    settings_->setIcon(themedIcon(QStringLiteral("settings")));
    settings_->setIconSize({14, 14});
    settings_->setFixedSize(22, 22);
    settings_->setFocusPolicy(Qt::TabFocus);
    settings_->setToolTip(scene::chosenStream(layer) ? tr("Colour, topic and more")
                                                     : tr("Colour, size and more"));
    QSizePolicy place = settings_->sizePolicy();
    place.setRetainSizeWhenHidden(true);
    settings_->setSizePolicy(place);
    settings_->setVisible(scene::layerTraits(layer).any());
    settings_->setAccessibleName(tr("Settings of %1").arg(title));
    head->addWidget(settings_);
    connect(settings_, &QToolButton::toggled, this, &LayerRow::fold);
  } else {
    head->addSpacing(25);
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(head);
  connect(eye_, &QToolButton::toggled, this, [this](bool on) { scene_->setLayerVisible(layer_, on); });
  connect(opacity_, &QSlider::valueChanged, this,
          [this](int value) { scene_->setLayerOpacity(layer_, value / 100.0); });
  sync();
}

void LayerRow::sync() {
  const bool visible = scene_->layerVisible(layer_);
  const QSignalBlocker quiet_eye(eye_), quiet_slider(opacity_);
  if (shown_ != visible) {
    shown_ = visible;
    eye_->setChecked(visible);
    eye_->setIcon(themedIcon(visible ? QStringLiteral("eye") : QStringLiteral("eye-off")));
    eye_->setToolTip(visible ? tr("Hide this layer") : tr("Show this layer"));
    name_->setSecondary(!visible);
  }
  opacity_->setValue(qRound(scene_->layerOpacity(layer_) * 100));
  opacity_->setEnabled(visible && reason_.isEmpty());
  opacity_->update();
  if (editor_) editor_->sync();
}

void LayerRow::setUnavailable(const QString& reason) {
  reason_ = reason;
  const bool fine = reason.isEmpty();
  eye_->setEnabled(fine);
  name_->setEnabled(fine);
  name_->setHint(reason);
  if (settings_) settings_->setEnabled(fine);
  setToolTip(plainToolTip(reason));
  setAccessibleDescription(reason);
  opacity_->setEnabled(fine && shown_.value_or(true));
}

void LayerRow::setTopics(const QStringList& choices, const QString& chosen, const QString& usual) {
  if (topics_ == choices && topic_ == chosen && usual_topic_ == usual) return;
  topics_ = choices;
  topic_ = chosen;
  usual_topic_ = usual;
  const bool any = scene::layerTraits(layer_).any() || !choices.isEmpty() || !chosen.isEmpty();
  if (!any) settings_->setChecked(false);
  settings_->setVisible(any);
  if (editor_) editor_->setTopics(choices, chosen, usual);
}

void LayerRow::fold(bool out) {
  if (out && !editor_) {
    editor_ = new LayerStyleEditor(scene_, layer_, this);
    editor_->setTopics(topics_, topic_, usual_topic_);
    connect(editor_, &LayerStyleEditor::topicChosen, this, &LayerRow::topicChosen);
    layout()->addWidget(editor_);
  }
  if (editor_) editor_->setVisible(out);
}

void LayerRow::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  press_ = event->position().toPoint();
  dragging_ = false;
  setFocus(Qt::MouseFocusReason);
}

void LayerRow::mouseMoveEvent(QMouseEvent* event) {
  if (!press_ || !(event->buttons() & Qt::LeftButton) || scene::specOf(layer_).order_fixed) return;
  const QPoint at = event->position().toPoint();
  if (!dragging_ && (at - *press_).manhattanLength() >= QApplication::startDragDistance()) {
    dragging_ = true;
    setCursor(Qt::ClosedHandCursor);
    update();
  }
  if (dragging_) Q_EMIT dragged(mapToParent(at).y());
}

void LayerRow::mouseReleaseEvent(QMouseEvent*) {
  press_.reset();
  if (!dragging_) return;
  dragging_ = false;
  unsetCursor();
  update();
  Q_EMIT dropped();
}

void LayerRow::keyPressEvent(QKeyEvent* event) {
  const bool control = event->modifiers() & Qt::ControlModifier;
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down: {
      const int rows = event->key() == Qt::Key_Up ? -1 : 1;
      control ? Q_EMIT moveWanted(rows) : Q_EMIT focusWanted(rows);
      return;
    }
    case Qt::Key_Space:
      if (eye_->isEnabled()) eye_->toggle();
      return;
    default:
      QFrame::keyPressEvent(event);
  }
}

void LayerRow::paintEvent(QPaintEvent*) {
  if (!hasFocus() && !dragging_) return;
  const UiColors colors = appColors();
  QPainter painter(this);
  const QRect head(0, 0, width(), kLayerRowPx);
  painter.fillRect(head, dragging_ ? colors.selection : colors.hover);
  painter.fillRect(QRect(0, 0, 2, kLayerRowPx), colors.accent);
}

}  // namespace mapwright::window

#include "moc_layer_row.cpp"
