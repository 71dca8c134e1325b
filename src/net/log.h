// What this room writes into the log (docs/troubleshooting.md, "The log").
#pragma once

#include <QLoggingCategory>
#include <QString>
#include <QUrl>

namespace mapwright::net {

Q_DECLARE_LOGGING_CATEGORY(lcNet)
Q_DECLARE_LOGGING_CATEGORY(lcCache)

/// Without what may be a secret: user, password, fragment, and all of the query but numbers (ver=3). A number
/// is left out as well where its name says that it is a secret (pin=1234).
QString urlForLog(const QUrl& url);

}  // namespace mapwright::net
