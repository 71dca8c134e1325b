// What the hand does on the map: clicks, drags, keys. A tool gets every point in world metres and in viewport
// pixels; a drag that it does not take pans.
#pragma once

#include <Eigen/Core>
#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QString>

class QPainter;

namespace mapwright::window {

/// Where the hand is, and which modifiers it holds.
struct MapPoint {
  Eigen::Vector2d world_m{0, 0};
  QPointF px;  // of the viewport
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

struct MapKeyPress {
  int key = 0;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  bool repeats = false;  // it is still held
};

class MapTool : public QObject {
  Q_OBJECT
 public:
  /// Things are hit when they are no farther than this from the hand.
  static constexpr double kReachPx = 9;

  using QObject::QObject;

  virtual QString name() const = 0;  // as remembered in the settings
  virtual QCursor cursor() const = 0;
  /// Every press begins something, however quickly it follows the one before: there are no double clicks.
  virtual bool takesEveryPress() const { return false; }
  virtual void activate() {}
  virtual void deactivate() {}

  /// The left button went down. True: what follows, if it becomes a drag, is the tool's; else it pans.
  virtual bool pressed(const MapPoint& /*at*/) { return false; }
  /// A drag that the tool took goes on; its first word comes when the hand has moved a few pixels.
  virtual void dragged(const MapPoint& /*at*/) {}
  /// It ends here.
  virtual void released(const MapPoint& /*at*/) {}
  /// It ends without having been (another window came, another tool).
  virtual void dragCancelled() {}
  /// Pressed and let go in one place, whether the tool took the press or not.
  virtual void clicked(const MapPoint& /*at*/) {}
  virtual void hovered(const MapPoint& /*at*/) {}
  virtual void left() {}  // the cursor left the map
  /// True when the tool took the double click; else the map centres there and zooms in.
  virtual bool doubleClicked(const MapPoint& /*at*/) { return false; }
  /// True when the tool took the key.
  virtual bool keyPressed(const MapKeyPress& /*press*/) { return false; }
  /// Paints over the map, in viewport pixels; changed() asks for it.
  virtual void paint(QPainter& /*painter*/) {}
  /// One line on what is going on and what can be done; empty = nothing to say.
  virtual QString hint() const { return {}; }

 Q_SIGNALS:
  void hintChanged();
  void changed();   // what it paints, or its cursor
  void finished();  // the tool has nothing more to do: back to panning
};

/// The tool to start with: only drags; what a click means is for others to say.
class PanTool : public MapTool {
  Q_OBJECT
 public:
  using MapTool::MapTool;
  QString name() const override { return QStringLiteral("pan"); }
  QCursor cursor() const override { return Qt::ArrowCursor; }
  void clicked(const MapPoint& at) override { Q_EMIT clickedAt(at.world_m); }

 Q_SIGNALS:
  void clickedAt(const Eigen::Vector2d& world_m);
};

}  // namespace mapwright::window
