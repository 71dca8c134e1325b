#include "window/files/export_map.h"

#include <utility>

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QImageWriter>
#include <QSaveFile>

#include "raster/export_grid.h"
#include "render/compose_grid.h"

namespace mapwright::window {

namespace {

using Proceed = std::function<bool(double)>;
using Problem = std::optional<QString>;

constexpr double kComposePart = 0.7;  // of the work, when submaps have to be composed first

Problem fromText(const std::optional<std::string>& problem) {
  return problem ? std::optional(QString::fromStdString(*problem)) : std::nullopt;
}

Problem cannotWrite(const QString& path, const QString& why) {
  return QStringLiteral("%1 cannot be written: %2.").arg(QDir::toNativeSeparators(path), why);
}

Problem writeText(const QString& path, const std::string& text) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
  file.write(text.data(), qint64(text.size()));
  return file.commit() ? Problem() : cannotWrite(path, file.errorString());
}

Problem writeView(const ViewExport& view, const QString& path) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
  QImageWriter writer(&file, "png");
  if (!writer.write(view.picture)) return cannotWrite(path, writer.errorString());
  return file.commit() ? Problem() : cannotWrite(path, file.errorString());
}

Problem writeGrid(const WholeMapExport& map, const ExportRequest& request, const Proceed& proceed) {
  if (!map.cells) return QStringLiteral("There is no map to export.");
  const std::string path = QDir::toNativeSeparators(request.path).toStdString();
  return fromText(request.format == ExportFormat::MapServer
                      ? raster::writeMapServer(*map.cells, map.reference, path, proceed)
                      : raster::writeGridPng(*map.cells, path, proceed));
}

}  // namespace

QString worldFilePath(const QString& picture_path) {
  const QFileInfo info(picture_path);
  return info.dir().filePath(info.completeBaseName() + QStringLiteral(".pgw"));
}

QString exportSuffix(ExportFormat format) {
  return format == ExportFormat::MapServer ? QStringLiteral("yaml") : QStringLiteral("png");
}

ExportResult exportMap(const ExportRequest& request, const Proceed& proceed) {
  ExportResult result{request.path, {}, false};
  const Proceed watched = [&](double done) {
    if (proceed && !proceed(done)) result.cancelled = true;
    return !result.cancelled;
  };
  Problem problem;
  map::GridReference reference;
  if (const auto* view = std::get_if<ViewExport>(&request.source)) {
    reference = view->reference;
    problem = writeView(*view, request.path);
  } else if (const auto* whole = std::get_if<WholeMapExport>(&request.source)) {
    reference = whole->reference;
    problem = writeGrid(*whole, request, watched);
  } else {
    const auto& submaps = std::get<SubmapsExport>(request.source);
    render::DenseCache cache;
    const auto composed = render::composeGrid(submaps.textures, submaps.resolution_m, cache,
                                              [&](double done) { return watched(done * kComposePart); });
    if (composed) {
      reference = composed->reference;
      problem = writeGrid({composed->cells, composed->reference}, request,
                          [&](double done) { return watched(kComposePart + done * (1 - kComposePart)); });
    } else {
      problem = QString::fromStdString(composed.error());
    }
  }
  if (!problem && !result.cancelled && request.world_file && request.format != ExportFormat::MapServer) {
    problem = writeText(worldFilePath(request.path), raster::worldFileText(reference));
  }
  if (problem && !result.cancelled) result.error = *problem;
  return result;
}

ExportJob::ExportJob(QObject* parent) : QObject(parent) { pool_.setMaxThreadCount(1); }

ExportJob::~ExportJob() {
  cancel();
  pool_.waitForDone();
}

void ExportJob::start(ExportRequest request) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  running_ = true;
  pool_.start([this, cancelled = cancelled_, request = std::move(request)] {
    QElapsedTimer told;
    const ExportResult result = exportMap(request, [&](double done) {
      if (!told.isValid() || told.elapsed() > 50) {
        told.start();
        QMetaObject::invokeMethod(
            this, [this, done] { Q_EMIT progressed(done); }, Qt::QueuedConnection);
      }
      return !cancelled->load();
    });
    QMetaObject::invokeMethod(
        this,
        [this, result] {
          running_ = false;
          Q_EMIT finished(result);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace mapwright::window
