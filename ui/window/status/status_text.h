// The sentences that tell how things stand. Pure functions, so that they can be checked.
#pragma once

#include <optional>
#include <string>

#include <QDateTime>
#include <QString>

#include "geometry/view_transform.h"
#include "robot/robot.h"
#include "session/session.h"

namespace mapwright::window {

/// How a state is marked next to its words: a shape and a colour, never the colour alone.
enum class Mark { None, Neutral, Busy, Good, Warning, Bad };

struct StateText {
  Mark mark = Mark::None;
  QString text;
  bool operator==(const StateText&) const = default;
};

/// "connected 12 ms", "reconnecting in 3 s (attempt 2): connection refused". `waited_ms` is the time since
/// `state` was read.
/// The robot refused for want of the right secret, and waits for a better one.
bool wantsSecret(const robot::ConnectionState& state);
StateText connectionText(const robot::ConnectionState& state, qint64 waited_ms = 0);
/// One or two words of the same: "connected", "reconnecting".
QString connectionWord(robot::ConnectionPhase phase);

/// "312 of 480 submaps, 2 missing".
QString loadingText(const session::SubmapCounts& counts);
/// "4 in flight, 18 queued"; empty when nothing is under way.
QString trafficText(const session::SubmapCounts& counts);

/// What the map on screen is called; one that is still on its way while nothing is on screen.
QString mapOnScreen(const session::MapSlot& slot, int limit = 60);
/// "Ground floor, 1,240 x 980 cells" once it is read, mapProgressText() until then.
QString mapShownText(const session::MapSlot& slot);
/// "Fetching Ground floor", "Reading Ground floor 42 %"; empty when there is nothing to wait for.
QString mapProgressText(const session::MapSlot& slot);
/// What a map is called: its name, or its id where it has none. One line, not longer than `limit`.
QString mapCalled(const QString& name, const map::MapKey& key, int limit = 60);

/// "x 12.345 y -3.210 m": as many decimals as a pixel is worth, millimetres at the most.
QString coordinatesText(const Eigen::Vector2d& world_m, double scale_m_per_px);
/// For the clipboard: always millimetres, "12.345, -3.210".
QString coordinatesForClipboard(const Eigen::Vector2d& world_m);
/// "occupied 97 %", "free 88 %", "unknown".
QString occupancyText(std::optional<int> occupied_percent);

/// "1:189  5 cm/px".
QString scaleText(double scale_m_per_px, double dots_per_inch);
/// "38°", -180 < degrees <= 180.
QString rotationText(double rotation_rad);

/// A robot's words as one line: no control or invisible characters (some turn the writing direction of what
/// follows), not longer than `limit`.
QString plainWords(const std::string& words, int limit);

/// "1.5 KB", "42.1 MB".
QString bytesText(qint64 bytes);
/// 12480 -> "12,480".
QString countText(qint64 count);
/// "1 problem", "3 problems".
QString problemsText(qint64 count);
/// "1 submap", "12,480 submaps".
QString submapsText(qint64 count);

/// Words for one row of the inspector.
QString statusWord(session::SubmapStatus status);
QString statusIcon(session::SubmapStatus status);
Mark statusMark(session::SubmapStatus status);

}  // namespace mapwright::window
