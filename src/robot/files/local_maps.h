// Maps in the file system, as values. These functions access the disk; any thread.
#pragma once

#include <optional>
#include <vector>

#include <QHash>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/catalogue.h"
#include "robot/files/read_map_yaml.h"

namespace mapwright::robot::files {

/// The position of a plain picture in the world, if its address states it.
struct PicturePlace {
  std::optional<double> resolution_m;
  std::optional<geometry::Pose2> origin;  // the lower-left corner
};

bool isMapFile(const QString& path);  // by its extension: .yaml, .yml, .png, .pgm, .bmp
bool isPicture(const QString& path);  // .png, .pgm, .bmp
/// .geojson. It is opened as the map beside it that has its name ("office.yaml" for "office.geojson" and
/// "office.overlays.geojson"); without one, as an empty map around what it holds.
bool isOverlayFile(const QString& path);
/// The map beside an overlay file; empty: there is none.
QString mapBeside(const QString& overlay_file);

/// The file of a map at `path`, a file or a folder; empty if there is none. Only files inside the folder: an
/// id cannot lead out of it.
QString mapPathOf(const QString& path, const map::MapKey& key);

/// The names of the map files in a folder, in order; at most 10,000.
QStringList mapFilesIn(const QString& folder);

/// Which map.yaml of a folder describes which of its pictures.
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

/// The map of a map.yaml or a picture, without opening the picture. `path` is absolute. A picture without a
/// stated position uses the only map.yaml in its folder that names it as its image; `beside` knows those of
/// the folder (null: looks them up). The error says why not.
tl::expected<map::WholeMap, Fault> readLocalMap(const QString& path, const PicturePlace& place,
                                                YamlShelf& yamls, const PictureYamls* beside = nullptr);

/// Its catalogue entry.
map::CatalogueEntry entryOf(const map::MapKey& key, const QString& path, const PicturePlace& place,
                            YamlShelf& yamls, const PictureYamls* beside = nullptr);

/// Path, size, time and inode of a file as a text that changes whenever the file does.
std::string stampOf(const QString& path);

}  // namespace mapwright::robot::files
