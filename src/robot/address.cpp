#include "robot/address.h"

#include <QCoreApplication>
#include <QStringList>

namespace mapwright::robot {
namespace {

constexpr int kAxbotPort = 8090;

QString tr(const char* text) { return QCoreApplication::translate("Address", text); }

}  // namespace

tl::expected<Address, QString> parseAddress(const QString& typed) {
  const QString text = typed.trimmed();
  const auto error = [&](const QString& why) { return tl::make_unexpected(why); };
  if (text.isEmpty()) {
    return error(tr("Give a robot address, for example axbot+http://192.168.25.25:8090."));
  }
  if (text == QLatin1String("demo") || text.startsWith(QLatin1String("demo:"))) {
    const QString query = text.contains(QLatin1Char('?')) ? text.section(QLatin1Char('?'), 1) : QString();
    QUrl url;
    url.setScheme(QStringLiteral("demo"));
    url.setQuery(query);
    return Address{Backend::Demo, url,
                   query.isEmpty() ? QStringLiteral("demo:") : QStringLiteral("demo:?") + query};
  }
  for (const char* later : {"aimdk+", "kabam+", "rep130+", "file:"}) {
    if (text.startsWith(QLatin1String(later), Qt::CaseInsensitive)) {
      return error(
          tr("Addresses that begin with %1 are not supported by this version; it talks to Autoxing robots "
             "(axbot+http://HOST:8090) and to demo:.")
              .arg(QLatin1String(later)));
    }
  }
  QString rest = text;
  if (rest.startsWith(QLatin1String("axbot+"), Qt::CaseInsensitive)) rest = rest.mid(6);
  if (!rest.contains(QLatin1String("://"))) rest = QStringLiteral("http://") + rest;
  QUrl url(rest, QUrl::StrictMode);
  const QString scheme = url.scheme().toLower();
  if (!url.isValid() || url.host().isEmpty()) {
    return error(
        tr("\"%1\" is not an address. Write for example axbot+http://192.168.25.25:8090.").arg(text));
  }
  if (scheme != QLatin1String("http") && scheme != QLatin1String("https")) {
    return error(tr("\"%1\" does not begin with a scheme that is known here. Write axbot+http://HOST:8090, "
                    "axbot+https://HOST or demo:.")
                     .arg(text));
  }
  if (!url.userInfo().isEmpty()) {
    return error(
        tr("Leave the user name and password out of the address: give the secret in its own field, by "
           "--secret-file or by MAPWRIGHT_SECRET."));
  }
  if (url.hasQuery() || url.hasFragment()) {
    return error(tr("The address of an Autoxing robot has no part after ? or #."));
  }
  if (url.port() == -1) url.setPort(kAxbotPort);
  if (url.port() == 0) return error(tr("Port 0 is not an address of a robot."));
  QString path = url.path();
  while (path.endsWith(QLatin1Char('/'))) path.chop(1);
  url.setPath(path);
  return Address{Backend::Axbot, url, QStringLiteral("axbot+") + url.toString()};
}

}  // namespace mapwright::robot
