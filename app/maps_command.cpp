#include "app/maps_command.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include <QApplication>
#include <QCoreApplication>
#include <QJsonArray>
#include <QTemporaryDir>

#include "app/display.h"
#include "app/exit_code.h"
#include "app/report.h"
#include "app/say.h"

namespace mapwright::app {
namespace {

class MapsCommandText {
  Q_DECLARE_TR_FUNCTIONS(MapsCommand)
};

QJsonObject failed(const QString& sentence) {
  return {{QStringLiteral("complete"), false}, {QStringLiteral("warnings"), QJsonArray{sentence}}};
}

}  // namespace

MapsCommand::MapsCommand(double timeout_s, QString report_path)
    : time_{commandStart(timeout_s, processAge()), timeout_s}, report_path_(std::move(report_path)) {}

CommandResult<MapReading*> MapsCommand::open(const QString& address, const Access& access,
                                             MapReading::Purpose purpose) {
  auto reading = MapReading::open(address, access, time_, purpose, workers_);
  if (!reading) return tl::make_unexpected(reading.error());
  connected_->store(true);
  readings_.push_back(std::move(*reading));
  return readings_.back().get();
}

bool MapsCommand::complete() const {
  for (const auto& reading : readings_) {
    if (!reading->complete()) return false;
  }
  return true;
}

int MapsCommand::run(int& argc, char** argv, const std::function<CommandResult<int>(MapsCommand&)>& work) {
  if (!(time_.timeout_s > 0 && time_.timeout_s <= 86'400)) {
    return refuse(kUsage, MapsCommandText::tr("--timeout must be greater than 0 and at most 86400 seconds."));
  }
  Deadline deadline(later(time_.start.begun, time_.timeout_s + time_.start.grace.end_s),
                    [connected = connected_, path = report_path_, timeout_s = time_.timeout_s] {
                      const QString sentence =
                          (*connected ? MapsCommandText::tr(
                                            "Incomplete: the command did not finish within %1 s (--timeout).")
                                      : MapsCommandText::tr("No connection within %1 s (--timeout)."))
                              .arg(timeout_s);
                      if (!path.isEmpty()) writeReportInHaste(path, failed(sentence));
                      sayAtTheEnd(sentence.toStdString());
                      return int(*connected ? kIncomplete : kUnreachable);
                    });
  const auto fonts = chooseOffscreenPlatform();
  QApplication application(argc, argv);
  const int exit_code = end(work(*this));
  std::fflush(stdout);
  // Everything has been reported: cleaning up must not take longer than the remaining time.
  deadline.setLastWords([exit_code] { return exit_code; });
  readings_.clear();
  return exit_code;
}

int MapsCommand::end(const CommandResult<int>& result) const {
  QStringList warnings;
  for (const auto& reading : readings_) warnings += reading->warnings();
  QJsonObject report;
  if (!result) {
    report = failed(result.error().sentence);
  } else {
    if (readings_.size() == 1) report = readings_.front()->facts();
    if (readings_.size() == 2) {
      report[QStringLiteral("first")] = readings_.front()->facts();
      report[QStringLiteral("second")] = readings_.back()->facts();
    }
    report[QStringLiteral("complete")] = complete();
    report[QStringLiteral("warnings")] = QJsonArray::fromStringList(warnings);
  }
  if (!done_.isEmpty()) report[done_name_] = done_;
  if (!report_path_.isEmpty()) {
    if (const auto problem = writeReport(report_path_, report)) return refuse(kUsage, *problem);
  }
  if (!result) return refuse(result.error().exit_code, result.error().sentence);
  if (!complete()) {
    const bool refused = std::any_of(readings_.begin(), readings_.end(),
                                     [](const auto& reading) { return reading->refused(); });
    return refuse(refused            ? exitCodeOf(map::FailureKind::Refused)
                  : *result == kDone ? int(kIncomplete)
                                     : *result,
                  MapsCommandText::tr("Incomplete. %1").arg(firstOf(warnings)));
  }
  return warnings.isEmpty() ? *result : refuse(*result, firstOf(warnings));
}

}  // namespace mapwright::app
