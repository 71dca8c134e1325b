#include "app/robot_factory.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStandardPaths>

#include "app/log.h"
#include "app/recording_operand.h"
#include "robot/address.h"
#include "robot/aimdk/aimdk_address.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_address.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/files/file_address.h"
#include "robot/files/file_robot.h"
#include "robot/files/local_maps.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/ros/ros_address.h"
#include "robot/ros/ros_robot.h"

namespace mapwright::app {

QString httpCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
         QStringLiteral("/mapwright/http");
}

QString draftsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
         QStringLiteral("/mapwright/drafts");
}

QString gridCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
         QStringLiteral("/mapwright/grids");
}

namespace {

class RobotFactoryText {
  Q_DECLARE_TR_FUNCTIONS(RobotFactory)
};

using Made = tl::expected<std::unique_ptr<robot::Robot>, QString>;

/// A kind of robot: its address scheme and its factory.
struct Kind {
  robot::AddressScheme scheme;
  std::function<Made(const robot::Address&, const Access&, DemoTime)> make;
};

Made makeAxbot(const robot::Address& address, const Access& access, DemoTime) {
  robot::axbot::LinkOptions link;
  link.base = address.url;
  link.secret = access.secret;
  link.trust = access.trust;
  link.cache_folder = httpCacheFolder();
  return std::make_unique<robot::axbot::AxbotRobot>(address.text, std::move(link));
}

Made makeAimdk(const robot::Address& address, const Access& access, DemoTime) {
  robot::aimdk::LinkOptions link;
  link.base = address.url;
  link.trust = access.trust;
  robot::aimdk::RobotBeside second;
  if (const QUrl tf = robot::aimdk::tfOf(address); !tf.isEmpty()) {
    robot::ros::LinkOptions beside;
    beside.url = tf;
    // It is another server: it gets neither the secret nor the pinned certificate.
    beside.trust.authorities = access.trust.authorities;
    robot::Address its;
    its.url = tf;
    second = {
        std::make_unique<robot::ros::RosRobot>(QStringLiteral("ros+") + tf.toString(), std::move(beside)),
        robot::hostOf(its)};
  }
  return std::make_unique<robot::aimdk::AimdkRobot>(address.text, std::move(link), std::move(second));
}

Made rosRobot(const robot::Address& address, const Access& access, bool kabam_only) {
  robot::ros::LinkOptions link;
  link.url = address.url;
  link.secret = access.secret;
  link.trust = access.trust;
  link.ns = robot::ros::namespaceOf(address);
  link.dispatch = robot::ros::dispatchSettingsOf(address);
  link.kabam_only = kabam_only;
  if (access.timeout) link.kabam.read = *access.timeout;
  return std::make_unique<robot::ros::RosRobot>(address.text, std::move(link));
}

Made makeRos(const robot::Address& address, const Access& access, DemoTime) {
  return rosRobot(address, access, false);
}

Made makeKabam(const robot::Address& address, const Access& access, DemoTime) {
  return rosRobot(address, access, true);
}

Made makeFiles(const robot::Address& address, const Access&, DemoTime) {
  if (robot::recorded::isRecording(address.path)) return openRecording(address.path).robot;
  robot::files::FileOptions file;
  file.path = address.path;
  file.place = robot::files::placeOf(address);
  return std::make_unique<robot::files::FileRobot>(address.text, std::move(file));
}

Made makeDemo(const robot::Address& address, const Access&, DemoTime time) {
  const auto options = parseDemoQuery(address.options, time);
  if (!options) return tl::make_unexpected(options.error());
  return makeDemoRobot(address.text, *options);
}

/// Maps and recordings: a path with a recording's extension is one, even if it does not exist.
robot::AddressScheme fileScheme() {
  robot::AddressScheme scheme = robot::files::addressScheme();
  scheme.claims = [maps = scheme.claims](const QString& typed) {
    const bool recording = typed.endsWith(QLatin1String(".mcap"), Qt::CaseInsensitive) ||
                           typed.endsWith(QLatin1String(".bag"), Qt::CaseInsensitive);
    return maps(typed) || (recording && !typed.contains(QLatin1String("://")));
  };
  return scheme;
}

/// All kinds of robots; the first one takes addresses that no other claims.
std::vector<Kind> kinds() {
  return {{robot::axbot::addressScheme(), makeAxbot},
          {robot::aimdk::addressScheme(), makeAimdk},
          {robot::ros::rosAddressScheme(), makeRos},
          {robot::ros::kabamAddressScheme(), makeKabam},
          {robot::ros::rep130AddressScheme(), makeRos},
          {demoAddressScheme(), makeDemo},
          {fileScheme(), makeFiles}};
}

}  // namespace

robot::Addresses knownAddresses() {
  std::vector<robot::AddressScheme> schemes;
  for (Kind& kind : kinds()) schemes.push_back(std::move(kind.scheme));
  return robot::Addresses(std::move(schemes));
}

std::optional<QString> whyNoPlace(const QString& address, const std::string& resolution,
                                  const std::string& origin) {
  if (resolution.empty() && origin.empty()) return std::nullopt;
  const auto parsed = knownAddresses().parse(address);
  if (!parsed) return std::nullopt;  // reported elsewhere
  const QString options = origin.empty()       ? QStringLiteral("--resolution")
                          : resolution.empty() ? QStringLiteral("--origin")
                                               : RobotFactoryText::tr("--resolution and --origin");
  if (parsed->path.isEmpty()) {
    return RobotFactoryText::tr(
               "%1: only for a plain picture file. A robot reports itself where its maps are.")
        .arg(options);
  }
  if (!parsed->options.isEmpty()) {
    return RobotFactoryText::tr("%1: the address already contains it after the ?. Give it only once.")
        .arg(options);
  }
  const QString suffix = QFileInfo(parsed->path).suffix().toLower();
  if (suffix == QLatin1String("yaml") || suffix == QLatin1String("yml")) {
    return RobotFactoryText::tr("%1: only for a plain picture file. %2 states itself where its map is.")
        .arg(options, QFileInfo(parsed->path).fileName());
  }
  return std::nullopt;
}

std::vector<std::string> sourceFilesOf(const QString& address, const std::string& id,
                                       const std::string& picture) {
  const auto parsed = knownAddresses().parse(address);
  std::vector<std::string> files =
      parsed ? robot::localFiles(*parsed, id, picture) : std::vector<std::string>();
  if (files.empty() || picture.empty()) return files;
  for (const QString& yaml : robot::files::yamlsNaming(QString::fromStdString(picture)))
    files.push_back(yaml.toStdString());
  return files;
}

QString placedFile(const QString& address, const std::string& resolution, const std::string& origin) {
  if (resolution.empty() && origin.empty()) return address;
  const auto parsed = knownAddresses().parse(address);
  if (!parsed || parsed->path.isEmpty() || address.contains(QLatin1Char('?'))) return address;
  QUrlQuery query;
  if (!resolution.empty())
    query.addQueryItem(QStringLiteral("resolution"), QString::fromStdString(resolution));
  if (!origin.empty()) query.addQueryItem(QStringLiteral("origin"), QString::fromStdString(origin));
  return QStringLiteral("file:") + parsed->path + QLatin1Char('?') + query.toString();
}

tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address, const Access& access,
                                                               DemoTime demo_time) {
  const auto parsed = knownAddresses().parse(address);
  if (!parsed) return tl::make_unexpected(parsed.error());
  hideInLog(access.secret);
  qCInfo(lcApp, "robot %s, secret: %s", qUtf8Printable(parsed->text),
         access.secret.isEmpty() ? "none" : "given");
  for (const Kind& kind : kinds()) {
    if (kind.scheme.prefix == parsed->scheme) return kind.make(*parsed, access, demo_time);
  }
  return tl::make_unexpected(RobotFactoryText::tr("No kind of robot supports the address %1.").arg(address));
}

}  // namespace mapwright::app
