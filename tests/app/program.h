// mapwright as a script runs it: in a folder of its own, without a display, and with no robot in the
// environment.
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

namespace mapwright::tests {

struct Ended {
  int code = -1;
  QString out, err;
  QJsonObject object() const { return QJsonDocument::fromJson(out.toUtf8()).object(); }
  QJsonArray array() const { return QJsonDocument::fromJson(out.toUtf8()).array(); }
};

class Program {
 public:
  Ended run(const QStringList& words, const QByteArray& input = {}) const {
    QProcessEnvironment env = QProcessEnvironment::systemEnvironment();
    for (const char* name :
         {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "MAPWRIGHT_ROBOT", "MAPWRIGHT_SECRET"})
      env.remove(QLatin1String(name));
    env.insert(QStringLiteral("XDG_CACHE_HOME"), path("cache"));
    env.insert(QStringLiteral("XDG_CONFIG_HOME"), path("config"));
    env.insert(QStringLiteral("XDG_DATA_HOME"), path("data"));
    QProcess process;
    process.setProcessEnvironment(env);
    process.setWorkingDirectory(folder_.path());
    process.start(QStringLiteral(MAPWRIGHT_PROGRAM), words);
    process.write(input);
    process.closeWriteChannel();
    if (!process.waitForFinished(120'000)) return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
  }

  /// In its folder.
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  void put(const char* name, const QByteArray& bytes) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
      qFatal("%s: not written", name);
  }
  QByteArray bytes(const char* name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace mapwright::tests
