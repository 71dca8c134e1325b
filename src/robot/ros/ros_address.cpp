#include "robot/ros/ros_address.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include "words/listed.h"

namespace mapwright::robot::ros {
namespace {

constexpr int kPort = 9090;

class RosAddressText {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

auto error(const QString& why) { return tl::make_unexpected(why); }

/// Names of ROS: letters, digits and _, each part beginning with a letter or _.
bool isNamespace(const QString& text) {
  static const QRegularExpression like(
      QRegularExpression::anchoredPattern(QStringLiteral("(/[A-Za-z_][A-Za-z0-9_]*)+/?")));
  return text.size() <= 200 && like.match(text).hasMatch();
}

/// ws and wss are treated like http and https; other schemes are unchanged, and will be refused.
QString asWeb(const QString& typed) {
  const auto starts = [&](const char* scheme) {
    return typed.startsWith(QLatin1String(scheme), Qt::CaseInsensitive);
  };
  if (starts("ws://")) return QStringLiteral("http://") + typed.mid(5);
  if (starts("wss://")) return QStringLiteral("https://") + typed.mid(6);
  // Other input must not become a WebSocket by accident.
  if (starts("http://") || starts("https://")) return QStringLiteral("x-") + typed;
  return typed;
}

/// Resolves names like ROS: those without a leading slash are in the namespace.
QString wholeName(const QString& typed, const QString& ns) {
  return typed.startsWith(QLatin1Char('/')) ? typed : ns + QLatin1Char('/') + typed;
}

QString withoutLastSlashes(QString name) {
  while (name.endsWith(QLatin1Char('/'))) name.chop(1);
  return name;
}

/// All options after the ? except ns.
QStringList dispatchOptions() {
  QStringList all;
  for (const auto& [service, name, type] : usualDispatchServices()) all << QLatin1String(name);
  return all << QLatin1String(kProjectedMap);
}

using MaybeQuery = tl::expected<QUrlQuery, QString>;

MaybeQuery readOptions(const QUrlQuery& typed, bool dispatcher) {
  const auto options = typed.queryItems(QUrl::FullyDecoded);
  const QStringList known = dispatchOptions();
  const QString below = withoutLastSlashes(typed.queryItemValue(QStringLiteral("ns"), QUrl::FullyDecoded));
  QUrlQuery read;
  for (const auto& [name, value] : options) {
    const bool ns = name == QLatin1String("ns");
    const bool fits = ns || (dispatcher && known.contains(name));
    const QString whole = ns ? value : wholeName(value, below);
    if (!fits || !isNamespace(whole) || read.hasQueryItem(name)) {
      return error(
          dispatcher ? RosAddressText::tr("The address of a map dispatcher may only have ROS names after its "
                                          "?, each once: ?ns=/NAMESPACE, or %1 with the name used instead.")
                           .arg(words::listed(known))
                     : RosAddressText::tr(
                           "The address of a ROS robot may only have ?ns=/NAMESPACE after the host."));
    }
    read.addQueryItem(name, withoutLastSlashes(whole));
  }
  return read;
}

/// In the order of the specification, however they were typed.
QString textOf(const QUrlQuery& options) {
  QStringList parts;
  for (const QString& name : QStringList(QStringLiteral("ns")) + dispatchOptions()) {
    if (options.hasQueryItem(name)) parts << name + QLatin1Char('=') + options.queryItemValue(name);
  }
  return parts.isEmpty() ? QString() : QLatin1Char('?') + parts.join(QLatin1Char('&'));
}

ParsedAddress parse(const QString& rest, const QString& prefix) {
  auto url = webAddress(asWeb(rest), prefix + QStringLiteral("ws://192.168.1.7:9090"), kPort);
  if (!url) return error(url.error());
  Address address;
  const auto options = readOptions(QUrlQuery(*url), prefix == QLatin1String("rep130+"));
  if (!options) return error(options.error());
  address.options = *options;
  if (url->hasFragment())
    return error(RosAddressText::tr("The address of a ROS robot cannot have a # part."));
  url->setQuery(QString());
  url->setScheme(url->scheme() == QLatin1String("https") ? QStringLiteral("wss") : QStringLiteral("ws"));
  address.url = *url;
  address.text = prefix + url->toString() + textOf(address.options);
  return address;
}

AddressScheme schemeOf(const char* prefix, const QString& title) {
  const QString text = QLatin1String(prefix);
  AddressScheme scheme{text, text + QStringLiteral("ws://HOST:9090"),
                       [text](const QString& rest) { return parse(rest, text); }};
  scheme.title = title;
  scheme.port = kPort;
  scheme.plain = QStringLiteral("ws");
  scheme.encrypted = QStringLiteral("wss");
  return scheme;
}

}  // namespace

AddressScheme rosAddressScheme() { return schemeOf("ros+", RosAddressText::tr("ROS")); }

AddressScheme kabamAddressScheme() { return schemeOf("kabam+", RosAddressText::tr("KABAM")); }

AddressScheme rep130AddressScheme() { return schemeOf("rep130+", RosAddressText::tr("REP 130")); }

std::string namespaceOf(const Address& address) {
  return withoutLastSlashes(address.options.queryItemValue(QStringLiteral("ns"), QUrl::FullyDecoded))
      .toStdString();
}

DispatchSettings dispatchSettingsOf(const Address& address) {
  const auto option = [&](const char* name) {
    return address.options.queryItemValue(QLatin1String(name), QUrl::FullyDecoded).toStdString();
  };
  DispatchSettings settings;
  settings.expected = address.scheme == QLatin1String("rep130+");
  (settings.expected ? settings.ns : settings.near) = namespaceOf(address);
  for (const auto& [service, name, type] : usualDispatchServices()) {
    if (address.options.hasQueryItem(QLatin1String(name))) settings.names[service] = option(name);
  }
  settings.projected_map = option(kProjectedMap);
  return settings;
}

}  // namespace mapwright::robot::ros
