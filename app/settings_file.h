// The window's settings, in a file that survives a full disk, and the folders of the XDG Base Directory
// Specification 0.8.
#pragma once

#include <memory>

#include <QSettings>

namespace mapwright::app {

/// XDG_CONFIG_HOME/mapwright/mapwright.json. Takes over mapwright.ini of older versions once. If no file can
/// be written the settings last until the program ends; status() says so after sync().
std::unique_ptr<QSettings> openSettings();

/// The program's folders for settings, drafts and caches, as far as they are there, are for this user alone:
/// they hold addresses, names and maps of robots.
void makeOwnFoldersPrivate();

/// The same in `folder`.
std::unique_ptr<QSettings> openSettingsIn(const QString& folder);

/// "All paths set in these environment variables must be absolute. If an implementation encounters a relative
/// path it should consider the path invalid and ignore it": removes relative paths from the environment, so
/// that Qt, fontconfig and we agree. Call it before any thread starts.
void ignoreRelativeFolders();

}  // namespace mapwright::app
