// A map is downloaded into a folder: its files replace what was there when that began, and nothing else.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "jobs/map_folder.h"
#include "test_program.h"

namespace test_map_folder {

using namespace mapwright;

namespace {

void put(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("not written");
}

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A robot whose map has no data and no overlays. While it is downloaded somebody writes a file.
class Transfer : public robot::MapTransfer {
 public:
  QString appears;
  robot::Call parts(const map::MapKey& key, robot::OutcomeTo<robot::MapParts> reply) override {
    robot::MapParts parts;
    parts.facts.key = key;
    parts.picture = std::make_shared<const std::string>("picture");
    reply(std::move(parts));
    return {};
  }
  robot::Call download(const robot::MapFacts&, const QString&,
                       robot::OutcomeTo<robot::DataDownload> reply) override {
    if (!appears.isEmpty()) put(appears, "another's");
    map::Failure none;
    none.robot_code = "404";
    reply(robot::fail(std::move(none)));
    return {};
  }
  robot::Call add(const robot::NewMap&, robot::OutcomeTo<robot::MapParts>) override { return {}; }
};

}  // namespace

class TestMapFolder : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;

  robot::Outcome<jobs::DownloadedMap> downloaded(Transfer& transfer) const {
    std::optional<robot::Outcome<jobs::DownloadedMap>> got;
    jobs::downloadMap(transfer, {map::MapKind::Stored, "7"}, folder_.path(),
                      [&](robot::Outcome<jobs::DownloadedMap> outcome) { got = std::move(outcome); });
    return std::move(*got);
  }

 private Q_SLOTS:
  void cleanup() {
    for (const QString& name : QDir(folder_.path()).entryList(QDir::Files))
      QFile::remove(folder_.filePath(name));
  }

  void whatWasThereIsReplaced() {
    for (const char* name : {"map.json", "map.png", "map.pbstream", "overlays.geojson"})
      put(folder_.filePath(QLatin1String(name)), "old");
    Transfer transfer;
    QVERIFY(downloaded(transfer));
    QCOMPARE(bytesOf(folder_.filePath(QStringLiteral("map.png"))), QByteArray("picture"));
    QVERIFY(bytesOf(folder_.filePath(QStringLiteral("map.json"))).contains("mapwright map"));
    QCOMPARE(QDir(folder_.path()).entryList(QDir::Files).size(), 2);
  }

  void whatAppearsMeanwhileStays_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("whole");
    QTest::newRow("picture") << QStringLiteral("map.png") << false;
    QTest::newRow("facts") << QStringLiteral("map.json") << false;
    QTest::newRow("data that it has none of") << QStringLiteral("map.pbstream") << true;
    QTest::newRow("overlays that it has none of") << QStringLiteral("overlays.geojson") << true;
  }
  void whatAppearsMeanwhileStays() {
    QFETCH(QString, name);
    QFETCH(bool, whole);
    Transfer transfer;
    transfer.appears = folder_.filePath(name);
    QCOMPARE(downloaded(transfer).has_value(), whole);
    QCOMPARE(bytesOf(transfer.appears), QByteArray("another's"));
  }
};

}  // namespace test_map_folder

MAPWRIGHT_TEST(test_map_folder, TestMapFolder, Core)
#include "test_map_folder.moc"
