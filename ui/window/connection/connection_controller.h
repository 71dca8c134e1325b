// Which robot the window is connected to, and how that stands.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QSet>
#include <QTimer>
#include <tl/expected.hpp>

#include "robot/robot.h"
#include "window/controller.h"
#include "window/dialogs/recent_robots.h"
#include "window/status/safety_text.h"
#include "window/window_context.h"

namespace mapwright::window {

class ConnectDialog;
class ConnectionChip;
class RobotMenus;

class ConnectionController : public Controller {
  Q_OBJECT
 public:
  /// Makes a robot, not yet connected, from an address (also "demo:"). The error is a sentence.
  using Connect = std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(
      const QString& address, const QByteArray& secret)>;

  ConnectionController(WindowContext& context, Connect make_robot, QObject* parent = nullptr);

  /// Leaves the present robot and goes to another, once what is not saved is saved or let go of; the error is
  /// a sentence, then everything stays as it was.
  std::optional<QString> connectTo(const QString& address, const QByteArray& secret = {});
  /// A robot of this address, not yet connected, with the secret that was typed for it last. The error is a
  /// sentence.
  tl::expected<std::unique_ptr<robot::Robot>, QString> another(const QString& address) const;
  /// What went wrong becomes a toast.
  void goTo(const QString& address);
  /// What went wrong stays above the map.
  void startWith(const QString& address);
  /// Reconnects, and asks again for everything that failed.
  void retry();

  ConnectionChip* chip() const { return chip_; }
  ConnectDialog* secretDialog() const;  // null: not open
  void setSafety(const SafetyText& text);
  void setSession(session::Session* session) override;

 Q_SIGNALS:
  void fileWanted();

 private:
  void addActions();
  void begin(std::unique_ptr<robot::Robot> robot, const QString& address);
  void leave();
  void wireCard();
  void openDialog();
  void enterSecret();
  void openCertificate();
  /// That of the robot's second server, if any is in the way.
  std::optional<robot::UntrustedCertificate> certificateBeside() const;
  void noteSettings();
  void noteIdentity();
  void noteRestart();
  void refresh();
  void refreshChip();
  void refreshNotices();

  WindowContext& context_;
  Connect make_robot_;
  RecentRobots recents_;
  RobotMenus* menus_;
  ConnectionChip* chip_ = nullptr;
  QAction *retry_ = nullptr, *disconnect_ = nullptr;
  QTimer stale_tick_;  // while the connection is lost
  SafetyText safety_;
  QString last_uuid_;
  QString secret_of_;           // an address
  QByteArray secret_;           // was typed for it
  bool settings_told_ = false;  // that they cannot be kept
};

}  // namespace mapwright::window
