// A capability of the window: its dock, actions and tools, in a folder of its own. The window makes it and
// tells it which robot is there; controllers do not know each other. What one wants of another is a signal
// that the window connects.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QObject>
#include <QSettings>

#include "session/session.h"

namespace mapwright::window {

/// What was fetched of the robot, and is nowhere but on screen.
struct Fetched {
  QString name;  // "a cloud of 1,200 points"; plain text
  /// Asks where to. Calls `saved` once it is written; never when the user gives it up or it cannot be
  /// written.
  std::function<void(std::function<void()> saved)> save;
};

class Controller : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Another robot, or none (null). What belonged to the last one must not be touched afterwards. The scene
  /// shows it already, or still.
  virtual void setSession(session::Session* /*session*/) {}
  /// Once, when the window and all controllers are made.
  virtual void recall(const QSettings& /*settings*/) {}
  virtual void remember(QSettings& /*settings*/) {}
  /// Back to how it was at first: "Reset layout".
  virtual void reset() {}
  /// Esc that nothing else wanted. True: it was left, and nobody else is asked.
  virtual bool escape() { return false; }

  /// Something would be lost if the present map were left.
  virtual bool unsaved() const { return false; }
  /// It can be saved now: what stands in the way is none of what has to be decided or waited for first.
  virtual bool maySave() const { return unsaved(); }
  /// Saves it, if there is anything.
  virtual void save() {}
  /// What is lost with the robot, though nobody has changed anything. It is asked about together.
  virtual std::vector<Fetched> fetched() { return {}; }
  /// The present map is about to be left: calls `then` when it may be, at once where nothing is unsaved; else
  /// asks first, and never calls it when the user wants to stay.
  virtual void beforeLeaving(std::function<void()> then) { then(); }
  /// The robot is about to be left, and all of its maps.
  virtual void beforeLeavingRobot(std::function<void()> then) { beforeLeaving(std::move(then)); }

 Q_SIGNALS:
  void unsavedChanged();  // unsaved() or maySave()
};

}  // namespace mapwright::window
