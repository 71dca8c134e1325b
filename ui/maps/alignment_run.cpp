#include "ui/maps/alignment_run.h"

#include <utility>

#include <QElapsedTimer>

#include "align/align_placed.h"

namespace mapwright::window {

AlignmentRun::AlignmentRun(std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent), workers_(std::move(workers)), share_(workers_) {}

AlignmentRun::~AlignmentRun() { cancel(); }

void AlignmentRun::cancel() {
  cancelled_->store(true);
  running_ = false;
}

void AlignmentRun::start(render::PlacedGrid old_map, render::PlacedGrid new_map,
                         std::vector<placing::PointPair> pairs) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  running_ = true;
  share_.startLong([this, cancelled = cancelled_, old_map = std::move(old_map), new_map = std::move(new_map),
                    pairs = std::move(pairs), workers = workers_] {
    QElapsedTimer told;
    align::Options options{pairs, workers, {}};
    options.proceed = [&](double done) {
      if (!told.isValid() || told.elapsed() > 50) {
        told.start();
        QMetaObject::invokeMethod(
            this,
            [this, cancelled, done] {
              if (!*cancelled) Q_EMIT progressed(done);
            },
            Qt::QueuedConnection);
      }
      return !cancelled->load();
    };
    const auto found = align::alignPlaced(old_map, new_map, options, cancelled.get());
    if (!found) return;
    QMetaObject::invokeMethod(
        this,
        [this, cancelled, found = *found] {
          if (*cancelled) return;
          running_ = false;
          Q_EMIT finished(found);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::window

#include "moc_alignment_run.cpp"
