// Which map.yaml of a folder describes which of its pictures. Looks at the disk; any thread.
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>

#include "robot/files/yaml_shelf.h"

namespace mapwright::robot::files {

class PictureYamls {
 public:
  /// Reads the YAML files of the folder that have changed since `yamls` held them, as many as anyone keeps
  /// beside one picture and no longer than a map.yaml is; what is none counts for nothing.
  PictureYamls(const QString& folder, YamlShelf& yamls);
  /// The paths of those that name the picture as their image, in order of their names.
  QStringList naming(const QString& picture) const;

  static constexpr qsizetype kMostFiles = 1'000;
  static constexpr qint64 kLongest = qint64(64) << 10;

 private:
  QHash<QString, QStringList> yamls_;  // by the true path of the picture
};

/// For a picture alone. Empty for what is no picture.
QStringList yamlsNaming(const QString& picture);

}  // namespace mapwright::robot::files
