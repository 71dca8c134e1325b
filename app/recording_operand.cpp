#include "app/recording_operand.h"

#include <QDir>
#include <QFileInfo>

#include "robot/recorded/recorded_robot.h"

namespace mapwright::app {
namespace {

QString absolute(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

}  // namespace

void takeRecording(std::string& robot, std::string& bag, const std::string& otherwise) {
  if (!robot.empty()) return;
  const QString typed = QString::fromStdString(bag);
  const bool is_path =
      typed.contains(QLatin1Char('/')) || typed.endsWith(QLatin1String(".mcap"), Qt::CaseInsensitive);
  // A missing file is opened anyway, so that the error is reported then.
  if (is_path || (otherwise.empty() && QFileInfo(typed).isFile())) {
    robot = (QStringLiteral("file:") + absolute(typed)).toStdString();
    bag = robot::recorded::bagNameOf(typed);
  } else {
    robot = otherwise;
  }
}

bool isFileName(const QString& typed) {
  return typed.contains(QLatin1Char('/')) || QFileInfo::exists(typed) ||
         typed.startsWith(QLatin1String("file:")) ||
         typed.endsWith(QLatin1String(".mcap"), Qt::CaseInsensitive) ||
         typed.endsWith(QLatin1String(".bag"), Qt::CaseInsensitive);
}

OpenedRecording openRecording(const QString& path) {
  robot::recorded::RecordedOptions options;
  options.path = absolute(path);
  const QString address = QStringLiteral("file:") + options.path;
  std::string name = robot::recorded::bagNameOf(options.path);
  return {std::make_unique<robot::recorded::RecordedRobot>(address, std::move(options)), std::move(name)};
}

}  // namespace mapwright::app
