// Texts for regions of a map that could not be loaded.
#pragma once

#include <QString>

#include "regions/region_plan.h"

namespace mapwright::sentences {

/// "It answered with another region." Plain text; empty = nothing is wrong.
QString sentenceOf(const regions::RegionTrouble& trouble);

}  // namespace mapwright::sentences
