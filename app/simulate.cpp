#include "app/simulate.h"

#include <csignal>
#include <cstdio>
#include <pthread.h>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/robot_access.h"
#include "words/plain.h"

namespace mapwright::app {
namespace {

class SimulateText {
  Q_DECLARE_TR_FUNCTIONS(Simulate)
};

}  // namespace

int simulate(const SimulateWords& words) {
  simulator::Options options = words.options;
  // MAPWRIGHT_SECRET is for clients: only a file makes this robot require a secret.
  if (!words.secret_file.empty()) {
    const auto secret = readSecret(QString::fromStdString(words.secret_file));
    if (!secret || secret->isEmpty()) {
      const QString why = secret ? SimulateText::tr("The secret file %1 holds no secret.")
                                       .arg(QString::fromStdString(words.secret_file))
                                 : secret.error();
      std::fprintf(stderr, "%s\n", qUtf8Printable(why));
      return kUsage;
    }
    options.secret = secret->toStdString();
  }
  // Blocked before any thread starts, so that they only arrive at sigwait().
  sigset_t stop_signals;
  sigemptyset(&stop_signals);
  sigaddset(&stop_signals, SIGINT);
  sigaddset(&stop_signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &stop_signals, nullptr);

  simulator::Simulator robot(options);
  if (const auto error = robot.start()) {
    std::fprintf(stderr, "%s\n", words::plainLine(*error).c_str());
    return kUnreachable;
  }
  const std::string rep130 =
      options.ros.dispatcher.there ? R"(,"rep130":")" + robot.rep130Address() + '"' : std::string();
  std::printf(R"({"axbot":"%s","aimdk":"%s","ros":"%s","kabam":"%s"%s})"
              "\n",
              robot.address().c_str(), robot.aimdkAddress().c_str(), robot.rosAddress().c_str(),
              robot.kabamAddress().c_str(), rep130.c_str());
  std::fflush(stdout);
  int received = 0;
  sigwait(&stop_signals, &received);
  robot.stop();
  return kDone;
}

}  // namespace mapwright::app
