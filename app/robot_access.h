// Credentials for robots: secrets and certificates, from files or the environment, never from an argument
// (docs/command-line.md, "Addresses").
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QString>
#include <tl/expected.hpp>

#include "net/secret.h"
#include "net/trust.h"
#include "robot/robot.h"

namespace mapwright::app {

/// The options as typed.
struct AccessArguments {
  std::string secret_file;                                            // of the robot of --robot
  std::vector<std::pair<std::string, std::string>> secret_files_for;  // address and file, of other robots
  std::string ca_file;
};

/// The content of `file` without surrounding blanks. The error is a sentence and never contains the secret.
tl::expected<QByteArray, QString> readSecret(const QString& file);

/// For one robot.
struct Access {
  QByteArray secret;
  net::Trust trust;
  /// Time limit for a long answer, if the user sets one (--timeout).
  std::optional<std::chrono::milliseconds> timeout = {};
};

/// Which secret goes to which robot. A secret belongs to one origin (scheme, host, port) and is never sent to
/// any other.
class RobotAccess {
 public:
  /// `robot`: what --secret-file belongs to. MAPWRIGHT_SECRET belongs to MAPWRIGHT_ROBOT if that is set,
  /// otherwise to `robot`; a file takes precedence. Reads all files. The error is a sentence and never
  /// contains a secret.
  static tl::expected<RobotAccess, QString> read(const AccessArguments& args, const QString& robot);
  Access forAddress(const QString& address) const;

 private:
  std::vector<net::Secret> secrets_;  // the first that belongs there
  net::Trust trust_;
};

/// Why there is no connection, with the options that may help.
QString notConnectedReason(const robot::ConnectionState& state);

}  // namespace mapwright::app
