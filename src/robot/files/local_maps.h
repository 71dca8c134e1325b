// Maps in the file system, as values. These functions access the disk; any thread.
#pragma once

#include <optional>
#include <vector>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/catalogue.h"
#include "robot/files/picture_yamls.h"
#include "robot/files/yaml_shelf.h"

namespace mapwright::robot::files {

/// The position of a plain picture in the world, if its address states it.
struct PicturePlace {
  std::optional<double> resolution_m;
  std::optional<geometry::Pose2> origin;  // the lower-left corner
};

bool isMapFile(const QString& path);  // by its extension: .yaml, .yml, .png, .pgm, .bmp
bool isPicture(const QString& path);  // .png, .pgm, .bmp

/// The file of a map at `path`, a file or a folder; empty if there is none. Only files inside the folder: an
/// id cannot lead out of it.
QString mapPathOf(const QString& path, const map::MapKey& key);

/// The names of the map files in a folder, in order; at most 10,000.
QStringList mapFilesIn(const QString& folder);

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
