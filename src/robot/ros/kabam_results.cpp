#include "robot/ros/kabam_results.h"

#include <algorithm>
#include <span>
#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {
namespace {

using map::Applied;
using map::FailureKind;
using net::rosbridge::Field;

/// What a code means. Without a cause it was done.
struct Code {
  std::int64_t code;
  FaultCode cause = {};
  bool of_name = false;  // the cause names what it is about
  FailureKind kind = FailureKind::RejectedByRobot;
};

constexpr Code kOfWaypoints[] = {
    {0},  // created
    {3},  // updated
    {5},  // deleted
    {1, fault::ResultMapUnknown},
    {2, fault::ResultNameTaken, true},
    {4, fault::ResultWaypointUnknown, false, FailureKind::Conflict},  // somebody else has deleted it
    {6, fault::ResultUndefined},
};
constexpr Code kOfUpdates[] = {
    {0},  // updated
    {1},  // deleted
    {2, fault::ResultMapUnknown},
    {3, fault::ResultInvalid},
    {4, fault::ResultUndefined},
};
constexpr Code kOfLoads[] = {
    {0},
    {1, fault::ResultMapUnknown},
    {2, fault::ResultAlreadyLoaded},
    {3, fault::ResultInvalidLoad},
    {4, fault::ResultUndefined},
};
constexpr Code kOfSaves[] = {
    {0},
    {1, fault::ResultNothingToSave},
    {2, fault::ResultMapNameTaken, true},
    {3, fault::ResultUndefined},
};

map::Failure withoutCode(map::Subject subject) {
  return {.kind = FailureKind::MalformedAnswer,
          .subject = std::move(subject),
          .applied = Applied::Maybe,
          .asked_for = map::AskedFor::Change,
          .cause = {fault::AnswerWithoutResult}};
}

std::optional<map::Failure> resultBy(std::span<const Code> codes, const Field& values, map::Subject subject,
                                     const std::string& name = {}) {
  const auto code = values["result"].integer();
  if (!code) return withoutCode(std::move(subject));
  map::Failure failure{.kind = FailureKind::RejectedByRobot,
                       .subject = std::move(subject),
                       .applied = Applied::Maybe,
                       .robot_code = std::to_string(*code),
                       .asked_for = map::AskedFor::Change,
                       .cause = {fault::ResultUnknown, {*code}}};
  const auto known =
      std::find_if(codes.begin(), codes.end(), [&](const Code& one) { return one.code == *code; });
  if (known == codes.end()) return failure;
  if (known->cause == FaultCode()) return std::nullopt;
  failure.kind = known->kind;
  failure.cause = known->cause;
  if (known->of_name) failure.cause.arguments = {name};
  // What is not known to have been refused may have been done.
  if (known->cause != fault::ResultUndefined) failure.applied = Applied::No;
  return failure;
}

}  // namespace

std::optional<map::Failure> waypointResult(const Field& values, map::Subject subject,
                                           const std::string& name) {
  return resultBy(kOfWaypoints, values, std::move(subject), name);
}

std::optional<map::Failure> updateMapResult(const Field& values, map::Subject subject) {
  return resultBy(kOfUpdates, values, std::move(subject));
}

std::optional<map::Failure> loadMapResult(const Field& values, map::Subject subject) {
  return resultBy(kOfLoads, values, std::move(subject));
}

std::optional<map::Failure> saveMapResult(const Field& values, map::Subject subject,
                                          const std::string& name) {
  return resultBy(kOfSaves, values, std::move(subject), name);
}

std::optional<map::Failure> triggerResult(const Field& values, map::Subject subject) {
  const auto success = values["success"].flag();
  if (!success) return withoutCode(std::move(subject));
  if (*success) return std::nullopt;
  return map::Failure{.kind = FailureKind::RejectedByRobot,
                      .subject = std::move(subject),
                      .detail = values["message"].text().substr(0, 300),
                      .asked_for = map::AskedFor::Change};
}

}  // namespace mapwright::robot::ros
