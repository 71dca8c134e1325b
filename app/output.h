// What a command prints, and where it writes: checked before the work begins and before anything is lost.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "disk/existing.h"

namespace mapwright::app {

/// One line of at most `most` characters for a terminal: without control characters and line breaks; longer
/// texts lose their middle.
QString oneLine(const QString& text, qsizetype most = 1'000);
/// A sentence on standard error.
void say(const QString& sentence);
/// Prints why nothing was done. Returns the exit code.
int refuse(int exit_code, const QString& sentence);

/// How far it is, on standard error: a line that is written over. Prints nothing where that is no terminal.
class ProgressLine {
 public:
  ~ProgressLine() { clear(); }
  /// False: nobody sees it.
  bool shown() const { return terminal_; }
  void tell(const QString& line);
  void clear();

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool told_ = false;
};

/// Writes to standard output, for long outputs; false: it accepts no more data. concludeStandardOutput()
/// reports the reason at the end.
bool printOut(std::string_view text);
/// As printOut(), for people to read and programs to parse.
void printLine(const QString& line);
void printJson(const QJsonObject& json);
void printJson(const QJsonArray& json);
/// Columns are as wide as their widest cell; put names into the last one, as they may have any width.
void printTable(const std::vector<QStringList>& rows);
/// From now on nothing of the above is printed: --report writes there.
void leaveStandardOutputToReport();
/// Flushes standard output; if that fails, prints a sentence to standard error and returns another exit code.
int concludeStandardOutput(int exit_code);

/// "-" and equivalent names.
bool isStandardOutput(const QString& path);
/// That, a pipe or a device: data is written to it, nothing is replaced.
bool isStream(const QString& path);
/// A sentence if it is clear beforehand that nothing can be written there.
std::optional<QString> notWritableReason(const QString& path);
/// The same for a PNG, which is not written under the name of another kind of picture.
std::optional<QString> pngNotWritableReason(const QString& path);
/// --report of this name is a page for people, not JSON.
bool isPageName(const std::string& path);
/// A sentence if two of them are the same file. Devices may be used twice; empty paths are ignored.
std::optional<QString> notTogetherReason(const QStringList& outputs);
/// A sentence if one of `outputs` is a file that was read, through any path or link.
std::optional<QString> overOwnSource(const QStringList& outputs, const std::vector<std::string>& sources);
/// A sentence if --report is one of `sources`, which the command reads.
std::optional<QString> reportOverSource(const QString& report, const std::vector<std::string>& sources);
/// Why a file that people edit or cannot make again (all but pictures and reports) cannot be written: one of
/// the sentences above, there is one already and no `force`, or it is one of the recordings `sources` that
/// are read meanwhile, `force` or not. A stream is written into.
std::optional<QString> notCreatedReason(const QString& path, bool force,
                                        const std::vector<std::string>& sources = {});
/// The same for such a file that appears while the command runs.
inline disk::Existing existingBy(bool force) {
  return force ? disk::Existing::Replace : disk::Existing::Refuse;
}

}  // namespace mapwright::app
