// The layers of the map: which are drawn, in which order, how strongly and how.
#pragma once

#include <vector>

#include <QDockWidget>
#include <QPointer>

#include "robot/offers_topics.h"
#include "scene/map_scene.h"

class QScrollArea;
class QSlider;
class QToolButton;
class QVBoxLayout;

namespace mapwright::window {

class LayerRow;

/// The list matches the map: the top layer is at the top. Rows are moved by dragging, or with Ctrl+Up and
/// Ctrl+Down.
class LayersDock : public QDockWidget {
  Q_OBJECT
 public:
  explicit LayersDock(scene::MapScene* scene, QWidget* parent = nullptr);
  /// Layers without data from this robot are greyed. Null: no robot.
  void setSession(session::Session* session);
  /// Shows what the scene says.
  void sync();

  LayerRow* row(scene::Layer layer) const;
  QToolButton* eye(scene::Layer layer) const;
  QSlider* opacity(scene::Layer layer) const;

 Q_SIGNALS:
  /// The user wants other topics from this robot.
  void topicsChosen(const mapwright::robot::TopicChoices& choices);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void noteAvailability();
  void noteTopics(LayerRow* row);
  void chooseTopic(map::Stream stream, const QString& topic);
  void place();
  void drag(LayerRow* row, int y);
  void commit();
  void move(LayerRow* row, int rows);
  void focusNext(LayerRow* row, int rows);

  scene::MapScene* scene_;
  QPointer<session::Session> session_;
  std::vector<LayerRow*> rows_;  // as on screen, top first
  QScrollArea* scroll_;
  QWidget* body_;
  QVBoxLayout* column_;
  bool dragging_ = false;
};

}  // namespace mapwright::window
