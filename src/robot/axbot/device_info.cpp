#include "robot/axbot/device_info.h"

#include <algorithm>
#include <initializer_list>

#include <QJsonDocument>
#include <QJsonObject>

namespace mapwright::robot::axbot {
namespace {

/// A member under any of its names, here and one level down: firmware versions nest them differently.
QJsonValue findMember(const QJsonObject& object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto value = object.value(QLatin1String(name)); !value.isUndefined() && !value.isNull())
      return value;
  }
  for (const QJsonValue& child : object) {
    if (!child.isObject()) continue;
    const QJsonObject inner = child.toObject();
    for (const char* name : names) {
      if (const auto value = inner.value(QLatin1String(name)); !value.isUndefined() && !value.isNull())
        return value;
    }
  }
  return QJsonValue::Undefined;
}

QString memberText(const QJsonObject& object, std::initializer_list<const char*> names) {
  const QJsonValue value = findMember(object, names);
  return value.isString()   ? value.toString().left(200)
         : value.isDouble() ? value.toVariant().toString()
                            : QString();
}

}  // namespace

DeviceInfo deviceInfoIn(const QByteArray& body) {
  const QJsonObject info = QJsonDocument::fromJson(body).object();
  DeviceInfo told;
  told.identity.model = memberText(info, {"model"});
  told.identity.serial = memberText(info, {"sn", "serial", "serial_number"});
  told.identity.name = memberText(info, {"nickname", "name"});
  told.identity.version = memberText(info, {"axbot_version", "version", "software_version"});
  told.takes_topic_lists = findMember(info, {"supportsEnableTopicList"}).toBool(false);
  const QStringList caps = info.value(QLatin1String("caps")).toObject().keys();
  told.surely = info.contains(QLatin1String("axbot_version")) ||
                std::any_of(caps.begin(), caps.end(),
                            [](const QString& name) { return name.startsWith(QLatin1String("supports")); });
  return told;
}

}  // namespace mapwright::robot::axbot
