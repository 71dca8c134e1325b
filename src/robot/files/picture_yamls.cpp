#include "robot/files/picture_yamls.h"

#include <QDir>
#include <QFileInfo>

#include "robot/files/local_maps.h"

namespace mapwright::robot::files {
namespace {

/// A canonical name for a file.
QString trueName(const QString& path) {
  const QString canonical = QFileInfo(path).canonicalFilePath();
  return canonical.isEmpty() ? QDir::cleanPath(path) : canonical;
}

}  // namespace

PictureYamls::PictureYamls(const QString& folder, YamlShelf& shelf) {
  const QDir dir(folder);
  const QStringList names = dir.entryList({QStringLiteral("*.yaml"), QStringLiteral("*.yml")}, QDir::Files,
                                          QDir::Name | QDir::IgnoreCase);
  for (const QString& name : names.mid(0, kMostFiles)) {
    const QString path = dir.absoluteFilePath(name);
    const QFileInfo file(path);
    if (!file.isFile() || file.size() > kLongest) continue;
    const auto yaml = shelf.read(path.toStdString());
    if (!yaml) continue;
    yamls_[trueName(dir.absoluteFilePath(QString::fromStdString(yaml->image)))] << path;
  }
}

QStringList PictureYamls::naming(const QString& picture) const { return yamls_.value(trueName(picture)); }

QStringList yamlsNaming(const QString& picture) {
  if (!isPicture(picture)) return {};
  YamlShelf shelf;
  return PictureYamls(QFileInfo(picture).absolutePath(), shelf).naming(picture);
}

}  // namespace mapwright::robot::files
