// Times as people type them. Pure. Seconds since the epoch; typed in UTC, like the times of robots' bags.
#pragma once

#include <optional>

#include <QString>

namespace mapwright::excerpt {

/// What people type: "14:36:17.5" or "14:36" (of a day within first_s..last_s), "2023-10-31 14:36:17",
/// "+90" or "+1:30" after the start, "-10" before the end, "12.5" seconds after the start (or, as messages
/// are stamped, where stamps begin at zero), seconds since 1970. nullopt: it is no time, or none within
/// first_s..last_s.
std::optional<double> timeTyped(const QString& text, double first_s, double last_s);
/// Of these, those that need no start and no end; they may lie anywhere.
std::optional<double> absoluteTimeTyped(const QString& text, double first_s);

}  // namespace mapwright::excerpt
