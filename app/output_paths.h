// Where a command writes: checked before the work begins and before anything is lost.
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

/// "-" and equivalent names.
bool isStandardOutput(const QString& path);

/// A sentence if it is clear beforehand that nothing can be written there.
std::optional<QString> whyNotWritable(const QString& path);

/// A sentence if two of them are the same file. Devices may be used twice; empty paths are ignored.
std::optional<QString> whyNotTogether(const QStringList& outputs);

/// A sentence if one of `outputs` is a file that was read, through any path or link.
std::optional<QString> overOwnSource(const QStringList& outputs, const std::vector<std::string>& sources);

/// Writes to standard output, for long outputs; false: it accepts no more data. concludeStandardOutput()
/// reports the reason at the end.
bool printOut(std::string_view text);

/// As printOut(), for people to read and programs to parse.
void printJson(const QJsonObject& json);
void printJson(const QJsonArray& json);

/// Flushes standard output; if that fails, prints a sentence to standard error and returns another exit code.
int concludeStandardOutput(int exit_code);

}  // namespace mapwright::app
