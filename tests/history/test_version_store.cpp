// Versions of overlays are kept, found again and bounded, whatever happens to the file.
#include <sqlite3.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "history/version_store.h"
#include "test_program.h"

namespace test_version_store {

using namespace mapwright;
using history::Origin;
using history::VersionStore;

namespace {

const history::MapName kHall{"axbot+http://10.0.0.7:8090", "uid-1", "1", "Hall <b>1</b> 😀"};
const history::MapName kYard{"axbot+http://10.0.0.7:8090", "uid-2", "2", "Yard"};

}  // namespace

class VersionStoreTest : public QObject {
  Q_OBJECT
  std::unique_ptr<QTemporaryDir> folder_;

  std::string path() const { return folder_->filePath(QStringLiteral("new/overlays.sqlite")).toStdString(); }
  VersionStore store(VersionStore::Limits limits = {}) const {
    auto opened = VersionStore::open(path(), limits);
    if (!opened) qFatal("%s", inEnglish(opened.error()).c_str());
    return std::move(*opened);
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void whatIsKeptIsFoundAgain() {
    const std::string text("{\"a\":1.50,\"\0\xff\":2}", 16);
    QVERIFY(!store().keep(kHall, 5, Origin::Read, text, 1000.5));
    VersionStore again = store();
    QVERIFY(!again.keep(kHall, std::nullopt, Origin::Saved, "", 1001));
    QVERIFY(!again.keep(kYard, 1, Origin::Read, text, 1002));
    const auto hall = again.list(kHall.robot, kHall.uid);
    QVERIFY(hall && hall->size() == 2);
    QVERIFY((*hall)[0].origin == Origin::Saved && !(*hall)[0].version && (*hall)[0].bytes == 0);
    QCOMPARE((*hall)[1].version, std::optional(5));
    QCOMPARE((*hall)[1].kept_s, 1000.5);
    QCOMPARE((*hall)[1].map.name, kHall.name);
    QCOMPARE((*hall)[1].map.id, kHall.id);
    QCOMPARE(again.text((*hall)[1].number).value(), text);
    QCOMPARE(again.text((*hall)[0].number).value(), std::string());
    QCOMPARE(again.list("", "")->size(), std::size_t(3));
    QCOMPARE(again.list(kHall.robot, "")->size(), std::size_t(3));
    QCOMPARE(again.list("another", "")->size(), std::size_t(0));
    QCOMPARE(again.find((*hall)[1].number).value()->bytes, std::int64_t(text.size()));
  }

  void theSameTextIsKeptOnce() {
    VersionStore versions = store();
    for (const char* text : {"a", "a", "b", "a"}) QVERIFY(!versions.keep(kHall, 1, Origin::Read, text, 1));
    QCOMPARE(versions.list("", "")->size(), std::size_t(3));
  }

  void theOldestGo() {
    VersionStore versions = store({.of_map = 3, .bytes = 1'000});
    for (int i = 0; i < 5; ++i) QVERIFY(!versions.keep(kHall, i, Origin::Read, std::to_string(i), i));
    QVERIFY(!versions.keep(kYard, 1, Origin::Read, "yard", 9));
    QCOMPARE(versions.list(kHall.robot, kHall.uid)->back().version, std::optional(2));
    QVERIFY(!versions.keep(kYard, 2, Origin::Read, std::string(900, 'x'), 10));
    QVERIFY(!versions.keep(kYard, 3, Origin::Read, std::string(200, 'y'), 11));
    QCOMPARE(versions.list("", "")->size(), std::size_t(1));
    // What is kept now stays, however large.
    QVERIFY(!versions.keep(kYard, 4, Origin::Read, std::string(2'000, 'z'), 12));
    QCOMPARE(versions.list("", "")->size(), std::size_t(1));
    QCOMPARE(versions.list("", "")->front().version, std::optional(4));
  }

  void twoProgramsKeepAtOnce() {
    VersionStore one = store(), other = store();
    QVERIFY(!one.keep(kHall, 1, Origin::Read, "a", 1));
    QVERIFY(!other.keep(kHall, 2, Origin::Read, "b", 2));
    QVERIFY(!one.keep(kHall, 2, Origin::Read, "b", 3));
    QCOMPARE(one.list("", "")->size(), std::size_t(2));
  }

  void aVersionThatWasDamagedIsNotGivenOut() {
    QVERIFY(!store().keep(kHall, 1, Origin::Read, "the wall is at 1.50 m", 1));
    QVERIFY(!store().keep(kHall, 2, Origin::Read, "the wall is at 2.50 m", 2));
    QFile file(QString::fromStdString(path()));
    QVERIFY(file.open(QIODevice::ReadWrite));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.count("1.50 m") == 1 && file.seek(bytes.indexOf("1.50 m")) && file.write("7") == 1);
    file.close();
    const auto versions = store().list("", "");
    QVERIFY(versions && versions->size() == 2);
    const auto damaged = store().text(versions->back().number);
    QVERIFY(!damaged && inEnglish(damaged.error()).find("damaged") != std::string::npos);
    QCOMPARE(store().text(versions->front().number).value(), std::string("the wall is at 2.50 m"));
  }

  void versionsOfOlderProgramsAreRead() {
    QVERIFY(!store().keep(kHall, 1, Origin::Read, "old", 1));
    sqlite3* database = nullptr;
    QCOMPARE(sqlite3_open(path().c_str(), &database), SQLITE_OK);
    QCOMPARE(sqlite3_exec(database, "ALTER TABLE versions DROP COLUMN sum", nullptr, nullptr, nullptr),
             SQLITE_OK);
    sqlite3_close(database);
    QVERIFY(!store().keep(kHall, 2, Origin::Read, "new", 2));
    const auto versions = store().list("", "");
    QVERIFY(versions && versions->size() == 2);
    QCOMPARE(store().text(versions->back().number).value(), std::string("old"));
    QCOMPARE(store().text(versions->front().number).value(), std::string("new"));
  }

  void whatIsNoStoreIsSaid() {
    QFile file(folder_->filePath(QStringLiteral("overlays.sqlite")));
    QVERIFY(file.open(QIODevice::WriteOnly) &&
            file.write("this is no database at all, but long enough for one") > 0);
    file.close();
    const auto opened = VersionStore::open(file.fileName().toStdString());
    QVERIFY(!opened);
    QVERIFY(inEnglish(opened.error()).find("overlays.sqlite") != std::string::npos);
    QVERIFY(!VersionStore::open("/proc/none/overlays.sqlite"));
    QVERIFY(!store().text(77));
    QVERIFY(!store().find(77)->has_value());
  }
};

}  // namespace test_version_store

MAPWRIGHT_TEST(test_version_store, VersionStoreTest, Nothing)
#include "test_version_store.moc"
