#include "ui/maps/walls_off_marks.h"

#include <utility>

namespace mapwright::ui {

WallsOffMarks::WallsOffMarks(scene::MapScene* scene, std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent), scene_(scene), share_(std::move(workers)) {}

WallsOffMarks::~WallsOffMarks() { over_ = true; }

void WallsOffMarks::hand(std::shared_ptr<const scene::WallsOff> walls) {
  shown_ = std::move(walls);
  scene_->setWallsOff(shown_);
}

void WallsOffMarks::show(const std::optional<Subject>& subject) {
  if (std::exchange(wanted_, subject) == subject) return;
  if (!subject || !made_ || !made_->sameMaps(*subject)) {
    made_.reset();
    walls_.reset();
    hand(nullptr);
  }
  if (subject && !running_) start();
}

void WallsOffMarks::start() {
  running_ = true;
  share_.startLong([this, subject = *wanted_, walls = walls_]() mutable {
    if (!walls) walls = align::WallsOff::between(subject.reference, subject.map, over_);
    if (!walls) return;
    auto off = std::make_shared<scene::WallsOff>();
    for (const align::OffWall& wall : walls->at(subject.pose, scene::kOffSteps_m.front()))
      off->walls.push_back({wall.at_m, wall.off_m});
    off->cell_m = walls->cell_m();
    QMetaObject::invokeMethod(
        this,
        [this, subject, walls, off = std::move(off)]() mutable {
          running_ = false;
          if (!wanted_) return;  // nobody wants it any more
          if (subject.sameMaps(*wanted_)) {
            made_ = subject;
            walls_ = walls;
            hand(std::move(off));
          }
          if (made_ != wanted_) return start();
          Q_EMIT found();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::ui

#include "moc_walls_off_marks.cpp"
