// A robot whose data come from two servers: what stands in the way of the second one. The first one is
// Robot::connection().
#pragma once

#include <optional>

#include "robot/robot.h"

namespace mapwright::robot {

/// Called on the thread that made the robot.
class SecondServer {
 public:
  virtual ~SecondServer() = default;
  /// "10.0.0.7:9090"; empty = there is none.
  virtual QString hostBeside() const = 0;
  /// Its certificate, where that is not accepted; nullopt = that is not what is wrong. Another one is told by
  /// Robot::connectionChanged().
  virtual std::optional<UntrustedCertificate> certificateBeside() const = 0;
  /// From now on exactly the certificate with this SHA-256 ("AB:CD:…") is accepted there, and no other;
  /// connects where that is wanted.
  virtual void trustBeside(const QString& sha256) = 0;
};

/// null: it has no second server.
inline SecondServer* secondServerOf(Robot& robot) { return dynamic_cast<SecondServer*>(&robot); }

}  // namespace mapwright::robot
