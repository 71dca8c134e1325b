// What differs as a picture: the actual one in pale gray, what differs in a strong colour, clusters in boxes;
// what only one of two pictures of different sizes has is hatched.
#pragma once

#include <optional>
#include <string>

#include "compare/comparison.h"

namespace mapwright::compare {

/// Boxes stand around the first of the clusters only: more of them say nothing.
inline constexpr std::size_t kMostBoxes = 200;

/// Writes a PNG of the canvas of the comparison. Reads the pictures again. nullopt = written.
std::optional<Fault> writeDifference(const Comparison& comparison, const std::string& expected,
                                     const std::string& actual, const std::string& path);

}  // namespace mapwright::compare
