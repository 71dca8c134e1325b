#include "robot/address.h"

#include <cmath>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStringList>
#include <QUrlQuery>

namespace mapwright::robot {
namespace {

using Parsed = tl::expected<Address, QString>;

constexpr int kAxbotPort = 8090, kAimdkPort = 50807;

QString tr(const char* text) { return QCoreApplication::translate("Address", text); }

auto error(const QString& why) { return tl::make_unexpected(why); }

bool begins(const QString& text, const char* with) {
  return text.startsWith(QLatin1String(with), Qt::CaseInsensitive);
}

Parsed demo(const QString& text) {
  const QString query = text.contains(QLatin1Char('?')) ? text.section(QLatin1Char('?'), 1) : QString();
  Address address;
  address.backend = Backend::Demo;
  address.url.setScheme(QStringLiteral("demo"));
  address.url.setQuery(query);
  address.text = query.isEmpty() ? QStringLiteral("demo:") : QStringLiteral("demo:?") + query;
  return address;
}

bool endsLikeMap(const QString& path) {
  for (const char* suffix : {".yaml", ".yml", ".png", ".pgm", ".bmp"}) {
    if (path.endsWith(QLatin1String(suffix), Qt::CaseInsensitive)) return true;
  }
  return false;
}

/// nullopt unless all of `text` is 2 or 3 finite numbers.
std::optional<geometry::Pose2> originFrom(const QString& text) {
  const QStringList parts = text.split(QLatin1Char(','));
  if (parts.size() != 2 && parts.size() != 3) return std::nullopt;
  double values[3] = {0, 0, 0};
  for (qsizetype i = 0; i < parts.size(); ++i) {
    bool ok = false;
    values[i] = parts[i].trimmed().toDouble(&ok);
    if (!ok || !std::isfinite(values[i])) return std::nullopt;
  }
  return geometry::Pose2{values[0], values[1], values[2]};
}

QString takeFileQuery(const QString& query, Address& address) {
  for (const auto& [name, value] : QUrlQuery(query).queryItems(QUrl::FullyDecoded)) {
    bool ok = true;
    if (name == QLatin1String("resolution")) {
      address.resolution_m = value.toDouble(&ok);
      ok = ok && std::isfinite(*address.resolution_m) && *address.resolution_m > 0;
    } else if (name == QLatin1String("origin")) {
      address.origin = originFrom(value);
      ok = address.origin.has_value();
    } else {
      return tr("file: knows resolution and origin after the ?, but not \"%1\".").arg(name);
    }
    if (!ok) {
      return tr("file: %1 cannot be \"%2\". Write for example ?resolution=0.05&origin=-10,-7.5.")
          .arg(name, value);
    }
  }
  return {};
}

Parsed file(const QString& given) {
  Address address;
  address.backend = Backend::File;
  QString path = given, query;
  // A file may have a ? in its name; where it exists, that is what is meant.
  const bool exists = QFileInfo::exists(path);
  if (const auto mark = path.lastIndexOf(QLatin1Char('?')); mark >= 0 && !exists) {
    query = path.mid(mark + 1);
    path.truncate(mark);
  }
  if (path.isEmpty()) return error(tr("Give the path of a map, for example file:maps/office.yaml."));
  if (path.startsWith(QLatin1String("~/"))) path.replace(0, 1, QDir::homePath());
  if (const QString why = takeFileQuery(query, address); !why.isEmpty()) return error(why);
  address.path = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  address.text = QStringLiteral("file:") + address.path;
  if (!query.isEmpty()) address.text += QLatin1Char('?') + query;
  return address;
}

/// What follows "file:", as a path.
QString filePath(const QString& rest) {
  if (!rest.startsWith(QLatin1String("//"))) return rest;
  const QString encoded = rest.section(QLatin1Char('?'), 0, 0);
  QString path = QUrl(QStringLiteral("file:") + encoded).toLocalFile();
  if (rest.contains(QLatin1Char('?'))) path += QLatin1Char('?') + rest.section(QLatin1Char('?'), 1);
  return path;
}

/// An http or https address of a host with a port and without a password; the error is a sentence.
tl::expected<QUrl, QString> webAddress(const QString& text, QString rest, const QString& example, int port) {
  if (!rest.contains(QLatin1String("://"))) rest = QStringLiteral("http://") + rest;
  QUrl url(rest, QUrl::StrictMode);
  const QString scheme = url.scheme().toLower();
  // Not repeated: the text may hold a password.
  if (!url.userInfo().isEmpty() || rest.contains(QLatin1Char('@'))) {
    return error(
        tr("Leave the user name and password out of the address: give the secret in its own field, by "
           "--secret-file or by MAPWRIGHT_SECRET."));
  }
  if (!url.isValid() || url.host().isEmpty()) {
    return error(tr("\"%1\" is not an address. Write for example %2.").arg(text, example));
  }
  if (scheme != QLatin1String("http") && scheme != QLatin1String("https")) {
    return error(tr("\"%1\" does not begin with a scheme that is known here. Write axbot+http://HOST:8090, "
                    "axbot+https://HOST, aimdk+http://HOST, file:PATH or demo:.")
                     .arg(text));
  }
  if (url.port() == -1) url.setPort(port);
  if (url.port() == 0) return error(tr("Port 0 is not an address of a robot."));
  QString path = url.path();
  while (path.endsWith(QLatin1Char('/'))) path.chop(1);
  url.setPath(path);
  return url;
}

Parsed axbot(const QString& text, const QString& rest) {
  const auto url = webAddress(text, rest, QStringLiteral("axbot+http://192.168.25.25:8090"), kAxbotPort);
  if (!url) return error(url.error());
  if (url->hasQuery() || url->hasFragment()) {
    return error(tr("The address of an Autoxing robot has no part after ? or #."));
  }
  Address address;
  address.url = *url;
  address.text = QStringLiteral("axbot+") + url->toString();
  return address;
}

Parsed aimdk(const QString& text, const QString& rest) {
  auto url = webAddress(text, rest, QStringLiteral("aimdk+http://192.168.100.110:50807"), kAimdkPort);
  if (!url) return error(url.error());
  Address address;
  address.backend = Backend::Aimdk;
  for (const auto& [name, value] : QUrlQuery(*url).queryItems(QUrl::FullyDecoded)) {
    address.tf = QUrl(value, QUrl::StrictMode);
    const QString scheme = address.tf.scheme();
    const bool usable = address.tf.isValid() && !address.tf.host().isEmpty() &&
                        address.tf.userInfo().isEmpty() &&
                        (scheme == QLatin1String("ws") || scheme == QLatin1String("wss"));
    if (name != QLatin1String("tf") || !usable) {
      return error(
          tr("The address of an Agibot robot may only have ?tf=ws://HOST:9090 (its rosbridge) after "
             "the host."));
    }
  }
  if (url->hasFragment()) return error(tr("The address of an Agibot robot has no part after #."));
  url->setQuery(QString());
  address.url = *url;
  address.text = QStringLiteral("aimdk+") + url->toString();
  if (!address.tf.isEmpty()) address.text += QStringLiteral("?tf=") + address.tf.toString();
  return address;
}

}  // namespace

Parsed parseAddress(const QString& typed) {
  const QString text = typed.trimmed();
  if (text.isEmpty()) {
    return error(tr("Give a robot address, for example axbot+http://192.168.25.25:8090."));
  }
  if (text == QLatin1String("demo") || text.startsWith(QLatin1String("demo:"))) return demo(text);
  if (begins(text, "file:")) return file(filePath(text.mid(5)));
  for (const char* later : {"kabam+", "rep130+"}) {
    if (begins(text, later)) {
      return error(
          tr("Addresses that begin with %1 are not supported by this version; it talks to Autoxing robots "
             "(axbot+http://HOST:8090), Agibot robots (aimdk+http://HOST), files (file:PATH) and demo:.")
              .arg(QLatin1String(later)));
    }
  }
  if (begins(text, "axbot+")) return axbot(text, text.mid(6));
  if (begins(text, "aimdk+")) return aimdk(text, text.mid(6));
  const QString before_query = text.section(QLatin1Char('?'), 0, 0);
  const bool has_scheme = text.contains(QLatin1String("://"));
  if (!has_scheme && (endsLikeMap(before_query) || QFileInfo::exists(text) ||
                      QFileInfo::exists(before_query) || text.startsWith(QLatin1Char('/')) ||
                      text.startsWith(QLatin1String("./")) || text.startsWith(QLatin1String("~/")))) {
    return file(text);
  }
  return axbot(text, text);
}

QString hostOf(const Address& address) {
  if (address.backend != Backend::Axbot && address.backend != Backend::Aimdk) return {};
  const QString host = address.url.host();
  return QStringLiteral("%1:%2")
      .arg(host.contains(QLatin1Char(':')) ? QLatin1Char('[') + host + QLatin1Char(']') : host)
      .arg(address.url.port());
}

std::vector<std::string> localFiles(const QString& address, const std::string& id,
                                    const std::string& picture) {
  std::vector<std::string> files;
  const auto parsed = parseAddress(address);
  if (!parsed || parsed->backend != Backend::File) return files;
  const std::string path = parsed->path.toStdString();
  files.push_back(path);
  if (!id.empty()) files.push_back(path + '/' + id);
  if (!picture.empty()) files.push_back(picture);
  return files;
}

}  // namespace mapwright::robot
