// What to plot: a quantity of any robot, or a field of the messages of a topic. A field is dragged from a
// message to a plot.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include <QMimeData>
#include <QString>

#include "series/fields.h"

namespace mapwright::ui {

using PlotSelection = std::variant<series::Quantity, series::FieldPath>;

/// The displayed name; one line, harmless.
QString plotName(const PlotSelection& selection);
/// "m/s"; empty = none, or unknown.
QString plotUnit(const PlotSelection& selection);
/// For settings and for dragging: "speed", "/tracked_pose.pos[0]".
QString plotWord(const PlotSelection& selection);
/// The reverse; nullopt: invalid.
std::optional<PlotSelection> plotFromWord(const QString& word);

inline constexpr const char* kFieldMime = "application/x-mapwright-field";
/// For dragging, with its path as text for other programs.
std::unique_ptr<QMimeData> mimeOf(const PlotSelection& selection);
/// A field of ours, or a text with the path of one.
std::optional<PlotSelection> plotFromMime(const QMimeData& mime);

}  // namespace mapwright::ui
