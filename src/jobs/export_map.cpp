#include "jobs/export_map.h"

#include <utility>

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImageWriter>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "grids/rows_missing.h"
#include "jobs/faults.h"
#include "render/compose_grid.h"
#include "render/dense_cache.h"
#include "sentences/fault_sentence.h"
#include "words/figures.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::jobs {

namespace {

using Proceed = std::function<bool(double)>;
using Problem = std::optional<Fault>;

constexpr double kComposePart = 0.7;  // of the work, if submaps have to be composed first

Problem told(const std::optional<disk::FileError>& fault) {
  return fault ? Problem(disk::notWritten(*fault)) : std::nullopt;
}

/// Where a picture is whose name was taken; empty: that is not the problem.
QString keptInstead(const Fault& problem) {
  if (problem.because.empty() || problem.because[0].code != disk::fault::NameTaken) return {};
  return QString::fromStdString(std::get<std::string>(problem.because[0].arguments[0]));
}

/// What AMCL and nav2 do not see of what we show; empty if they see all.
QString unseenBy(const grids::SeenByRobots& seen) {
  if (seen.whole()) return {};
  const auto count = [](std::int64_t cells) { return QString::fromStdString(words::grouped(cells)); };
  QStringList said{
      QCoreApplication::translate("window",
                                  "AMCL and Nav2's costmaps will see %1 of %2 wall cells as walls, "
                                  "and %3 of %4 free cells as free.")
          .arg(count(seen.walls), count(seen.shown.occupied), count(seen.free), count(seen.shown.free))};
  if (seen.walls_as_free > 0)
    said << QCoreApplication::translate("window", "%1 wall cells will be free for them.")
                .arg(count(seen.walls_as_free));
  said << QCoreApplication::translate("window", "Mode trinary without thresholds keeps them all.");
  return words::paragraph(said);
}

Problem writeGrid(const WholeMapExport& map, const ExportRequest& request, const Proceed& proceed,
                  QString& remark) {
  if (!map.cells) return Fault(faultText("jobs", "There is no map to export."));
  const std::string path = QDir::toNativeSeparators(request.path).toStdString();
  if (request.format != ExportFormat::MapServer)
    return grids::writeGridPng(*map.cells, path, proceed, request.existing);
  const auto seen =
      grids::writeMapServer(*map.cells, map.reference, path, request.form, proceed, request.existing);
  if (!seen) return seen.error();
  remark = unseenBy(*seen);
  return std::nullopt;
}

}  // namespace

std::optional<Fault> writePicture(const QImage& picture, const QString& path, disk::Existing existing) {
  QBuffer png;
  png.open(QIODevice::WriteOnly);
  QImageWriter writer(&png, "png");
  if (!writer.write(picture)) {
    return Fault(faultText("jobs", "The picture for %1 cannot be encoded: %2."),
                 {path.toStdString(), writer.errorString().toStdString()});
  }
  const auto fault = disk::writeFile(
      path.toStdString(), std::string_view(png.data().constData(), std::size_t(png.data().size())), existing);
  return fault ? std::optional(disk::notWritten(*fault)) : std::nullopt;
}

std::vector<std::string> sourceFiles(const robot::Addresses& addresses, const QString& address,
                                     const std::string& id, const std::string& picture,
                                     const YamlsNaming& yamls_naming) {
  const auto parsed = addresses.parse(address);
  std::vector<std::string> files;
  if (parsed) files = robot::localFiles(*parsed, id, picture);
  if (files.empty() || picture.empty() || !yamls_naming) return files;
  for (const QString& yaml : yamls_naming(QString::fromStdString(picture)))
    files.push_back(yaml.toStdString());
  return files;
}

QString worldFilePath(const QString& picture_path, ExportFormat format) {
  const QFileInfo info(picture_path);
  const bool is_pgm = format == ExportFormat::MapServer;
  return info.absolutePath() + QLatin1Char('/') + info.completeBaseName() +
         (is_pgm ? QStringLiteral(".wld") : QStringLiteral(".pgw"));
}

QStringList exportedFiles(const QString& path, ExportFormat format, bool with_world_file,
                          grids::MapServerForm::Mode mode) {
  QStringList files(path);
  if (format == ExportFormat::MapServer) {
    const grids::MapServerFiles pair = grids::mapServerFiles(path.toStdString(), mode);
    files = {QString::fromStdString(pair.yaml), QString::fromStdString(pair.picture)};
  }
  if (with_world_file) files << worldFilePath(path, format);
  return files;
}

QString firstOwnSource(const QStringList& files, const std::vector<std::string>& sources) {
  for (const QString& file : files) {
    const QFileInfo info(file);
    const bool takes_bytes = disk::isStandardOutput(file.toStdString()) || (info.exists() && !info.isFile());
    if (file.isEmpty() || takes_bytes) continue;
    for (const std::string& source : sources) {
      if (disk::sameFile(file.toStdString(), source)) return file;
    }
  }
  return {};
}

QString mostlyMissingReason(const grids::GridPyramid& cells) {
  constexpr std::int64_t kMuch = 1'000'000;  // cells; less is no trouble for anybody
  const std::int64_t height = cells.height(), missing = grids::rowsMissing(cells), width = cells.width();
  if (missing * width <= kMuch || missing * 2 <= height) return {};
  const auto count = [](std::int64_t number) { return QString::fromStdString(words::grouped(number)); };
  return QCoreApplication::translate("window",
                                     "The picture has only %1 of the %2 rows that its header says: %3 cells "
                                     "would be written as unknown, and %4 are there.")
      .arg(count(height - missing), count(height), count(missing * width), count((height - missing) * width));
}

QString exportSuffix(ExportFormat format) {
  return format == ExportFormat::MapServer ? QStringLiteral("yaml") : QStringLiteral("png");
}

ExportResult exportMap(const ExportRequest& request, const Proceed& proceed, const grids::Resources& means) {
  ExportResult result{request.path, {}, false, {}};
  const Proceed watched = [&](double done) {
    if (proceed && !proceed(done)) result.cancelled = true;
    return !result.cancelled;
  };
  Problem problem;
  map::GridReference reference;
  // Written before the picture and moved into place after it: both exist, or neither.
  std::optional<disk::WrittenFile> world_file;
  const auto writeWorldFile = [&] {
    if (!request.world_file) return true;
    world_file.emplace(worldFilePath(request.path, request.format).toStdString(), request.existing);
    world_file->write(grids::worldFileText(reference));
    if (!world_file->finish()) problem = told(world_file->place());
    return !problem;
  };
  if (const auto* view = std::get_if<ViewExport>(&request.source)) {
    reference = view->reference;
    if (writeWorldFile()) problem = writePicture(view->picture, request.path, request.existing);
  } else if (const auto* whole = std::get_if<WholeMapExport>(&request.source)) {
    reference = whole->reference;
    if (writeWorldFile()) problem = writeGrid(*whole, request, watched, result.remark);
  } else {
    const auto& submaps = std::get<SubmapsExport>(request.source);
    render::DenseCache cache;
    const auto composed = render::composeGrid(
        submaps.textures, submaps.resolution_m, cache,
        [&](double done) { return watched(done * kComposePart); }, means);
    if (composed) {
      reference = composed->reference;
      if (writeWorldFile()) {
        problem = writeGrid(
            {composed->cells, composed->reference}, request,
            [&](double done) { return watched(kComposePart + done * (1 - kComposePart)); }, result.remark);
      }
    } else {
      problem = composed.error();
    }
  }
  if (!problem && !result.cancelled && world_file) problem = told(world_file->place());
  if (problem && !result.cancelled) {
    result.error = sentences::wordsOf(*problem);
    // The place of the picture belongs to where it is.
    if (const QString kept = keptInstead(*problem); world_file && !kept.isEmpty())
      disk::writeFile(worldFilePath(kept, request.format).toStdString(), grids::worldFileText(reference),
                      request.existing);
  }
  return result;
}

}  // namespace mapwright::jobs
