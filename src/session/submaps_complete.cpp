#include "session/submaps_complete.h"

#include <algorithm>

#include "robot/submap_list_topic.h"

namespace mapwright::session {
namespace {

using map::ProblemCode;
using map::SubjectKind;

bool isOpen(const LoggedProblem& row) {
  return !row.resolved && row.problem.severity >= map::Severity::Warning;
}

bool isOfListTopic(const LoggedProblem& row) {
  return isOpen(row) && row.problem.code == ProblemCode::Unreadable &&
         row.problem.subject == map::Subject(SubjectKind::Topic, robot::kSubmapListTopic);
}

bool leavesOut(const LoggedProblem& row) {
  const map::Problem& problem = row.problem;
  if (!isOpen(row)) return false;
  if (problem.subject.kind == SubjectKind::SubmapList) return problem.code == ProblemCode::Odd;
  return problem.subject.kind == SubjectKind::Submap &&
         (problem.code == ProblemCode::Unavailable || problem.code == ProblemCode::Unplaced);
}

}  // namespace

bool listUnreadable(const ProblemLog& problems) {
  return std::any_of(problems.rows().begin(), problems.rows().end(), isOfListTopic);
}

bool submapsComplete(const SubmapCounts& counts, const ProblemLog& problems) {
  return counts.list_received && counts.shown + counts.without_slice == counts.listed &&
         counts.updating == 0 && !listUnreadable(problems) &&
         std::none_of(problems.rows().begin(), problems.rows().end(), leavesOut);
}

}  // namespace mapwright::session
