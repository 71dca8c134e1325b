#include "app/snapshot.h"

#include <cstdio>
#include <unistd.h>

#include <QApplication>
#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

#include "app/deadline.h"
#include "app/display.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/report.h"
#include "app/robot_access.h"
#include "app/robot_factory.h"
#include "app/say.h"
#include "app/snapshot_run.h"
#include "replay/replay_robot.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class SnapshotText {
  Q_DECLARE_TR_FUNCTIONS(Snapshot)
};

/// Called at the deadline if the run is not finished: reports it, also in the report.
int giveUp(const SnapshotOptions& options, const SnapshotStanding& standing) {
  if (!options.report.isEmpty()) writeReportInHaste(options.report, standing.report);
  if (options.json && !isStandardOutput(options.report)) {
    const QByteArray json = words::escapedJson(QJsonDocument(standing.report).toJson());
    if (write(STDOUT_FILENO, json.constData(), std::size_t(json.size())) < 0) return kIncomplete;
  }
  sayAtTheEnd(oneLine(standing.sentence).toStdString());
  return standing.exit_code;
}

QString summaryOf(const SnapshotRun& run) {
  const QJsonObject report = run.report();
  if (const QJsonObject region = report[QLatin1String("region")].toObject(); !region.isEmpty()) {
    return SnapshotText::tr("%1: regions of the map: %2 of %3")
        .arg(run.options().output, QString::number(region[QLatin1String("answered")].toInt()),
             QString::number(region[QLatin1String("parts")].toInt()));
  }
  if (report[QLatin1String("mode")].toString() == QLatin1String("whole")) {
    const QJsonObject map = report[QLatin1String("map")].toObject();
    if (map.isEmpty()) return SnapshotText::tr("%1: no map").arg(run.options().output);
    const QJsonArray size = map[QLatin1String("size")].toArray();
    const QString name = words::plainName(map[QLatin1String("name")].toString());
    return SnapshotText::tr("%1: map %2%3, %4 x %5 cells")
        .arg(run.options().output, map[QLatin1String("id")].toString(),
             name.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(name),
             QString::number(size.at(0).toInt()), QString::number(size.at(1).toInt()));
  }
  const QJsonObject submaps = report[QLatin1String("submaps")].toObject();
  QString line = SnapshotText::tr("%1: %2 of %3 submaps")
                     .arg(run.options().output, QString::number(submaps[QLatin1String("drawn")].toInt()),
                          QString::number(submaps[QLatin1String("listed")].toInt()));
  for (const auto& [kind, counted] :
       {std::pair{"missing", SnapshotText::tr(", %1 missing")},
        std::pair{"failed", SnapshotText::tr(", %1 failed")},
        std::pair{"corrupt", SnapshotText::tr(", %1 corrupt")},
        std::pair{"without_slice", SnapshotText::tr(", %1 without this slice")}}) {
    if (const int count = submaps[QLatin1String(kind)].toInt()) line += counted.arg(count);
  }
  return line;
}

/// Writes the report and the terminal output; returns the exit code.
int sayWhatCame(const SnapshotRun& run, int exit_code) {
  const QJsonObject report = run.report();
  const QString& report_path = run.options().report;
  if (!report_path.isEmpty() && !run.overItsSource()) {
    if (const auto problem = writeReport(report_path, report)) return refuse(kUsage, *problem);
  }
  const bool printed = isStandardOutput(report_path) || isStandardOutput(run.options().output);
  if (run.options().json && !isStandardOutput(report_path)) printJson(report);
  if (!run.error().isEmpty()) return refuse(exit_code, run.error());
  if (!run.options().json && !printed) std::printf("%s\n", qUtf8Printable(oneLine(summaryOf(run))));
  if (exit_code == kDone) {
    if (!run.shownInstead().isEmpty())
      std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(run.shownInstead())));
    return kDone;
  }
  return refuse(exit_code, SnapshotText::tr("Incomplete. %1").arg(firstOf(run.warnings())));
}

}  // namespace

int snapshot(const SnapshotWords& words, int& argc, char** argv) {
  const CommandStart start = commandStart(words.timeout_s, processAge());
  auto options = parseSnapshotOptions(words);
  if (!options) return refuse(kUsage, options.error());
  // Outlives everything that may take time, including destruction.
  Deadline deadline(app::later(start.begun, options->timeout_s + start.grace.end_s),
                    [late = SnapshotText::tr("%1: no connection was made in time.")
                                .arg(oneLine(options->robot))
                                .toStdString()] {
                      sayAtTheEnd(late);
                      return int(kUnreachable);
                    });
  const auto fonts = chooseOffscreenPlatform();
  QApplication application(argc, argv);
  const auto access = RobotAccess::read(words.access, options->robot);
  if (!access) return refuse(kUsage, access.error());
  auto robot = makeRobot(options->robot, access->forAddress(options->robot), DemoTime::Frozen);
  if (!robot) return refuse(kUsage, robot.error());

  if (!options->bag.empty()) *robot = std::make_unique<replay::ReplayRobot>(std::move(*robot), options->bag);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  SnapshotRun run(std::move(*options), std::move(*robot), start);
  deadline.setLastWords(
      [options = run.options(), standing = run.standing()] { return giveUp(options, standing->take()); });
  int exit_code = kDone;
  if (terminal) {
    QObject::connect(&run, &SnapshotRun::progressed,
                     [](const QString& line) { std::fprintf(stderr, "\r%-70s", qUtf8Printable(line)); });
  }
  QObject::connect(
      &run, &SnapshotRun::finished, &application,
      [&](int code) {
        exit_code = code;
        application.quit();
      },
      Qt::QueuedConnection);
  run.start();
  QApplication::exec();
  if (terminal) std::fprintf(stderr, "\r%-70s\r", "");
  exit_code = sayWhatCame(run, exit_code);
  std::fflush(stdout);
  // Everything has been reported: cleaning up must not take longer than the remaining time.
  deadline.setLastWords([exit_code] { return exit_code; });
  return exit_code;
}

}  // namespace mapwright::app
