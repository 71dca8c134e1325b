#include "map/problem.h"

namespace mapwright::map {

Problem problemOf(const Failure& failure, Severity severity) {
  return {severity,     failure.subject,
          {},           isUnreadable(failure) ? ProblemCode::Unreadable : ProblemCode::Unavailable,
          failure.kind, failure};
}

std::string patternOf(const Problem& problem) {
  std::string pattern = patternOf(problem.reason);
  if (!problem.request) return pattern;
  const Failure& failure = *problem.request;
  for (const int code :
       {int(failure.kind), int(failure.asked_for), int(failure.applied), int(failure.reason)}) {
    pattern += ' ' + std::to_string(code);
  }
  return pattern + ' ' + withoutNumbers(failure.robot_code) + '|' + withoutNumbers(failure.detail) +
         patternOf(failure.cause);
}

}  // namespace mapwright::map
