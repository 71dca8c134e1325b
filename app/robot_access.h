// What robots are spoken to with: secrets and certificates, from files or the environment, never from an
// argument (docs/command-line.md, "Addresses").
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

/// The words of the command line.
struct AccessWords {
  std::string secret_file;                                            // of the robot of --robot
  std::vector<std::pair<std::string, std::string>> secret_files_for;  // address and file, of other robots
  std::string ca_file;
};

/// The content of `file` without surrounding blanks. The error is a sentence that never holds the secret.
tl::expected<QByteArray, QString> readSecret(const QString& file);

/// The words of a subcommand, whose robot is `robot`, with those given before it: their --secret-file belongs
/// to the robot named there, `outer_robot`.
AccessWords withOuter(AccessWords words, const std::string& robot, const AccessWords& outer,
                      const std::string& outer_robot);

/// For one robot.
struct Access {
  QByteArray secret;
  net::Trust trust;
  /// How long a long answer may take, where the user says (--timeout).
  std::optional<std::chrono::milliseconds> timeout = {};
};

/// Which secret goes to which robot. One belongs to one origin (scheme, host, port): every other address gets
/// none.
class RobotAccess {
 public:
  /// `robot`: what --secret-file belongs to. MAPWRIGHT_SECRET belongs to MAPWRIGHT_ROBOT where that is set,
  /// else to `robot`; a file goes before it. Every file is read. The error is a sentence that never holds a
  /// secret.
  static tl::expected<RobotAccess, QString> read(const AccessWords& words, const QString& robot);
  Access forAddress(const QString& address) const;

 private:
  std::vector<net::Secret> secrets_;  // the first that belongs there
  net::Trust trust_;
};

/// Why there is no connection, with what the command line offers to do about it.
QString whyNotConnected(const robot::ConnectionState& state);

}  // namespace mapwright::app
