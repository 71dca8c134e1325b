// Drags a field of a message from the inspector to a plot.
#pragma once

#include <memory>
#include <optional>

#include <QMimeData>

#include "ui/plots/plot_wish.h"

namespace mapwright::window {

inline constexpr const char* kFieldMime = "application/x-mapwright-field";

/// The field, with its path as text for other programs.
std::unique_ptr<QMimeData> mimeOf(const PlotWish& wish);
/// A field of ours, or a text with the path of one.
std::optional<PlotWish> wishFromMime(const QMimeData& mime);

}  // namespace mapwright::window
