// Mouse and keyboard input on the map: clicks, drags, keys. A tool gets positions in world metres and
// viewport pixels; drags that it does not take pan the map.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QString>

class QPainter;

namespace mapwright::ui {

/// The cursor position and modifiers.
struct MapPoint {
  Eigen::Vector2d world_m{0, 0};
  QPointF px;  // of the viewport
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

struct MapKeyPress {
  int key = 0;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  bool repeats = false;  // auto-repeat of a held key
};

class MapTool : public QObject {
  Q_OBJECT
 public:
  /// Objects within this distance of the cursor are hit.
  static constexpr double kReachPx = 9;

  using QObject::QObject;

  virtual QString name() const = 0;  // as remembered in the settings
  virtual QCursor cursor() const { return Qt::CrossCursor; }
  /// Every press counts, however fast it follows the previous one: there are no double clicks.
  virtual bool takesEveryPress() const { return false; }
  virtual void activate() {}
  virtual void deactivate() {}

  /// The left button was pressed. True: a following drag belongs to the tool; otherwise it pans.
  virtual bool pressed(const MapPoint& /*at*/) { return false; }
  /// A drag of the tool; first called after the cursor has moved a few pixels.
  virtual void dragged(const MapPoint& /*at*/) {}
  /// The drag ended.
  virtual void released(const MapPoint& /*at*/) {}
  /// The drag was cancelled (another window or tool).
  virtual void dragCancelled() {}
  /// Pressed and released at one position, whether or not the tool took the press.
  virtual void clicked(const MapPoint& /*at*/) {}
  virtual void hovered(const MapPoint& /*at*/) {}
  virtual void left() {}  // the cursor left the map
  /// True if the tool handled the double click; otherwise the map centres there and zooms in.
  virtual bool doubleClicked(const MapPoint& /*at*/) { return false; }
  /// True when the tool took the key.
  virtual bool keyPressed(const MapKeyPress& /*press*/) { return false; }
  /// True if the tool takes this key before the menus do.
  virtual bool claims(const MapKeyPress& /*press*/) const { return false; }
  /// Paints over the map, in viewport pixels; triggered by changed(). Only what lies in the clip of the
  /// painter is seen.
  virtual void paint(QPainter& /*painter*/) {}
  /// Where names of the map would lie below what it paints and can be dragged; viewport pixels.
  virtual std::vector<QRectF> covered() const { return {}; }
  /// One line about the state of the tool and the possible actions; empty = none.
  virtual QString hint() const { return {}; }

 Q_SIGNALS:
  void hintChanged();
  void changed();   // what it paints, or its cursor
  void finished();  // the tool is done: back to panning

 protected:
  /// What it paints and its hint are others now.
  void notifyChanged() {
    Q_EMIT changed();
    Q_EMIT hintChanged();
  }
};

/// The initial tool: only drags; others handle its clicks.
class PanTool : public MapTool {
  Q_OBJECT
 public:
  using MapTool::MapTool;
  QString name() const override { return QStringLiteral("pan"); }
  QCursor cursor() const override { return Qt::ArrowCursor; }
  void clicked(const MapPoint& at) override { Q_EMIT clickedAt(at); }

 Q_SIGNALS:
  void clickedAt(const mapwright::ui::MapPoint& at);
};

}  // namespace mapwright::ui
