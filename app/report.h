// What a command reports, as JSON and as text. Pure, except for the memory figure.
#pragma once

#include <optional>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "map/catalogue.h"
#include "session/problem_log.h"
#include "session/session.h"

namespace mapwright::app {

/// {"listed", "drawn", "missing", "failed", "corrupt", "without_slice"}
QJsonObject submapsJson(const session::SubmapCounts& counts);
/// {"bytes_fetched", "fetches", "cache_hits"}
QJsonObject trafficJson(const session::SubmapCounts& counts);
/// {"size", "resolution", "origin"}
QJsonObject gridJson(const map::GridReference& grid);
/// A row of `maps list --json` (docs/json.md).
QJsonObject entryJson(const map::CatalogueEntry& row);
/// {"id", "name", "size", "resolution", "origin"}
QJsonObject mapJson(const map::MapKey& key, const QString& name, const map::GridReference& grid);

/// "Map 12: It breaks off."
QString problemLine(map::Problem problem);
/// Current problems, one line each, most severe first: a terminal shows only the first one.
QStringList problemLines(const session::ProblemLog& log);
/// Something could not be loaded because the secret is wrong or missing.
bool anyRefused(const session::ProblemLog& log);
/// What is lost of a bag because its file is damaged or cut off; one line each.
QStringList bagLosses(const session::ProblemLog& log);
/// The first line and the number of others; "" if there is none.
QString firstOf(const QStringList& lines);

/// nullopt = written, else a sentence. "-" is the standard output.
std::optional<QString> writeReport(const QString& path, const QJsonObject& report);

/// The same after the time limit: does not wait for the disk to confirm.
bool writeReportInHaste(const QString& path, const QJsonObject& report);

/// Peak memory use of this program.
qint64 peakMemoryBytes();

}  // namespace mapwright::app
