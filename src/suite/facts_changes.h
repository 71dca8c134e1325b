// Which facts of a picture changed, and which of them explain where it differs. Pure functions.
#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "compare/comparison.h"
#include "suite/facts.h"

namespace mapwright::suite {

/// In words that begin small and end without a full stop: "submap 12-3 went from version 7 to 9".
struct FactChange {
  QString words;
  std::vector<geometry::WorldRect> where;  // before and after, with names; empty: nobody knows
  bool whole_picture = false;              // every pixel may be another one
  bool moves_names = false;                // of other things: no name covers another one, or a symbol
};
std::vector<FactChange> changesBetween(const Facts& before, const Facts& after);

/// Changes by where the pictures differ.
struct Explanation {
  std::vector<QStringList> near;  // for each of the clusters: what changed there
  QStringList everywhere;         // changes that may be the cause of any cluster
  QStringList somewhere;          // changes whose place is unknown, where others explain every cluster
  QStringList elsewhere;          // changes near none of the clusters
};
Explanation explained(const compare::Comparison& comparison, const geometry::ViewTransform& view,
                      const std::vector<FactChange>& changes);

/// "3 clusters, the largest 0.8 m² at (12.4, -3.1): move virtual wall W17 by 0.40 m; submap 12-3 went from
/// version 7 to 9. Elsewhere: …" Names the first changes only.
QString explanationText(const compare::Comparison& comparison, const geometry::ViewTransform& view,
                        const Explanation& explanation);

/// "a; b; c and 12 more".
QString firstChanges(const QStringList& changes);

}  // namespace mapwright::suite
