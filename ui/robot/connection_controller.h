// Which robot the window is connected to, and the state of the connection.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QByteArray>
#include <QSet>
#include <QTimer>
#include <tl/expected.hpp>

#include "robot/robot.h"
#include "ui/kit/controller.h"
#include "ui/kit/safety_badge.h"
#include "ui/robot/connect_dialog.h"
#include "ui/robot/kept_secrets.h"
#include "ui/robot/recent_robots.h"
#include "ui/shell/window_context.h"

class QMenu;

namespace mapwright::ui {

class ConnectionChip;
enum class CardOffer;

class ConnectionController : public Controller {
  Q_OBJECT
 public:
  /// Makes a robot, not yet connected, from an address (also "demo:"). The error is a sentence.
  using Connect = std::function<tl::expected<std::unique_ptr<robot::Robot>, QString>(
      const QString& address, const QByteArray& secret)>;
  /// What it is done with. Everything outlives this.
  struct Means {
    Connect connect;
    ConnectDialog::Probes probes = {};  // null: nobody is looked for
    keyring::KeyRing* keys = nullptr;   // null: secrets are not kept
    /// A secret for this address came with the program's start: it goes before a kept one.
    std::function<bool(const QString& address)> has_secret = {};
  };

  ConnectionController(WindowContext& context, Means means, QObject* parent = nullptr);

  /// Switches to another robot after unsaved changes are saved or discarded; the error is a sentence, and
  /// then nothing has changed.
  std::optional<QString> connectTo(const QString& address, const QByteArray& secret = {});
  /// A robot with this address, not yet connected, with the last secret typed for it. The error is a
  /// sentence.
  tl::expected<std::unique_ptr<robot::Robot>, QString> another(const QString& address) const;
  /// Addresses of recent robots, and what these are called.
  std::vector<std::pair<QString, QString>> named() const;
  /// Errors are shown as a toast.
  void goTo(const QString& address);
  /// The same, with the secret and the name that it had before a replay.
  void goBackTo(const QString& address);
  /// Errors stay above the map.
  void startWith(const QString& address);
  /// Reconnects, and repeats all requests that failed.
  void retry();

  ConnectionChip* chip() const { return chip_; }
  ConnectDialog* secretDialog() const;  // null: not open
  void setSafety(const SafetyText& text);
  /// That the robot begins anew is no surprise, and `sentence` is said of it (empty: nothing).
  void expectSession(const std::optional<QString>& sentence) { expected_ = sentence; }
  void setSession(session::Session* session) override;

 Q_SIGNALS:
  void fileWanted();

 private:
  void addActions();
  void fillChipMenu(QMenu& menu);
  void addRecents(QMenu& menu, bool files, const QString& title);
  std::optional<QString> connectAs(const ConnectDialog::Wish& wish);
  std::optional<QString> connectWith(const QString& address, const QByteArray& secret, const RobotLook& look);
  void begin(std::unique_ptr<robot::Robot> robot, const RobotLook& look);
  /// Keeps what has worked: the address, its name and colour, perhaps its secret.
  void onWorks();
  void askToKeepSecret(const QString& address);
  void forget(const QString& address);
  void editLook();
  void showLook();
  void leave();
  void acceptOffer(CardOffer offer);
  void openDialog();
  void enterSecret();
  void openCertificate();
  /// That of the robot's second server, if it is a problem.
  std::optional<robot::UntrustedCertificate> certificateBeside() const;
  void storeSettings();
  void saveIdentity();
  void updateRestart();
  void refresh();
  void refreshChip();
  void refreshNotices();

  WindowContext& context_;
  Means means_;
  RecentRobots recents_;
  KeptSecrets secrets_;
  QString unproven_;  // an address that has not worked yet
  RobotLook look_;    // the user's, of the present one
  bool typed_secret_ = false;
  int attempts_ = 0;  // to connect: a late answer of the key ring belongs to an earlier one
  ConnectionChip* chip_ = nullptr;
  QAction *retry_ = nullptr, *disconnect_ = nullptr, *look_action_ = nullptr;
  QAction *close_file_ = nullptr, *read_again_ = nullptr;
  QTimer stale_tick_;  // while the connection is lost
  SafetyText safety_;
  QString last_uuid_;
  std::optional<QString> expected_;
  QString secret_of_;           // an address
  QByteArray secret_;           // was typed for it
  bool settings_told_ = false;  // it was reported that they cannot be saved
};

}  // namespace mapwright::ui
