#include "robot/aimdk/aimdk_address.h"

#include <QCoreApplication>

namespace mapwright::robot::aimdk {
namespace {

constexpr int kPort = 50807;

class AimdkAddressText {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

auto error(const QString& why) { return tl::make_unexpected(why); }

constexpr int kRosbridgePort = 9090;

/// No user and no query: they could contain a password, and addresses are displayed.
bool usable(const QUrl& tf) {
  const QString scheme = tf.scheme();
  return tf.isValid() && !tf.host().isEmpty() && tf.userInfo().isEmpty() && !tf.hasQuery() &&
         !tf.hasFragment() && tf.port() != 0 &&
         (scheme == QLatin1String("ws") || scheme == QLatin1String("wss"));
}

ParsedAddress parse(const QString& rest) {
  auto url = webAddress(rest, QStringLiteral("aimdk+http://192.168.100.110:50807"), kPort);
  if (!url) return error(url.error());
  Address address;
  address.options = QUrlQuery(*url);
  const auto options = address.options.queryItems(QUrl::FullyDecoded);
  for (const auto& [name, value] : options) {
    if (const auto why = noPortReason(value)) return error(*why);
    if (name != QLatin1String("tf") || !usable(QUrl(value, QUrl::StrictMode)) || options.size() > 1) {
      return error(AimdkAddressText::tr(
          "The address of an Agibot robot may only have ?tf=ws://HOST:9090 (its rosbridge) after "
          "the host."));
    }
  }
  if (url->hasFragment())
    return error(AimdkAddressText::tr("The address of an Agibot robot cannot have a # part."));
  url->setQuery(QString());
  address.url = *url;
  address.text = QStringLiteral("aimdk+") + url->toString();
  if (const QUrl tf = tfOf(address); !tf.isEmpty()) address.text += QStringLiteral("?tf=") + tf.toString();
  return address;
}

}  // namespace

AddressScheme addressScheme() {
  AddressScheme scheme{QStringLiteral("aimdk+"), QStringLiteral("aimdk+http://HOST:50807"), parse};
  scheme.title = AimdkAddressText::tr("Agibot");
  scheme.port = kPort;
  return scheme;
}

QUrl tfOf(const Address& address) {
  QUrl url(address.options.queryItemValue(QStringLiteral("tf"), QUrl::FullyDecoded), QUrl::StrictMode);
  if (url.isEmpty()) return url;
  if (url.port() == -1) url.setPort(kRosbridgePort);
  QString path = url.path();
  while (path.endsWith(QLatin1Char('/'))) path.chop(1);
  url.setPath(path);
  return url;
}

}  // namespace mapwright::robot::aimdk
