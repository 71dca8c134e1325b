#include "app/output.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <QFileInfo>
#include <QJsonDocument>

#include "app/command_text.h"
#include "app/exit_code.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "jobs/export_map.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

int why_not_printed = 0;  // the first errno of a failed write to standard output
bool left_to_report = false;

/// A pipe or a device: data is written to it, nothing is replaced.
bool takesBytes(const QString& path) {
  const QFileInfo info(path);
  return info.exists() && !info.isFile() && !info.isDir();
}

}  // namespace

QString oneLine(const QString& text, qsizetype most) {
  QString line = words::plainLine(text);
  if (line.size() > most) line = line.left(most / 2) + QStringLiteral(" … ") + line.right(most / 2 - 3);
  return line;
}

void say(const QString& sentence) { std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(sentence))); }

int refuse(int exit_code, const QString& sentence) {
  say(sentence);
  return exit_code;
}

void ProgressLine::tell(const QString& line) {
  if (!terminal_) return;
  std::fprintf(stderr, "\r%-70s", qUtf8Printable(line));
  told_ = true;
}

void ProgressLine::clear() {
  if (told_) std::fprintf(stderr, "\r%-70s\r", "");
  told_ = false;
}

bool isStandardOutput(const QString& path) { return disk::isStandardOutput(path.toStdString()); }

bool isStream(const QString& path) { return isStandardOutput(path) || takesBytes(path); }

std::optional<QString> notWritableReason(const QString& path) {
  if (isStandardOutput(path)) {
    if (isatty(STDOUT_FILENO) == 0) return std::nullopt;
    return Text::tr("%1: the standard output is a terminal. Redirect it to a file or another program.")
        .arg(path);
  }
  // The target of a link is found when it is written.
  if (takesBytes(path) || QFileInfo(path).isSymLink()) return std::nullopt;
  const QFileInfo folder(QFileInfo(path).absolutePath());
  if (folder.isDir() && folder.isWritable()) return std::nullopt;
  return Text::tr("%1 cannot be written: the folder %2 does not exist or is not writable.")
      .arg(path, folder.filePath());
}

std::optional<QString> pngNotWritableReason(const QString& path) {
  static const QStringList kOthers{QStringLiteral("jpg"),  QStringLiteral("jpeg"), QStringLiteral("bmp"),
                                   QStringLiteral("gif"),  QStringLiteral("tif"),  QStringLiteral("tiff"),
                                   QStringLiteral("webp"), QStringLiteral("svg"),  QStringLiteral("pgm"),
                                   QStringLiteral("ppm"),  QStringLiteral("pdf")};
  if (kOthers.contains(QFileInfo(path).suffix().toLower()))
    return Text::tr("%1: only PNG is written here. Choose a name that ends in .png.").arg(path);
  return notWritableReason(path);
}

bool isPageName(const std::string& path) {
  const QString suffix = QFileInfo(words::text(path)).suffix().toLower();
  return suffix == QLatin1String("html") || suffix == QLatin1String("htm");
}

std::optional<QString> notTogetherReason(const QStringList& outputs) {
  for (qsizetype i = 0; i < outputs.size(); ++i) {
    for (qsizetype j = i + 1; j < outputs.size(); ++j) {
      const QString &one = outputs[i], &other = outputs[j];
      if (one.isEmpty() || other.isEmpty()) continue;
      if (isStandardOutput(one) && isStandardOutput(other)) {
        return Text::tr("Only one of the outputs can go to the standard output.");
      }
      if (isStandardOutput(one) || isStandardOutput(other) || takesBytes(one)) continue;
      const bool same = QFileInfo(one).absoluteFilePath() == QFileInfo(other).absoluteFilePath() ||
                        disk::sameFile(one.toStdString(), other.toStdString());
      if (same) return Text::tr("%1 and %2 are the same file. Choose two different ones.").arg(one, other);
    }
  }
  return std::nullopt;
}

std::optional<QString> overOwnSource(const QStringList& outputs, const std::vector<std::string>& sources) {
  const QString own = jobs::firstOwnSource(outputs, sources);
  if (own.isEmpty()) return std::nullopt;
  return Text::tr("%1 is a file that the map is read from. Pass --force to replace it.").arg(own);
}

std::optional<QString> reportOverSource(const QString& report, const std::vector<std::string>& sources) {
  if (jobs::firstOwnSource({report}, sources).isEmpty()) return std::nullopt;
  return Text::tr("%1 is a file that this command reads. Choose another one for --report.").arg(report);
}

std::optional<QString> notCreatedReason(const QString& path, bool force,
                                        const std::vector<std::string>& sources) {
  if (auto why = notWritableReason(path)) return why;
  if (!jobs::firstOwnSource({path}, sources).isEmpty())
    return Text::tr("%1 is the recording itself. Choose another name.").arg(path);
  if (QFileInfo::exists(path) && !isStream(path) && !force)
    return Text::tr("%1 already exists. Pass --force to replace it.").arg(path);
  return std::nullopt;
}

bool printOut(std::string_view text) {
  if (left_to_report) return true;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written && why_not_printed == 0) why_not_printed = errno;
  return std::ferror(stdout) == 0;
}

void printLine(const QString& line) { printOut(line.toStdString() + "\n"); }

void printJson(const QJsonObject& json) {
  printOut(words::escapedJson(QJsonDocument(json).toJson()).toStdString());
}

void printJson(const QJsonArray& json) {
  printOut(words::escapedJson(QJsonDocument(json).toJson()).toStdString());
}

void leaveStandardOutputToReport() { left_to_report = true; }

int concludeStandardOutput(int exit_code) {
  const bool flushed = std::fflush(stdout) == 0;
  // The first failure has the reason; errno only describes the last call.
  if (!flushed && why_not_printed == 0) why_not_printed = errno;
  if (flushed && std::ferror(stdout) == 0) return exit_code;
  // Whoever reads has seen enough, as head does.
  if (why_not_printed == EPIPE) return exit_code;
  QString sentence = Text::tr("The standard output cannot be written.");
  if (why_not_printed != 0)
    sentence = Text::tr("The standard output cannot be written: %1.")
                   .arg(QString::fromLocal8Bit(std::strerror(why_not_printed)));
  say(sentence);
  return kUsage;
}

namespace {

/// Columns of a terminal: Chinese, Japanese and Korean characters take two.
qsizetype columnsOf(const QString& text) {
  return text.size() + std::count_if(text.begin(), text.end(), [](QChar c) {
           const char16_t code = c.unicode();
           return (code >= 0x1100 && code < 0x1160) || (code >= 0x2e80 && code < 0xa4d0) ||
                  (code >= 0xac00 && code < 0xd7a4) || (code >= 0xf900 && code < 0xfb00) ||
                  (code >= 0xfe30 && code < 0xfe70) || (code >= 0xff00 && code < 0xff61);
         });
}

}  // namespace

void printTable(const std::vector<QStringList>& rows) {
  std::vector<qsizetype> widths;
  for (const QStringList& row : rows) {
    widths.resize(std::max(widths.size(), std::size_t(row.size())));
    for (qsizetype i = 0; i < row.size(); ++i)
      widths[std::size_t(i)] = std::max(widths[std::size_t(i)], columnsOf(row[i]));
  }
  for (const QStringList& row : rows) {
    QString line;
    for (qsizetype i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size())
        line += QString(widths[std::size_t(i)] + 2 - columnsOf(row[i]), QLatin1Char(' '));
    }
    printOut(words::plainLine(line).toStdString() + "\n");
  }
}

}  // namespace mapwright::app
