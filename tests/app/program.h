// mapwright as a script runs it: in a folder of its own, without a display, with no robot in the
// environment, and as on a desk also where the tests run on a build server.
#pragma once

#include <functional>
#include <type_traits>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

namespace mapwright::tests {

template <typename Text>
struct EndedWith {
  int code = -1;  // -1: it crashed, or took too long
  Text out, err;
  QJsonObject object() const { return document().object(); }
  QJsonArray array() const { return document().array(); }

 private:
  QJsonDocument document() const {
    if constexpr (std::is_same_v<Text, QByteArray>) {
      return QJsonDocument::fromJson(out);
    } else {
      return QJsonDocument::fromJson(out.toUtf8());
    }
  }
};
using Ended = EndedWith<QString>;
using EndedBytes = EndedWith<QByteArray>;

class Program {
 public:
  struct Means {
    QMap<QString, QString> environment = {};
    QByteArray input = {};
    QString output = {};                  // a file that its standard output goes to; empty = it is read
    std::function<void()> in_child = {};  // before it becomes the program
  };

  QProcessEnvironment environment(const QMap<QString, QString>& more = {}) const {
    QProcessEnvironment env = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"CI", "DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "QT_LOGGING_RULES",
                             "QT_MESSAGE_PATTERN", "MAPWRIGHT_ROBOT", "MAPWRIGHT_SECRET", "MAPWRIGHT_LOG"})
      env.remove(QLatin1String(name));
    env.insert(QStringLiteral("XDG_CACHE_HOME"), path("cache"));
    env.insert(QStringLiteral("XDG_CONFIG_HOME"), path("config"));
    env.insert(QStringLiteral("XDG_DATA_HOME"), path("data"));
    for (auto it = more.begin(); it != more.end(); ++it) env.insert(it.key(), it.value());
    return env;
  }

  /// Events go on meanwhile: servers of the test may live on this thread.
  EndedBytes runForBytes(const QStringList& words, const Means& means) const {
    QProcess process;
    process.setProcessEnvironment(environment(means.environment));
    process.setWorkingDirectory(folder_.path());
    if (!means.output.isEmpty()) process.setStandardOutputFile(means.output);
    if (means.in_child) process.setChildProcessModifier(means.in_child);
    process.start(QStringLiteral(MAPWRIGHT_PROGRAM), words);
    process.write(means.input);
    process.closeWriteChannel();
    if (!QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, 300'000)) {
      process.kill();
      process.waitForFinished();
    }
    const bool crashed = process.exitStatus() != QProcess::NormalExit;
    const EndedBytes ended{crashed ? -1 : process.exitCode(), process.readAllStandardOutput(),
                           process.readAllStandardError()};
    // Said here, because a test that only compares the code would not say what ended the program.
    if (crashed)
      qWarning("%s: ended by signal %d: %s", qPrintable(words.join(QLatin1Char(' '))), process.exitCode(),
               ended.err.constData());
    return ended;
  }
  EndedBytes runForBytes(const QStringList& words) const { return runForBytes(words, Means()); }
  Ended run(const QStringList& words, const Means& means) const {
    const EndedBytes ended = runForBytes(words, means);
    return {ended.code, QString::fromUtf8(ended.out), QString::fromUtf8(ended.err)};
  }
  Ended run(const QStringList& words, const QByteArray& input = {}) const {
    return run(words, Means{.input = input});
  }

  QString folder() const { return folder_.path(); }
  /// In its folder.
  QString path(const QString& name) const { return folder_.filePath(name); }
  QString path(const char* name) const { return path(QLatin1String(name)); }
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
