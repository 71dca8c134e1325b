// The problems of a session: counted instead of repeated; bounded; never lost silently.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include <QDateTime>
#include <QString>

#include "map/problem.h"

namespace mapwright::session {

/// One problem, with how often and when it occurred.
struct LoggedProblem {
  quint64 row = 0;       // identifies the row as long as the log lives
  map::Problem problem;  // the last occurrence: its numbers are the newest
  std::string pattern;   // the same for problems that differ only in numbers
  int count = 1;
  QDateTime first, last;              // met
  std::optional<QDateTime> resolved;  // when the subject recovered; nullopt if it has not
  QDateTime since;                    // start of the present or last period
  qint64 earlier_ms = 0;              // total length of earlier periods

  /// Total duration of all periods, up to `now` if it persists.
  qint64 lastedMs(const QDateTime& now) const;
};

/// Newest last. Problems with the same subject, code and text except numbers share a row with a count. At
/// most kLimit rows; resolved ones are dropped first, then the oldest, and counted in forgotten().
class ProblemLog {
 public:
  using Rows = std::deque<LoggedProblem>;
  static constexpr std::size_t kLimit = 2'000;
  void add(const map::Problem& problem, const QDateTime& now);
  /// True if something was unresolved and is resolved now.
  bool resolve(const map::Recovery& recovery, const QDateTime& now);
  bool resolveAll(map::SubjectKind kind, const QDateTime& now);
  void clear();
  const Rows& rows() const { return rows_; }
  int unresolved() const { return unresolved_; }
  std::size_t forgotten() const { return forgotten_; }
  /// The whole list as plain text, one line each, for the clipboard and for reports.
  QString toText(const QDateTime& now) const;

 private:
  template <typename Recovered>
  bool resolveIf(const QDateTime& now, const Recovered& recovered);
  void count(const LoggedProblem& row, int by);
  void makeRoom();

  Rows rows_;           // ascending by `row`
  int open_ = 0;        // unresolved rows: recoveries are frequent, problems rare
  int unresolved_ = 0;  // those that are more severe than information
  quint64 last_row_ = 0;
  std::size_t forgotten_ = 0;
};

/// "0.4 s", "12 s", "3 min 20 s", "2 h 5 min", "3 d 4 h".
QString spanText(qint64 ms);

}  // namespace mapwright::session
