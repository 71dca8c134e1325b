#include "ui/window/made_of.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QSysInfo>

#include "versions.h"

namespace mapwright::ui {
namespace {

/// An empty text as null: it is not known.
QJsonValue orNone(const QString& text) { return text.isEmpty() ? QJsonValue() : QJsonValue(text); }

}  // namespace

QList<Library> libraries() {
  const auto row = [](const char* name, const char* version, const char* licence) {
    return Library{QString::fromLatin1(name), QString::fromLatin1(version), QString::fromLatin1(licence)};
  };
  return {
      row("qt6-base", kVersionOfQt, "LGPL-3"),        row("qt6-websockets", kVersionOfQtWebSockets, "LGPL-3"),
      row("qt6-svg", kVersionOfQtSvg, "LGPL-3"),      row("qtkeychain", kVersionOfQtKeychain, "BSD-2"),
      row("protobuf", kVersionOfProtobuf, "BSD-3"),   row("simdjson", kVersionOfSimdjson, "Apache-2.0"),
      row("yaml-cpp", kVersionOfYamlCpp, "MIT"),      row("Eigen", kVersionOfEigen, "MPL-2.0"),
      row("tl::expected", kVersionOfExpected, "CC0"), row("libdeflate", kVersionOfDeflate, "MIT"),
      row("libspng", kVersionOfSpng, "BSD-2"),        row("SQLite", kVersionOfSqlite, "public domain"),
      row("ISA-L", kVersionOfIsal, "BSD-3"),          row("LZ4", kVersionOfLz4, "BSD-2"),
      row("Zstandard", kVersionOfZstd, "BSD-3"),      row("bzip2", kVersionOfBzip2, "BSD-like"),
      row("Boost", kVersionOfBoost, "BSL-1.0"),       row("zlib", kVersionOfZlib, "Zlib"),
      row("OpenCV", kVersionOfOpenCv, "Apache-2.0"),  row("CLI11", kVersionOfCli11, "BSD-3"),
  };
}

QString compiledQt() { return QStringLiteral(QT_VERSION_STR); }
QString runningQt() { return QString::fromLatin1(qVersion()); }

QJsonObject versionJson() {
  QJsonArray used;
  for (const Library& library : libraries()) {
    used << QJsonObject{{QStringLiteral("name"), library.name},
                        {QStringLiteral("version"), orNone(library.version)},
                        {QStringLiteral("licence"), library.licence}};
  }
  return {{QStringLiteral("version"), QStringLiteral(MAPWRIGHT_VERSION)},
          {QStringLiteral("commit"), orNone(builtCommit())},
          {QStringLiteral("licence"), QStringLiteral("Apache-2.0")},
          {QStringLiteral("architecture"), QSysInfo::buildCpuArchitecture()},
          {QStringLiteral("qt"),
           QJsonObject{{QStringLiteral("compiled"), compiledQt()}, {QStringLiteral("running"), runningQt()}}},
          {QStringLiteral("libraries"), used}};
}

QString versionText() {
  QStringList lines{
      QStringLiteral("mapwright %1 (Apache-2.0)").arg(QLatin1String(MAPWRIGHT_VERSION)),
      QCoreApplication::translate("window", "Commit %1")
          .arg(builtCommit().isEmpty() ? QCoreApplication::translate("window", "unknown") : builtCommit()),
      QCoreApplication::translate("window", "Qt %1, compiled against %2").arg(runningQt(), compiledQt())};
  for (const Library& library : libraries())
    lines << QStringLiteral("%1 %2 (%3)").arg(library.name, library.version, library.licence);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace mapwright::ui
