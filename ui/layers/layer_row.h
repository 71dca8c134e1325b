// One layer in the list: eye, name, opacity, and a row of settings that can be expanded.
#pragma once

#include <QFrame>

#include "scene/map_scene.h"

class QSlider;
class QToolButton;

namespace mapwright::window {

class LayerStyleEditor;
class PlainLabel;

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
  /// A reason greys the row; empty = it is available.
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

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void fold(bool out);

  scene::MapScene* scene_;
  scene::Layer layer_;
  QToolButton* eye_;
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

}  // namespace mapwright::window
