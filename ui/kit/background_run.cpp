#include "ui/kit/background_run.h"

#include <utility>

#include <QElapsedTimer>

namespace mapwright::ui {

BackgroundRun::BackgroundRun(const std::shared_ptr<work::Workers>& workers) : share_(workers) {}

BackgroundRun::~BackgroundRun() { forget(); }

void BackgroundRun::cancel() { turn_->cancelled = true; }

void BackgroundRun::forget() {
  cancel();
  turn_->forgotten = true;
  running_ = false;
}

void BackgroundRun::start(Job job, Progressed progressed) {
  constexpr qint64 kProgressEvery_ms = 50;
  forget();
  turn_ = std::make_shared<Turn>();
  running_ = true;
  share_.startLong([this, turn = turn_, job = std::move(job), progressed = std::move(progressed)] {
    const auto post = [&](auto what) {
      QMetaObject::invokeMethod(
          this,
          [turn, what = std::move(what)] {
            if (!turn->forgotten) what();
          },
          Qt::QueuedConnection);
    };
    QElapsedTimer last;
    const auto proceed = [&](double done) {
      if (progressed && (!last.isValid() || last.elapsed() >= kProgressEvery_ms)) {
        last.start();
        post([progressed, done] { progressed(done); });
      }
      return !turn->cancelled;
    };
    post([this, then = job({proceed, turn->cancelled})] {
      running_ = false;
      if (then) then();
    });
  });
}

}  // namespace mapwright::ui
