#include "session/pose_graph_slot.h"

#include <utility>

#include <QPointer>

#include "robot/pose_graph_source.h"
#include "robot/robot.h"

namespace mapwright::session {

PoseGraphSlot::PoseGraphSlot(robot::Robot& robot, std::shared_ptr<work::Workers> workers)
    : robot_(robot), ranking_(std::move(workers)) {}

PoseGraphSlot::~PoseGraphSlot() { call_.cancel(); }

bool PoseGraphSlot::offered() const { return robot_.poseGraphSource() != nullptr; }

void PoseGraphSlot::want() {
  wanted_ = true;
  if (!loading_ && !closures_ && !failure_) refresh();
}

void PoseGraphSlot::refresh() {
  if (!wanted_) return;
  if (loading_) {
    again_ = true;
    return;
  }
  robot::PoseGraphSource* const source = robot_.poseGraphSource();
  if (!source) {
    failure_.reset();
    if (std::exchange(closures_, nullptr)) Q_EMIT changed();
    return;
  }
  loading_ = true;
  ++request_;
  call_ = source->fetch([self = QPointer(this)](robot::Outcome<Graph> answer) {
    if (self) self->onAnswer(std::move(answer));
  });
  Q_EMIT changed();
}

void PoseGraphSlot::onAnswer(robot::Outcome<Graph> answer) {
  if (answer) {
    // 100,000 constraints take a while.
    ranking_.start(work::Urgency::Wanted, [this, graph = std::move(*answer), of = request_] {
      auto closures = std::make_shared<const map::Closures>(map::rankClosures(*graph));
      QMetaObject::invokeMethod(
          this, [this, closures = std::move(closures), of] { onRanked(closures, of); }, Qt::QueuedConnection);
    });
    return;
  }
  loading_ = false;
  failure_ = std::move(answer.error());
  Q_EMIT changed();
  if (std::exchange(again_, false)) refresh();
}

void PoseGraphSlot::onRanked(std::shared_ptr<const map::Closures> closures, quint64 of) {
  if (of != request_) return;
  loading_ = false;
  failure_.reset();
  closures_ = std::move(closures);
  Q_EMIT changed();
  if (std::exchange(again_, false)) refresh();
}

}  // namespace mapwright::session

#include "moc_pose_graph_slot.cpp"
