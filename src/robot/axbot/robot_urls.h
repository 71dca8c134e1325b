// Addresses on one robot. Pure functions. Source: docs/protocols/autoxing.md, "Addresses that a robot names".
#pragma once

#include <string_view>

#include <QString>
#include <QUrl>

namespace mapwright::robot::axbot {

/// `path` ("/maps/", percent-encoded where needed) below the address that the user connected to.
QUrl urlOnRobot(const QUrl& base, const QString& path, const QString& query = {});

/// What a robot's `*_url` or `data_url` means: robots name themselves by hosts that often cannot be reached,
/// so only path and query are taken, and asked of `base`. An invalid URL for a text without a path.
QUrl robotUrl(const QUrl& base, std::string_view given);

/// An id as one segment of a path.
QString pathSegment(std::string_view id);

}  // namespace mapwright::robot::axbot
