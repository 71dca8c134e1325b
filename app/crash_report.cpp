#include "app/crash_report.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <execinfo.h>
#include <unistd.h>

#include <QCoreApplication>

#include "app/command_text.h"

namespace mapwright::app {
namespace {

constexpr int kMostCalls = 64;
constexpr unsigned kMostSeconds = 5;

// Nothing can be translated, or allocated, once it has crashed.
std::array<char, 512> crash_sentence;
std::size_t crash_sentence_bytes = 0;

void writeToStderr(const char* text, std::size_t bytes) {
  if (::write(STDERR_FILENO, text, bytes) < 0) return;  // nowhere to write to
}

void onCrash(int signal) {
  // Whatever is broken may hold a lock that is needed here.
  ::alarm(kMostSeconds);
  std::array<void*, kMostCalls> calls{};
  const int count = ::backtrace(calls.data(), kMostCalls);
  writeToStderr(crash_sentence.data(), crash_sentence_bytes);
  ::backtrace_symbols_fd(calls.data(), count, STDERR_FILENO);
  ::raise(signal);  // with its default action, see SA_RESETHAND
}

}  // namespace

void reportCrashes() {
  const QByteArray words =
      Text::tr("mapwright crashed. Please report it together with the lines that follow:").toUtf8() + '\n';
  crash_sentence_bytes = std::min(crash_sentence.size(), std::size_t(words.size()));
  std::copy_n(words.constData(), crash_sentence_bytes, crash_sentence.data());
  // The first call loads a library.
  std::array<void*, 1> call{};
  ::backtrace(call.data(), 1);
  struct sigaction action {};
  action.sa_handler = &onCrash;
  action.sa_flags = SA_RESETHAND | SA_NODEFER;
  ::sigaction(SIGABRT, &action, nullptr);
#ifndef __SANITIZE_ADDRESS__  // which reports these itself
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) ::sigaction(signal, &action, nullptr);
#endif
}

}  // namespace mapwright::app
