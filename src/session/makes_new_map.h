// Whether the robot is making a new map: then it is in none of its stored maps.
#pragma once

namespace mapwright::map {
struct LiveState;
}
namespace mapwright::robot {
class Robot;
}
namespace mapwright::submap {
class SubmapStore;
}

namespace mapwright::session {

bool makesNewMap(robot::Robot& robot, const map::LiveState& live, const submap::SubmapStore& submaps);

}  // namespace mapwright::session
