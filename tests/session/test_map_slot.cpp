// One whole map on its way to the screen.
#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "grids/grid_pyramid.h"
#include "map/faults.h"
#include "sentences/problem_sentence.h"
#include "session/map_slot.h"
#include "test_program.h"

namespace test_map_slot {

using namespace mapwright;
using session::MapSlot;
using Phase = MapSlot::Phase;

namespace {

constexpr int kPatienceMs = 60'000;  // the threads that read stand back on a machine that is busy

/// A binary PGM of one gray level.
std::shared_ptr<const std::string> pgm(int width, int height, int gray, int rows = -1) {
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  bytes.append(std::size_t(width) * std::size_t(rows < 0 ? height : rows), char(gray));
  return std::make_shared<const std::string>(std::move(bytes));
}

map::WholeMap mapOf(const std::string& id, std::shared_ptr<const std::string> bytes) {
  map::WholeMap map;
  map.key = {map::MapKind::Stored, id};
  map.name = "Map <b>" + id + "</b>";
  map.grid = {0, 0, 0.05, {1, 2, 0}};
  map.bytes = std::move(bytes);
  return map;
}

}  // namespace

class MapSlotTest : public QObject {
  Q_OBJECT
  std::unique_ptr<MapSlot> slot_;
  QStringList problems_;

 private Q_SLOTS:
  void init() {
    slot_ = std::make_unique<MapSlot>(QString(), grids::Resources{});
    problems_.clear();
    connect(slot_.get(), &MapSlot::problemFound, this,
            [this](const map::Problem& problem) { problems_ << sentences::sentenceOf(problem); });
  }

  void aMapIsReadAndShown() {
    slot_->expect({map::MapKind::Stored, "1"}, QStringLiteral("Lobby"));
    QVERIFY(slot_->phase() == Phase::Fetching && !slot_->settled());
    slot_->show(mapOf("1", pgm(30, 20, 254)));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    QCOMPARE(slot_->reference().width, 30);
    QCOMPARE(slot_->reference().height, 20);
    QCOMPARE(int(slot_->cells()->at(29, 19)), 254);
    QVERIFY(problems_.isEmpty() && !slot_->remark() && !slot_->broken());
  }

  void thePicturesOwnSizeWinsOverADeclaredOne() {
    map::WholeMap map = mapOf("1", pgm(30, 20, 254));
    map.grid.width = 31;
    map.grid.height = 20;
    slot_->show(std::move(map));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    QCOMPARE(slot_->reference().width, 30);
    QCOMPARE(problems_.size(), 1);
    QVERIFY(problems_[0].contains(QLatin1String("31 x 20")));
  }

  void aPictureWhoseLaterRowsTellMoreOfItsGraysEndsInTheirMeaning() {
    constexpr int kWidth = 2048, kHeight = 800, kLate = 700;
    std::string bytes = "P5\n2048 800\n255\n";
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) bytes += char(y < kLate ? (x < 500 ? 205 : 254) : (x * 7 + y) % 256);
    }
    map::WholeMap map = mapOf("1", std::make_shared<const std::string>(std::move(bytes)));
    map.grid.width = 31;
    slot_->show(std::move(map));
    QTRY_VERIFY_WITH_TIMEOUT(slot_->phase() == Phase::Ready, kPatienceMs);
    QVERIFY(slot_->cells()->complete() && !slot_->broken());
    QVERIFY(grids::meaningOf(slot_->cells()->code()).known[205]);
    QCOMPARE(int(slot_->cells()->at(kWidth - 1, kHeight - 1)), ((kWidth - 1) * 7 + kHeight - 1) % 256);
    QCOMPARE(problems_.size(), 1);  // its size, said once
  }

  void whatCannotBePlacedOrReadFailsWithASentence() {
    map::WholeMap map = mapOf("1", pgm(30, 20, 254));
    map.grid.resolution_m = 0;
    slot_->show(std::move(map));
    QTRY_VERIFY(slot_->phase() == Phase::Failed);
    QVERIFY(slot_->remark()->reason == Fault(map::fault::ResolutionNotPositive, {0.0}));
    slot_->show(mapOf("2", std::make_shared<const std::string>("no picture at all")));
    QTRY_VERIFY(slot_->phase() == Phase::Failed);
    QVERIFY(slot_->remark() && !slot_->cells());
  }

  void aPictureThatBreaksOffKeepsTheRowsThatCame() {
    slot_->show(mapOf("1", pgm(30, 20, 254, 11)));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    QVERIFY(slot_->broken() && slot_->remark());
    QCOMPARE(int(slot_->cells()->at(0, 10)), 254);
    QVERIFY(!grids::meaningOf(grids::CellCode::Gray).known[slot_->cells()->at(0, 12)]);
  }

  void anUpdateOfTheSameMapIsShownWhenItIsWhole() {
    slot_->show(mapOf("1", pgm(30, 20, 254)));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    const auto before = slot_->cells();
    slot_->show(mapOf("1", pgm(30, 20, 0)));
    QCOMPARE(slot_->cells(), before);
    QTRY_VERIFY(slot_->phase() == Phase::Ready && slot_->cells() != before);
    QCOMPARE(int(slot_->cells()->at(3, 3)), 0);
  }

  void onlyTheNewestOfSeveralIsShown() {
    for (int i = 0; i < 20; ++i) slot_->show(mapOf(std::to_string(i), pgm(300, 300, i)));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    QCOMPARE(int(slot_->cells()->at(3, 3)), 19);
    QVERIFY(slot_->key().id == "19");
  }

  void aMapThatChangesFasterThanItIsReadIsStillSeen() {
    QSignalSpy changed(slot_.get(), &MapSlot::changed);
    for (int i = 1; i <= 20; ++i) slot_->show(mapOf("live", pgm(700, 700, i)));
    QTRY_VERIFY(slot_->cells() != nullptr);
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    QCOMPARE(int(slot_->cells()->at(3, 3)), 20);
    QVERIFY(problems_.isEmpty());
  }

  void aFailureOfTheSameMapKeepsWhatIsOnScreen() {
    slot_->show(mapOf("1", pgm(30, 20, 254)));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    slot_->expect({map::MapKind::Stored, "1"}, QStringLiteral("again"));
    slot_->fail({map::Severity::Error, "Map", fault::said("The robot is gone.")});
    QVERIFY(slot_->phase() == Phase::Failed && slot_->cells());
    slot_->expect({map::MapKind::Stored, "2"}, QStringLiteral("other"));
    slot_->fail({map::Severity::Error, "Map", fault::said("The robot is gone.")});
    QVERIFY(!slot_->cells());
  }

  void averagingReadsThePictureAgain() {
    slot_->show(mapOf("1", pgm(600, 600, 254)));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    slot_->setAveraged(true);
    QTRY_VERIFY(slot_->phase() == Phase::Ready && slot_->cells()->reduction() == grids::Reduction::Average);
  }

  void onlyLargeStoredMapsEarnASidecar_data() {
    QTest::addColumn<map::MapKind>("kind");
    QTest::addColumn<int>("edge");
    QTest::addColumn<int>("files");
    QTest::newRow("stored and large") << map::MapKind::Stored << 2100 << 1;
    QTest::newRow("a result of mapping, large") << map::MapKind::Mapping << 2100 << 1;
    QTest::newRow("a file, large") << map::MapKind::File << 2100 << 1;
    QTest::newRow("stored and small") << map::MapKind::Stored << 500 << 0;
    QTest::newRow("live and small") << map::MapKind::Live << 500 << 0;
    QTest::newRow("live and large") << map::MapKind::Live << 2100 << 0;
  }
  void onlyLargeStoredMapsEarnASidecar() {
    QFETCH(map::MapKind, kind);
    QFETCH(int, edge);
    QFETCH(int, files);
    QTemporaryDir folder;
    MapSlot slot(folder.path(), {});
    // As a robot whose map changes every second: what is in the folder must not be pushed out.
    for (int version = 1; version <= 3; ++version) {
      map::WholeMap map = mapOf("7", pgm(edge, edge, 100 + version));
      map.key.kind = kind;
      map.fingerprint = "content " + std::to_string(version);
      slot.show(std::move(map));
      QTRY_VERIFY_WITH_TIMEOUT(slot.phase() == Phase::Ready && slot.cells()->at(3, 3) == 100 + version,
                               kPatienceMs);
      QCOMPARE(int(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size()), files * version);
    }
  }

  void aDamagedSidecarIsReadAgainAndSaidOnce() {
    QTemporaryDir folder;
    constexpr int kEdge = 2100;
    std::string bytes = "P5\n2100 2100\n255\n";
    for (int n = 0; n < kEdge * kEdge; ++n) bytes.push_back(char(n % 251 % 7 == 0 ? 0 : 254));
    map::WholeMap map = mapOf("1", std::make_shared<const std::string>(std::move(bytes)));
    map.fingerprint = "content";
    for (const bool damaged : {false, true, false}) {
      MapSlot slot(folder.path(), {});
      QStringList problems;
      connect(&slot, &MapSlot::problemFound, this,
              [&](const map::Problem& problem) { problems << sentences::sentenceOf(problem); });
      if (damaged) {
        const QString path = folder.filePath(QDir(folder.path()).entryList(QDir::Files).first());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        file.seek(4096);
        file.write(QByteArray(20'000, 'x'));
      }
      slot.show(map);
      QTRY_VERIFY_WITH_TIMEOUT(slot.phase() == Phase::Ready, kPatienceMs);
      for (int tile_y = 0; tile_y < 9; ++tile_y) {
        for (int tile_x = 0; tile_x < 9; ++tile_x) QVERIFY(slot.cells()->tile(0, tile_x, tile_y));
      }
      int wrong = 0;
      for (int v = 0; v < kEdge; v += 13) {
        for (int u = 0; u < kEdge; ++u) {
          wrong += slot.cells()->at(u, v) != ((v * kEdge + u) % 251 % 7 == 0 ? 0 : 254);
        }
      }
      QCOMPARE(wrong, 0);
      QVERIFY(!slot.broken());
      QTRY_COMPARE_WITH_TIMEOUT(int(problems.size()), damaged ? 1 : 0, kPatienceMs);
      if (damaged) QVERIFY(problems.first().contains(QLatin1String("read again")));
    }
  }

  void whatIsDamagedAndCannotBeReadAgainIsBroken() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("map.pgm"));
    QFile picture(path);
    QVERIFY(picture.open(QIODevice::WriteOnly));
    QByteArray bytes = "P5\n2100 2100\n255\n";
    for (int n = 0; n < 2100 * 2100; ++n) bytes.append(char(n % 251 % 7 == 0 ? 0 : 254));
    picture.write(bytes);
    picture.close();
    map::WholeMap map = mapOf("1", nullptr);
    map.key.kind = map::MapKind::File;
    map.path = path.toStdString();
    map.fingerprint = "content";
    const QString cache = folder.filePath(QStringLiteral("cache"));
    {
      MapSlot first(cache, {});
      first.show(map);
      QTRY_VERIFY_WITH_TIMEOUT(first.phase() == Phase::Ready, kPatienceMs);
    }
    MapSlot slot(cache, {});
    slot.show(map);
    QTRY_VERIFY_WITH_TIMEOUT(slot.phase() == Phase::Ready, kPatienceMs);
    QVERIFY(!slot.broken());
    QVERIFY(QFile::resize(path, 1000));
    QVERIFY(QFile::resize(QDir(cache).filePath(QDir(cache).entryList(QDir::Files).first()), 5000));
    QVERIFY(slot.cells()->tile(0, 0, 0)->damaged);
    QVERIFY(slot.broken());
    QTRY_VERIFY_WITH_TIMEOUT(sentences::sentenceOf(slot.remark()).contains(QLatin1String("damaged")),
                             kPatienceMs);
  }

  void aPyramidMayOutliveItsSlot() {
    QTemporaryDir folder;
    std::string bytes = *pgm(2100, 2100, 200);
    for (std::size_t n = 100; n < bytes.size(); n += 7) bytes[n] = 0;
    map::WholeMap map = mapOf("1", std::make_shared<const std::string>(std::move(bytes)));
    map.fingerprint = "content";
    std::shared_ptr<const grids::GridPyramid> cells;
    {
      MapSlot slot(folder.path(), {});
      slot.show(map);
      QTRY_VERIFY_WITH_TIMEOUT(slot.phase() == Phase::Ready, kPatienceMs);
      cells = slot.cells();
    }
    QVERIFY(QFile::resize(folder.filePath(QDir(folder.path()).entryList(QDir::Files).first()), 5000));
    QVERIFY(!cells->tile(0, 3, 3)->damaged);
    QCoreApplication::processEvents();
  }

  void aTurnThatIsNoNumberCountsAsNone() {
    map::WholeMap map = mapOf("1", pgm(30, 20, 254));
    map.grid.origin.yaw_rad = std::numeric_limits<double>::quiet_NaN();
    slot_->show(std::move(map));
    QTRY_VERIFY(slot_->phase() == Phase::Ready);
    QCOMPARE(slot_->reference().origin.yaw_rad, 0.0);
    QCOMPARE(problems_.size(), 1);
  }
};

}  // namespace test_map_slot

MAPWRIGHT_TEST(test_map_slot, MapSlotTest, Core)
#include "test_map_slot.moc"
