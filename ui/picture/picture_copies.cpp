#include "ui/picture/picture_copies.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

#include "grids/export_grid.h"
#include "jobs/export_map.h"

namespace mapwright::window {

namespace {

/// Sorted by time, according to the names from copyPath().
QStringList copiesIn(const QDir& folder) {
  static const QRegularExpression made(
      QStringLiteral("^\\d{4}-\\d\\d-\\d\\d_\\d\\d-\\d\\d-\\d\\d-\\d{3}\\.yaml$"));
  return folder.entryList(QDir::Files, QDir::Name).filter(made);
}

}  // namespace

QString copiesFolder(const QString& drafts_folder, const QString& robot, const QString& map) {
  if (drafts_folder.isEmpty()) return {};
  return QDir(QFileInfo(QDir(drafts_folder).absolutePath()).path())
      .filePath(QStringLiteral("overwritten/%1/%2").arg(jobs::fileNameFrom(robot), jobs::fileNameFrom(map)));
}

QString copyPath(const QString& folder, const QDateTime& now) {
  return QDir(folder).filePath(now.toUTC().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss-zzz")) +
                               QStringLiteral(".yaml"));
}

std::optional<Fault> keepCopy(const grids::GridPyramid& cells, const map::GridReference& reference,
                              const QString& path) {
  const QDir folder = QFileInfo(path).dir();
  QDir().mkpath(folder.path());  // if that fails, the next step fails, too, and reports why
  if (auto trouble = grids::writeMapServer(cells, reference, QFile::encodeName(path).toStdString()))
    return trouble;
  const QStringList copies = copiesIn(folder);
  for (qsizetype i = 0; i + kMostCopies < copies.size(); ++i) {
    const auto files = grids::mapServerFiles(QFile::encodeName(folder.filePath(copies[i])).toStdString());
    QFile::remove(QFile::decodeName(files.yaml.c_str()));
    QFile::remove(QFile::decodeName(files.pgm.c_str()));
  }
  return std::nullopt;
}

}  // namespace mapwright::window
