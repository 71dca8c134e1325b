#include "work/workers.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <deque>
#include <list>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "work/stand_back.h"

namespace mapwright::work {

/// Counters of one share; guarded by the crew's mutex.
struct Account {
  int waiting = 0, running = 0;
};

class Workers::Impl {
 public:
  struct Waiting {
    std::shared_ptr<Account> owner;
    Share::Job job;
  };

  std::mutex mutex;
  std::condition_variable work, done;
  std::array<std::deque<Waiting>, 3> queues;  // by urgency
  int running = 0, waiting = 0;
  int idle = 0;  // threads of the crew without a job
  bool closing = false;
  const int most;
  std::vector<std::thread> crew;
  std::list<std::thread> long_ones;  // beyond the crew
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

Workers::Workers(int threads)
    : impl_(std::make_unique<Impl>(threads > 0 ? threads
                                               : std::max(1, int(std::thread::hardware_concurrency())))) {}

Workers::~Workers() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->closing = true;
  }
  impl_->work.notify_all();
  for (std::thread& thread : impl_->crew) thread.join();
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

Share::Share(std::shared_ptr<Workers> workers)
    : workers_(std::move(workers)), mine_(std::make_shared<Account>()) {}

Share::~Share() {
  drop();
  waitForDone();
}

void Share::start(Urgency urgency, Job job) {
  Workers::Impl& impl = *workers_->impl_;
  {
    const std::lock_guard lock(impl.mutex);
    impl.queues[std::size_t(urgency)].push_back({mine_, std::move(job)});
    ++impl.waiting;
    ++mine_->waiting;
    if (impl.waiting > impl.idle && int(impl.crew.size()) < impl.most) {
      impl.crew.emplace_back([&impl] { impl.serve(); });
    }
  }
  impl.work.notify_one();
}

void Share::startLong(Job job) {
  Workers::Impl& impl = *workers_->impl_;
  std::list<std::thread> ended;
  {
    const std::lock_guard lock(impl.mutex);
    ended.swap(impl.ended);
    Workers::Impl::Waiting mine{mine_, std::move(job)};
    impl.begin(mine);
    const auto place = impl.long_ones.emplace(impl.long_ones.end());
    *place = std::thread([&impl, place, mine = std::move(mine)]() mutable {
      standBack();
      std::unique_lock inner(impl.mutex);
      impl.run(inner, std::move(mine));
      impl.ended.splice(impl.ended.end(), impl.long_ones, place);
    });
  }
  for (std::thread& thread : ended) thread.join();
}

int Share::drop() {
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

bool Share::waitForDone(std::chrono::milliseconds longest) {
  Workers::Impl& impl = *workers_->impl_;
  std::unique_lock lock(impl.mutex);
  const auto idle = [&] { return mine_->running == 0 && mine_->waiting == 0; };
  if (longest == std::chrono::milliseconds::max()) {
    impl.done.wait(lock, idle);
    return true;
  }
  return impl.done.wait_for(lock, longest, idle);
}

int Share::waiting() const {
  const std::lock_guard lock(workers_->impl_->mutex);
  return mine_->waiting;
}

int Share::running() const {
  const std::lock_guard lock(workers_->impl_->mutex);
  return mine_->running;
}

}  // namespace mapwright::work
