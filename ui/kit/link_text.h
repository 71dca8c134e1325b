// The state of the connection, including silence before it is lost.
#pragma once

#include <optional>

#include <QDateTime>

#include "ui/kit/status_text.h"

namespace mapwright::window {

/// The data on screen is from then: the connection is lost, or nothing has arrived since.
std::optional<QDateTime> valuesAsOf(const session::Session& session);
/// Since when an open connection is silent; nullopt = it is not silent, or not open.
std::optional<QDateTime> silentOnline(const session::Session& session);
/// Like connectionText(), and "nothing for 4 s" for a silent one.
StateText linkText(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since,
                   qint64 waited_ms = 0, const QDateTime& now = QDateTime::currentDateTime());
/// The same in one word.
QString linkWord(const robot::ConnectionState& state, const std::optional<QDateTime>& silent_since);

}  // namespace mapwright::window
