// The threads that work in the background: one crew for all of the program, so that many sessions, maps and
// pictures share the processors instead of fighting for them. Why:
// docs/decisions/0008-one-pool-of-threads-one-budget.md.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace mapwright::work {

/// What is taken first; among equals the oldest.
enum class Urgency {
  Background,  // nobody looks at it yet
  Wanted,      // somebody waits for it
  InView,      // somebody looks at the place where it is missing
};

struct Account;  // of one owner: what runs and what waits

/// A crew of threads that stand back where the window is drawn. Any thread may use it; it outlives its shares
/// by being shared with them. A thread is made when there is work for it.
class Workers {
 public:
  /// 0 = one thread a processor.
  explicit Workers(int threads = 0);
  /// Every share is gone by now. Not on a thread of the crew: no job may hold the crew itself.
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const;  // at most
  /// Jobs that run now, those on threads of their own included, and jobs that wait.
  int running() const;
  int waiting() const;

 private:
  friend class Share;
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// `workers`, or a crew of one's own where none is handed in.
std::shared_ptr<Workers> orOwn(std::shared_ptr<Workers> workers);

/// One owner's part of the work: what it has started can be dropped and waited for without touching that of
/// others. Jobs may not throw, and may not wait for other jobs of the crew. All members from one thread.
class Share {
 public:
  using Job = std::function<void()>;

  explicit Share(std::shared_ptr<Workers> workers);
  /// Drops what waits, and waits for what runs.
  ~Share();
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;

  void start(Urgency urgency, Job job);
  /// For what takes seconds or waits for a disk: a thread of its own beyond the crew, so that a large map is
  /// read, and a slow share waited for, while tiles are made. Begins at once.
  void startLong(Job job);
  /// Forgets what waits; how many these were.
  int drop();
  /// True when nothing of this share runs or waits any more.
  bool waitForDone(std::chrono::milliseconds longest = std::chrono::milliseconds::max());
  int waiting() const;
  int running() const;

 private:
  std::shared_ptr<Workers> workers_;
  std::shared_ptr<Account> mine_;
};

}  // namespace mapwright::work
