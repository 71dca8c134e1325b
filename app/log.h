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

/// --log for the program and each of its commands; `rules` gets what was typed, and outlives them.
void addLog(CLI::App& program, std::string& rules);

/// What "net,session" or "mapwright.net.debug=true; qt.*=true" means to QLoggingCategory::setFilterRules(),
/// or a sentence that says what is wrong with it.
tl::expected<QString, QString> logRules(const QString& typed);

/// From now on messages of Qt and of the program go to standard error, one line each: those of `rules`
/// (--log), else of MAPWRIGHT_LOG; errors alone where neither is given. The error is a sentence.
tl::expected<void, QString> startLog(const std::string& rules);

/// Never in the log from now on, whoever says it. Any thread.
void hideInLog(const QByteArray& secret);

}  // namespace mapwright::app
