#include "app/connecting.h"

#include <cmath>

#include <QCoreApplication>
#include <QTimer>

#include "app/exit_code.h"
#include "app/robot_access.h"

namespace mapwright::app {
namespace {

class ConnectingTexts {
  Q_DECLARE_TR_FUNCTIONS(Connecting)
};

}  // namespace

std::optional<CommandFailure> connectWithin(robot::Robot& robot, double timeout_s, QEventLoop& loop) {
  const auto phase = [&] { return robot.connection().phase; };
  const auto settled = [&] {
    return phase() == robot::ConnectionPhase::Online || phase() == robot::ConnectionPhase::Refused;
  };
  bool too_late = false;
  QObject waiting;
  QObject::connect(&robot, &robot::Robot::connectionChanged, &waiting, [&] {
    if (settled()) loop.quit();
  });
  QTimer::singleShot(std::chrono::milliseconds(std::llround(timeout_s * 1000)), &waiting, [&] {
    too_late = true;
    loop.quit();
  });
  robot.connectToRobot();
  if (!settled()) loop.exec();
  if (phase() == robot::ConnectionPhase::Online || (!settled() && !too_late)) return std::nullopt;
  const robot::ConnectionState state = robot.connection();
  if (state.reason.any()) return CommandFailure{kUnreachable, whyNotConnected(state)};
  return CommandFailure{kUnreachable,
                        ConnectingTexts::tr("No connection within %1 s (--timeout).").arg(timeout_s)};
}

}  // namespace mapwright::app
