// The log that people switch on (docs/troubleshooting.md, "The log").
#pragma once

#include <string>

#include <QByteArray>
#include <QLoggingCategory>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

namespace CLI {
class App;
}

namespace mapwright::app {

Q_DECLARE_LOGGING_CATEGORY(lcApp)

/// As typed; empty = not given.
struct LogArguments {
  std::string rules, file;
};
/// --log and --log-file for the program and each of its commands; `args` outlives them.
void addLog(CLI::App& program, LogArguments& args);

/// What "net,session" or "mapwright.net.debug=true; qt.*=true" means to QLoggingCategory::setFilterRules(),
/// or a sentence that says what is wrong with it.
tl::expected<QString, QString> logRules(const QString& typed);

/// From now on messages of Qt and of the program go to the file, or else to standard error, one line each:
/// those of the rules (--log), else of MAPWRIGHT_LOG. Where neither is given all goes to the file, and only
/// errors to standard error. The error is a sentence; a file that cannot be written is said and is none.
tl::expected<void, QString> startLog(const LogArguments& args);

/// Never in the log from now on, whoever says it. Any thread.
void hideInLog(const QByteArray& secret);

}  // namespace mapwright::app
