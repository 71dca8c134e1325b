// Problems: made of failures, and read by people.
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "map/problem.h"

namespace mapwright::sentences {

/// What is wrong, as plain text without its subject, which whoever shows it names beside (nameOf).
QString sentenceOf(const map::Problem& problem);
/// The same; empty when there is none.
QString sentenceOf(const std::optional<map::Problem>& problem);

}  // namespace mapwright::sentences
