// Which map.yaml of a folder describes which of its pictures. Accesses the disk; any thread.
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>

#include "robot/files/yaml_shelf.h"

namespace mapwright::robot::files {

class PictureYamls {
 public:
  /// Reads the YAML files of the folder that have changed since `yamls` read them, up to a reasonable number
  /// and size; other files are ignored.
  PictureYamls(const QString& folder, YamlShelf& yamls);
  /// The paths of those that name the picture as their image, by name.
  QStringList naming(const QString& picture) const;

  static constexpr qsizetype kMostFiles = 1'000;
  static constexpr qint64 kLongest = qint64(64) << 10;

 private:
  QHash<QString, QStringList> yamls_;  // by the real path of the picture
};

/// For a single picture. Empty if it is not a picture.
QStringList yamlsNaming(const QString& picture);

}  // namespace mapwright::robot::files
