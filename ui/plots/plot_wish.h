// What to plot: a quantity of any robot, or a field of the messages of a topic.
#pragma once

#include <optional>
#include <variant>

#include <QString>

#include "series/field_path.h"
#include "series/quantity.h"

namespace mapwright::window {

using PlotWish = std::variant<series::Quantity, series::FieldPath>;

/// The displayed name; one line, harmless.
QString plotName(const PlotWish& wish);
/// "m/s"; empty = none, or unknown.
QString plotUnit(const PlotWish& wish);
/// For settings and for dragging: "speed", "/tracked_pose.pos[0]".
QString plotWord(const PlotWish& wish);
/// The reverse; nullopt: invalid.
std::optional<PlotWish> plotFromWord(const QString& word);

}  // namespace mapwright::window
