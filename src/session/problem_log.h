// The problems met in a session: counted, not repeated; bounded; never lost silently.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
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

/// Newest last. Problems of one subject whose sentences differ in numbers only are one row with a count. At
/// most kLimit rows; resolved ones go first, then the oldest, and they are counted in forgotten().
class ProblemLog {
 public:
  static constexpr std::size_t kLimit = 2'000;
  void add(const map::Problem& problem, const QDateTime& now);
  /// True when something was unresolved and is no more.
  bool resolve(const map::Recovery& recovery, const QDateTime& now);
  bool resolveAll(map::SubjectKind kind, const QDateTime& now);
  void clear();
  const std::vector<LoggedProblem>& rows() const { return rows_; }
  int unresolved() const;
  std::size_t forgotten() const { return forgotten_; }
  /// The whole list as plain text, one line each, for the clipboard and for reports.
  QString toText(const QDateTime& now) const;

 private:
  using Identity = std::pair<map::SubjectKind, std::string>;
  void makeRoom();
  void settle(std::size_t at, const QDateTime& now);
  void close(const Identity& identity);

  std::vector<LoggedProblem> rows_;
  std::vector<std::string> patterns_;  // of the sentences, row by row
  std::map<Identity, int> open_;       // unresolved rows: recoveries are many, problems few
  quint64 last_row_ = 0;
  std::size_t forgotten_ = 0;
};

/// The sentence with every number replaced: what "Row 12 is 3.5 m off" and "Row 7 is 1,200 m off" share.
std::string withoutNumbers(const std::string& sentence);

/// "0.4 s", "12 s", "3 min 20 s", "2 h 5 min", "3 d 4 h".
QString spanText(qint64 ms);

}  // namespace mapwright::session
