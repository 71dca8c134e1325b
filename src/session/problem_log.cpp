#include "session/problem_log.h"

#include <algorithm>

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

ProblemLog::Identity ProblemLog::identityOf(const map::Problem& problem) {
  return {problem.subject.kind, problem.subject.id};
}

ProblemLog::Likeness ProblemLog::likenessOf(const map::Problem& problem) {
  return {problem.subject.kind, problem.subject.id, problem.code, map::patternOf(problem)};
}

ProblemLog::Rows::iterator ProblemLog::at(quint64 row) {
  return std::lower_bound(rows_.begin(), rows_.end(), row,
                          [](const LoggedProblem& logged, quint64 number) { return logged.row < number; });
}

void ProblemLog::begin(const LoggedProblem& row) {
  open_[identityOf(row.problem)].push_back(row.row);
  unresolved_ += row.problem.severity != map::Severity::Info;
}

void ProblemLog::end(LoggedProblem& row, const QDateTime& now) {
  row.resolved = now;
  resolved_.insert(row.row);
  unresolved_ -= row.problem.severity != map::Severity::Info;
}

void ProblemLog::add(const map::Problem& problem, const QDateTime& now) {
  const auto [known, fresh] = alike_.try_emplace(likenessOf(problem), last_row_ + 1);
  if (!fresh) {
    LoggedProblem& row = *at(known->second);
    if (row.resolved) {
      row.earlier_ms = row.lastedMs(now);
      row.since = now;
      row.resolved.reset();
      resolved_.erase(row.row);
      row.problem = problem;
      begin(row);
    } else {
      unresolved_ +=
          int(problem.severity != map::Severity::Info) - int(row.problem.severity != map::Severity::Info);
      row.problem = problem;
    }
    ++row.count;
    row.last = now;
    return;
  }
  if (rows_.size() >= kLimit) makeRoom();
  rows_.push_back({++last_row_, problem, 1, now, now, std::nullopt, now, 0});
  begin(rows_.back());
}

void ProblemLog::makeRoom() {
  const auto oldest = resolved_.empty() ? rows_.begin() : at(*resolved_.begin());
  if (!oldest->resolved) {
    const auto open = open_.find(identityOf(oldest->problem));
    std::erase(open->second, oldest->row);
    if (open->second.empty()) open_.erase(open);
    unresolved_ -= oldest->problem.severity != map::Severity::Info;
  }
  resolved_.erase(oldest->row);
  alike_.erase(likenessOf(oldest->problem));
  rows_.erase(oldest);
  ++forgotten_;
}

bool ProblemLog::resolve(const map::Recovery& recovery, const QDateTime& now) {
  const auto open = open_.find({recovery.subject.kind, recovery.subject.id});
  if (open == open_.end()) return false;
  const std::size_t before = open->second.size();
  std::erase_if(open->second, [&](quint64 number) {
    LoggedProblem& row = *at(number);
    if (recovery.code && row.problem.code != *recovery.code) return false;
    end(row, now);
    return true;
  });
  const bool any = open->second.size() < before;
  if (open->second.empty()) open_.erase(open);
  return any;
}

bool ProblemLog::resolveAll(map::SubjectKind kind, const QDateTime& now) {
  const auto first = open_.lower_bound({kind, {}});
  auto last = first;
  for (; last != open_.end() && last->first.first == kind; ++last) {
    for (const quint64 number : last->second) end(*at(number), now);
  }
  const bool any = first != last;
  open_.erase(first, last);
  return any;
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
