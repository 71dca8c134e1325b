#include "robot/address.h"

#include <algorithm>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace mapwright::robot {
namespace {

class AddressText {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

auto error(const QString& why) { return tl::make_unexpected(why); }

bool isPort(int port) { return port > 0 && port < 65'536; }

/// "kabam+" of "kabam+ws://robot"; empty where there is none.
QString networkPrefix(const QString& text) {
  static const QRegularExpression like(QStringLiteral("^([a-z][a-z0-9]*\\+)[a-z]+:"),
                                       QRegularExpression::CaseInsensitiveOption);
  return like.match(text).captured(1);
}

/// An address without the part before the @, even if the password contains another one.
QString withoutUser(const QString& typed) {
  static const QRegularExpression scheme(QStringLiteral("^[a-z][a-z0-9]*://"),
                                         QRegularExpression::CaseInsensitiveOption);
  return scheme.match(typed).captured() + typed.mid(typed.lastIndexOf(QLatin1Char('@')) + 1);
}

/// Never with a password in it.
QString leaveOutUser(const QString& shown) {
  return AddressText::tr(
             "%1: leave the user name and password out of the address. Put the secret into its own field, "
             "--secret-file or MAPWRIGHT_SECRET.")
      .arg(shown);
}

}  // namespace

ParsedAddress Addresses::parse(const QString& typed) const {
  const QString text = typed.trimmed();
  const QStringList known = examples();
  if (text.isEmpty() || schemes_.empty()) {
    return error(AddressText::tr("Enter a robot address, for example %1.").arg(known.value(0)));
  }
  const auto parsed = [&](const AddressScheme& scheme, const QString& rest) {
    if (scheme.on_network && rest.contains(QLatin1Char('@'))) {
      return ParsedAddress(error(leaveOutUser(text.chopped(rest.size()) + withoutUser(rest))));
    }
    if (const auto why = scheme.on_network ? noPortReason(text) : std::nullopt)
      return ParsedAddress(error(*why));
    ParsedAddress address = scheme.parse(rest);
    if (address) address->scheme = scheme.prefix;
    return address;
  };
  for (const AddressScheme& scheme : schemes_) {
    if (text.startsWith(scheme.prefix, Qt::CaseInsensitive))
      return parsed(scheme, text.mid(scheme.prefix.size()));
  }
  if (const QString prefix = networkPrefix(text); !prefix.isEmpty()) {
    return error(AddressText::tr("Addresses that begin with %1 are not supported by this version. Use %2.")
                     .arg(prefix, known.join(QStringLiteral(", "))));
  }
  for (const AddressScheme& scheme : schemes_) {
    if (scheme.claims && scheme.claims(text)) return parsed(scheme, text);
  }
  return parsed(schemes_.front(), text);
}

std::string Addresses::kindOf(const QString& typed) const {
  const auto parsed = parse(typed);
  QString scheme = parsed ? parsed->scheme : QString();
  while (!scheme.isEmpty() && !scheme.back().isLetterOrNumber()) scheme.chop(1);
  return scheme.toStdString();
}

QString Addresses::titleOf(const QString& typed) const {
  const auto parsed = parse(typed);
  for (const AddressScheme& scheme : schemes_) {
    if (parsed && scheme.prefix == parsed->scheme) return scheme.title;
  }
  return {};
}

QString Addresses::hostShown(const QString& typed) const {
  const auto parsed = parse(typed);
  if (!parsed || parsed->url.host().isEmpty()) return {};
  QString host = hostOf(*parsed);
  for (const AddressScheme& scheme : schemes_) {
    if (scheme.prefix == parsed->scheme && scheme.port == parsed->url.port())
      host.truncate(host.lastIndexOf(QLatin1Char(':')));
  }
  return host + parsed->url.path();
}

std::optional<Host> Addresses::bareHost(const QString& typed) const {
  QString text = typed.trimmed();
  static const QRegularExpression browser(QStringLiteral("^http(s?)://([^/?#]*)([^?#]*)"),
                                          QRegularExpression::CaseInsensitiveOption);
  const QRegularExpressionMatch copied = browser.match(text);
  if (!copied.hasMatch() && (isAddress(text) || std::any_of(schemes_.begin(), schemes_.end(), [&](auto& one) {
                               return one.claims && one.claims(text);
                             })))
    return std::nullopt;
  if (copied.hasMatch()) text = copied.captured(2);
  static const QRegularExpression like(
      QRegularExpression::anchoredPattern(QStringLiteral("(?:\\[([0-9A-Fa-f:.%a-z]+)\\]|([^\\s:/?#@\\[\\]]+))"
                                                         "(?::([0-9]{1,5}))?(/[^?#]*)?")));
  // Of an IPv6 address without brackets everything is the host.
  static const QRegularExpression bare_v6(QRegularExpression::anchoredPattern(
      QStringLiteral("[0-9A-Fa-f]*:[0-9A-Fa-f:.]*:[0-9A-Fa-f:.]*(?:%\\w+)?")));
  if (bare_v6.match(text).hasMatch()) return Host{text, std::nullopt};
  const QRegularExpressionMatch match = like.match(text);
  if (!match.hasMatch()) return std::nullopt;
  Host host{match.captured(1).isEmpty() ? match.captured(2) : match.captured(1), std::nullopt,
            copied.hasMatch() ? copied.captured(3) : match.captured(4), !copied.captured(1).isEmpty()};
  while (host.path.endsWith(QLatin1Char('/'))) host.path.chop(1);
  if (!match.captured(3).isEmpty()) host.port = match.captured(3).toInt();
  const bool possible = !host.port || isPort(*host.port);
  return possible && serverAt(QStringLiteral("http"), host, 80).isValid() ? std::optional(host)
                                                                          : std::nullopt;
}

QStringList Addresses::examples() const {
  QStringList all;
  for (const AddressScheme& scheme : schemes_) all << scheme.like;
  return all;
}

bool Addresses::isAddress(const QString& typed) const {
  const QString text = typed.trimmed();
  return !networkPrefix(text).isEmpty() ||
         std::any_of(schemes_.begin(), schemes_.end(), [&](const AddressScheme& scheme) {
           return text.startsWith(scheme.prefix, Qt::CaseInsensitive);
         });
}

QUrl serverAt(const QString& scheme, const Host& host, int usual_port) {
  QUrl url;
  url.setScheme(scheme);
  url.setHost(host.name, QUrl::DecodedMode);
  url.setPort(host.port.value_or(usual_port));
  return url;
}

QString addressAt(const AddressScheme& scheme, const Host& host, bool encrypted) {
  QUrl url = serverAt(encrypted ? scheme.encrypted : scheme.plain, host, scheme.port);
  url.setPath(host.path);
  return scheme.prefix + url.toString();
}

std::optional<QString> noPortReason(const QString& typed) {
  // Host and port, of which the former may be an IPv6 address in brackets.
  static const QRegularExpression like(
      QStringLiteral("^(?:[a-z0-9+.-]*://)?(?:\\[[^\\]]*\\]|[^:/?#\\[\\]]+):([0-9]+)(?:[/?#]|$)"),
      QRegularExpression::CaseInsensitiveOption);
  const QRegularExpressionMatch match = like.match(typed.trimmed());
  bool number = false;
  const int port = match.captured(1).toInt(&number);
  if (!match.hasMatch() || (number && isPort(port))) return std::nullopt;
  return AddressText::tr("\"%1\" has port %2. A port is a number from 1 to 65535.")
      .arg(typed.trimmed(), match.captured(1));
}

tl::expected<QUrl, QString> webAddress(const QString& typed, const QString& example, int port) {
  const QString rest = typed.contains(QLatin1String("://")) ? typed : QStringLiteral("http://") + typed;
  QUrl url(rest, QUrl::StrictMode);
  const QString scheme = url.scheme().toLower();
  if (!url.userInfo().isEmpty() || rest.contains(QLatin1Char('@'))) {
    return error(leaveOutUser(withoutUser(typed)));
  }
  if (!url.isValid() || url.host().isEmpty()) {
    return error(AddressText::tr("\"%1\" is not an address. For example: %2.").arg(typed, example));
  }
  if (scheme != QLatin1String("http") && scheme != QLatin1String("https")) {
    return error(
        AddressText::tr("\"%1\" does not begin with a known scheme. For example: %2.").arg(typed, example));
  }
  if (url.port() == -1) url.setPort(port);
  QString path = url.path();
  while (path.endsWith(QLatin1Char('/'))) path.chop(1);
  url.setPath(path);
  return url;
}

QString hostOf(const Address& address) {
  const QString host = address.url.host();
  if (host.isEmpty()) return {};
  return QStringLiteral("%1:%2")
      .arg(host.contains(QLatin1Char(':')) ? QLatin1Char('[') + host + QLatin1Char(']') : host)
      .arg(address.url.port());
}

std::vector<std::string> localFiles(const Address& address, const std::string& id,
                                    const std::string& picture) {
  std::vector<std::string> files;
  if (address.path.isEmpty()) return files;
  const std::string path = address.path.toStdString();
  files.push_back(path);
  if (!id.empty()) files.push_back(path + '/' + id);
  if (!picture.empty()) files.push_back(picture);
  return files;
}

}  // namespace mapwright::robot
