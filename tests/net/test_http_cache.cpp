#include <atomic>
#include <limits>
#include <sys/stat.h>

#include <QDir>
#include <QDirIterator>
#include <QSemaphore>
#include <QTemporaryDir>
#include <QThread>
#include <QTimeZone>
#include <QtEndian>
#include <QtTest>
#include <libdeflate.h>

#include "fault_arguments.h"
#include "net/http_cache.h"
#include "test_program.h"

namespace test_http_cache {

using namespace mapwright;
using namespace mapwright::net;

namespace {

const QUrl kUrl(QStringLiteral("http://robot:8090/ros/slam/submaps/u/0/1?ver=7"));

QStringList filesIn(const QString& folder) {
  QStringList files;
  QDirIterator all(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (all.hasNext()) {
    files.append(all.next());
  }
  return files;
}

/// A disk that is busy until it is told to go on.
struct SlowDisk {
  QSemaphore begun, may_go_on;
  std::atomic<int> written = 0;
  WriteFile write() {
    return [this](const std::string& path, const QByteArray& bytes, qint64 now_ms) {
      begun.release();
      may_go_on.acquire();
      const int failure = writeWhole(path, bytes, now_ms);
      written += failure == 0;
      return failure;
    };
  }
  void beFastAgain() { may_go_on.release(1'000'000); }
};

}  // namespace

class TestHttpCache : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    now_ = QDateTime(QDate(2030, 5, 1), QTime(12, 0), QTimeZone::utc()).toUTC();
  }

  void obeysTheHeaders_data() {
    QTest::addColumn<QByteArray>("cache_control");
    QTest::addColumn<QByteArray>("etag");
    QTest::addColumn<bool>("content_addressed");
    QTest::addColumn<bool>("kept");
    QTest::addColumn<qint64>("fresh_for_s");  // -1: for good
    const auto row = [](const char* name, const char* control, const char* etag, bool versioned, bool kept,
                        qint64 fresh) {
      QTest::addRow("%s", name) << QByteArray(control) << QByteArray(etag) << versioned << kept << fresh;
    };
    row("a year", "public, max-age=31536000, immutable", "", true, true, 31536000);
    row("a minute", "max-age=60", "\"x\"", false, true, 60);
    row("in capitals and quotes", "Max-Age=\"60\"", "", false, true, 60);
    row("immutable alone", "immutable", "", false, true, -1);
    row("no-store", "no-store", "\"x\"", true, false, 0);
    row("no-store among others", "max-age=60, No-Store", "\"x\"", true, false, 0);
    row("no-cache with an ETag", "no-cache", "W/\"x\"", false, true, 0);
    row("no-cache beats max-age", "no-cache, max-age=60", "W/\"x\"", false, true, 0);
    row("no-cache without an ETag", "no-cache", "", true, false, 0);
    row("max-age=0 without an ETag", "max-age=0", "", true, false, 0);
    row("unreadable age", "max-age=soon", "\"x\"", false, true, 0);
    row("negative age", "max-age=-5", "\"x\"", false, true, 0);
    row("endless age", "max-age=99999999999999999999999", "", false, true, qint64(1) << 31);
    row("only an ETag", "", "\"x\"", false, true, 0);
    row("nothing", "", "", false, false, 0);
    row("nothing, but versioned", "", "", true, true, -1);
  }
  void obeysTheHeaders() {
    QFETCH(QByteArray, cache_control);
    QFETCH(QByteArray, etag);
    QFETCH(bool, content_addressed);
    QFETCH(bool, kept);
    QFETCH(qint64, fresh_for_s);
    HttpCache cache = open();
    cache.store(kUrl, "body", "text/plain", cache_control, etag, content_addressed);
    const auto found = cache.find(kUrl);
    QCOMPARE(found.has_value(), kept);
    cache.flush();
    if (!kept) {
      QVERIFY(filesIn(folder_->path()).isEmpty());
      return;
    }
    QCOMPARE(found->body, QByteArray("body"));
    QCOMPARE(found->content_type, QByteArray("text/plain"));
    QCOMPARE(found->etag, etag);
    QCOMPARE(found->fresh, fresh_for_s != 0);
    if (fresh_for_s > 0) {
      now_ = now_.addSecs(fresh_for_s - 1);
      QVERIFY(cache.find(kUrl)->fresh);
      now_ = now_.addSecs(1);
    } else {
      now_ = now_.addYears(90);
    }
    QCOMPARE(cache.find(kUrl)->fresh, fresh_for_s == -1);
  }

  void ageIsUnknownWhenTheClockWasSetBack() {
    HttpCache cache = open();
    cache.store(kUrl, "body", {}, "max-age=60", "\"x\"", false);
    now_ = now_.addSecs(-3600);
    QVERIFY(cache.find(kUrl).has_value());
    QVERIFY(!cache.find(kUrl)->fresh);
  }

  void refreshingMakesTheBodyFreshAgain() {
    HttpCache cache = open();
    cache.store(kUrl, "body", "a/b", "max-age=60", "\"x\"", false);
    now_ = now_.addSecs(100);
    QVERIFY(!cache.find(kUrl)->fresh);
    cache.refresh(kUrl, "max-age=60", "\"y\"");
    QVERIFY(cache.find(kUrl)->fresh);
    QCOMPARE(cache.find(kUrl)->etag, QByteArray("\"y\""));
    QCOMPARE(cache.find(kUrl)->body, QByteArray("body"));
    now_ = now_.addSecs(61);
    cache.refresh(kUrl, {}, {});  // a 304 without headers: the old ones hold
    QVERIFY(cache.find(kUrl)->fresh);
    QCOMPARE(cache.find(kUrl)->etag, QByteArray("\"y\""));
    cache.refresh(kUrl, "no-store", {});
    QVERIFY(!cache.find(kUrl));
  }

  void anotherProcessAndANextStartFindTheSame() {
    HttpCache first = open();
    HttpCache second = open();
    bool trouble = false;
    first.setTrouble([&](const Fault&) { trouble = true; });
    first.store(kUrl, "one", {}, "immutable", {}, true);
    first.flush();
    QCOMPARE(second.find(kUrl)->body, QByteArray("one"));
    second.store(kUrl, "two", {}, "immutable", {}, true);
    second.flush();
    QCOMPARE(first.find(kUrl)->body, QByteArray("two"));
    second.remove(kUrl);
    second.flush();
    QVERIFY(!first.find(kUrl));
    first.remove(kUrl);
    first.store(kUrl, "three", {}, "immutable", {}, true);
    first.flush();
    QCOMPARE(open().find(kUrl)->body, QByteArray("three"));
    QVERIFY(!trouble);
  }

  void differentAddressesDoNotMeet() {
    HttpCache cache = open();
    QUrl other = kUrl;
    other.setQuery(QStringLiteral("ver=8"));
    cache.store(kUrl, "seven", {}, "immutable", {}, true);
    QVERIFY(!cache.find(other));
    cache.store(other, "eight", {}, "immutable", {}, true);
    QCOMPARE(cache.find(kUrl)->body, QByteArray("seven"));
    QCOMPARE(cache.find(other)->body, QByteArray("eight"));
    cache.flush();
    // A file under the name of another address is not believed.
    const QString path_of_other = [&] {
      QStringList before = filesIn(folder_->path());
      cache.remove(other);
      cache.flush();
      for (const QString& left : filesIn(folder_->path())) {
        before.removeAll(left);
      }
      return before.value(0);
    }();
    QVERIFY(QFile::copy(filesIn(folder_->path()).value(0), path_of_other));
    QVERIFY(!cache.find(other));
    cache.flush();
    QVERIFY(!QFile::exists(path_of_other));
  }

  void damagedFilesReadAsAMissAndAreRemoved_data() {
    QTest::addColumn<int>("damage");
    QTest::addRow("empty") << 0;
    QTest::addRow("cut in its head") << 1;
    QTest::addRow("cut in its body") << 2;
    QTest::addRow("one bit changed") << 3;
    QTest::addRow("garbage") << 4;
    QTest::addRow("longer") << 5;
    QTest::addRow("fresh for ever and a day") << 6;
    QTest::addRow("stored before all time") << 7;
  }
  void damagedFilesReadAsAMissAndAreRemoved() {
    QFETCH(int, damage);
    HttpCache cache = open();
    cache.store(kUrl, QByteArray(1000, 'b'), "t/t", "immutable", {}, true);
    cache.flush();
    const QStringList files = filesIn(folder_->path());
    QCOMPARE(files.size(), 1);
    QFile file(files[0]);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray bytes = file.readAll();
    switch (damage) {
      case 0:
        bytes.clear();
        break;
      case 1:
        bytes.truncate(13);
        break;
      case 2:
        bytes.chop(1);
        break;
      case 3:
        bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 4);
        break;
      case 4:
        bytes.fill('\xff');
        break;
      case 5:
        bytes.append('x');
        break;
      default:  // numbers that no cache writes, and the right checksum
        constexpr qsizetype kBody = 1004;
        qToBigEndian(std::numeric_limits<qint64>::min(),
                     bytes.data() + bytes.size() - kBody - (damage == 6 ? 8 : 16));
        qToBigEndian(libdeflate_crc32(0, bytes.constData() + 12, std::size_t(bytes.size() - 12)),
                     bytes.data() + 8);
    }
    file.resize(0);
    file.seek(0);
    file.write(bytes);
    file.close();
    QVERIFY(!open().find(kUrl));
    QVERIFY(filesIn(folder_->path()).isEmpty());
    QVERIFY(!cache.find(kUrl));
    cache.store(kUrl, "again", {}, "immutable", {}, true);
    cache.flush();
    QCOMPARE(cache.find(kUrl)->body, QByteArray("again"));
  }

  void theLongestUnusedGoFirst() {
    HttpCache cache = open(100'000);
    for (int i = 0; i < 9; ++i) {
      now_ = now_.addSecs(600);
      cache.store(numbered(i), QByteArray(10'000, 'x'), {}, "immutable", {}, true);
    }
    cache.flush();
    now_ = now_.addSecs(600);
    QVERIFY(cache.find(numbered(0)));  // now the one used last
    now_ = now_.addSecs(600);
    cache.store(numbered(9), QByteArray(10'000, 'x'), {}, "immutable", {}, true);
    QVERIFY(cache.bytes() <= 100'000);
    QVERIFY(cache.find(numbered(0)));
    QVERIFY(!cache.find(numbered(1)));
    QVERIFY(cache.find(numbered(8)));
    QVERIFY(cache.find(numbered(9)));
    // The order of use outlives the process.
    now_ = now_.addSecs(600);
    HttpCache next = open(100'000);
    QCOMPARE(next.bytes(), cache.bytes());
    next.store(numbered(10), QByteArray(40'000, 'x'), {}, "immutable", {}, true);
    next.flush();
    QVERIFY(next.find(numbered(0)));
    QVERIFY(!next.find(numbered(3)));
    qint64 on_disk = 0;
    for (const QString& file : filesIn(folder_->path())) {
      on_disk += QFileInfo(file).size();
    }
    QCOMPARE(next.bytes(), on_disk);
    QVERIFY(on_disk <= 100'000);
  }

  void whatIsLargerThanTheBudgetIsNotKept() {
    HttpCache cache = open(1000);
    cache.store(kUrl, "small", {}, "immutable", {}, true);
    cache.store(kUrl, QByteArray(1000, 'x'), {}, "immutable", {}, true);
    QVERIFY(!cache.find(kUrl));
    QCOMPARE(cache.bytes(), qint64(0));
  }

  void theBudgetIsOfWholeFiles() {
    HttpCache cache = open();
    cache.store(kUrl, "body", "a/b", "immutable", "\"x\"", true);
    const qint64 whole = cache.bytes();
    QCOMPARE(whole, QFileInfo(filesIn(folder_->path()).value(0)).size());
    HttpCache exact = open(whole), short_by_one = open(whole - 1);
    exact.store(kUrl, "BODY", "a/b", "immutable", "\"x\"", true);
    QCOMPARE(exact.bytes(), whole);
    QCOMPARE(exact.find(kUrl)->body, QByteArray("BODY"));
    short_by_one.store(kUrl, "BODY", "a/b", "immutable", "\"x\"", true);
    QVERIFY(!short_by_one.find(kUrl));
    QCOMPARE(short_by_one.bytes(), qint64(0));
  }

  void aFolderThatCannotBeWrittenMakesItForget() {
    QFile obstacle(folder_->filePath(QStringLiteral("file")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    HttpCache cache(obstacle.fileName(), 1 << 20, [this] { return now_; });
    Fault told;
    cache.setTrouble([&](const Fault& why) { told = why; });
    cache.store(kUrl, "body", {}, "immutable", {}, true);
    cache.flush();
    QVERIFY(!cache.find(kUrl));
    QVERIFY(told.any());
  }

  void whatGoesWrongIsToldOnce() {
    QFile obstacle(folder_->filePath(QStringLiteral("file")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    HttpCache cache(obstacle.fileName(), 1 << 20, [this] { return now_; });
    QList<Fault> told;
    cache.setTrouble([&](const Fault& why) { told << why; });
    for (int i = 0; i < 5; ++i) cache.store(numbered(i), "body", {}, "immutable", {}, true);
    cache.flush();
    QCOMPARE(told.size(), qsizetype(1));
    QVERIFY(argumentsOf(told.first()).value(0).startsWith(obstacle.fileName()));
    cache.store(kUrl, "body", {}, "immutable", {}, true);
    cache.flush();
    QCoreApplication::processEvents();
    QCOMPARE(told.size(), qsizetype(1));
  }

  void itIsToldOnTheOwnersThreadWithoutBeingAsked() {
    QFile obstacle(folder_->filePath(QStringLiteral("file")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    HttpCache cache(obstacle.fileName(), 1 << 20, [this] { return now_; });
    QList<QThread*> told_on;
    cache.setTrouble([&](const Fault&) { told_on << QThread::currentThread(); });
    cache.store(kUrl, "body", {}, "immutable", {}, true);
    QVERIFY(told_on.isEmpty());  // never from within
    QTRY_COMPARE(told_on, QList<QThread*>{QThread::currentThread()});
  }

  void nobodyIsToldByACacheThatIsGone() {
    QFile obstacle(folder_->filePath(QStringLiteral("file")));
    QVERIFY(obstacle.open(QIODevice::WriteOnly));
    int told = 0;
    {
      HttpCache cache(obstacle.fileName(), 1 << 20, [this] { return now_; });
      cache.setTrouble([&](const Fault&) { ++told; });
      cache.store(kUrl, "body", {}, "immutable", {}, true);
    }
    QCoreApplication::processEvents();
    QCOMPARE(told, 0);
  }

  void answersComeWhileTheDiskIsBusy() {
    SlowDisk disk;
    const QUrl a = numbered(1), b = numbered(2), c = numbered(3);
    {
      HttpCache cache(
          folder_->path(), 1 << 20, [this] { return now_; }, disk.write());
      cache.store(a, "one", "a/b", "max-age=60", "\"x\"", false);
      disk.begun.acquire();  // from now on it is being written
      cache.store(b, "two", "c/d", "max-age=60", "\"y\"", false);
      QCOMPARE(cache.find(a)->body, QByteArray("one"));
      QCOMPARE(cache.find(b)->body, QByteArray("two"));
      QCOMPARE(cache.find(b)->content_type, QByteArray("c/d"));
      cache.copy(a, c);
      QCOMPARE(cache.find(c)->body, QByteArray("one"));
      now_ = now_.addSecs(100);
      QVERIFY(!cache.find(b)->fresh);
      cache.refresh(b, "max-age=60", "\"z\"");
      QVERIFY(cache.find(b)->fresh);
      QCOMPARE(cache.find(b)->etag, QByteArray("\"z\""));
      QVERIFY(!cache.find(a)->fresh);
      cache.refresh(a, "max-age=60", {});
      QVERIFY(cache.find(a)->fresh);
      QVERIFY(!cache.find(c)->fresh);
      QCOMPARE(int(disk.written), 0);
      disk.beFastAgain();
      cache.flush();
      QCOMPARE(filesIn(folder_->path()).size(), qsizetype(3));
    }
    HttpCache next = open();
    QVERIFY(next.find(a)->fresh);
    QCOMPARE(next.find(b)->etag, QByteArray("\"z\""));
    QCOMPARE(next.find(c)->body, QByteArray("one"));
    QVERIFY(!next.find(c)->fresh);
  }

  void whatIsRemovedIsNotWrittenAfterwards() {
    SlowDisk disk;
    const QUrl in_progress = numbered(1), waits = numbered(2), again = numbered(3), old = numbered(4);
    open().store(old, "old", {}, "immutable", {}, true);
    HttpCache cache(
        folder_->path(), 1 << 20, [this] { return now_; }, disk.write());
    cache.store(in_progress, "one", {}, "immutable", {}, true);
    disk.begun.acquire();
    cache.store(waits, "two", {}, "immutable", {}, true);
    cache.store(again, "three", {}, "immutable", {}, true);
    for (const QUrl& url : {in_progress, waits, again, old}) {
      cache.remove(url);
      QVERIFY(!cache.find(url));
    }
    cache.refresh(waits, "max-age=60", {});
    cache.copy(waits, numbered(5));
    cache.store(again, "four", {}, "immutable", {}, true);
    QCOMPARE(cache.find(again)->body, QByteArray("four"));
    disk.beFastAgain();
    cache.flush();
    QCOMPARE(filesIn(folder_->path()).size(), qsizetype(1));
    QCOMPARE(open().find(again)->body, QByteArray("four"));
    QCOMPARE(cache.bytes(), QFileInfo(filesIn(folder_->path()).value(0)).size());
  }

  void ofWhatWaitsForAnAddressOnlyTheLastIsWritten() {
    SlowDisk disk;
    HttpCache cache(
        folder_->path(), 1 << 20, [this] { return now_; }, disk.write());
    cache.store(numbered(1), "one", {}, "immutable", {}, true);
    disk.begun.acquire();
    for (int i = 0; i < 50; ++i) cache.store(numbered(2), QByteArray::number(i), {}, "immutable", {}, true);
    disk.beFastAgain();
    cache.flush();
    QCOMPARE(int(disk.written), 2);
    QCOMPARE(open().find(numbered(2))->body, QByteArray("49"));
  }

  void whatWaitsIsWrittenBeforeItGoes() {
    {
      HttpCache cache = open();
      for (int i = 0; i < 50; ++i) cache.store(numbered(i), QByteArray(i, 'x'), {}, "immutable", {}, true);
    }
    QCOMPARE(filesIn(folder_->path()).size(), qsizetype(50));
    HttpCache next = open();
    for (int i = 0; i < 50; ++i) QCOMPARE(next.find(numbered(i))->body, QByteArray(i, 'x'));
  }

  void whoeverIsFarAheadOfTheDiskWaitsForIt() {
    const QByteArray body(HttpCache::kMostWaitingBytes / 5 * 2, 'x');  // two of them may wait
    QSemaphore stored;
    std::atomic<bool> first = true, overtaken = false;
    const auto write = [&](const std::string&, const QByteArray&, qint64) {
      if (first.exchange(false)) {
        stored.acquire(2);
        overtaken = stored.tryAcquire(1, 50);
      }
      return 0;
    };
    HttpCache cache(
        folder_->path(), qint64(1) << 30, [this] { return now_; }, write);
    for (int i = 0; i < 3; ++i) {
      cache.store(numbered(i), body, {}, "immutable", {}, true);
      stored.release();
    }
    cache.flush();
    QVERIFY(!overtaken);
    // Alone even one goes that is longer than all that may wait.
    cache.store(numbered(4), body + body + body, {}, "immutable", {}, true);
    cache.flush();
    QVERIFY(cache.bytes() > HttpCache::kMostWaitingBytes);
  }

  void whatIsNoFileReadsAsAMissAndHoldsNobodyUp_data() {
    QTest::addColumn<bool>("pipe");
    QTest::newRow("a named pipe") << true;
    QTest::newRow("a folder") << false;
  }
  void whatIsNoFileReadsAsAMissAndHoldsNobodyUp() {
    QFETCH(bool, pipe);
    HttpCache cache = open();
    cache.store(kUrl, "body", {}, "immutable", {}, true);
    cache.flush();
    const QString path = filesIn(folder_->path()).value(0);
    QVERIFY(QFile::remove(path));
    QVERIFY(pipe ? ::mkfifo(QFile::encodeName(path).constData(), 0600) == 0 : QDir().mkdir(path));
    QVERIFY(!cache.find(kUrl));
    cache.refresh(kUrl, "immutable", {});
    cache.copy(kUrl, numbered(1));
    QVERIFY(!cache.find(numbered(1)));
    cache.store(kUrl, "body", {}, "immutable", {}, true);
    cache.flush();
    QCOMPARE(cache.find(kUrl).has_value(), pipe);  // a folder stays in the way
  }

  void onlyTheUserMayLookInside() {
    const QString folder = folder_->filePath(QStringLiteral("deep/cache"));
    HttpCache cache(folder, 1 << 20, [this] { return now_; });
    cache.store(kUrl, "body", {}, "immutable", {}, true);
    cache.flush();
    const QFileDevice::Permissions others = QFileDevice::ReadGroup | QFileDevice::WriteGroup |
                                            QFileDevice::ExeGroup | QFileDevice::ReadOther |
                                            QFileDevice::WriteOther | QFileDevice::ExeOther;
    QVERIFY(!(QFileInfo(folder).permissions() & others));
    QVERIFY(!(QFileInfo(filesIn(folder).value(0)).permissions() & others));
  }

 private:
  HttpCache open(qint64 budget = 1 << 20) {
    return HttpCache(folder_->path(), budget, [this] { return now_; });
  }
  static QUrl numbered(int i) { return QUrl(QStringLiteral("http://robot/%1").arg(i)); }

  std::unique_ptr<QTemporaryDir> folder_;
  QDateTime now_;
};

}  // namespace test_http_cache

MAPWRIGHT_TEST(test_http_cache, TestHttpCache, Core)
#include "test_http_cache.moc"
