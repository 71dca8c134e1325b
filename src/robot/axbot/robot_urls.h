// Addresses on a robot. Pure functions. Source: docs/protocols/autoxing.md, "Addresses that a robot names".
#pragma once

#include <string_view>

#include <QString>
#include <QUrl>

namespace mapwright::robot::axbot {

/// `path` ("/maps/", percent-encoded if needed) below the address that the user connected to.
QUrl urlOnRobot(const QUrl& base, const QString& path, const QString& query = {});

/// The meaning of a robot's `*_url` or `data_url`: robots often use host names for themselves that cannot be
/// reached, so only path and query are used, on `base`. An invalid URL if there is no path.
QUrl robotUrl(const QUrl& base, std::string_view given);

/// An id as one segment of a path.
QString pathSegment(std::string_view id);

}  // namespace mapwright::robot::axbot
