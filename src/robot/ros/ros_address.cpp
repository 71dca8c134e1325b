#include "robot/ros/ros_address.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace mapwright::robot::ros {
namespace {

constexpr int kPort = 9090;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

auto error(const QString& why) { return tl::make_unexpected(why); }

/// Names of ROS: letters, digits and _, each part beginning with a letter or _.
bool isNamespace(const QString& text) {
  static const QRegularExpression like(
      QRegularExpression::anchoredPattern(QStringLiteral("(/[A-Za-z_][A-Za-z0-9_]*)+/?")));
  return text.size() <= 200 && like.match(text).hasMatch();
}

/// ws and wss are http and https by other means; every other scheme is left as it is, to be refused.
QString asWeb(const QString& typed) {
  const auto starts = [&](const char* scheme) {
    return typed.startsWith(QLatin1String(scheme), Qt::CaseInsensitive);
  };
  if (starts("ws://")) return QStringLiteral("http://") + typed.mid(5);
  if (starts("wss://")) return QStringLiteral("https://") + typed.mid(6);
  // What was not meant must not become a WebSocket by accident.
  if (starts("http://") || starts("https://")) return QStringLiteral("x-") + typed;
  return typed;
}

ParsedAddress parse(const QString& rest, const QString& prefix) {
  auto url = webAddress(asWeb(rest), prefix + QStringLiteral("ws://192.168.1.7:9090"), kPort);
  if (!url) return error(url.error());
  Address address;
  address.options = QUrlQuery(*url);
  const auto options = address.options.queryItems(QUrl::FullyDecoded);
  for (const auto& [name, value] : options) {
    if (name != QLatin1String("ns") || !isNamespace(value) || options.size() > 1) {
      return error(Words::tr("The address of a ROS robot may only have ?ns=/NAMESPACE after the host."));
    }
  }
  if (url->hasFragment()) return error(Words::tr("The address of a ROS robot has no part after #."));
  url->setQuery(QString());
  url->setScheme(url->scheme() == QLatin1String("https") ? QStringLiteral("wss") : QStringLiteral("ws"));
  address.url = *url;
  address.text = prefix + url->toString();
  if (const std::string ns = namespaceOf(address); !ns.empty())
    address.text += QStringLiteral("?ns=") + QString::fromStdString(ns);
  return address;
}

AddressScheme schemeOf(const char* prefix) {
  const QString text = QLatin1String(prefix);
  return {text, text + QStringLiteral("ws://HOST:9090"),
          [text](const QString& rest) { return parse(rest, text); }};
}

}  // namespace

AddressScheme rosAddressScheme() { return schemeOf("ros+"); }

AddressScheme kabamAddressScheme() { return schemeOf("kabam+"); }

std::string namespaceOf(const Address& address) {
  std::string ns = address.options.queryItemValue(QStringLiteral("ns"), QUrl::FullyDecoded).toStdString();
  while (!ns.empty() && ns.back() == '/') ns.pop_back();
  return ns;
}

}  // namespace mapwright::robot::ros
