// Verdicts in words.
#pragma once

#include <QString>

#include "carry/carried.h"

namespace mapwright::carry {

/// "kept", "in an obstacle".
QString verdictText(Verdict verdict);
/// What it means, in one sentence.
QString meaningOf(Verdict verdict);

}  // namespace mapwright::carry
