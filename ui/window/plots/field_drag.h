// A field of a message on its way from the inspector of messages to a plot.
#pragma once

#include <memory>
#include <optional>

#include <QMimeData>

#include "window/plots/plot_wish.h"

namespace mapwright::window {

inline constexpr const char* kFieldMime = "application/x-mapwright-field";

/// The field, and its path as text for everybody else.
std::unique_ptr<QMimeData> mimeOf(const PlotWish& wish);
/// A field of ours, or a text that is the path of one.
std::optional<PlotWish> wishFromMime(const QMimeData& mime);

}  // namespace mapwright::window
