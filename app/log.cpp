#include "app/log.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <mutex>

#include <CLI/CLI.hpp>
#include <QRegularExpression>
#include <QUrl>

#include "app/command_text.h"
#include "app/commands.h"
#include "app/log_file.h"
#include "app/output.h"
#include "net/log.h"
#include "net/unsaid.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

const QStringList kParts = {QStringLiteral("app"),       QStringLiteral("net"),   QStringLiteral("cache"),
                            QStringLiteral("rosbridge"), QStringLiteral("axbot"), QStringLiteral("aimdk"),
                            QStringLiteral("ros"),       QStringLiteral("files"), QStringLiteral("recorded"),
                            QStringLiteral("session"),   QStringLiteral("edit"),  QStringLiteral("recorder")};

/// Qt's message handler is a plain function: what it needs can lie nowhere else. Never destroyed, for other
/// threads may still write when the program ends.
struct Hidden {
  std::mutex mutex;
  std::map<QByteArray, net::Unsaid> secrets{{QByteArray(), {}}};  // also without one: what proves it
  /// An address with more in it than a host and a path.
  const QRegularExpression address{
      QStringLiteral("[A-Za-z][A-Za-z0-9+.-]*://[^\\s\"'<>]*[?@#][^\\s\"'<>]*"
                     "[^\\s\"'<>:,;.)]")};
};
Hidden& hidden() {
  static Hidden* const all = new Hidden;
  return *all;
}

QString withoutSecrets(QString line) {
  qsizetype at = 0;
  for (auto match = hidden().address.match(line); match.hasMatch();
       match = hidden().address.match(line, at)) {
    const QString shown = net::urlForLog(QUrl(match.captured()));
    line.replace(match.capturedStart(), match.capturedLength(), shown);
    at = match.capturedStart() + shown.size();
  }
  const std::lock_guard lock(hidden().mutex);
  for (const auto& [typed, secret] : hidden().secrets) secret.hideIn(line);
  return line;
}

/// Qt's own remarks (a missing XDG_RUNTIME_DIR, say) are no business of whoever reads our one line of error.
void keepQtQuiet(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtCriticalMsg || type == QtFatalMsg) std::fprintf(stderr, "%s\n", qUtf8Printable(message));
}

std::string lineOf(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  return words::plainLine(withoutSecrets(qFormatLogMessage(type, context, message))).toStdString();
}

void writeLine(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  std::fprintf(stderr, "%s\n", lineOf(type, context, message).c_str());
}

/// Where the message handler finds it; never destroyed, as Hidden.
LogFile& logFile() {
  static LogFile* const file = new LogFile;
  return *file;
}

void writeInFile(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  if (const auto lost = logFile().write(lineOf(type, context, message))) say(*lost);
  keepQtQuiet(type, context, message);
}

}  // namespace

Q_LOGGING_CATEGORY(lcApp, "mapwright.app", QtWarningMsg)

void addLog(CLI::App& program, LogArguments& args) {
  program.add_option("--log", args.rules,
                     help(Text::tr("Log to standard error: all, parts of the program such as net,session, or "
                                   "rules of Qt such as mapwright.net.debug=true (or MAPWRIGHT_LOG)")));
  program.add_option(
      "--log-file", args.file,
      help(Text::tr("Log to this file instead, and everything where there is no --log; at 2 MB it "
                    "becomes FILE.1, and so on to FILE.4")));
  for (CLI::App* command : program.get_subcommands({})) addLog(*command, args);
}

tl::expected<QString, QString> logRules(const QString& typed) {
  static const QRegularExpression kBetween(QStringLiteral("[;,\\n]"));
  // As QLoggingCategory takes them: a star stands first, last, or alone.
  static const QRegularExpression kRule(
      QStringLiteral("^(\\*?[\\w.-]*?\\*?)(\\.(?:debug|info|warning|critical))?\\s*=\\s*(true|false)$"));
  // What others remark without a category is no part of it, unless it is asked for.
  QStringList rules{QStringLiteral("default.debug=false"), QStringLiteral("default.info=false"),
                    QStringLiteral("default.warning=false")};
  for (const QString& part : typed.split(kBetween, Qt::SkipEmptyParts)) {
    const QString rule = part.trimmed();
    if (rule.isEmpty()) continue;
    if (rule == QLatin1String("all")) {
      rules << QStringLiteral("mapwright.*=true");
      continue;
    }
    const QString own = rule.startsWith(QLatin1String("mapwright.")) ? rule.mid(10) : rule;
    if (kParts.contains(own)) {
      rules << QStringLiteral("mapwright.%1=true").arg(own);
      continue;
    }
    const QRegularExpressionMatch parts = kRule.match(rule);
    const QString category = parts.captured(1);
    const bool unknown = category.startsWith(QLatin1String("mapwright.")) &&
                         !category.contains(QLatin1Char('*')) && !kParts.contains(category.mid(10));
    if (!parts.hasMatch() || category.isEmpty() || unknown) {
      return tl::make_unexpected(
          Text::tr("\"%1\" is no rule for the log. Give all, some of %2, or rules such as "
                   "mapwright.net.debug=true.")
              .arg(rule, words::listed(kParts)));
    }
    // "net=false" behind "all".
    rules << (kParts.contains(category) ? QStringLiteral("mapwright.") + rule : rule);
  }
  return rules.join(QLatin1Char('\n'));
}

tl::expected<void, QString> startLog(const LogArguments& given) {
  const bool typed = !given.rules.empty();
  QString args = typed ? QString::fromStdString(given.rules) : qEnvironmentVariable("MAPWRIGHT_LOG");
  const bool in_file = !given.file.empty();
  if (args.trimmed().isEmpty()) {
    qInstallMessageHandler(keepQtQuiet);
    if (!in_file) return {};
    args = QStringLiteral("all");
  }
  const auto rules = logRules(args);
  if (!rules) {
    return tl::make_unexpected((typed ? QStringLiteral("--log: ") : QStringLiteral("MAPWRIGHT_LOG: ")) +
                               rules.error());
  }
  if (in_file) {
    if (const auto lost = logFile().open(given.file)) {
      say(*lost);
      qInstallMessageHandler(keepQtQuiet);
      return {};
    }
  }
  // A file is read days later.
  qSetMessagePattern(in_file ? QStringLiteral("%{time yyyy-MM-dd hh:mm:ss.zzz} %{category}: %{message}")
                             : QStringLiteral("%{time hh:mm:ss.zzz} %{category}: %{message}"));
  qInstallMessageHandler(in_file ? writeInFile : writeLine);
  QLoggingCategory::setFilterRules(*rules);
  qCInfo(lcApp, "mapwright %s, Qt %s", MAPWRIGHT_VERSION, qVersion());
  return {};
}

void hideInLog(const QByteArray& secret) {
  if (secret.isEmpty()) return;
  const std::lock_guard lock(hidden().mutex);
  hidden().secrets.try_emplace(secret, secret, 1);
}

}  // namespace mapwright::app
