#include "ui/carry/carry_run.h"

#include <utility>

namespace mapwright::ui {

CarryRun::CarryRun(const std::shared_ptr<work::Workers>& workers, QObject* parent)
    : QObject(parent), share_(workers) {}

CarryRun::~CarryRun() { cancel(); }

void CarryRun::cancel() { cancelled_->store(true); }

void CarryRun::start(render::PlacedGrid old_map, render::PlacedGrid new_map, const geometry::Pose2& transform,
                     Job job) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  share_.startLong([this, cancelled = cancelled_, old_map = std::move(old_map), new_map = std::move(new_map),
                    transform, job = std::move(job)] {
    const carry::Site site(old_map, new_map, transform);
    if (*cancelled) return;
    QMetaObject::invokeMethod(
        this,
        [cancelled, then = job(site)] {
          if (!*cancelled) then();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::ui

#include "moc_carry_run.cpp"
