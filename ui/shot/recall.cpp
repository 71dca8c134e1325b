#include "ui/shot/recall.h"

namespace mapwright::ui::shot {

Recall::Recall(session::Session& session, replay::ReplayRobot& robot) : robot_(robot) {
  connect(&robot, &replay::ReplayRobot::jumped, this,
          [this, &session](const map::World& world, replay::Knowledge knowledge) {
            if (in_ || knowledge != replay::Knowledge::Exact) return;
            in_ = true;
            session.reset(world);
          });
}

void Recall::goTo(double at_s) {
  at_s_ = at_s;
  robot_.goTo(at_s);
}

std::optional<map::Failure> Recall::failure() const {
  const replay::Cell* const obstacle = robot_.reading()->chunks().obstacleUntil(at_s_);
  const bool final = obstacle && replay::isFinal(*obstacle) && (!in_ || obstacle->lost);
  return final ? std::optional(obstacle->failure) : std::nullopt;
}

}  // namespace mapwright::ui::shot
