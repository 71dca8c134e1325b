#include "app/snapshot.h"

#include <cstdio>
#include <unistd.h>

#include <QApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>

#include "app/display.h"
#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/robot_factory.h"
#include "app/secret.h"
#include "app/snapshot_run.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

int refuse(int exit_code, const QString& sentence) {
  std::fprintf(stderr, "%s\n", qUtf8Printable(oneLine(sentence)));
  return exit_code;
}

bool writeReport(const QString& path, const QJsonObject& report) {
  QSaveFile file(path);
  return file.open(QIODevice::WriteOnly) &&
         file.write(words::escapedJson(QJsonDocument(report).toJson())) > 0 && file.commit();
}

QString summaryOf(const SnapshotRun& run) {
  const QJsonObject report = run.report();
  if (report[QLatin1String("mode")].toString() == QLatin1String("whole")) {
    const QJsonObject map = report[QLatin1String("map")].toObject();
    const QJsonArray size = map[QLatin1String("size")].toArray();
    const QString name = words::plainName(map[QLatin1String("name")].toString());
    return QStringLiteral("%1: map %2%3, %4 x %5 cells")
        .arg(run.options().output, map[QLatin1String("id")].toString(),
             name.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(name))
        .arg(size.at(0).toInt())
        .arg(size.at(1).toInt());
  }
  const QJsonObject submaps = report[QLatin1String("submaps")].toObject();
  QString line = QStringLiteral("%1: %2 of %3 submaps")
                     .arg(run.options().output)
                     .arg(submaps[QLatin1String("drawn")].toInt())
                     .arg(submaps[QLatin1String("listed")].toInt());
  for (const char* kind : {"missing", "failed", "corrupt", "without_slice"}) {
    if (const int count = submaps[QLatin1String(kind)].toInt()) {
      line += QStringLiteral(", %1 %2").arg(count).arg(
          QString::fromLatin1(kind).replace(QLatin1Char('_'), QLatin1Char(' ')));
    }
  }
  return line;
}

}  // namespace

int snapshot(const SnapshotWords& words, int& argc, char** argv) {
  chooseOffscreenPlatform();
  QApplication application(argc, argv);
  auto options = parseSnapshotOptions(words);
  if (!options) return refuse(kUsage, options.error());
  const auto secret = readSecret(options->secret_file);
  if (!secret) return refuse(kUsage, secret.error());
  auto robot = makeRobot(options->robot, *secret, DemoTime::Frozen);
  if (!robot) return refuse(kUsage, robot.error());

  const bool terminal = isatty(STDERR_FILENO) != 0;
  SnapshotRun run(std::move(*options), std::move(*robot));
  int exit_code = kDone;
  QObject::connect(&run, &SnapshotRun::progressed, [&](const QString& line) {
    if (terminal) std::fprintf(stderr, "\r%-70s", qUtf8Printable(line));
  });
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

  if (!run.options().report.isEmpty() && !writeReport(run.options().report, run.report())) {
    return refuse(kUsage, QStringLiteral("%1 cannot be written.").arg(run.options().report));
  }
  if (run.options().json)
    std::printf("%s", words::escapedJson(QJsonDocument(run.report()).toJson()).constData());
  if (!run.error().isEmpty()) return refuse(exit_code, run.error());
  if (!run.options().json) std::printf("%s\n", qUtf8Printable(oneLine(summaryOf(run))));
  if (exit_code != kDone) {
    const QStringList warnings = run.warnings();
    refuse(exit_code,
           QStringLiteral("Not complete. %1%2")
               .arg(warnings.isEmpty() ? QString() : warnings.first(),
                    warnings.size() > 1
                        ? QStringLiteral(" (and %1 more; --report lists them)").arg(warnings.size() - 1)
                        : QString()));
  }
  return exit_code;
}

}  // namespace mapwright::app
