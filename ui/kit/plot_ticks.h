// Positions and labels of axis ticks. Pure.
#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace mapwright::ui {

struct PlotTick {
  double at = 0;
  QString text = {};
};

/// At round numbers, at most `most` of them, within least..greatest.
std::vector<PlotTick> valueTicks(double least, double greatest, int most);

/// Times in seconds since the epoch, at round local times: "14:03:20", "14:03:20.250", a date at the start of
/// a day. With `since_s` they are seconds after that, at round ones: "120", "0.25".
std::vector<PlotTick> timeTicks(double from_s, double until_s, int most, std::optional<double> since_s = {});

/// A time as shown at the cursor: finer than any tick.
QString timeText(double at_s, std::optional<double> since_s = {});
/// The local time zone at that time: "UTC", "UTC+2", "UTC+5:30".
QString zoneText(double at_s);
/// With a sensible number of digits.
QString valueText(double value);

}  // namespace mapwright::ui
