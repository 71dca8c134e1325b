#include "ui/kit/folders.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace mapwright::ui {

namespace {

const QString kMapFolderKey = QStringLiteral("files/folder");

template <typename Usable>
QString firstOf(const QStringList& wishes, Usable usable) {
  const auto found = std::find_if(wishes.begin(), wishes.end(), [&](const QString& wish) {
    return !wish.isEmpty() && QFileInfo(wish).isDir() && usable(QFileInfo(wish));
  });
  return found == wishes.end() ? QString() : *found;
}

}  // namespace

QString folderToWriteInto(const QStringList& wishes) {
  const QString found = firstOf(wishes + QStringList{QDir::homePath()},
                                [](const QFileInfo& folder) { return folder.isWritable(); });
  return found.isEmpty() ? QDir::tempPath() : found;
}

QString folderToReadFrom(const QStringList& wishes) {
  return firstOf(wishes, [](const QFileInfo& folder) { return folder.isReadable(); });
}

QString lastMapFolder(const QSettings& settings) {
  return folderToReadFrom({settings.value(kMapFolderKey).toString(),
                           QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
                           QDir::homePath()});
}

void rememberMapFolder(QSettings& settings, const QString& folder) {
  settings.setValue(kMapFolderKey, folder);
}

}  // namespace mapwright::ui
