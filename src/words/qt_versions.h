// What has one name in Qt 6.4 (Debian 12) and another in Qt 6.8 (Debian 13), which warns of the old one.
#pragma once

#include <utility>

#include <QDateTime>
#include <QTimeZone>
#include <QtGlobal>

namespace mapwright::words {

// toUTC(), as the texts of times in a zone end with +00:00 in Qt 6.4, those of times in UTC with Z.
inline QDateTime utcOfMs(qint64 since_epoch_ms) {
  return QDateTime::fromMSecsSinceEpoch(since_epoch_ms, QTimeZone::utc()).toUTC();
}
/// What the date and the time of day of `time` are in UTC.
inline QDateTime takenAsUtc(const QDateTime& time) {
  return QDateTime(time.date(), time.time(), QTimeZone::utc()).toUTC();
}

/// The signal of a QWebSocket that something has failed.
template <typename Socket>
constexpr auto socketFailed() {
  if constexpr (requires { &Socket::errorOccurred; })
    return &Socket::errorOccurred;
  else
    return QOverload<decltype(std::declval<const Socket&>().error())>::of(&Socket::error);
}

}  // namespace mapwright::words
