// The robot that the window is connected to, if any.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "robot/address.h"
#include "session/session.h"

namespace mapwright::ui::scene {
class MapScene;
}

namespace mapwright::ui {

class CurrentSession : public QObject {
  Q_OBJECT
 public:
  /// The scene must outlive this.
  CurrentSession(scene::MapScene& scene, session::Session::Options options, robot::Addresses addresses = {},
                 QObject* parent = nullptr);
  ~CurrentSession() override;

  /// null = none.
  session::Session* session() const { return session_.get(); }
  QString address() const;  // empty = none
  /// Of what was open before the replay, or before the present robot; empty = none.
  const QString& addressBefore() const { return before_replay_; }
  /// By the user's name, if there is one, else as it calls itself, else its host. Empty = none; one line of
  /// plain text.
  QString called() const;
  /// The user's name for it; empty = none. Until another one begins.
  void setCalled(const QString& by_user);

  /// Leaves the present robot, shows this one and connects to it.
  void begin(std::unique_ptr<robot::Robot> robot);
  void leave();

 Q_SIGNALS:
  /// Null: the last one is about to end, and session() is already null.
  void changed(session::Session* session);
  /// Something has changed: connection, identity, list, rows, maps or the visible layers; or the session was
  /// replaced. Update everything that shows it.
  void stateChanged();

 private:
  void watch();

  scene::MapScene& scene_;
  const std::unique_ptr<session::Session::Options> options_;
  robot::Addresses addresses_;
  std::unique_ptr<session::Session> session_;
  QString called_, before_replay_;
};

/// For PanelPosition::idle: what is open has none of these, and nothing may still bring them.
std::function<bool()> lacksForGood(CurrentSession& current, std::vector<robot::Capability> capabilities);

}  // namespace mapwright::ui
