// The SLAM session behind a view, held against the limits of the view. Pure functions.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QStringList>

#include "map/closures.h"
#include "suite/facts.h"
#include "suite/outcome.h"
#include "suite/suite.h"

namespace mapwright::suite {

/// What was found of what a Quality asks for.
struct Examined {
  std::shared_ptr<const map::Closures> closures;  // null: not asked for, or not here
  std::optional<DisagreementFact> disagreement;   // likewise
  struct Square {                                 // of 1 m
    Eigen::Vector2d center_m;
    std::int64_t cells = 0;              // that contradict
    std::vector<map::SubmapId> submaps;  // that disagree there
  };
  std::vector<Square> squares;  // most cells first
  QStringList lacks;            // sentences: why what is asked for is not here
};

/// Rounded, as facts are.
void addFigures(const Examined& examined, Facts& facts);

/// Adds the figures, beside those of `before`, and what is to be said of them. A view that is as expected
/// fails where something could not be examined, and is over its limit where a loop closure has a larger
/// residual, or a larger share of the cells contradicts; other verdicts stay.
void judgeQuality(const Quality& limits, const Examined& examined, const std::optional<Facts>& before,
                  ViewOutcome& outcome);

}  // namespace mapwright::suite
