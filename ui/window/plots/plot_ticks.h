// Where the marks of axes stand and what they say. Pure.
#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace mapwright::window {

struct PlotTick {
  double at = 0;
  QString text = {};
};

/// At round numbers, `most` of them or fewer, within least..greatest.
std::vector<PlotTick> valueTicks(double least, double greatest, int most);

/// Times in seconds since the epoch, at whole parts of local time: "14:03:20", "14:03:20.250", a date where a
/// day begins. With `since_s` they are seconds after that, at round ones: "120", "0.25".
std::vector<PlotTick> timeTicks(double from_s, double until_s, int most, std::optional<double> since_s = {});

/// A time as it is said beside a cursor: finer than any tick.
QString timeText(double at_s, std::optional<double> since_s = {});
/// What local time is at that time: "UTC", "UTC+2", "UTC+5:30".
QString zoneText(double at_s);
/// With as many digits as say something.
QString valueText(double value);

}  // namespace mapwright::window
