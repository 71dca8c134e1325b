#include "robot/ros/kabam_results.h"

#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {
namespace {

using map::Applied;
using map::FailureKind;
using net::rosbridge::Field;

struct Meaning {
  FailureKind kind = FailureKind::RejectedByRobot;
  Applied applied = Applied::No;
  Fault cause;
};

/// Anything but a known refusal may have been carried out.
Meaning undefined() { return {FailureKind::RejectedByRobot, Applied::Maybe, {fault::ResultUndefined}}; }

map::Failure failure(map::Subject subject, std::int64_t code, Meaning meaning) {
  map::Failure failure;
  failure.kind = meaning.kind;
  failure.subject = std::move(subject);
  failure.applied = meaning.applied;
  failure.robot_code = std::to_string(code);
  failure.asked_for = map::AskedFor::Change;
  failure.cause = std::move(meaning.cause);
  return failure;
}

map::Failure withoutCode(map::Subject subject) {
  map::Failure failure;
  failure.kind = FailureKind::MalformedAnswer;
  failure.subject = std::move(subject);
  failure.applied = Applied::Maybe;
  failure.asked_for = map::AskedFor::Change;
  failure.cause = {fault::AnswerWithoutResult};
  return failure;
}

Meaning unknown(std::int64_t code) {
  return {FailureKind::RejectedByRobot, Applied::Maybe, {fault::ResultUnknown, {code}}};
}

}  // namespace

std::optional<map::Failure> waypointResult(const Field& values, map::Subject subject,
                                           const std::string& name) {
  const auto code = values["result"].integer();
  if (!code) return withoutCode(std::move(subject));
  Meaning meaning;
  switch (*code) {
    case 0:  // created
    case 3:  // updated
    case 5:  // deleted
      return std::nullopt;
    case 1:
      meaning.cause = {fault::ResultMapUnknown};
      break;
    case 2:
      meaning.cause = {fault::ResultNameTaken, {name}};
      break;
    case 4:  // someone else has deleted it
      meaning.kind = FailureKind::Conflict;
      meaning.cause = {fault::ResultWaypointUnknown};
      break;
    case 6:
      meaning = undefined();
      break;
    default:
      meaning = unknown(*code);
  }
  return failure(std::move(subject), *code, std::move(meaning));
}

std::optional<map::Failure> updateMapResult(const Field& values, map::Subject subject) {
  const auto code = values["result"].integer();
  if (!code) return withoutCode(std::move(subject));
  Meaning meaning;
  switch (*code) {
    case 0:  // updated
    case 1:  // deleted
      return std::nullopt;
    case 2:
      meaning.cause = {fault::ResultMapUnknown};
      break;
    case 3:
      meaning.cause = {fault::ResultInvalid};
      break;
    case 4:
      meaning = undefined();
      break;
    default:
      meaning = unknown(*code);
  }
  return failure(std::move(subject), *code, std::move(meaning));
}

std::optional<map::Failure> loadMapResult(const Field& values, map::Subject subject) {
  const auto code = values["result"].integer();
  if (!code) return withoutCode(std::move(subject));
  Meaning meaning;
  switch (*code) {
    case 0:  // loaded
      return std::nullopt;
    case 1:
      meaning.cause = {fault::ResultMapUnknown};
      break;
    case 2:
      meaning.cause = {fault::ResultAlreadyLoaded};
      break;
    case 3:
      meaning.cause = {fault::ResultInvalidLoad};
      break;
    case 4:
      meaning = undefined();
      break;
    default:
      meaning = unknown(*code);
  }
  return failure(std::move(subject), *code, std::move(meaning));
}

std::optional<map::Failure> saveMapResult(const Field& values, map::Subject subject,
                                          const std::string& name) {
  const auto code = values["result"].integer();
  if (!code) return withoutCode(std::move(subject));
  Meaning meaning;
  switch (*code) {
    case 0:  // saved
      return std::nullopt;
    case 1:
      meaning.cause = {fault::ResultNothingToSave};
      break;
    case 2:
      meaning.cause = {fault::ResultMapNameTaken, {name}};
      break;
    case 3:
      meaning = undefined();
      break;
    default:
      meaning = unknown(*code);
  }
  return failure(std::move(subject), *code, std::move(meaning));
}

std::optional<map::Failure> triggerResult(const Field& values, map::Subject subject) {
  const auto success = values["success"].flag();
  if (!success) return withoutCode(std::move(subject));
  if (*success) return std::nullopt;
  map::Failure failure;
  failure.kind = FailureKind::RejectedByRobot;
  failure.subject = std::move(subject);
  failure.asked_for = map::AskedFor::Change;
  failure.detail = values["message"].text().substr(0, 300);
  return failure;
}

}  // namespace mapwright::robot::ros
