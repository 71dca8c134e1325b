#include "app/live_robot.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QTimer>

#include "app/command_text.h"
#include "app/language.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

sigset_t stopSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

std::chrono::milliseconds millis(double seconds) {
  return std::chrono::milliseconds(std::llround(seconds * 1000));
}

}  // namespace

int runLive(int& argc, char** argv, const std::function<CommandResult<int>()>& work) {
  // Before any thread starts.
  const sigset_t signals = stopSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  const InPlaceOfSpeaker own;
  const QCoreApplication application(argc, argv);
  const CommandResult<int> done = work();
  std::fflush(stdout);
  return done ? *done : refuse(done.error().exit_code, done.error().sentence);
}

CommandResult<std::unique_ptr<LiveRobot>> LiveRobot::make(const RobotArguments& args) {
  const QString address = words::text(args.robot);
  if (address.isEmpty()) return wrong(Text::tr("Which robot? Pass --robot ADDRESS."));
  const auto access = RobotAccess::read(args.access, address);
  if (!access) return wrong(access.error());
  auto robot = makeRobot(address, access->forAddress(address), DemoTime::Running);
  if (!robot) return wrong(robot.error());
  return std::unique_ptr<LiveRobot>(new LiveRobot(std::move(*robot), args.timeout_s));
}

LiveRobot::LiveRobot(std::unique_ptr<robot::Robot> robot, double timeout_s)
    : robot_(std::move(robot)), timeout_s_(timeout_s) {
  const sigset_t signals = stopSignals();
  signals_ = ::signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
  if (signals_ < 0) {
    // Otherwise they end the program as usual: a file then ends with the last chunk.
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    return;
  }
  notifier_ = std::make_unique<QSocketNotifier>(signals_, QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, &loop_, [this] {
    signalfd_siginfo info{};
    while (::read(signals_, &info, sizeof info) == ssize_t(sizeof info)) {
    }
    stopped_ = true;
    loop_.quit();
  });
}

LiveRobot::~LiveRobot() {
  notifier_.reset();
  if (signals_ >= 0) ::close(signals_);
}

std::optional<CommandFailure> LiveRobot::connectToRobot() {
  const auto phase = [&] { return robot_->connection().phase; };
  const auto settled = [&] {
    return phase() == robot::ConnectionPhase::Online || phase() == robot::ConnectionPhase::Refused;
  };
  bool too_late = false;
  QObject waiting;
  QObject::connect(robot_.get(), &robot::Robot::connectionChanged, &waiting, [&] {
    if (settled()) loop_.quit();
  });
  QTimer::singleShot(millis(timeout_s_), &waiting, [&] {
    too_late = true;
    loop_.quit();
  });
  robot_->connectToRobot();
  if (!settled()) loop_.exec();
  if (phase() == robot::ConnectionPhase::Online || (!settled() && !too_late)) return std::nullopt;
  const robot::ConnectionState state = robot_->connection();
  if (state.reason.any()) return CommandFailure{kUnreachable, notConnectedReason(state)};
  return CommandFailure{kUnreachable, Text::tr("%1: no connection within %2 s (--timeout).")
                                          .arg(oneLine(robot_->address()), QString::number(timeout_s_))};
}

void LiveRobot::follow(std::optional<double> seconds) {
  if (stopped_) return;
  QObject waiting;
  if (seconds) QTimer::singleShot(millis(*seconds), &waiting, [this] { loop_.quit(); });
  loop_.exec();
}

}  // namespace mapwright::app
