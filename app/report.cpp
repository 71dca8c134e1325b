#include "app/report.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include "app/command_text.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

QJsonValue jsonOr(const std::optional<int>& number) { return number ? QJsonValue(*number) : QJsonValue(); }

}  // namespace

QJsonObject submapsJson(const session::SubmapCounts& counts) {
  return {{QStringLiteral("listed"), counts.listed},
          {QStringLiteral("drawn"), counts.shown},
          {QStringLiteral("missing"), counts.missing},
          {QStringLiteral("failed"), counts.failed},
          {QStringLiteral("pending"), counts.pending},
          {QStringLiteral("corrupt"), counts.corrupt},
          {QStringLiteral("without_slice"), counts.without_slice}};
}

QJsonObject trafficJson(const session::SubmapCounts& counts) {
  return {{QStringLiteral("bytes_fetched"), qint64(counts.bytes_fetched)},
          {QStringLiteral("fetches"), qint64(counts.fetches)},
          {QStringLiteral("cache_hits"), qint64(counts.cache_hits)}};
}

QJsonObject gridJson(const map::GridReference& grid) {
  const bool size_known = grid.width > 0 && grid.height > 0;  // otherwise its picture was not opened
  return {
      {QStringLiteral("size"), size_known ? QJsonValue(QJsonArray{grid.width, grid.height}) : QJsonValue()},
      {QStringLiteral("resolution"), grid.resolution_m},
      {QStringLiteral("origin"), QJsonArray{grid.origin.x_m, grid.origin.y_m, grid.origin.yaw_rad}}};
}

QJsonObject entryJson(const map::CatalogueEntry& row) {
  QJsonObject json{{QStringLiteral("id"), QString::fromStdString(map::toText(row.key))},
                   {QStringLiteral("name"), QString::fromStdString(row.name)},
                   {QStringLiteral("uid"), QString::fromStdString(row.uid)},
                   {QStringLiteral("kind"), row.key.kind == map::MapKind::Mapping ? QStringLiteral("mapping")
                                            : row.key.kind == map::MapKind::File  ? QStringLiteral("file")
                                                                                  : QStringLiteral("map")},
                   {QStringLiteral("current"), row.is_current},
                   {QStringLiteral("archived"), row.is_archived},
                   {QStringLiteral("map_version"), jsonOr(row.map_version)},
                   {QStringLiteral("overlays_version"), jsonOr(row.overlays_version)},
                   {QStringLiteral("created"), row.created_s ? QJsonValue(*row.created_s) : QJsonValue()},
                   {QStringLiteral("modified"), row.modified_s ? QJsonValue(*row.modified_s) : QJsonValue()}};
  if (!row.file_name.empty()) json[QStringLiteral("map_name")] = QString::fromStdString(row.file_name);
  if (!row.state.empty()) json[QStringLiteral("state")] = QString::fromStdString(row.state);
  json[QStringLiteral("grid")] = row.grid ? QJsonValue(gridJson(*row.grid)) : QJsonValue();
  return json;
}

QJsonObject mapJson(const map::MapKey& key, const QString& name, const map::GridReference& grid) {
  QJsonObject json = gridJson(grid);
  json[QStringLiteral("id")] = QString::fromStdString(map::toText(key));
  json[QStringLiteral("name")] = name;
  return json;
}

QString problemLine(map::Problem problem) {
  // A command that is over does not request it again.
  Consequence& then = problem.reason.then;
  if (then == Consequence::AskedAgain || then == Consequence::AskedAgainAtTheNext) then = Consequence::None;
  if (then == Consequence::ShownWithoutItUntilTheNext) then = Consequence::ShownWithoutIt;
  return words::about(sentences::nameOf(problem.subject), sentences::sentenceOf(problem));
}

QStringList problemLines(const session::ProblemLog& log) {
  QStringList lines;
  for (const map::Severity severity : {map::Severity::Error, map::Severity::Warning, map::Severity::Info}) {
    for (const session::LoggedProblem& row : log.rows()) {
      if (row.resolved || row.problem.severity != severity) continue;
      lines << problemLine(row.problem);
    }
  }
  return lines;
}

bool anyRefused(const session::ProblemLog& log) {
  return std::any_of(log.rows().begin(), log.rows().end(), [](const session::LoggedProblem& row) {
    return !row.resolved && row.problem.severity == map::Severity::Error &&
           row.problem.failure == map::FailureKind::Refused;
  });
}

QStringList bagLosses(const session::ProblemLog& log) {
  QStringList lines;
  for (const session::LoggedProblem& row : log.rows()) {
    const map::Problem& problem = row.problem;
    const bool lost =
        problem.code == map::ProblemCode::Unreadable || problem.code == map::ProblemCode::Unavailable;
    if (!row.resolved && problem.subject.kind == map::SubjectKind::Bag && lost &&
        problem.severity >= map::Severity::Warning)
      lines << problemLine(problem);
  }
  return lines;
}

QString firstOf(const QStringList& lines) {
  if (lines.size() < 2) return lines.isEmpty() ? QString() : lines.first();
  return Text::tr("%1 (and %2 more; --report lists them)")
      .arg(lines.first(), QString::number(lines.size() - 1));
}

std::optional<QString> writeReport(const QString& path, const QJsonObject& report) {
  const auto fault =
      disk::writeFile(path.toStdString(), words::escapedJson(QJsonDocument(report).toJson()).toStdString());
  return fault ? std::optional(sentences::wordsOf(disk::notWritten(*fault))) : std::nullopt;
}

bool writeReportInHaste(const QString& path, const QJsonObject& report) {
  const QByteArray json = words::escapedJson(QJsonDocument(report).toJson());
  if (disk::isStandardOutput(path.toStdString())) {
    return ::write(STDOUT_FILENO, json.constData(), std::size_t(json.size())) == json.size();
  }
  const QFileInfo target(path);
  const bool aside = !target.exists() || target.isFile();  // not next to a device
  QFile file(aside ? path + QStringLiteral(".part") : path);
  const bool written = file.open(QIODevice::WriteOnly) && file.write(json) == json.size() && file.flush();
  file.close();
  if (!aside) return written;
  const bool moved = written && std::rename(QFile::encodeName(file.fileName()).constData(),
                                            QFile::encodeName(path).constData()) == 0;
  if (!moved) file.remove();
  return moved;
}

qint64 peakMemoryBytes() {
  // getrusage() would return the parent's peak if that is higher.
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QIODevice::ReadOnly)) return 0;
  for (const QByteArray& line : status.readAll().split('\n')) {
    if (line.startsWith("VmHWM:")) return line.mid(6).trimmed().split(' ').first().toLongLong() * 1024;
  }
  return 0;
}

}  // namespace mapwright::app
