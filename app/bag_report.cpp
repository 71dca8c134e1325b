// `mapwright bags report`: a moment of a bag as one HTML file.
#include <QEventLoop>
#include <QFileInfo>

#include "app/bag_reading.h"
#include "app/command_text.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "ui/reporting/report_job.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

const QString kFileScheme = QStringLiteral("file:");

ui::reporting::ReportOrder::Part partOf(const QString& address, const std::string& bag,
                                        const RobotAccess& access, std::optional<double> at_s) {
  ui::reporting::ReportOrder::Part part;
  part.robot = [address, access] { return makeRobot(address, access.forAddress(address), DemoTime::Frozen); };
  part.bag.name = bag;
  part.any_kind = true;
  part.at_s = at_s;
  return part;
}

/// OTHER@TIME, or OTHER.
struct OtherRun {
  std::string bag;
  std::string at;
};
OtherRun otherRunFrom(const std::string& typed) {
  const std::size_t split = typed.rfind('@');
  if (split == std::string::npos || QFileInfo::exists(words::text(typed))) return {typed, {}};
  const std::string at = typed.substr(split + 1);
  return isTime(at) ? OtherRun{typed.substr(0, split), at} : OtherRun{typed, {}};
}

}  // namespace

CommandResult<int> bagsReport(RobotCommand& command, const BagsArguments& args) {
  const QString address = words::text(args.robot), path = words::text(args.output);
  if (address.isEmpty())
    return wrong(Text::tr(
        "Which robot? Pass --robot ADDRESS or set MAPWRIGHT_ROBOT; demo: is the built-in simulated robot."));
  const auto access = RobotAccess::read(args.access, address);
  if (!access) return wrong(access.error());
  const auto at_s = timeIn(args, address, args.name, args.at, QStringLiteral("--at"));
  if (!at_s) return passOn(at_s);
  ui::reporting::ReportOrder order{partOf(address, args.name, *access, *at_s), std::nullopt, path};
  QStringList sources{address};
  if (!args.against.empty()) {
    OtherRun other = otherRunFrom(args.against);
    if (const QString file = words::text(other.bag); QFileInfo(file).isFile() && !isRecording(file))
      return wrong(Text::tr("--against %1 is not a recording. Pass a file (.mcap, .bag, .db3) or the name of "
                            "a bag of the robot.")
                       .arg(words::plainName(other.bag)));
    std::string robot;
    onRecording(robot, other.bag, address.startsWith(kFileScheme) ? std::string() : args.robot);
    if (robot.empty())
      return wrong(Text::tr("--against %1: there is no such file.").arg(words::plainName(args.against)));
    sources << words::text(robot);
    order.against = partOf(words::text(robot), other.bag, *access, std::nullopt);
    if (!other.at.empty()) {
      const auto then_s = timeIn(args, words::text(robot), other.bag, other.at, QStringLiteral("--against"));
      if (!then_s) return passOn(then_s);
      order.against->at_s = *then_s;
    }
  }
  std::vector<std::string> files;
  for (const QString& source : sources) {
    if (source.startsWith(kFileScheme)) files.push_back(source.mid(kFileScheme.size()).toStdString());
  }
  if (const auto why = notCreatedReason(path, true, files)) return wrong(*why);
  if (const auto why = notTogetherReason({path, args.json ? QStringLiteral("-") : QString()}))
    return wrong(*why);

  ui::reporting::ReportJob job(std::move(order), std::make_shared<work::Workers>());
  ProgressLine progress;
  QEventLoop loop;
  QObject::connect(&job, &ui::reporting::ReportJob::progressed, &loop, [&](double share) {
    command.reportConnected();
    progress.tell(Text::tr("%1 % read").arg(int(share * 100)));
  });
  QObject::connect(&job, &ui::reporting::ReportJob::ended, &loop, &QEventLoop::quit, Qt::QueuedConnection);
  job.start();
  loop.exec();
  progress.clear();
  if (!job.error().isEmpty()) {
    const bool ours = address.startsWith(kFileScheme) || job.failure() == map::FailureKind::None ||
                      job.failure() == map::FailureKind::Unsupported;
    return tl::make_unexpected(
        CommandFailure{ours ? int(kUsage) : int(exitCodeOf(job.failure())), job.error()});
  }
  const incident::Report& report = job.report();
  if (args.json) {
    QJsonObject json = incident::reportJson(report);
    json[QStringLiteral("file")] = path;
    printJson(json);
  } else if (!isStandardOutput(path)) {
    QString line = Text::tr("%1: %2 at %3")
                       .arg(path, words::plainName(report.run.name), incident::utcText(report.run.at_s));
    if (report.against) {
      line += Text::tr(", beside %1 at %2")
                  .arg(words::plainName(report.against->name), incident::utcText(report.against->at_s));
      if (report.against_m) line += Text::tr(", %1 m away").arg(*report.against_m, 0, 'f', 2);
    }
    printLine(oneLine(line));
  }
  if (!report.run.remarks.isEmpty())
    return tl::make_unexpected(CommandFailure{kIncomplete, words::paragraph(report.run.remarks)});
  return kDone;
}

}  // namespace mapwright::app
