#include "ui/layers/layer_row.h"

#include <algorithm>

#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>

#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kLayerRowPx = 24;

QIcon swatch(const QColor& color, const QColor& border) {
  QPixmap pixmap(36, 14);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(border);
  painter.setBrush(color);
  painter.drawRoundedRect(QRectF(0.5, 0.5, 35, 13), 3, 3);
  return QIcon(pixmap);
}

}  // namespace

LayerRow::LayerRow(scene::MapScene* scene, scene::Layer layer, QWidget* parent)
    : QFrame(parent),
      scene_(scene),
      layer_(layer),
      eye_(new EyeButton(this)),
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
  QSizePolicy eye_policy = eye_->sizePolicy();
  eye_policy.setRetainSizeWhenHidden(true);
  eye_->setSizePolicy(eye_policy);
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
  if (scene::specOf(layer).traits().any() || scene::chosenStream(layer)) {
    settings_ = new QToolButton(this);
    settings_->setObjectName(QStringLiteral("settings-") + scene::layerName(layer));
    settings_->setCheckable(true);
    settings_->setIcon(themedIcon(QStringLiteral("settings")));
    settings_->setIconSize({14, 14});
    settings_->setFixedSize(22, 22);
    settings_->setFocusPolicy(Qt::TabFocus);
    settings_->setToolTip(scene::chosenStream(layer) ? tr("Colour, topic and more")
                                                     : tr("Colour, size and more"));
    QSizePolicy policy = settings_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    settings_->setSizePolicy(policy);
    settings_->setAccessibleName(tr("Settings of %1").arg(title));
    head->addWidget(settings_);
    connect(settings_, &QToolButton::toggled, this, &LayerRow::fold);
    syncSettings();
  } else {
    head->addSpacing(25);
  }
  setLayout(columnOf({head}, 0, QMargins()));
  connect(eye_, &QToolButton::toggled, this, [this](bool on) { scene_->setLayerVisible(layer_, on); });
  connect(eye_, &EyeButton::soloWanted, this, &LayerRow::soloWanted);
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
    eye_->setToolTip(visible ? tr("Hide this layer. Alt+click: show only this layer")
                             : tr("Show this layer. Alt+click: show only this layer"));
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
  for (QWidget* const part : {static_cast<QWidget*>(eye_), static_cast<QWidget*>(opacity_)})
    part->setVisible(fine);
  syncSettings();
  setToolTip(plainToolTip(reason));
  setAccessibleDescription(reason);
  opacity_->setEnabled(fine && shown_.value_or(true));
}

void LayerRow::setTopics(const QStringList& choices, const QString& chosen, const QString& usual) {
  if (topics_ == choices && topic_ == chosen && usual_topic_ == usual) return;
  topics_ = choices;
  topic_ = chosen;
  usual_topic_ = usual;
  syncSettings();
  if (editor_) editor_->setTopics(choices, chosen, usual);
}

void LayerRow::syncSettings() {
  if (!settings_) return;
  const bool any = scene::specOf(layer_).traits().any() || !topics_.isEmpty() || !topic_.isEmpty();
  const bool offered = any && reason_.isEmpty();
  if (!offered) settings_->setChecked(false);
  settings_->setVisible(offered);
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
  if (!press_ || !(event->buttons() & Qt::LeftButton) || scene::specOf(layer_).order_fixed ||
      !reason_.isEmpty())
    return;
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

void EyeButton::mouseReleaseEvent(QMouseEvent* event) {
  const bool alone = event->button() == Qt::LeftButton && event->modifiers() & Qt::AltModifier && isDown() &&
                     hitButton(event->position().toPoint());
  if (!alone) return QToolButton::mouseReleaseEvent(event);
  setDown(false);
  Q_EMIT soloWanted();
}

OpacitySlider::OpacitySlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, 100);
  setPageStep(10);
  setFixedSize(46, 18);
  setFocusPolicy(Qt::TabFocus);
  setToolTip(tr("Opacity"));
}

void OpacitySlider::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(hasFocus() ? colors.focus : colors.border);
  painter.setBrush(isEnabled() ? colors.base : colors.window);
  painter.drawRoundedRect(box, 3, 3);
  if (value() > 0 && isEnabled()) {
    QColor fill = colors.accent;
    fill.setAlpha(colors.dark ? 110 : 60);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(
        QRectF(box.left() + 1, box.top() + 1, (box.width() - 2) * value() / 100.0, box.height() - 2), 2, 2);
  }
  painter.setPen(isEnabled() ? colors.text : palette().color(QPalette::Disabled, QPalette::WindowText));
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.88);
  painter.setFont(small);
  painter.drawText(rect(), Qt::AlignCenter, tr("%1 %").arg(value()));
}

void OpacitySlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) follow(event->position());
}

void OpacitySlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) follow(event->position());
}

// The list scrolls; the wheel must not change the slider under the cursor.
void OpacitySlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

void OpacitySlider::follow(const QPointF& at) {
  setValue(qRound(100.0 * (at.x() - 1.5) / qMax(1, width() - 3)));
}

LayerStyleEditor::LayerStyleEditor(scene::MapScene* scene, scene::Layer layer, QWidget* parent)
    : QWidget(parent), scene_(scene), layer_(layer) {
  const scene::LayerTraits traits = scene::specOf(layer).traits();
  auto* form = new QFormLayout(this);
  form->setContentsMargins(31, 2, 8, 6);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  if (traits.color) {
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    color_ = new QToolButton(this);
    color_->setIconSize({36, 14});
    color_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    color_->setAccessibleName(tr("Colour of %1").arg(scene::layerTitle(layer)));
    color_reset_ = new QToolButton(this);
    color_reset_->setIcon(themedIcon(QStringLiteral("reset")));
    color_reset_->setIconSize({14, 14});
    color_reset_->setToolTip(tr("Reset to the theme's colour"));
    line->addWidget(color_);
    line->addWidget(color_reset_);
    line->addStretch();
    form->addRow(tr("Colour"), line);
    connect(color_, &QToolButton::clicked, this, &LayerStyleEditor::askForColor);
    connect(color_reset_, &QToolButton::clicked, this, [this] { setColor({}); });
  }
  if (traits.size_px) {
    size_ = new DecimalBox(this);
    size_->setRange(traits.size_px->first, traits.size_px->second);
    size_->setDecimals(1);
    size_->setSingleStep(0.5);
    size_->setSuffix(QStringLiteral(" px"));
    form->addRow(traits.size_title, size_);
    connect(size_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
      scene::LayerStyle style = scene_->layerStyle(layer_);
      style.size = value;
      scene_->setLayerStyle(layer_, style);
    });
  }
  if (!traits.choices.isEmpty()) {
    choice_ = new QComboBox(this);
    choice_->addItems(traits.choices);
    choice_->setMinimumContentsLength(8);
    form->addRow(traits.choice_title, choice_);
    connect(choice_, &QComboBox::activated, this, [this](int index) {
      scene::LayerStyle style = scene_->layerStyle(layer_);
      style.choice = index;
      scene_->setLayerStyle(layer_, style);
    });
  }
  if (scene::chosenStream(layer)) {
    topic_ = new QComboBox(this);
    topic_->setMinimumContentsLength(8);
    topic_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    topic_->setAccessibleName(tr("Topic of %1").arg(scene::layerTitle(layer)));
    form->addRow(tr("Topic"), topic_);
    connect(topic_, &QComboBox::activated, this,
            [this](int index) { Q_EMIT topicChosen(topic_->itemData(index).toString()); });
    setTopics({}, {}, {});
  }
  sync();
}

void LayerStyleEditor::setTopics(const QStringList& choices, const QString& chosen, const QString& usual) {
  if (!topic_) return;
  topic_->clear();
  const QString as_usual = tr("Default");
  topic_->addItem(
      chosen.isEmpty() && !usual.isEmpty() ? tr("Default (%1)").arg(words::plainName(usual)) : as_usual,
      QString());
  QStringList all = choices;
  if (!chosen.isEmpty() && !all.contains(chosen)) all.prepend(chosen);  // it may still appear
  for (const QString& topic : all) topic_->addItem(words::plainName(topic), topic);
  topic_->setCurrentIndex(std::max(0, topic_->findData(chosen)));
  topic_->setToolTip(plainToolTip(chosen.isEmpty() ? usual : chosen));
  static_cast<QFormLayout*>(layout())->setRowVisible(topic_, !all.isEmpty());
}

void LayerStyleEditor::sync() {
  const scene::LayerStyle& style = scene_->layerStyle(layer_);
  if (color_) {
    const UiColors colors = appColors();
    const bool own = style.color.isValid();
    color_->setIcon(swatch(own ? style.color : QColor(Qt::transparent), colors.neutral));
    color_->setText(own ? style.color.name() : QStringLiteral("theme"));
    color_reset_->setVisible(own);
  }
  if (size_) {
    const QSignalBlocker quiet(size_);
    size_->setValue(style.size > 0 ? style.size : scene::specOf(layer_).traits().default_size_px);
  }
  if (choice_) choice_->setCurrentIndex(style.choice);
}

void LayerStyleEditor::setColor(const QColor& color) {
  scene::LayerStyle style = scene_->layerStyle(layer_);
  style.color = color;
  scene_->setLayerStyle(layer_, style);
}

void LayerStyleEditor::askForColor() {
  if (dialog_) {
    dialog_->raise();
    return;
  }
  const scene::LayerStyle before = scene_->layerStyle(layer_);
  dialog_ = new QColorDialog(before.color.isValid() ? before.color : QColor(Qt::red), this);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  dialog_->setOption(QColorDialog::DontUseNativeDialog);
  dialog_->setWindowTitle(tr("Colour of %1").arg(scene::layerTitle(layer_)));
  connect(dialog_, &QColorDialog::currentColorChanged, this, &LayerStyleEditor::setColor);
  connect(dialog_, &QDialog::rejected, this, [this, before] { setColor(before.color); });
  dialog_->open();
}

}  // namespace mapwright::ui

#include "moc_layer_row.cpp"
