// Maps in the file system, as values. Functions that look at the disk; any thread.
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

/// How a bare picture lies in the world, where its address says so.
struct PicturePlace {
  std::optional<double> resolution_m;
  std::optional<geometry::Pose2> origin;  // the lower-left corner
};

bool isMapFile(const QString& path);  // by its name: .yaml, .yml, .png, .pgm, .bmp
bool isPicture(const QString& path);  // .png, .pgm, .bmp

/// The file of a map at `path`, which is a file or a folder; empty when there is none. Only what the folder
/// holds: an id is no way out of it.
QString mapPathOf(const QString& path, const map::MapKey& key);

/// The names of the map files in a folder, in order; at most 10,000.
QStringList mapFilesIn(const QString& folder);

/// The map of a map.yaml or a picture, its picture not opened. `path` is absolute. A picture whose place is
/// not said lies where the one map.yaml beside it says that names it as its image; `beside` knows those of
/// its folder (null: looked up). The error says why not.
tl::expected<map::WholeMap, Fault> readLocalMap(const QString& path, const PicturePlace& place,
                                                YamlShelf& yamls, const PictureYamls* beside = nullptr);

/// What a catalogue can tell of it.
map::CatalogueEntry entryOf(const map::MapKey& key, const QString& path, const PicturePlace& place,
                            YamlShelf& yamls, const PictureYamls* beside = nullptr);

/// Path, size, time and inode of a file as one text that changes whenever the file does.
std::string stampOf(const QString& path);

}  // namespace mapwright::robot::files
