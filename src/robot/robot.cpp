#include "robot/robot.h"

#include <QTimer>

namespace mapwright::robot {

void WholeMapSource::fetchOverview(double, AnswerTo<map::WholeMap> reply) {
  QTimer::singleShot(0, [reply = std::move(reply)] {
    reply(tl::make_unexpected(map::Problem{map::Severity::Info, map::Subject(map::SubjectKind::Overview, {}),
                                           "This robot offers no overview picture of its map."}));
  });
}

void Robot::trustCertificate(const QString&) {}

}  // namespace mapwright::robot
