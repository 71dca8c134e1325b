// What came of a run as JUnit XML, which all servers that build and test read.
#pragma once

#include <vector>

#include <QIODevice>

#include "suite/outcome.h"

namespace mapwright::suite {

/// A view that differs, is over a limit or is not expected yet is a failure, one that failed an error.
/// Figures are the output of their view. False: `out` did not take everything.
bool writeJunit(const QString& suite, const std::vector<ViewOutcome>& outcomes, QIODevice& out);

}  // namespace mapwright::suite
