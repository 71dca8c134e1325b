// Texts for regions of a map that could not be loaded.
#pragma once

#include <QString>

#include "regions/region_plan.h"

namespace mapwright::regions {

/// "It answered with another region." Plain text; empty = nothing is wrong.
QString sentenceOf(const RegionTrouble& trouble);

}  // namespace mapwright::regions
