// The thread pool for background work: one for the whole program, so that sessions, maps and pictures share
// the processors instead of competing. Why: docs/decisions/0008-one-pool-of-threads-one-budget.md.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>

namespace mapwright::work {

/// What is taken first; among equals the oldest.
enum class Urgency {
  Background,  // not visible yet
  Wanted,      // something waits for it
  InView,      // missing in the visible area
};

struct Account;  // the running and waiting jobs of one owner

/// A pool of low-priority threads. Any thread may use it; the tasks of its owners keep it alive. Threads are
/// created on demand.
class Workers {
 public:
  /// 0 = as many threads as MAPWRIGHT_THREADS says, or else one per processor.
  explicit Workers(int threads = 0);
  /// All tasks are gone by now. Not called on a thread of the pool: no job may own the pool itself.
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const;  // the maximum
  /// Running jobs, including those on threads of their own, and waiting jobs.
  int running() const;
  int waiting() const;

 private:
  friend class Tasks;
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// `workers`, or a new pool if it is null.
std::shared_ptr<Workers> orOwn(std::shared_ptr<Workers> workers);

/// The jobs of one owner: they can be dropped and waited for without touching those of others.
/// Jobs may not throw, and may not wait for other jobs of the pool. Call all members from one thread.
class Tasks {
 public:
  using Job = std::function<void()>;

  explicit Tasks(std::shared_ptr<Workers> workers);
  /// Drops waiting jobs, and waits for running ones.
  ~Tasks();
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  void start(Urgency urgency, Job job);
  /// For jobs that take seconds or wait for a disk: a thread of its own outside of the pool, so that tiles
  /// are made while a large map is read. Starts at once.
  void startLong(Job job);
  /// Drops waiting jobs and returns their number.
  int drop();
  /// True when no job of this owner runs or waits any more.
  bool waitForDone(std::chrono::milliseconds longest = std::chrono::milliseconds::max());
  int waiting() const;
  int running() const;

 private:
  std::shared_ptr<Workers> workers_;
  std::shared_ptr<Account> mine_;
};

}  // namespace mapwright::work
