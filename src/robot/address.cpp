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
  if (url.port() == 0) return error(AddressText::tr("Port 0 is not valid in a robot address."));
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
