#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QDateTime>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimeZone>

#include "app/settings_file.h"
#include "test_program.h"

namespace test_settings_file {

using namespace mapwright::app;

namespace {

QByteArray read(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class SettingsFileTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;
  QString path(const char* name) const { return folder_->filePath(QLatin1String(name)); }
  static void fill(QSettings& settings) {
    settings.setValue(QStringLiteral("window/geometry"), QByteArray::fromHex("00ff10"));
    settings.setValue(QStringLiteral("layers/order"),
                      QStringList{QStringLiteral("a"), QStringLiteral("b, c")});
    settings.setValue(QStringLiteral("layers/grid/opacity"), 0.25);
    settings.setValue(QStringLiteral("layers/grid/visible"), false);
    settings.setValue(QStringLiteral("view/theme"), QStringLiteral("dark \"é\"\n"));
    settings.beginWriteArray(QStringLiteral("recentRobots"), 1);
    settings.setArrayIndex(0);
    settings.setValue(QStringLiteral("last"),
                      QDateTime(QDate(2030, 5, 1), QTime(12, 0), QTimeZone::utc()).toUTC());
    settings.endArray();
  }
  static void check(QSettings& settings) {
    QCOMPARE(settings.value(QStringLiteral("window/geometry")).toByteArray(), QByteArray::fromHex("00ff10"));
    QCOMPARE(settings.value(QStringLiteral("layers/order")).toStringList(),
             (QStringList{QStringLiteral("a"), QStringLiteral("b, c")}));
    QCOMPARE(settings.value(QStringLiteral("layers/grid/opacity")).toDouble(), 0.25);
    QCOMPARE(settings.value(QStringLiteral("layers/grid/visible"), true).toBool(), false);
    QCOMPARE(settings.value(QStringLiteral("view/theme")).toString(), QStringLiteral("dark \"é\"\n"));
    QCOMPARE(settings.beginReadArray(QStringLiteral("recentRobots")), 1);
    settings.setArrayIndex(0);
    QCOMPARE(settings.value(QStringLiteral("last")).toDateTime(),
             QDateTime(QDate(2030, 5, 1), QTime(12, 0), QTimeZone::utc()).toUTC());
    settings.endArray();
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void everyKindOfValueComesBack() {
    fill(*openSettingsIn(folder_->path()));
    const auto settings = openSettingsIn(folder_->path());
    check(*settings);
    QCOMPARE(settings->status(), QSettings::NoError);
  }

  void whatAnOlderVersionKeptIsTakenOverOnce() {
    {
      QSettings older(path("mapwright.ini"), QSettings::IniFormat);
      fill(older);
    }
    check(*openSettingsIn(folder_->path()));
    openSettingsIn(folder_->path())->setValue(QStringLiteral("view/theme"), QStringLiteral("light"));
    QCOMPARE(openSettingsIn(folder_->path())->value(QStringLiteral("view/theme")).toString(),
             QStringLiteral("light"));
  }

  void aFullDiskLeavesTheOldOnesAndIsSaid_data() {
    QTest::addColumn<int>("room");
    for (const int room : {0, 100, 600, 5'000}) QTest::addRow("room for %d bytes", room) << room;
  }
  void aFullDiskLeavesTheOldOnesAndIsSaid() {
    QFETCH(int, room);
    fill(*openSettingsIn(folder_->path()));
    const QByteArray before = read(path("mapwright.json"));
    QVERIFY(!before.isEmpty());
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{rlim_t(room), limit.rlim_max};
    auto settings = openSettingsIn(folder_->path());
    settings->setValue(QStringLiteral("long"), QString(6'000, QLatin1Char('x')));
    ::setrlimit(RLIMIT_FSIZE, &small);
    settings->sync();
    const auto status = settings->status();
    settings.reset();
    ::setrlimit(RLIMIT_FSIZE, &limit);
    QCOMPARE(status, QSettings::AccessError);
    QCOMPARE(read(path("mapwright.json")), before);
  }

  void aNamedPipeInTheWayHoldsNobodyUp() {
    for (const char* name : {"mapwright.ini", "mapwright.json"}) {
      QCOMPARE(::mkfifo(QFile::encodeName(path(name)).constData(), 0600), 0);
      const auto settings = openSettingsIn(folder_->path());
      settings->setValue(QStringLiteral("a"), 1);
      QCOMPARE(settings->value(QStringLiteral("a")).toInt(), 1);
      settings->sync();
      QCOMPARE(settings->status() == QSettings::NoError,
               QString::fromLatin1(name).endsWith(QStringLiteral("ini")));
      QFile::remove(path("mapwright.json"));
    }
  }

  void relativeFoldersAreIgnored() {
    qputenv("HOME", QFile::encodeName(folder_->path()));
    for (const char* value : {"here", "./here", "../here", "~/here", ""}) {
      for (const char* name : {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"})
        qputenv(name, value);
      qputenv("XDG_DATA_DIRS", "rel:/usr/share:also/rel");
      ignoreRelativeFolders();
      QCOMPARE(QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation), path(".config"));
      QCOMPARE(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation), path(".cache"));
      QCOMPARE(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation), path(".local/share"));
      QVERIFY(!qEnvironmentVariableIsSet("XDG_STATE_HOME"));
      QCOMPARE(qgetenv("XDG_DATA_DIRS"), QByteArray("/usr/share"));
    }
    qputenv("XDG_CACHE_HOME", "/else/where");
    ignoreRelativeFolders();
    QCOMPARE(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation),
             QStringLiteral("/else/where"));
  }
};

}  // namespace test_settings_file

MAPWRIGHT_TEST(test_settings_file, SettingsFileTest, Core)
#include "test_settings_file.moc"
