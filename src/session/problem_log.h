// The problems met in a session: counted, not repeated; bounded; never lost silently.
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

/// One problem with how often and when it was met.
struct LoggedProblem {
  quint64 row = 0;       // names the row as long as the log lives
  map::Problem problem;  // as it was met last: its numbers are the newest
  int count = 1;
  QDateTime first, last;              // met
  std::optional<QDateTime> resolved;  // when the subject recovered; nullopt while it has not
  QDateTime since;                    // the spell that lasts, or the last one, began
  qint64 earlier_ms = 0;              // what the spells before it lasted

  /// How long it was there, all spells together: to its end, or to `now` while it lasts.
  qint64 lastedMs(const QDateTime& now) const;
};

/// Newest last. Problems of one subject, code and reason that differ in numbers only are one row with a
/// count. At most kLimit rows; resolved ones go first, then the oldest, and they are counted in forgotten().
class ProblemLog {
 public:
  using Rows = std::deque<LoggedProblem>;
  static constexpr std::size_t kLimit = 2'000;
  void add(const map::Problem& problem, const QDateTime& now);
  /// True when something was unresolved and is no more.
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
  std::map<Likeness, quint64> alike_;              // what is the same row again
  std::map<Identity, std::vector<quint64>> open_;  // unresolved rows: recoveries are many, problems few
  std::set<quint64> resolved_;                     // they go first
  int unresolved_ = 0;                             // that are more than information
  quint64 last_row_ = 0;
  std::size_t forgotten_ = 0;
};

/// "0.4 s", "12 s", "3 min 20 s", "2 h 5 min", "3 d 4 h".
QString spanText(qint64 ms);

}  // namespace mapwright::session
