// Default folders for dialogs. Accesses the disk.
#pragma once

#include <QSettings>
#include <QStringList>

namespace mapwright::ui {

/// The first of the wishes that is a writable folder; otherwise the home folder, or that for temporary files.
/// Empty wishes are skipped.
QString folderToWriteInto(const QStringList& wishes);
/// The first that is a readable folder; empty if there is none.
QString folderToReadFrom(const QStringList& wishes);

/// Where the user last chose map files, for file dialogs.
QString lastMapFolder(const QSettings& settings);
void rememberMapFolder(QSettings& settings, const QString& folder);

}  // namespace mapwright::ui
