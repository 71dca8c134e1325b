// The settings of one layer: colour, size and choice, if it has them.
#pragma once

#include <QPointer>
#include <QWidget>

#include "scene/map_scene.h"

class QColorDialog;
class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace mapwright::window {

class LayerStyleEditor : public QWidget {
  Q_OBJECT
 public:
  LayerStyleEditor(scene::MapScene* scene, scene::Layer layer, QWidget* parent = nullptr);
  void sync();
  /// Null if the layer has no such setting.
  QToolButton* colorButton() const { return color_; }
  QDoubleSpinBox* sizeBox() const { return size_; }
  QComboBox* choiceBox() const { return choice_; }
  QComboBox* topicBox() const { return topic_; }
  /// The topics to choose from; none: no choice. `chosen`, empty: the default one, whose name is `usual`
  /// (empty: none).
  void setTopics(const QStringList& choices, const QString& chosen, const QString& usual);
  void setColor(const QColor& color);  // invalid: the theme's

 Q_SIGNALS:
  void topicChosen(const QString& topic);  // empty: as usual

 private:
  void askForColor();

  scene::MapScene* scene_;
  scene::Layer layer_;
  QToolButton *color_ = nullptr, *color_reset_ = nullptr;
  QDoubleSpinBox* size_ = nullptr;
  QComboBox* choice_ = nullptr;
  QComboBox* topic_ = nullptr;
  QPointer<QColorDialog> dialog_;
};

}  // namespace mapwright::window
