// A feature of the window: its dock, actions and tools, in its own folder. The window makes it and tells it
// about the robot; controllers do not know each other. Requests from one to another are signals that the
// window connects.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QObject>
#include <QSettings>

namespace mapwright::session {
class Session;
}

namespace mapwright::ui {

/// Data fetched from the robot that only exists on screen.
struct Fetched {
  QString name;  // "a cloud of 1,200 points"; plain text
  /// Asks for a file name. Calls `saved` once it is written; never if the user cancels or it fails.
  std::function<void(std::function<void()> saved)> save;
};

class Controller : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Another robot, or none (null). Do not touch data of the previous one afterwards. The scene already shows
  /// the new one, or still the old one.
  virtual void setSession(session::Session* /*session*/) {}
  /// Called once, when the window and all controllers exist.
  virtual void recall(const QSettings& /*settings*/) {}
  virtual void remember(QSettings& /*settings*/) {}
  /// Restores the original state: "Reset layout".
  virtual void reset() {}
  /// An unhandled Esc. True: something was left, and no other controller is asked.
  virtual bool escape() { return false; }

  /// Something would be lost if the present map were left.
  virtual bool unsaved() const { return false; }
  /// It can be saved now: no open decision or pending work prevents it.
  virtual bool maySave() const { return unsaved(); }
  /// Saves it, if there is anything.
  virtual void save() {}
  /// Data that is lost with the robot, although the user changed nothing. There is one question for all of
  /// it.
  virtual std::vector<Fetched> fetched() { return {}; }
  /// The present map is about to be left: calls `then` when that is allowed, at once if nothing is unsaved;
  /// otherwise asks first, and never calls it if the user wants to stay.
  virtual void beforeLeaving(std::function<void()> then) { then(); }
  /// The same when the robot is about to be left, with all of its maps.
  virtual void beforeLeavingRobot(std::function<void()> then) { beforeLeaving(std::move(then)); }

 Q_SIGNALS:
  void unsavedChanged();  // unsaved() or maySave()
};

}  // namespace mapwright::ui
