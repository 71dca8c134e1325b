#include "app/robot_factory.h"

#include <QStandardPaths>

#include "robot/address.h"
#include "robot/axbot/axbot_robot.h"

namespace mapwright::app {

QString httpCacheFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
         QStringLiteral("/mapwright/http");
}

tl::expected<std::unique_ptr<robot::Robot>, QString> makeRobot(const QString& address,
                                                               const QByteArray& secret, DemoTime demo_time) {
  const auto parsed = robot::parseAddress(address);
  if (!parsed) return tl::make_unexpected(parsed.error());
  if (parsed->backend == robot::Backend::Demo) {
    const auto options = parseDemoQuery(QUrlQuery(parsed->url), demo_time);
    if (!options) return tl::make_unexpected(options.error());
    return makeDemoRobot(parsed->text, *options);
  }
  robot::axbot::LinkOptions link;
  link.base = parsed->url;
  link.secret = secret;
  link.cache_folder = httpCacheFolder();
  return std::make_unique<robot::axbot::AxbotRobot>(parsed->text, std::move(link));
}

}  // namespace mapwright::app
