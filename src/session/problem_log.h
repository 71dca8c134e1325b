// The problems of a session: counted instead of repeated; bounded; never lost silently.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <QDateTime>
#include <QString>

#include "map/problem.h"

namespace mapwright::session {

/// One problem, with how often and when it occurred.
struct LoggedProblem {
  quint64 row = 0;       // identifies the row as long as the log lives
  map::Problem problem;  // the last occurrence: its numbers are the newest
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
  using Identity = std::pair<map::SubjectKind, std::string>;
  using Likeness = std::tuple<map::SubjectKind, std::string, map::ProblemCode, std::string>;
  static Identity identityOf(const map::Problem& problem);
  static Likeness likenessOf(const map::Problem& problem);
  Rows::iterator at(quint64 row);
  void begin(const LoggedProblem& row);
  void end(LoggedProblem& row, const QDateTime& now);
  void makeRoom();

  Rows rows_;                                      // ascending by `row`
  std::map<Likeness, quint64> alike_;              // finds the row of a repeated problem
  std::map<Identity, std::vector<quint64>> open_;  // unresolved rows: recoveries are frequent, problems rare
  std::set<quint64> resolved_;                     // they go first
  int unresolved_ = 0;                             // more severe than information
  quint64 last_row_ = 0;
  std::size_t forgotten_ = 0;
};

/// "0.4 s", "12 s", "3 min 20 s", "2 h 5 min", "3 d 4 h".
QString spanText(qint64 ms);

}  // namespace mapwright::session
