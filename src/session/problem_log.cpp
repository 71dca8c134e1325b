#include "session/problem_log.h"

#include <algorithm>

#include "words/qt_plain.h"

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

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isWordChar(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80);
}

/// The end of the number that begins at `at`: digits, grouped or with a fraction, and an exponent.
std::size_t endOfNumber(const std::string& text, std::size_t at) {
  const auto digitAt = [&](std::size_t i) { return i < text.size() && isDigit(text[i]); };
  while (digitAt(at) || (at < text.size() && (text[at] == '.' || text[at] == ',') && digitAt(at + 1))) ++at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t sign = at + 1 < text.size() && (text[at + 1] == '+' || text[at + 1] == '-') ? 1 : 0;
    if (digitAt(at + 1 + sign)) {
      at += 1 + sign;
      while (digitAt(at)) ++at;
    }
  }
  return at;
}

}  // namespace

std::string withoutNumbers(const std::string& sentence) {
  std::string pattern;
  pattern.reserve(sentence.size());
  for (std::size_t i = 0; i < sentence.size();) {
    const bool minus = sentence[i] == '-' && i + 1 < sentence.size() && isDigit(sentence[i + 1]) &&
                       (i == 0 || !isWordChar(sentence[i - 1]));
    if (!minus && !isDigit(sentence[i])) {
      pattern += sentence[i++];
      continue;
    }
    pattern += '#';
    i = endOfNumber(sentence, i + (minus ? 1 : 0));
  }
  return pattern;
}

QString spanText(qint64 ms) {
  const auto two = [](qint64 big, const QString& unit, qint64 small, const QString& smaller) {
    const QString text = QStringLiteral("%1 %2").arg(big).arg(unit);
    return small > 0 ? text + QStringLiteral(" %1 %2").arg(small).arg(smaller) : text;
  };
  const qint64 s = ms / 1000, min = s / 60, h = min / 60;
  if (ms < 1000) return QStringLiteral("%1 s").arg(double(std::max(qint64(0), ms) / 100) / 10);
  if (s < 60) return QStringLiteral("%1 s").arg(s);
  if (min < 60) return two(min, QStringLiteral("min"), s % 60, QStringLiteral("s"));
  if (h < 24) return two(h, QStringLiteral("h"), min % 60, QStringLiteral("min"));
  return two(h / 24, QStringLiteral("d"), h % 24, QStringLiteral("h"));
}

qint64 LoggedProblem::lastedMs(const QDateTime& now) const {
  return earlier_ms + std::max(qint64(0), since.msecsTo(resolved.value_or(now)));
}

void ProblemLog::add(const map::Problem& problem, const QDateTime& now) {
  std::string pattern = withoutNumbers(problem.sentence);
  const Identity identity(problem.subject.kind, problem.subject.id);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    LoggedProblem& row = rows_[i];
    if (!(row.problem.subject == problem.subject) || row.problem.code != problem.code ||
        patterns_[i] != pattern) {
      continue;
    }
    if (row.resolved) {
      row.earlier_ms = row.lastedMs(now);
      row.since = now;
      row.resolved.reset();
      ++open_[identity];
    }
    row.problem = problem;
    ++row.count;
    row.last = now;
    return;
  }
  if (rows_.size() >= kLimit) makeRoom();
  rows_.push_back({++last_row_, problem, 1, now, now, std::nullopt, now, 0});
  patterns_.push_back(std::move(pattern));
  ++open_[identity];
}

void ProblemLog::makeRoom() {
  auto oldest = std::find_if(rows_.begin(), rows_.end(),
                             [](const LoggedProblem& row) { return row.resolved.has_value(); });
  if (oldest == rows_.end()) {
    oldest = rows_.begin();
    close({oldest->problem.subject.kind, oldest->problem.subject.id});
  }
  patterns_.erase(patterns_.begin() + (oldest - rows_.begin()));
  rows_.erase(oldest);
  ++forgotten_;
}

void ProblemLog::close(const Identity& identity) {
  const auto open = open_.find(identity);
  if (open != open_.end() && --open->second == 0) open_.erase(open);
}

bool ProblemLog::resolve(const map::Recovery& recovery, const QDateTime& now) {
  if (!open_.contains({recovery.subject.kind, recovery.subject.id})) return false;
  bool any = false;
  for (LoggedProblem& row : rows_) {
    if (row.resolved || !(row.problem.subject == recovery.subject) ||
        (recovery.code && row.problem.code != *recovery.code)) {
      continue;
    }
    row.resolved = now;
    close({recovery.subject.kind, recovery.subject.id});
    any = true;
  }
  return any;
}

bool ProblemLog::resolveAll(map::SubjectKind kind, const QDateTime& now) {
  bool any = false;
  for (LoggedProblem& row : rows_) {
    if (row.resolved || row.problem.subject.kind != kind) continue;
    row.resolved = now;
    close({kind, row.problem.subject.id});
    any = true;
  }
  return any;
}

void ProblemLog::clear() {
  rows_.clear();
  patterns_.clear();
  open_.clear();
  forgotten_ = 0;
}

int ProblemLog::unresolved() const {
  return int(std::count_if(rows_.begin(), rows_.end(), [](const LoggedProblem& row) {
    return !row.resolved && row.problem.severity != map::Severity::Info;
  }));
}

QString ProblemLog::toText(const QDateTime& now) const {
  QString text;
  for (const LoggedProblem& row : rows_) {
    text +=
        QStringLiteral("%1  %2  %3: %4")
            .arg(row.last.toString(Qt::ISODate), severityWord(row.problem.severity),
                 words::plainName(map::toText(row.problem.subject)), words::plainName(row.problem.sentence));
    if (row.count > 1) {
      text += QStringLiteral("  (%1 times since %2)").arg(row.count).arg(row.first.toString(Qt::ISODate));
    }
    if (row.resolved) text += QStringLiteral("  (resolved after %1)").arg(spanText(row.lastedMs(now)));
    text += QLatin1Char('\n');
  }
  if (forgotten_ > 0) text += QStringLiteral("%1 older problems are not kept.\n").arg(forgotten_);
  return text;
}

}  // namespace mapwright::session
