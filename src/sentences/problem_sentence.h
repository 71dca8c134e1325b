// Texts for problems.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "map/problem.h"

namespace mapwright::sentences {

/// What is wrong, as plain text without its subject, which the caller shows next to it (nameOf).
QString sentenceOf(const map::Problem& problem);
/// The same; empty if there is none.
QString sentenceOf(const std::optional<map::Problem>& problem);

}  // namespace mapwright::sentences
