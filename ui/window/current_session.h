// The robot that the window is connected to, if any.
#pragma once

#include <memory>

#include <QObject>
#include <QString>

#include "session/session.h"

namespace mapwright::scene {
class MapScene;
}

namespace mapwright::window {

class CurrentSession : public QObject {
  Q_OBJECT
 public:
  /// The scene must outlive this.
  CurrentSession(scene::MapScene& scene, session::Session::Options options, QObject* parent = nullptr);
  ~CurrentSession() override;

  /// null = none.
  session::Session* session() const { return session_.get(); }
  QString address() const;  // empty = none

  /// Leaves the present robot, shows this one and connects to it.
  void begin(std::unique_ptr<robot::Robot> robot);
  void leave();

 Q_SIGNALS:
  /// Null: the last one is about to end, and session() is null already.
  void changed(session::Session* session);
  /// How things stand has changed: link, identity, list, rows, maps or the visible layers; or the session has
  /// come or gone. What tells about it is to be put anew.
  void stateChanged();

 private:
  void watch();

  scene::MapScene& scene_;
  session::Session::Options options_;
  std::unique_ptr<session::Session> session_;
};

}  // namespace mapwright::window
