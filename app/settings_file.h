// What the window remembers, in a file that a full disk does not empty.
#pragma once

#include <memory>

#include <QSettings>

namespace mapwright::app {

/// XDG_CONFIG_HOME/mapwright/mapwright.json. What an older version kept in mapwright.ini is taken over once.
/// Where no file can be kept the settings last as long as the program; status() says so after sync().
std::unique_ptr<QSettings> openSettings();

/// The same in `folder`.
std::unique_ptr<QSettings> openSettingsIn(const QString& folder);

}  // namespace mapwright::app
