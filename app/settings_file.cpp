#include "app/settings_file.h"

#include <QByteArrayList>
#include <QDateTime>
#include <QFile>
#include <QFileDevice>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include "disk/private_folder.h"

namespace mapwright::app {
namespace {

const QString kBytes = QStringLiteral("base64");

QJsonValue jsonFrom(const QVariant& value) {
  if (value.typeId() == QMetaType::QByteArray) {
    return QJsonObject{{kBytes, QString::fromLatin1(value.toByteArray().toBase64())}};
  }
  if (value.typeId() == QMetaType::QDateTime) return value.toDateTime().toString(Qt::ISODateWithMs);
  return QJsonValue::fromVariant(value);
}

QVariant variantFrom(const QJsonValue& value) {
  const QJsonObject object = value.toObject();
  if (object.contains(kBytes)) return QByteArray::fromBase64(object[kBytes].toString().toLatin1());
  return value.toVariant();
}

bool readSettings(QIODevice& device, QSettings::SettingsMap& map) {
  const QByteArray text = device.readAll();
  if (text.isEmpty()) return true;
  const QJsonDocument json = QJsonDocument::fromJson(text);
  const QJsonObject object = json.object();
  for (auto at = object.begin(); at != object.end(); ++at) map.insert(at.key(), variantFrom(at.value()));
  return json.isObject();
}

bool writeSettings(QIODevice& device, const QSettings::SettingsMap& map) {
  QJsonObject object;
  for (auto at = map.begin(); at != map.end(); ++at) object.insert(at.key(), jsonFrom(at.value()));
  const QByteArray text = QJsonDocument(object).toJson();
  // QSettings and QSaveFile of Qt 6.4 ignore the result of flushing the buffer: a file that does not fit is
  // replaced by an empty one. Here nothing is replaced unless everything was written.
  auto* const file = qobject_cast<QFileDevice*>(&device);
  return device.write(text) == text.size() && file != nullptr && file->flush();
}

}  // namespace

std::unique_ptr<QSettings> openSettings() {
  return openSettingsIn(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                        QStringLiteral("/mapwright"));
}

std::unique_ptr<QSettings> openSettingsIn(const QString& folder) {
  const QSettings::Format format =
      QSettings::registerFormat(QStringLiteral("json"), &readSettings, &writeSettings);
  const QFileInfo file(folder + QStringLiteral("/mapwright.json"));
  const QFileInfo older(folder + QStringLiteral("/mapwright.ini"));
  // A named pipe would block; nothing can be stored below a device.
  const bool blocked = file.exists() && !file.isFile();
  if (!blocked) disk::makePrivateFolder(QFile::encodeName(folder).toStdString());
  auto settings = std::make_unique<QSettings>(
      blocked ? QStringLiteral("/dev/null/mapwright.json") : file.filePath(), format);
  if (!file.exists() && older.isFile()) {
    const QSettings before(older.filePath(), QSettings::IniFormat);
    for (const QString& key : before.allKeys()) settings->setValue(key, before.value(key));
  }
  return settings;
}

void makeOwnFoldersPrivate() {
  using Paths = QStandardPaths;
  for (const auto where :
       {Paths::GenericConfigLocation, Paths::GenericDataLocation, Paths::GenericCacheLocation}) {
    disk::makePrivate(
        QFile::encodeName(Paths::writableLocation(where) + QStringLiteral("/mapwright")).toStdString());
  }
}

void ignoreRelativeFolders() {
  for (const char* name :
       {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
    const QByteArray folder = qgetenv(name);
    if (!folder.isNull() && !folder.startsWith('/')) qunsetenv(name);
  }
  for (const char* name : {"XDG_CONFIG_DIRS", "XDG_DATA_DIRS"}) {
    const QByteArray folders = qgetenv(name);
    if (folders.isNull()) continue;
    QByteArrayList absolute;
    for (const QByteArray& folder : folders.split(':')) {
      if (folder.startsWith('/')) absolute << folder;
    }
    absolute.isEmpty() ? qunsetenv(name) : qputenv(name, absolute.join(':'));
  }
}

}  // namespace mapwright::app
