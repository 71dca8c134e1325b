#include "ui/waypoints/carry_run.h"

#include <utility>

namespace mapwright::window {

CarryRun::CarryRun(const std::shared_ptr<work::Workers>& workers, QObject* parent)
    : QObject(parent), share_(workers) {}

CarryRun::~CarryRun() { cancel(); }

void CarryRun::cancel() {
  cancelled_->store(true);
  running_ = false;
}

void CarryRun::start(render::PlacedGrid old_map, render::PlacedGrid new_map, const geometry::Pose2& transform,
                     std::vector<carry::Spot> old_spots, const carry::CarryOptions& options) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  running_ = true;
  share_.startLong([this, cancelled = cancelled_, old_map = std::move(old_map), new_map = std::move(new_map),
                    transform, old_spots = std::move(old_spots), options] {
    const carry::Site site(old_map, new_map, transform);
    if (*cancelled) return;
    auto carried = site.carried(old_spots, options);
    QMetaObject::invokeMethod(
        this,
        [this, cancelled, carried = std::move(carried)] {
          if (*cancelled) return;
          running_ = false;
          Q_EMIT finished(carried);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::window

#include "moc_carry_run.cpp"
