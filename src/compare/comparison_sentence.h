// What differs, in words: the same for the commands, reports and the window.
#pragma once

#include <optional>

#include <QString>

#include "compare/comparison.h"
#include "geometry/view_transform.h"

namespace mapwright::compare {

/// "The sizes differ: 640 x 480 expected, 800 x 480 here."; empty if they do not.
QString sizesText(const Comparison& comparison);
/// "3 clusters, the largest 0.8 m² at (12.4, -3.1)"; without a view in pixels. Empty if nothing differs.
QString clustersText(const Comparison& comparison, const std::optional<geometry::ViewTransform>& view);
/// "36 pixels differ (0.0117 %), by up to 255".
QString amountText(const Comparison& comparison);
/// All of it in sentences: whether they are equal, how many pixels differ, where.
QString comparisonText(const Comparison& comparison, const std::optional<geometry::ViewTransform>& view);
/// "(12.4, -3.1)".
QString placeText(const Eigen::Vector2d& at_m);

}  // namespace mapwright::compare
