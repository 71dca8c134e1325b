// Where a command writes to: checked before the work begins, and before something is lost.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

namespace mapwright::app {

/// "-" and its other names.
bool isStandardOutput(const QString& path);

/// A sentence when it is known beforehand that nothing can be written there.
std::optional<QString> whyNotWritable(const QString& path);

/// A sentence when two of them are one file. Devices take both. Empty ones are none.
std::optional<QString> whyNotTogether(const QStringList& outputs);

/// A sentence when one of `outputs` is one of the files that were read, by whatever path or link.
std::optional<QString> overOwnSource(const QStringList& outputs, const std::vector<std::string>& sources);

/// Writes to standard output, for what may be long; false: it takes nothing any more. Why not is known to
/// concludeStandardOutput(), whatever the program does until then.
bool printOut(std::string_view text);

/// As printOut(), for people to read and programs to parse.
void printJson(const QJsonObject& json);
void printJson(const QJsonArray& json);

/// Standard output is written out; when that fails, a sentence on standard error and another exit code.
int concludeStandardOutput(int exit_code);

}  // namespace mapwright::app
