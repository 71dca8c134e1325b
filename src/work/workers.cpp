#include "work/workers.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <list>
#include <mutex>
#include <sys/resource.h>
#include <thread>
#include <utility>
#include <vector>

namespace mapwright::work {

namespace {

/// Lowers the priority of the calling thread: the window is drawn first. Only for threads that do nothing but
/// background work, since it cannot be undone.
void standBack() {
  constexpr int kBack = 8, kLeast = 19;
  thread_local bool done = false;
  if (done) return;
  done = true;
  // On Linux the process of id 0 is the calling thread. A refusal leaves the thread as it is, which is no
  // loss.
  errno = 0;
  const int now = getpriority(PRIO_PROCESS, 0);
  if (errno == 0) setpriority(PRIO_PROCESS, 0, std::min(now + kBack, kLeast));
}

int threadsByDefault() {
  constexpr int kMost = 1024;
  const char* const told = std::getenv("MAPWRIGHT_THREADS");
  const int wanted = told ? std::atoi(told) : 0;
  return wanted > 0 ? std::min(wanted, kMost) : std::max(1, int(std::thread::hardware_concurrency()));
}

}  // namespace

/// Counters of one owner; guarded by the pool's mutex.
struct Account {
  int waiting = 0, running = 0;
};

class Workers::Impl {
 public:
  struct Waiting {
    std::shared_ptr<Account> owner;
    Tasks::Job job;
  };

  std::mutex mutex;
  std::condition_variable work, done;
  std::array<std::deque<Waiting>, 3> queues;  // by urgency
  int running = 0, waiting = 0;
  int idle = 0;  // threads without a job
  bool closing = false;
  const int most;
  std::vector<std::thread> pool_threads;
  std::list<std::thread> long_ones;  // beyond the pool
  std::list<std::thread> ended;      // of those: nothing is left but to join them

  explicit Impl(int most_threads) : most(most_threads) {}

  /// The most urgent, oldest job. Precondition: locked.
  bool take(Waiting& taken) {
    for (auto queue = queues.rbegin(); queue != queues.rend(); ++queue) {
      if (queue->empty()) continue;
      taken = std::move(queue->front());
      queue->pop_front();
      --waiting;
      --taken.owner->waiting;
      begin(taken);
      return true;
    }
    return false;
  }
  void begin(const Waiting& job) {
    ++running;
    ++job.owner->running;
  }
  /// Runs it, and what it holds is gone before anybody hears that it is done.
  void run(std::unique_lock<std::mutex>& lock, Waiting job) {
    lock.unlock();
    job.job();
    job.job = nullptr;
    lock.lock();
    --running;
    --job.owner->running;
    done.notify_all();
  }
  void serve() {
    standBack();
    std::unique_lock lock(mutex);
    for (;;) {
      Waiting next;
      if (take(next)) {
        run(lock, std::move(next));
      } else if (closing) {
        return;
      } else {
        ++idle;
        work.wait(lock);
        --idle;
      }
    }
  }
};

Workers::Workers(int threads) : impl_(std::make_unique<Impl>(threads > 0 ? threads : threadsByDefault())) {}

Workers::~Workers() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->closing = true;
  }
  impl_->work.notify_all();
  for (std::thread& thread : impl_->pool_threads) thread.join();
  for (std::thread& thread : impl_->ended) thread.join();
}

std::shared_ptr<Workers> orOwn(std::shared_ptr<Workers> workers) {
  return workers ? std::move(workers) : std::make_shared<Workers>();
}

int Workers::threads() const { return impl_->most; }

int Workers::running() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->running;
}

int Workers::waiting() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->waiting;
}

Tasks::Tasks(std::shared_ptr<Workers> workers)
    : workers_(std::move(workers)), mine_(std::make_shared<Account>()) {}

Tasks::~Tasks() {
  drop();
  waitForDone();
}

void Tasks::start(Urgency urgency, Job job) {
  Workers::Impl& impl = *workers_->impl_;
  {
    const std::lock_guard lock(impl.mutex);
    impl.queues[std::size_t(urgency)].push_back({mine_, std::move(job)});
    ++impl.waiting;
    ++mine_->waiting;
    if (impl.waiting > impl.idle && int(impl.pool_threads.size()) < impl.most) {
      impl.pool_threads.emplace_back([&impl] { impl.serve(); });
    }
  }
  impl.work.notify_one();
}

void Tasks::startLong(Job job) {
  Workers::Impl& impl = *workers_->impl_;
  std::list<std::thread> ended;
  {
    const std::lock_guard lock(impl.mutex);
    ended.swap(impl.ended);
    Workers::Impl::Waiting mine{mine_, std::move(job)};
    impl.begin(mine);
    const auto entry = impl.long_ones.emplace(impl.long_ones.end());
    *entry = std::thread([&impl, entry, mine = std::move(mine)]() mutable {
      standBack();
      std::unique_lock inner(impl.mutex);
      impl.run(inner, std::move(mine));
      impl.ended.splice(impl.ended.end(), impl.long_ones, entry);
    });
  }
  for (std::thread& thread : ended) thread.join();
}

int Tasks::drop() {
  Workers::Impl& impl = *workers_->impl_;
  std::vector<Workers::Impl::Waiting> dropped;  // let go of without the lock: jobs hold what they like
  const std::lock_guard lock(impl.mutex);
  for (auto& queue : impl.queues) {
    const auto others = std::stable_partition(
        queue.begin(), queue.end(), [&](const Workers::Impl::Waiting& job) { return job.owner != mine_; });
    dropped.insert(dropped.end(), std::make_move_iterator(others), std::make_move_iterator(queue.end()));
    queue.erase(others, queue.end());
  }
  impl.waiting -= int(dropped.size());
  mine_->waiting = 0;
  impl.done.notify_all();
  return int(dropped.size());
}

bool Tasks::waitForDone(std::chrono::milliseconds longest) {
  Workers::Impl& impl = *workers_->impl_;
  std::unique_lock lock(impl.mutex);
  const auto idle = [&] { return mine_->running == 0 && mine_->waiting == 0; };
  if (longest == std::chrono::milliseconds::max()) {
    impl.done.wait(lock, idle);
    return true;
  }
  return impl.done.wait_for(lock, longest, idle);
}

int Tasks::waiting() const {
  const std::lock_guard lock(workers_->impl_->mutex);
  return mine_->waiting;
}

int Tasks::running() const {
  const std::lock_guard lock(workers_->impl_->mutex);
  return mine_->running;
}

}  // namespace mapwright::work
