// The problems met in a session: counted, not repeated; bounded; never lost silently.
#pragma once

#include <cstddef>
#include <vector>

#include <QDateTime>
#include <QString>

#include "map/problem.h"

namespace mapwright::session {

/// One problem with how often and when it was met.
struct LoggedProblem {
  map::Problem problem;
  int count = 1;
  QDateTime first, last;
  bool resolved = false;  // the subject has recovered since
};

/// Newest last. Equal problems (subject and sentence) are one row with a count. At most kLimit rows; the
/// oldest go first and are counted in forgotten().
class ProblemLog {
 public:
  static constexpr std::size_t kLimit = 2'000;
  void add(const map::Problem& problem, const QDateTime& now);
  void resolve(const std::string& subject);
  void clear();
  const std::vector<LoggedProblem>& rows() const { return rows_; }
  int unresolved() const;
  std::size_t forgotten() const { return forgotten_; }
  /// The whole list as plain text, one line each, for the clipboard and for reports.
  QString toText() const;

 private:
  std::vector<LoggedProblem> rows_;
  std::size_t forgotten_ = 0;
};

}  // namespace mapwright::session
