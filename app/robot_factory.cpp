#include "app/robot_factory.h"

#include <QFileInfo>
#include <QStandardPaths>

#include "robot/address.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/files/file_robot.h"
#include "robot/files/picture_yamls.h"

namespace mapwright::app {

QString httpCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
         QStringLiteral("/mapwright/http");
}

QString gridCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
         QStringLiteral("/mapwright/grids");
}

std::optional<QString> whyNoPlace(const QString& address, const std::string& resolution,
                                  const std::string& origin) {
  if (resolution.empty() && origin.empty()) return std::nullopt;
  const auto parsed = robot::parseAddress(address);
  if (!parsed) return std::nullopt;  // which is said elsewhere
  const QString options = origin.empty()       ? QStringLiteral("--resolution")
                          : resolution.empty() ? QStringLiteral("--origin")
                                               : QStringLiteral("--resolution and --origin");
  if (parsed->backend != robot::Backend::File) {
    return QStringLiteral("%1: only for a bare picture file. A robot says itself where its maps lie.")
        .arg(options);
  }
  if (parsed->resolution_m || parsed->origin) {
    return QStringLiteral("%1: the address says it already, after its ?. Give one of the two.").arg(options);
  }
  const QString suffix = QFileInfo(parsed->path).suffix().toLower();
  if (suffix == QLatin1String("yaml") || suffix == QLatin1String("yml")) {
    return QStringLiteral("%1: only for a bare picture file. %2 says itself where its map lies.")
        .arg(options, QFileInfo(parsed->path).fileName());
  }
  return std::nullopt;
}

std::vector<std::string> sourceFilesOf(const QString& address, const std::string& id,
                                       const std::string& picture) {
  std::vector<std::string> files = robot::localFiles(address, id, picture);
  if (files.empty() || picture.empty()) return files;
  for (const QString& yaml : robot::files::yamlsNaming(QString::fromStdString(picture)))
    files.push_back(yaml.toStdString());
  return files;
}

QString placedFile(const QString& address, const std::string& resolution, const std::string& origin) {
  if (resolution.empty() && origin.empty()) return address;
  const auto parsed = robot::parseAddress(address);
  if (!parsed || parsed->backend != robot::Backend::File || address.contains(QLatin1Char('?')))
    return address;
  QUrlQuery query;
  if (!resolution.empty())
    query.addQueryItem(QStringLiteral("resolution"), QString::fromStdString(resolution));
  if (!origin.empty()) query.addQueryItem(QStringLiteral("origin"), QString::fromStdString(origin));
  return QStringLiteral("file:") + parsed->path + QLatin1Char('?') + query.toString();
}

tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address, const Access& access,
                                                               DemoTime demo_time) {
  const auto parsed = robot::parseAddress(address);
  if (!parsed) return tl::make_unexpected(parsed.error());
  if (parsed->backend == robot::Backend::Demo) {
    const auto options = parseDemoQuery(QUrlQuery(parsed->url), demo_time);
    if (!options) return tl::make_unexpected(options.error());
    return makeDemoRobot(parsed->text, *options);
  }
  if (parsed->backend == robot::Backend::File) {
    robot::files::FileOptions file;
    file.path = parsed->path;
    if (parsed->resolution_m) file.place.resolution_m = *parsed->resolution_m;
    if (parsed->origin) file.place.origin = *parsed->origin;
    return std::make_unique<robot::files::FileRobot>(parsed->text, std::move(file));
  }
  if (parsed->backend == robot::Backend::Aimdk) {
    robot::aimdk::LinkOptions link;
    link.base = parsed->url;
    link.tf = parsed->tf;
    link.trust = access.trust;
    return std::make_unique<robot::aimdk::AimdkRobot>(parsed->text, std::move(link));
  }
  robot::axbot::LinkOptions link;
  link.base = parsed->url;
  link.secret = access.secret;
  link.trust = access.trust;
  link.cache_folder = httpCacheFolder();
  return std::make_unique<robot::axbot::AxbotRobot>(parsed->text, std::move(link));
}

}  // namespace mapwright::app
