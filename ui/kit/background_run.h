// Long work of one owner on a thread beside the pool, one at a time. GUI-thread object; deleting it cancels
// and waits.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QObject>

#include "work/workers.h"

namespace mapwright::ui {

class BackgroundRun : public QObject {
 public:
  /// What is done with the result, on the GUI thread. It holds the result by value. May delete the run.
  using Then = std::function<void()>;
  /// What the work can see of its run.
  struct Running {
    std::function<bool(double done)> proceed;  // 0..1, from one thread at a time; false: it is cancelled
    const std::atomic<bool>& cancelled;
  };
  using Job = std::function<Then(const Running& run)>;
  using Progressed = std::function<void(double done)>;

  explicit BackgroundRun(const std::shared_ptr<work::Workers>& workers);
  ~BackgroundRun() override;

  /// Forgets what runs. `progressed` is called on the GUI thread, now and then.
  void start(Job job, Progressed progressed = {});
  /// It ends soon, and its Then is called.
  void cancel();
  /// It ends soon, and nothing is heard of it any more.
  void forget();
  /// Until just before Then.
  bool running() const { return running_; }

 private:
  struct Turn {
    std::atomic<bool> cancelled = false;
    bool forgotten = false;  // GUI thread
  };
  std::shared_ptr<Turn> turn_ = std::make_shared<Turn>();
  bool running_ = false;
  work::Tasks share_;  // last member: waits for running work
};

}  // namespace mapwright::ui
