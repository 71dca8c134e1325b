// What a click on the map does. Dragging pans with every tool; a tool only gets clicks, hovering and its
// keys.
#pragma once

#include <Eigen/Core>
#include <QCursor>
#include <QObject>
#include <QString>

namespace mapwright::window {

class MapTool : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  virtual QString name() const = 0;  // as remembered in the settings
  virtual QCursor cursor() const = 0;
  virtual void activate() {}
  virtual void deactivate() {}
  virtual void clicked(const Eigen::Vector2d& /*world_m*/) {}
  virtual void hovered(const Eigen::Vector2d& /*world_m*/) {}
  virtual void left() {}  // the cursor left the map
  /// True when the tool took the double click; else the map centres there and zooms in.
  virtual bool doubleClicked(const Eigen::Vector2d& /*world_m*/) { return false; }
  /// True when the tool took the key.
  virtual bool keyPressed(int /*key*/) { return false; }
  /// One line on what is going on and what can be done; empty = nothing to say.
  virtual QString hint() const { return {}; }

 Q_SIGNALS:
  void hintChanged();
  void finished();  // the tool has nothing more to do: back to panning
};

/// The tool to start with: only drags; what a click means is for others to say.
class PanTool : public MapTool {
  Q_OBJECT
 public:
  using MapTool::MapTool;
  QString name() const override { return QStringLiteral("pan"); }
  QCursor cursor() const override { return Qt::ArrowCursor; }
  void clicked(const Eigen::Vector2d& world_m) override { Q_EMIT clickedAt(world_m); }

 Q_SIGNALS:
  void clickedAt(const Eigen::Vector2d& world_m);
};

}  // namespace mapwright::window
