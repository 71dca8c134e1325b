// How the link to the robot stands, where it may have gone silent without being lost.
#pragma once

#include <optional>

#include <QDateTime>

#include "window/status/status_text.h"

namespace mapwright::window {

/// What is on screen is of then: the link is lost, or nothing has come since.
std::optional<QDateTime> valuesAsOf(const session::Session& session);
/// Since when an open link says nothing; nullopt = it speaks, or it is not open.
std::optional<QDateTime> silentOnline(const session::Session& session);
/// As connectionText(), and "nothing for 4 s" of a silent one.
StateText linkText(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since,
                   qint64 waited_ms = 0, const QDateTime& now = QDateTime::currentDateTime());
/// One word of the same.
QString linkWord(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since);

}  // namespace mapwright::window
