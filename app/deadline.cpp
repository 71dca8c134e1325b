#include "app/deadline.h"

#include <cstdlib>
#include <unistd.h>
#include <utility>

namespace mapwright::app {

SteadyTime later(SteadyTime start, double seconds) {
  return start + std::chrono::duration_cast<SteadyTime::duration>(std::chrono::duration<double>(seconds));
}

Deadline::Deadline(SteadyTime when, LastWords words, std::function<void(int)> end)
    : words_(std::move(words)), end_(std::move(end)), thread_([this, when] { wait(when); }) {}

Deadline::~Deadline() {
  {
    const std::lock_guard lock(mutex_);
    called_off_ = true;
  }
  called_off_changed_.notify_all();
  thread_.join();
}

void Deadline::setLastWords(LastWords words) {
  const std::lock_guard lock(mutex_);
  words_ = std::move(words);
}

void Deadline::wait(SteadyTime when) {
  std::unique_lock lock(mutex_);
  if (called_off_changed_.wait_until(lock, when, [this] { return called_off_; })) return;
  const int exit_code = words_ ? words_() : EXIT_FAILURE;
  if (!end_) std::_Exit(exit_code);
  end_(exit_code);
}

void sayAtTheEnd(const std::string& line) {
  const std::string text = line + '\n';
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody to hear it
}

}  // namespace mapwright::app
