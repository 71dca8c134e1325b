// Writes a map, or the view of it, into files. The work runs on any thread; ExportJob runs it beside the
// window.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>

#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"
#include "render/compositor.h"
#include "work/workers.h"

namespace mapwright::jobs {

enum class ExportFormat { MapPicture, MapServer, ViewPicture };

/// A whole map as it was read.
struct WholeMapExport {
  std::shared_ptr<const grids::GridPyramid> cells;  // complete
  map::GridReference reference;
};
/// Submaps, to be composed first.
struct SubmapsExport {
  std::vector<render::PlacedTexture> textures;  // ascending ids
  double resolution_m = 0.05;
};
/// The view as it is painted; `reference` places its pixels.
struct ViewExport {
  QImage picture;
  map::GridReference reference;
};
using ExportSource = std::variant<WholeMapExport, SubmapsExport, ViewExport>;

struct ExportRequest {
  ExportSource source;
  ExportFormat format = ExportFormat::MapPicture;  // of a ViewExport: ViewPicture
  QString path;             // MapServer: of the .yaml or the .pgm; "-" only takes a PNG
  bool world_file = false;  // beside it, as .pgw
};

/// What came of it.
struct ExportResult {
  QString path;   // what was written
  QString error;  // a sentence; empty = it is written
  bool cancelled = false;
};

/// Blocks. `proceed` gets the part that is done (0..1); false ends the work, and nothing half-written stays.
ExportResult exportMap(const ExportRequest& request, const std::function<bool(double done)>& proceed,
                       const grids::Means& means = {});
/// "/maps/a.png" -> "/maps/a.pgw".
QString worldFilePath(const QString& picture_path);
/// What will be written.
QStringList exportedFiles(const QString& path, ExportFormat format, bool with_world_file);
/// The first of `files` that is one of `sources`, whatever links lead to it; empty = none. Into pipes,
/// devices and the standard output bytes go, and nothing is replaced.
QString firstOwnSource(const QStringList& files, const std::vector<std::string>& sources);
/// The extension that the format takes: "png", "yaml".
QString exportSuffix(ExportFormat format);
/// A name that anybody may have given as the name of a file or a folder, without an ending.
QString fileNameFrom(const QString& name);

/// One export on a thread beyond the crew. GUI-thread object; deleting it cancels and waits.
class ExportJob : public QObject {
  Q_OBJECT
 public:
  explicit ExportJob(const std::shared_ptr<work::Workers>& workers, QObject* parent = nullptr);
  ~ExportJob() override;
  void start(ExportRequest request);
  void cancel() { cancelled_->store(true); }
  bool running() const { return running_; }

 Q_SIGNALS:
  void progressed(double done);
  void finished(const mapwright::jobs::ExportResult& result);

 private:
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  bool running_ = false;
  grids::Means means_;
  work::Share share_;  // last: it waits for what runs
};

}  // namespace mapwright::jobs
