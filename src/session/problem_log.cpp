#include "session/problem_log.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>

#include "sentences/plural.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "words/qt_plain.h"

namespace mapwright::session {
namespace {

class ProblemLogText {
  Q_DECLARE_TR_FUNCTIONS(ProblemLog)
};

QString severityWord(map::Severity severity) {
  switch (severity) {
    case map::Severity::Info:
      return ProblemLogText::tr("info");
    case map::Severity::Warning:
      return ProblemLogText::tr("warning");
    case map::Severity::Error:
      break;
  }
  return ProblemLogText::tr("error");
}

}  // namespace

QString spanText(qint64 ms) {
  const auto two = [](qint64 big, const QString& unit, qint64 small, const QString& smaller) {
    const QString text = QStringLiteral("%1 %2").arg(big).arg(unit);
    return small > 0 ? text + QStringLiteral(" %1 %2").arg(small).arg(smaller) : text;
  };
  const qint64 s = ms / 1000, min = s / 60, h = min / 60;
  if (ms < 1000) return ProblemLogText::tr("%1 s").arg(double(std::max(qint64(0), ms) / 100) / 10);
  if (s < 60) return ProblemLogText::tr("%1 s").arg(s);
  if (min < 60) return two(min, ProblemLogText::tr("min"), s % 60, ProblemLogText::tr("s"));
  if (h < 24) return two(h, ProblemLogText::tr("h"), min % 60, ProblemLogText::tr("min"));
  return two(h / 24, ProblemLogText::tr("d"), h % 24, ProblemLogText::tr("h"));
}

qint64 LoggedProblem::lastedMs(const QDateTime& now) const {
  return earlier_ms + std::max(qint64(0), since.msecsTo(resolved.value_or(now)));
}

void ProblemLog::count(const LoggedProblem& row, int by) {
  if (row.resolved) return;
  open_ += by;
  if (row.problem.severity != map::Severity::Info) unresolved_ += by;
}

void ProblemLog::add(const map::Problem& problem, const QDateTime& now) {
  std::string pattern = map::patternOf(problem);
  const auto alike = std::find_if(rows_.begin(), rows_.end(), [&](const LoggedProblem& row) {
    return row.problem.code == problem.code && row.problem.subject.kind == problem.subject.kind &&
           row.problem.subject.id == problem.subject.id && row.pattern == pattern;
  });
  if (alike == rows_.end()) {
    if (rows_.size() >= kLimit) makeRoom();
    rows_.push_back({++last_row_, problem, std::move(pattern), 1, now, now, std::nullopt, now, 0});
    count(rows_.back(), 1);
    return;
  }
  if (alike->resolved) {
    alike->earlier_ms = alike->lastedMs(now);
    alike->since = now;
  }
  count(*alike, -1);
  alike->resolved.reset();
  alike->problem = problem;
  count(*alike, 1);
  ++alike->count;
  alike->last = now;
}

void ProblemLog::makeRoom() {
  auto oldest = std::find_if(rows_.begin(), rows_.end(),
                             [](const LoggedProblem& row) { return row.resolved.has_value(); });
  if (oldest == rows_.end()) oldest = rows_.begin();
  count(*oldest, -1);
  rows_.erase(oldest);
  ++forgotten_;
}

template <typename Recovered>
bool ProblemLog::resolveIf(const QDateTime& now, const Recovered& recovered) {
  bool any = false;
  if (open_ == 0) return any;
  for (LoggedProblem& row : rows_) {
    if (row.resolved || !recovered(row.problem)) continue;
    count(row, -1);
    row.resolved = now;
    any = true;
  }
  return any;
}

bool ProblemLog::resolve(const map::Recovery& recovery, const QDateTime& now) {
  return resolveIf(now, [&](const map::Problem& problem) {
    return problem.subject.kind == recovery.subject.kind && problem.subject.id == recovery.subject.id &&
           (!recovery.code || problem.code == *recovery.code);
  });
}

bool ProblemLog::resolveAll(map::SubjectKind kind, const QDateTime& now) {
  return resolveIf(now, [kind](const map::Problem& problem) { return problem.subject.kind == kind; });
}

void ProblemLog::clear() {
  const quint64 last_row = last_row_;
  *this = {};
  last_row_ = last_row;
}

QString ProblemLog::toText(const QDateTime& now) const {
  QString text;
  for (const LoggedProblem& row : rows_) {
    text += QStringLiteral("%1  %2  %3: %4")
                .arg(row.last.toString(Qt::ISODate), severityWord(row.problem.severity),
                     words::plainName(sentences::nameOf(row.problem.subject)),
                     words::plainName(sentences::sentenceOf(row.problem)));
    if (row.count > 1) {
      text += QStringLiteral("  (%1)").arg(
          ProblemLogText::tr("%1 times since %2").arg(row.count).arg(row.first.toString(Qt::ISODate)));
    }
    if (row.resolved)
      text += QStringLiteral("  (%1)").arg(
          ProblemLogText::tr("resolved after %1").arg(spanText(row.lastedMs(now))));
    text += QLatin1Char('\n');
  }
  if (forgotten_ > 0) {
    text += sentences::counted(ProblemLogText::tr("%1 older problems are no longer listed.", nullptr,
                                                  sentences::formOf(qint64(forgotten_))),
                               qint64(forgotten_)) +
            QLatin1Char('\n');
  }
  return text;
}

}  // namespace mapwright::session
