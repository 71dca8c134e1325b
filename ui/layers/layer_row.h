// One layer in the list: eye, name, opacity, and a row of settings that can be expanded.
#pragma once

#include <QFrame>
#include <QPointer>
#include <QSlider>
#include <QToolButton>

#include "ui/scene/map_scene.h"

class QColorDialog;
class QComboBox;
class QDoubleSpinBox;

namespace mapwright::ui {

class PlainLabel;

/// A slider as high as a row, showing its percentage.
class OpacitySlider : public QSlider {
  Q_OBJECT
 public:
  explicit OpacitySlider(QWidget* parent = nullptr);
  QSize sizeHint() const override { return {46, 18}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void follow(const QPointF& at);
};

/// Shows or hides a layer; with Alt held it asks for that layer alone.
class EyeButton : public QToolButton {
  Q_OBJECT
 public:
  using QToolButton::QToolButton;

 Q_SIGNALS:
  void soloWanted();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
};

/// The settings of one layer: colour, size and choice, if it has them.
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

class LayerRow : public QFrame {
  Q_OBJECT
 public:
  LayerRow(scene::MapScene* scene, scene::Layer layer, QWidget* parent = nullptr);

  scene::Layer layer() const { return layer_; }
  QToolButton* eye() const { return eye_; }
  QSlider* opacity() const { return opacity_; }
  QToolButton* settings() const { return settings_; }   // null: there is nothing to set for any robot
  LayerStyleEditor* editor() const { return editor_; }  // null until expanded
  /// Shows what the scene says.
  void sync();
  /// With a reason there is nothing to set; empty = it is available.
  void setUnavailable(const QString& reason);
  QString unavailable() const { return reason_; }
  /// See LayerStyleEditor.
  void setTopics(const QStringList& choices, const QString& chosen, const QString& usual);

 Q_SIGNALS:
  /// The row is being dragged; `y` in the coordinates of the parent.
  void dragged(int y);
  void dropped();
  /// Up (towards the top of the map) is negative.
  void moveWanted(int rows);
  void focusWanted(int rows);
  void topicChosen(const QString& topic);
  /// This layer alone, or what was there before.
  void soloWanted();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void fold(bool out);
  void syncSettings();

  scene::MapScene* scene_;
  scene::Layer layer_;
  EyeButton* eye_;
  PlainLabel* name_;
  QSlider* opacity_;
  QToolButton* settings_ = nullptr;
  LayerStyleEditor* editor_ = nullptr;
  QString reason_;
  QStringList topics_;
  QString topic_, usual_topic_;
  std::optional<bool> shown_;
  std::optional<QPoint> press_;
  bool dragging_ = false;
};

}  // namespace mapwright::ui
