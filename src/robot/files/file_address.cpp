#include "robot/files/file_address.h"

#include <cmath>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace mapwright::robot::files {
namespace {

class FileAddressText {
  Q_DECLARE_TR_FUNCTIONS(Address)
};

auto error(const QString& why) { return tl::make_unexpected(why); }

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

std::optional<double> resolutionFrom(const QString& text) {
  bool ok = false;
  const double value = text.toDouble(&ok);
  return ok && std::isfinite(value) && value > 0 ? std::optional(value) : std::nullopt;
}

/// "/robot1"; nullopt: it is none.
std::optional<QString> namespaceFrom(QString text) {
  while (text.endsWith(QLatin1Char('/'))) text.chop(1);
  static const QRegularExpression like(
      QRegularExpression::anchoredPattern(QStringLiteral("(/[A-Za-z0-9_]+)+")));
  return text.size() <= 200 && like.match(text).hasMatch() ? std::optional(text) : std::nullopt;
}

/// A sentence about what is wrong with them; empty = nothing.
QString notOptionsReason(const QUrlQuery& options) {
  for (const auto& [name, value] : options.queryItems(QUrl::FullyDecoded)) {
    const bool resolution = name == QLatin1String("resolution");
    if (name == QLatin1String("ns")) {
      if (namespaceFrom(value)) continue;
      return FileAddressText::tr(
          "file: ns is the namespace of a robot in a recording, for example ?ns=/robot1.");
    }
    if (!resolution && name != QLatin1String("origin")) {
      return FileAddressText::
          tr("file: accepts resolution and origin (of a picture) and ns (of a recording) after the ?, but "
             "not \"%1\".")
              .arg(name);
    }
    if (resolution ? !resolutionFrom(value) : !originFrom(value)) {
      return FileAddressText::tr("file: %1 cannot be \"%2\". For example: ?resolution=0.05&origin=-10,-7.5.")
          .arg(name, value);
    }
  }
  return {};
}

/// What follows "file:", as a path.
QString filePath(const QString& rest) {
  if (!rest.startsWith(QLatin1String("//"))) return rest;
  const QString encoded = rest.section(QLatin1Char('?'), 0, 0);
  QString path = QUrl(QStringLiteral("file:") + encoded).toLocalFile();
  if (rest.contains(QLatin1Char('?'))) path += QLatin1Char('?') + rest.section(QLatin1Char('?'), 1);
  return path;
}

/// A map description, not a plain picture.
bool whatSaysItsPlace(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  return suffix == QLatin1String("yaml") || suffix == QLatin1String("yml");
}

ParsedAddress parse(const QString& rest) {
  QString path = filePath(rest), query;
  // A file name may contain a ?; if the file exists, that is what is meant.
  if (const auto mark = path.lastIndexOf(QLatin1Char('?')); mark >= 0 && !QFileInfo::exists(path)) {
    query = path.mid(mark + 1);
    path.truncate(mark);
  }
  if (path.isEmpty())
    return error(FileAddressText::tr("Enter the path of a map, for example file:maps/office.yaml."));
  if (path.startsWith(QLatin1String("~/"))) path.replace(0, 1, QDir::homePath());
  Address address;
  address.options = QUrlQuery(query);
  if (const QString why = notOptionsReason(address.options); !why.isEmpty()) return error(why);
  if (!query.isEmpty() && whatSaysItsPlace(path))
    return error(FileAddressText::tr("%1 already states where its map is: leave out the part after the ?.")
                     .arg(QFileInfo(path).fileName()));
  address.path = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  address.text = QStringLiteral("file:") + address.path;
  if (!query.isEmpty()) address.text += QLatin1Char('?') + query;
  return address;
}

/// Extensions that no host has: a file of this name is missing, or cannot be read as a map.
bool isOtherFile(const QString& path) {
  static const QStringList kSuffixes{
      QStringLiteral("jpg"),  QStringLiteral("jpeg"), QStringLiteral("gif"), QStringLiteral("tif"),
      QStringLiteral("tiff"), QStringLiteral("webp"), QStringLiteral("svg"), QStringLiteral("ppm"),
      QStringLiteral("pnm"),  QStringLiteral("pbm"),  QStringLiteral("xcf"), QStringLiteral("pdf"),
      QStringLiteral("json"), QStringLiteral("csv"),  QStringLiteral("txt"), QStringLiteral("xml")};
  return kSuffixes.contains(QFileInfo(path).suffix().toLower());
}

/// "maps/office", where the folder maps exists.
bool isInAFolder(const QString& path) {
  const auto slash = path.indexOf(QLatin1Char('/'));
  return slash > 0 && QFileInfo(path.left(slash)).isDir();
}

/// It exists as a path, looks like one, or has the extension of a file.
bool claims(const QString& typed) {
  if (typed.contains(QLatin1String("://"))) return false;
  const QString before_query = typed.section(QLatin1Char('?'), 0, 0);
  return isOtherFile(before_query) || isInAFolder(before_query) || isMapFile(before_query) ||
         isOverlayFile(before_query) || QFileInfo::exists(typed) || QFileInfo::exists(before_query) ||
         typed.startsWith(QLatin1Char('/')) || typed.startsWith(QLatin1String("./")) ||
         typed.startsWith(QLatin1String("~/"));
}

}  // namespace

AddressScheme addressScheme() {
  return {QStringLiteral("file:"), QStringLiteral("file:/maps/office.yaml"), parse, claims, false};
}

std::string namespaceOf(const Address& address) {
  const auto ns = namespaceFrom(address.options.queryItemValue(QStringLiteral("ns"), QUrl::FullyDecoded));
  return ns.value_or(QString()).toStdString();
}

PicturePlace placeOf(const Address& address) {
  const auto option = [&](const char* name) {
    return address.options.queryItemValue(QLatin1String(name), QUrl::FullyDecoded);
  };
  return {resolutionFrom(option("resolution")), originFrom(option("origin"))};
}

}  // namespace mapwright::robot::files
