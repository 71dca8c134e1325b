// Maps a time range to pixels, and formats times. Pure. Seconds since the epoch; displayed in UTC, like the
// times of robots' bags.
#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace mapwright::ui {

/// The visible part of a bag, and its width.
struct TimelineAxis {
  double from_s = 0, until_s = 1;  // until_s > from_s
  double left_px = 0, width_px = 1;

  double pixelOf(double at_s) const { return left_px + (at_s - from_s) / secondsPerPixel(); }
  double timeOf(double px) const { return from_s + (px - left_px) * secondsPerPixel(); }
  double secondsPerPixel() const { return (until_s - from_s) / (width_px > 0 ? width_px : 1); }

  /// Zooms in (factor below 1) or out around `at_s`; within first_s..last_s, and not closer than kNearestS.
  TimelineAxis zoomed(double factor, double at_s, double first_s, double last_s) const;
  /// The same length elsewhere, within first_s..last_s.
  TimelineAxis movedBy(double by_s, double first_s, double last_s) const;
  /// The same length with `at_s` visible: unchanged, or a page further.
  TimelineAxis showing(double at_s, double first_s, double last_s) const;

  static constexpr double kNearestS = 0.2;
};

struct AxisTick {
  double at_s = 0;
  QString label;  // empty: a small one
};
/// Round times, at least `label_px` apart if they have labels.
std::vector<AxisTick> axisTicks(const TimelineAxis& axis, double label_px);

/// "14:36:17.250".
QString clockText(double at_s, int decimals = 3);
/// "2023-10-31".
QString dayText(double at_s);
/// A length: "0:12.5", "1:02:03.0".
QString elapsedText(double length_s);

/// A speed: "2x", "-0.5x".
QString speedText(double speed);
/// "2", "0.5x", "-1 x"; nullopt: invalid, or outside of replay::Player's limits.
std::optional<double> speedTyped(const QString& text);

}  // namespace mapwright::ui
