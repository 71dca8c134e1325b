// Writes a map, or the current view of it, to files. Any thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <QImage>
#include <QString>
#include <QStringList>

#include "disk/existing.h"
#include "fault/fault.h"
#include "grids/export_grid.h"
#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"
#include "render/compositor.h"
#include "robot/address.h"

namespace mapwright::jobs {

enum class ExportFormat { MapPicture, MapServer, ViewPicture };

/// A whole map as it was read.
struct WholeMapExport {
  std::shared_ptr<const grids::GridPyramid> cells;  // complete
  map::GridReference reference;
};
/// Submaps, composed first.
struct SubmapsExport {
  std::vector<render::PlacedTexture> textures;  // ascending ids
  double resolution_m = 0.05;
};
/// The view as painted; `reference` gives the position of its pixels.
struct ViewExport {
  QImage picture;
  map::GridReference reference;
};
using ExportSource = std::variant<WholeMapExport, SubmapsExport, ViewExport>;

struct ExportRequest {
  ExportSource source;
  ExportFormat format = ExportFormat::MapPicture;  // of a ViewExport: ViewPicture
  QString path;                    // MapServer: of the .yaml or the picture; "-" only for a PNG
  bool world_file = false;         // also writes a .pgw or .wld
  grids::MapServerForm form = {};  // of MapServer
  disk::Existing existing = disk::Existing::Replace;  // files of these names
};

/// What came of it.
struct ExportResult {
  QString path;   // what was written
  QString error;  // a sentence; empty = success
  bool cancelled = false;
  QString remark = {};  // what robots that read the map do not see; empty = nothing
};

/// Blocks. `proceed` gets the share done (0..1); false cancels, and no partial file remains.
ExportResult exportMap(const ExportRequest& request, const std::function<bool(double done)>& proceed,
                       const grids::Resources& means = {});
/// Writes a painted picture to a PNG file: completely or not at all; disk::WrittenFile describes which paths
/// are possible. nullopt = written, otherwise why not.
std::optional<Fault> writePicture(const QImage& picture, const QString& path,
                                  disk::Existing existing = disk::Existing::Replace);
/// "/maps/a.png" -> "/maps/a.pgw"; of a PGM "/maps/a.wld". Other names GDAL does not look for.
QString worldFilePath(const QString& picture_path, ExportFormat format);
/// The files that will be written.
QStringList exportedFiles(const QString& path, ExportFormat format, bool with_world_file,
                          grids::MapServerForm::Mode mode = grids::MapServerForm::Mode::Trinary);
/// The map.yaml files that name a picture as their image; null = none are known.
using YamlsNaming = std::function<QStringList(const QString& picture)>;
/// The local files that the map `id` at `address` is read from, including the map.yaml of its `picture`; none
/// for a robot.
std::vector<std::string> sourceFiles(const robot::Addresses& addresses, const QString& address,
                                     const std::string& id, const std::string& picture,
                                     const YamlsNaming& yamls_naming);
/// The first of `files` that is one of `sources`, through any links; empty = none. Pipes, devices and the
/// standard output are ignored, since nothing is replaced there.
QString firstOwnSource(const QStringList& files, const std::vector<std::string>& sources);
/// Why a map is not written without asking: more of its picture is missing than is there, and it is large.
/// Such a file can be a header alone. Empty = it is written.
QString mostlyMissingReason(const grids::GridPyramid& cells);
/// The extension of the format: "png", "yaml".
QString exportSuffix(ExportFormat format);

}  // namespace mapwright::jobs
