// What came of a run as one HTML file that needs nothing else: pictures are in it.
#pragma once

#include <vector>

#include <QIODevice>

#include "suite/outcome.h"

namespace mapwright::suite {

/// The same bytes for the same pictures, however long they took. Reads the pictures of one view after the
/// other. `suite`: its name. False: `out` did not take everything.
bool writePage(const QString& suite, const std::vector<ViewOutcome>& outcomes, QIODevice& out);

}  // namespace mapwright::suite
