#include "robot/aimdk/aimdk_address.h"

#include <QCoreApplication>

namespace mapwright::robot::aimdk {
namespace {

constexpr int kPort = 50807;

class Words {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

auto error(const QString& why) { return tl::make_unexpected(why); }

bool usable(const QUrl& tf) {
  const QString scheme = tf.scheme();
  return tf.isValid() && !tf.host().isEmpty() && tf.userInfo().isEmpty() &&
         (scheme == QLatin1String("ws") || scheme == QLatin1String("wss"));
}

ParsedAddress parse(const QString& rest) {
  auto url = webAddress(rest, QStringLiteral("aimdk+http://192.168.100.110:50807"), kPort);
  if (!url) return error(url.error());
  Address address;
  address.options = QUrlQuery(*url);
  for (const auto& [name, value] : address.options.queryItems(QUrl::FullyDecoded)) {
    if (name != QLatin1String("tf") || !usable(QUrl(value, QUrl::StrictMode))) {
      return error(
          Words::tr("The address of an Agibot robot may only have ?tf=ws://HOST:9090 (its rosbridge) after "
                    "the host."));
    }
  }
  if (url->hasFragment()) return error(Words::tr("The address of an Agibot robot has no part after #."));
  url->setQuery(QString());
  address.url = *url;
  address.text = QStringLiteral("aimdk+") + url->toString();
  if (const QUrl tf = tfOf(address); !tf.isEmpty()) address.text += QStringLiteral("?tf=") + tf.toString();
  return address;
}

}  // namespace

AddressScheme addressScheme() {
  return {QStringLiteral("aimdk+"), QStringLiteral("aimdk+http://HOST:50807"), parse};
}

QUrl tfOf(const Address& address) {
  return QUrl(address.options.queryItemValue(QStringLiteral("tf"), QUrl::FullyDecoded), QUrl::StrictMode);
}

}  // namespace mapwright::robot::aimdk
