// Reads a suite of views: YAML. Pure functions.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include <QString>
#include <tl/expected.hpp>

#include "suite/suite.h"

namespace mapwright::suite {

inline constexpr std::size_t kMostSuiteBytes = std::size_t(16) << 20;
inline constexpr std::size_t kMostViews = 100'000;

/// The options of a snapshot that a view may have, by name ("robot", "robot-anyway").
struct KnownOptions {
  std::set<std::string> values, switches;
};

/// "views:" is a list of {name, options…, mask, tolerance, max_differing, quality}, "defaults:" has the same
/// keys but the name. "_" stands for "-" in the name of an option, too. The error is a sentence that begins
/// with the place: "Line 3, column 5: …".
tl::expected<Suite, QString> readSuite(const std::string& yaml, const KnownOptions& known);

/// "Line 3, column 5: …".
QString atPosition(Position at, const QString& sentence);

}  // namespace mapwright::suite
