#include "robot/axbot/axbot_address.h"

#include <QCoreApplication>

namespace mapwright::robot::axbot {
namespace {

constexpr int kPort = 8090;

class AxbotAddressText {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

ParsedAddress parse(const QString& rest) {
  const auto url = webAddress(rest, QStringLiteral("axbot+http://192.168.25.25:8090"), kPort);
  if (!url) return tl::make_unexpected(url.error());
  if (url->hasQuery() || url->hasFragment()) {
    return tl::make_unexpected(
        AxbotAddressText::tr("The address of an Autoxing robot cannot have a ? or # part."));
  }
  Address address;
  address.url = *url;
  address.text = QStringLiteral("axbot+") + url->toString();
  return address;
}

}  // namespace

AddressScheme addressScheme() {
  AddressScheme scheme{QStringLiteral("axbot+"), QStringLiteral("axbot+http://192.168.25.25:8090"), parse};
  scheme.title = AxbotAddressText::tr("Autoxing");
  scheme.port = kPort;
  return scheme;
}

}  // namespace mapwright::robot::axbot
