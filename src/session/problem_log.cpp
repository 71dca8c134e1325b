#include "session/problem_log.h"

#include <algorithm>

namespace mapwright::session {
namespace {

QString severityWord(map::Severity severity) {
  switch (severity) {
    case map::Severity::Info:
      return QStringLiteral("info");
    case map::Severity::Warning:
      return QStringLiteral("warning");
    case map::Severity::Error:
      break;
  }
  return QStringLiteral("error");
}

}  // namespace

void ProblemLog::add(const map::Problem& problem, const QDateTime& now) {
  const auto same = std::find_if(rows_.begin(), rows_.end(),
                                 [&](const LoggedProblem& row) { return row.problem == problem; });
  if (same != rows_.end()) {
    ++same->count;
    same->last = now;
    same->resolved = false;
    return;
  }
  if (rows_.size() >= kLimit) {
    rows_.erase(rows_.begin());
    ++forgotten_;
  }
  rows_.push_back({problem, 1, now, now, false});
}

void ProblemLog::resolve(const std::string& subject) {
  for (LoggedProblem& row : rows_) {
    if (row.problem.subject == subject) row.resolved = true;
  }
}

void ProblemLog::clear() {
  rows_.clear();
  forgotten_ = 0;
}

int ProblemLog::unresolved() const {
  return int(std::count_if(rows_.begin(), rows_.end(), [](const LoggedProblem& row) {
    return !row.resolved && row.problem.severity != map::Severity::Info;
  }));
}

QString ProblemLog::toText() const {
  QString text;
  for (const LoggedProblem& row : rows_) {
    text +=
        QStringLiteral("%1  %2  %3: %4")
            .arg(row.last.toString(Qt::ISODate), severityWord(row.problem.severity),
                 QString::fromStdString(row.problem.subject), QString::fromStdString(row.problem.sentence));
    if (row.count > 1) text += QStringLiteral("  (%1 times)").arg(row.count);
    if (row.resolved) text += QStringLiteral("  (resolved)");
    text += QLatin1Char('\n');
  }
  if (forgotten_ > 0) text += QStringLiteral("%1 older problems are not kept.\n").arg(forgotten_);
  return text;
}

}  // namespace mapwright::session
