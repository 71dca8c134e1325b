#include "app/simulate.h"

#include <csignal>
#include <cstdio>
#include <pthread.h>

#include "app/exit_code.h"
#include "words/plain.h"

namespace mapwright::app {

int simulate(const simulator::Options& options) {
  // Blocked before any thread starts, so that they arrive at sigwait() and nowhere else.
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
  std::printf("{\"axbot\":\"%s\",\"aimdk\":\"%s\"}\n", robot.address().c_str(), robot.aimdkAddress().c_str());
  std::fflush(stdout);
  int received = 0;
  sigwait(&stop_signals, &received);
  robot.stop();
  return kDone;
}

}  // namespace mapwright::app
