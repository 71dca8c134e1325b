// What came of one view, and of all of them.
#pragma once

#include <optional>
#include <vector>

#include <QString>
#include <QStringList>

#include "compare/comparison.h"
#include "suite/facts.h"
#include "suite/facts_changes.h"

namespace mapwright::suite {

enum class Verdict {
  AsExpected,
  Differs,
  OverLimit,       // as expected, but the SLAM session is over a limit of the view
  NotExpectedYet,  // there is no expected picture
  Failed,          // the view did not come, or could not be compared
};

/// Without the pictures: they lie in files.
struct ViewOutcome {
  QString name;
  Verdict verdict = Verdict::Failed;
  QString sentence;  // what is to be said of it, more than one on lines of their own; empty = nothing
  double seconds = 0;
  QString expected, actual, difference;  // files; empty = none
  struct ClusterRow {
    QString box, size, place, near;
  };
  std::vector<ClusterRow> clusters;  // the first ones
  std::int64_t clusters_in_all = 0;
  QStringList everywhere, somewhere, elsewhere;  // as in an Explanation
  /// Of the SLAM session, where the view sets a limit to it; `before`: in the facts of the expected picture.
  /// Empty texts: unknown, or no limit.
  struct Figure {
    QString name, before, now, limit;
    /// "share 0.8 % -> 2.4 %".
    QString words() const;
  };
  std::vector<Figure> figures;
  QStringList worst_closures, worst_squares;  // where a limit is not held; the first ones
};

/// For a terminal: `head` and the sentence in one line, or indented lines below it, also of the worst places.
QStringList linesOf(const QString& head, const ViewOutcome& outcome);

/// What is shown of clusters, with what changed near them.
std::vector<ViewOutcome::ClusterRow> clusterRows(const compare::Comparison& comparison,
                                                 const std::optional<geometry::ViewTransform>& view,
                                                 const Explanation& explanation);

struct Tally {
  int as_expected = 0, differ = 0, over_limit = 0, not_expected_yet = 0, failed = 0;
  int all() const { return as_expected + differ + over_limit + not_expected_yet + failed; }
  bool good() const { return as_expected == all(); }
};
Tally tallyOf(const std::vector<ViewOutcome>& outcomes);
/// "12 views as expected, 1 view differs, 1 view failed."
QString tallyText(const Tally& tally);
/// "differs", "as expected".
QString verdictText(Verdict verdict);

}  // namespace mapwright::suite
