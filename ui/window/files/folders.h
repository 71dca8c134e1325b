// Folders to propose in dialogs. Looks at the disk.
#pragma once

#include <QSettings>
#include <QStringList>

namespace mapwright::window {

/// The first of the wishes that is a folder which can be written to; else the home folder, else that for
/// temporary files. Empty wishes are passed over.
QString folderToWriteInto(const QStringList& wishes);
/// The first that is a folder which can be looked into; empty where there is none.
QString folderToReadFrom(const QStringList& wishes);

/// Where map files were last chosen, for file dialogs.
QString lastMapFolder(const QSettings& settings);
void rememberMapFolder(QSettings& settings, const QString& folder);

}  // namespace mapwright::window
