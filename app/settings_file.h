// The window's settings, in a file that survives a full disk.
#pragma once

#include <memory>

#include <QSettings>

namespace mapwright::app {

/// XDG_CONFIG_HOME/mapwright/mapwright.json. Takes over mapwright.ini of older versions once. If no file can
/// be written the settings last until the program ends; status() says so after sync().
std::unique_ptr<QSettings> openSettings();

/// The same in `folder`.
std::unique_ptr<QSettings> openSettingsIn(const QString& folder);

}  // namespace mapwright::app
