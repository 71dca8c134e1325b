#include "ui/layers/layer_style_editor.h"

#include <algorithm>

#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

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

LayerStyleEditor::LayerStyleEditor(scene::MapScene* scene, scene::Layer layer, QWidget* parent)
    : QWidget(parent), scene_(scene), layer_(layer) {
  const scene::LayerTraits traits = scene::layerTraits(layer);
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
    size_ = new QDoubleSpinBox(this);
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
    size_->setValue(style.size > 0 ? style.size : scene::layerTraits(layer_).default_size_px);
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

}  // namespace mapwright::window

#include "moc_layer_style_editor.cpp"
