// Texts about the state. Pure functions, so that they can be tested.
#pragma once

#include <optional>
#include <string>

#include <QDateTime>
#include <QString>

#include "geometry/view_transform.h"
#include "robot/robot.h"
#include "session/session.h"

namespace mapwright::ui {

/// The mark of a state next to its text: a shape and a colour, never only the colour.
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
/// The same in one or two words: "connected", "reconnecting".
QString connectionWord(robot::ConnectionPhase phase);

/// "312 of 480 submaps, 2 missing".
QString loadingText(const session::SubmapCounts& counts);
/// "22 to come": fetched or waiting to be; empty if nothing is.
QString trafficText(const session::SubmapCounts& counts);

/// The name of the map on screen, or of one that is loading while nothing is on screen.
QString mapOnScreen(const session::MapSlot& slot, int limit = 60);
/// "Ground floor, 1,240 x 980 cells" once it is read, mapProgressText() until then.
QString mapShownText(const session::MapSlot& slot);
/// "Fetching Ground floor", "Reading Ground floor 42 %"; empty if nothing is loading.
QString mapProgressText(const session::MapSlot& slot);
/// A name as one line of plain text, truncated to what a row can show; "(no name)" if there is none.
QString mapTitle(const std::string& name);
/// The displayed name of a map: its name, or its id if it has none. One line, at most `limit` characters.
QString mapCalled(const QString& name, const map::MapKey& key, int limit = 60);

/// "x 12.345 y -3.210 m": with the precision of a pixel, at most millimetres.
QString coordinatesText(const Eigen::Vector2d& world_m, double scale_m_per_px);
/// For the clipboard: always millimetres, "12.345, -3.210".
QString coordinatesForClipboard(const Eigen::Vector2d& world_m);
/// "occupied 97 %", "free 88 %", "unknown".
QString occupancyText(std::optional<int> occupied_percent);

/// "1:189  5 cm/px".
QString scaleText(double scale_m_per_px, double dots_per_inch);
/// "38°", -180 < degrees <= 180.
QString rotationText(double rotation_rad);

/// A robot's text as one line: no control or invisible characters (some change the writing direction of what
/// follows), at most `limit` characters.
QString plainWords(const std::string& words, int limit);
QString plainWords(const QString& words, int limit);

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

/// The data on screen is from then: the connection is lost, or nothing has arrived since.
std::optional<QDateTime> valuesAsOf(const session::Session& session);
/// Since when an open connection is silent; nullopt = it is not silent, or not open.
std::optional<QDateTime> silentOnline(const session::Session& session);
/// Like connectionText(), and "nothing for 4 s" for a silent one.
StateText linkText(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since,
                   qint64 waited_ms = 0, const QDateTime& now = QDateTime::currentDateTime());
/// The same in one word.
QString linkWord(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since);

}  // namespace mapwright::ui
