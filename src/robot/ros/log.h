// What this room writes into the log (docs/command-line.md, "The log").
#pragma once

#include <QLoggingCategory>

namespace mapwright::robot::ros {

Q_DECLARE_LOGGING_CATEGORY(lcRos)

}  // namespace mapwright::robot::ros
