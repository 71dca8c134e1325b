// Texts about clouds. Pure functions.
#pragma once

#include <optional>

#include <QString>

#include "clouds/cloud_store.h"

namespace mapwright::ui {

/// "5,000,000 points shown of 6,000,000", and what is missing and why, one line each.
QString cloudSumsText(const clouds::CloudSums& sums);
/// "12,480 points, from 0.02 m to 3.11 m".
QString sectionText(const clouds::Section& section);
/// "along 3.214 m, height 1.020 m; point at 3.210 m, 1.018 m".
QString sectionPlaceText(const Eigen::Vector2d& at, const std::optional<Eigen::Vector2d>& nearest);
/// "12.3 MB".
QString megabytesText(std::int64_t bytes);

}  // namespace mapwright::ui
