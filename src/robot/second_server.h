// A robot whose data comes from two servers: problems of the second one. Robot::connection() is about the
// first one.
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
  /// Its certificate, if that was rejected; nullopt = that is not the problem. Robot::connectionChanged()
  /// reports changes.
  virtual std::optional<UntrustedCertificate> certificateBeside() const = 0;
  /// From now on only the certificate with this SHA-256 ("AB:CD:…") is accepted there; connects if wanted.
  virtual void trustBeside(const QString& sha256) = 0;
};

/// null: it has no second server.
inline SecondServer* secondServerOf(Robot& robot) { return dynamic_cast<SecondServer*>(&robot); }

}  // namespace mapwright::robot
