// What a command says of its work, as JSON and in words. Pure, but for the memory.
#pragma once

#include <optional>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "map/catalogue.h"
#include "session/problem_log.h"
#include "session/session.h"

namespace mapwright::app {

/// Everything that is listed and has the chosen slice is there, and none has a newer version on its way.
bool submapsComplete(const session::SubmapCounts& counts);
/// {"listed", "drawn", "missing", "failed", "corrupt", "without_slice"}
QJsonObject submapsJson(const session::SubmapCounts& counts);
/// {"bytes_fetched", "fetches", "cache_hits"}
QJsonObject trafficJson(const session::SubmapCounts& counts);
/// {"size", "resolution", "origin"}
QJsonObject gridJson(const map::GridReference& grid);
/// A row of `maps list --json` (docs/command-line.md).
QJsonObject entryJson(const map::CatalogueEntry& row);
/// {"id", "name", "size", "resolution", "origin"}
QJsonObject mapJson(const map::MapKey& key, const QString& name, const map::GridReference& grid);

/// "Map 12: It breaks off."
QString problemLine(const map::Problem& problem);
/// What is wrong now, one line each, the gravest first: a terminal shows no more than one.
QStringList problemLines(const session::ProblemLog& log);
/// Something could not be had for want of the right secret, and still cannot.
bool anyRefused(const session::ProblemLog& log);
/// What is lost of a bag, because its file is damaged or cut off; one line each.
QStringList bagLosses(const session::ProblemLog& log);
/// The first and how many more there are; "" when there is none.
QString firstOf(const QStringList& lines);

/// nullopt = written, else a sentence. "-" is the standard output.
std::optional<QString> writeReport(const QString& path, const QJsonObject& report);

/// The same when the time is over: a disk that takes long to confirm is not waited for.
bool writeReportInHaste(const QString& path, const QJsonObject& report);

/// The most memory this program has held.
qint64 peakMemoryBytes();

}  // namespace mapwright::app
