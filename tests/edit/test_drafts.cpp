// Drafts: as bytes, on disk, in time.
#include <csignal>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "edit/document.h"
#include "edit/drafts.h"
#include "edit/faults.h"
#include "test_program.h"

namespace test_drafts {

using namespace mapwright;
using namespace mapwright::edit;

namespace {

const DraftIdentity kOffice{QStringLiteral("file:/maps/office.yaml"), QStringLiteral("file"),
                            QStringLiteral("waypoints")};

/// A clock that stands still until it is told to go on.
struct Clock {
  Later later() {
    return [this](std::chrono::milliseconds wait, std::function<void()> then) {
      longest = std::max(longest, wait);
      waiting.push_back(std::move(then));
    };
  }
  void ring() {
    for (const auto& then : std::exchange(waiting, {})) then();
  }
  std::chrono::milliseconds longest{0};
  std::vector<std::function<void()>> waiting;
};

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList filesIn(const QTemporaryDir& folder) {
  return QDir(folder.path()).entryList({QStringLiteral("*.json")});
}

}  // namespace

class TestDrafts : public QObject {
  Q_OBJECT
 private:
  const std::shared_ptr<work::Workers> workers_ = std::make_shared<work::Workers>(1);

 private Q_SLOTS:
  void initTestCase() {
    std::signal(SIGXFSZ, SIG_IGN);  // as the program does
  }

  void comeBackAsTheyWere() {
    map::Waypoint point;
    point.id = point.name = "Küche <b>\xF0\x9F\x9A\xAA";
    point.position_m = {0.1 + 0.2, -1e-9};
    point.yaw_rad = 1.0 / 3;
    point.tags = {"dock", ""};
    point.source = R"({"n": 12345678901234567890})";
    const WaypointDraft draft{kOffice,
                              QDateTime::fromMSecsSinceEpoch(1'700'000'000'123),
                              {{"k", std::nullopt, point}, {"d", point, std::nullopt}}};
    const auto read = waypointDraftFrom(toBytes(draft));
    QVERIFY(read);
    QCOMPARE(read->of, kOffice);
    QCOMPARE(read->made, draft.made);
    QCOMPARE(read->changes.size(), std::size_t(2));
    QCOMPARE(*read->changes[0].after, point);
    QVERIFY(!read->changes[0].before && !read->changes[1].after);
  }

  void whatIsNoDraftIsNone_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray good =
        toBytes(WaypointDraft{kOffice, QDateTime::currentDateTime(), {{"k", {}, map::Waypoint{}}}});
    QVERIFY(waypointDraftFrom(good));
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("text") << QByteArray("hello");
    QTest::newRow("half") << good.left(good.size() / 2);
    QTest::newRow("later version") << QByteArray(good).replace("\"mapwright_draft\":1",
                                                               "\"mapwright_draft\":2");
    QTest::newRow("no position") << QByteArray(good).replace("x_m", "q_m");
    QTest::newRow("no key") << QByteArray(good).replace("\"key\":\"k\"", "\"key\":\"\"");
    QTest::newRow("no change") << QByteArray(good).replace("\"after\"", "\"afterwards\"");
  }
  void whatIsNoDraftIsNone() {
    QFETCH(QByteArray, bytes);
    QVERIFY(!waypointDraftFrom(bytes));
  }

  void onlyThoseOfProgramsThatAreGoneAreLeft() {
    QTemporaryDir folder;
    auto mine = std::make_unique<DraftFile>(folder.path(), kOffice);
    QVERIFY(!mine->write("mine"));
    QVERIFY(leftDrafts(folder.path(), kOffice).drafts.empty());
    const QString path = mine->path();
    mine.reset();  // the program ends, its draft stays
    auto left = leftDrafts(folder.path(), kOffice);
    QCOMPARE(left.drafts.size(), std::size_t(1));
    QCOMPARE(left.drafts[0].bytes, QByteArray("mine"));
    // Held by one, it is not offered to another.
    QVERIFY(leftDrafts(folder.path(), kOffice).drafts.empty());
    DraftIdentity other = kOffice;
    other.map = QStringLiteral("attic.yaml");
    QVERIFY(leftDrafts(folder.path(), other).drafts.empty());
    QVERIFY(!removeDraft(std::move(left.drafts[0])));
    QVERIFY(!QFile::exists(path));
  }

  void brokenOnesAreSetAside() {
    QTemporaryDir folder;
    const QString path = [&] {
      DraftFile file(folder.path(), kOffice);
      (void)file.write("{broken");
      return file.path();
    }();
    auto left = leftDrafts(folder.path(), kOffice);
    QCOMPARE(left.drafts.size(), std::size_t(1));
    const Fault reason = setAside(std::move(left.drafts[0]));
    const auto says = [&](const FaultArgument& argument) {
      const auto* const words = std::get_if<std::string>(&argument);
      return words && words->find(path.toStdString() + ".broken") != std::string::npos;
    };
    QVERIFY(std::any_of(reason.arguments.begin(), reason.arguments.end(), says));
    QCOMPARE(contentOf(path + QStringLiteral(".broken")), QByteArray("{broken"));
    left.drafts.clear();
    QVERIFY(leftDrafts(folder.path(), kOffice).drafts.empty());
  }

  void isOnDiskWithinASecondAndGoesWhenNothingIsToBeKept() {
    QTemporaryDir folder;
    Clock clock;
    QByteArray content = "one";
    DraftKeeper keeper(
        folder.path(), kOffice,
        [&]() -> DraftKeeper::Job {
          return content.isEmpty() ? DraftKeeper::Job{} : [content] { return content; };
        },
        clock.later(), workers_);
    QSignalSpy written(&keeper, &DraftKeeper::written);
    keeper.touch();
    keeper.touch();
    QCOMPARE(clock.waiting.size(), std::size_t(1));
    QVERIFY(clock.longest <= std::chrono::milliseconds(800));
    QVERIFY(filesIn(folder).isEmpty());
    clock.ring();
    QTRY_COMPARE(written.size(), 1);
    QCOMPARE(filesIn(folder).size(), 1);
    QCOMPARE(contentOf(folder.filePath(filesIn(folder).front())), QByteArray("one"));
    content = "two";
    keeper.touch();
    clock.ring();
    QTRY_COMPARE(written.size(), 2);
    QCOMPARE(contentOf(folder.filePath(filesIn(folder).front())), QByteArray("two"));
    content.clear();
    keeper.touch();
    clock.ring();
    QTRY_COMPARE(written.size(), 3);
    QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());
  }

  void whatCannotBeWrittenIsSaidAndTriedAgain() {
    QTemporaryDir folder;
    QFile blocker(folder.filePath(QStringLiteral("drafts")));  // a file where the folder ought to be
    QVERIFY(blocker.open(QIODevice::WriteOnly));
    Clock clock;
    DraftKeeper keeper(
        blocker.fileName(), kOffice, [] { return [] { return QByteArray("one"); }; }, clock.later(),
        workers_);
    QSignalSpy trouble(&keeper, &DraftKeeper::troubleChanged);
    keeper.touch();
    clock.ring();
    QTRY_COMPARE(trouble.size(), 1);
    QCOMPARE(keeper.trouble().code, edit::fault::DraftFolderNotMade);
    blocker.remove();
    QTRY_COMPARE(clock.waiting.size(), std::size_t(1));
    clock.ring();
    QTRY_COMPARE(trouble.size(), 2);
    QVERIFY(!keeper.trouble().any());
  }

  void flushingWaitsForTheDisk() {
    QTemporaryDir folder;
    Clock clock;
    DraftKeeper keeper(
        folder.path(), kOffice, [] { return [] { return QByteArray("now"); }; }, clock.later(), workers_);
    keeper.touch();
    QVERIFY(!keeper.flush());
    QCOMPARE(contentOf(folder.filePath(filesIn(folder).front())), QByteArray("now"));
  }
};

}  // namespace test_drafts

MAPWRIGHT_TEST(test_drafts, TestDrafts, Core)
#include "test_drafts.moc"
