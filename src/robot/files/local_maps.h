// Maps in the file system, as values. Functions that look at the disk; any thread.
#pragma once

#include <optional>
#include <vector>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "map/catalogue.h"

namespace mapwright::robot::files {

/// How a bare picture lies in the world, where its address says so.
struct PicturePlace {
  std::optional<double> resolution_m;
  std::optional<geometry::Pose2> origin;  // the lower-left corner
};

bool isMapFile(const QString& path);  // by its name: .yaml, .yml, .png, .pgm, .bmp

/// The names of the map files in a folder, in order; at most 10,000.
QStringList mapFilesIn(const QString& folder);

/// The map of a map.yaml or a picture, its picture not opened. `path` is absolute. The error is a sentence.
tl::expected<map::WholeMap, std::string> readLocalMap(const QString& path, const PicturePlace& place);

/// What a catalogue can tell of it.
map::CatalogueEntry entryOf(const map::MapKey& key, const QString& path, const PicturePlace& place);

/// Path, size and time of a file as one text that changes whenever the file does.
std::string stampOf(const QString& path);

}  // namespace mapwright::robot::files
