// A finished pyramid is kept beside the cache and opened at once; whatever is wrong with it is a miss.
#include <mutex>
#include <thread>

#include <QtTest>

#include "grids/export_grid.h"
#include "grids/grid_pyramid.h"
#include "grids/sidecar.h"
#include "picture_samples.h"
#include "test_program.h"

namespace test_grid_sidecar {

using namespace mapwright;
using namespace mapwright::grids;
using map::CellReading;

namespace {

constexpr int kWidth = 900, kHeight = 700;

struct Opened {
  std::shared_ptr<const GridPyramid> pyramid;
  bool at_once = false;
};

bool same(const GridPyramid& a, const GridPyramid& b) {
  for (int level = 0; level < a.levels(); ++level) {
    for (int ty = 0; ty * 256 < a.levelHeight(level); ++ty) {
      for (int tx = 0; tx * 256 < a.levelWidth(level); ++tx) {
        const auto one = a.tile(level, tx, ty), other = b.tile(level, tx, ty);
        if (!one || !other || std::memcmp(one->cells.get(), other->cells.get(), 65536) != 0) return false;
      }
    }
  }
  return a.levels() == b.levels();
}

}  // namespace

class TestGridSidecar : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }
  void cleanup() { folder_.reset(); }

  void theSecondTimeItIsThereAtOnce() {
    const Opened first = open(options());
    QVERIFY(!first.at_once);
    QCOMPARE(files().size(), 1);
    const Opened second = open(options());
    QVERIFY(second.at_once);
    QVERIFY(second.pyramid->complete());
    QVERIFY(same(*first.pyramid, *second.pyramid));
    QVERIFY(first.pyramid->code() == second.pyramid->code() &&
            first.pyramid->reduction() == second.pyramid->reduction());
  }

  void anotherReadingReductionOrContentIsAnotherFile() {
    open(options());
    GridOptions other = options();
    other.fingerprint = "another";
    QVERIFY(!open(other).at_once);
    other = options();
    other.reduction = Reduction::Average;
    QVERIFY(!open(other).at_once);
    other = options();
    other.reading.mode = CellReading::Mode::Trinary;
    QVERIFY(!open(other).at_once);
    other.reading.free_thresh = 0.25;
    QVERIFY(!open(other).at_once);
    other.reading.negate = true;
    QVERIFY(!open(other).at_once);
    QCOMPARE(files().size(), 6);
    QVERIFY(open(options()).at_once);
    QVERIFY(open(other).at_once);
  }

  void withoutAFolderOrAFingerprintNothingIsKept() {
    GridOptions without = options();
    without.fingerprint.clear();
    open(without);
    QVERIFY(!open(without).at_once);
    QVERIFY(files().isEmpty());
  }

  void atornFileIsAMissAndGoes() {
    open(options());
    const QString path = files().first();
    const QByteArray whole = contentOf(path);
    for (qsizetype size = 0; size < whole.size(); size += 1 + whole.size() / 40) {
      write(path, whole.left(size));
      QVERIFY2(!openOnly(options()), qPrintable(QString::number(size)));
      QVERIFY(!QFile::exists(path));
    }
    write(path, whole + "x");
    QVERIFY(!openOnly(options()));
    write(path, whole);
    QVERIFY(openOnly(options()));
  }

  void aForeignFileIsAMissAndGoes() {
    open(options());
    const QString path = files().first();
    const QByteArray whole = contentOf(path);
    for (const int offset : {0, 8, 12, 16, 20, 24, 28, 32, 40, 48, 56, 60}) {  // every field of the header
      QByteArray bytes = whole;
      bytes[offset] = char(bytes[offset] ^ 1);
      write(path, bytes);
      QVERIFY2(!openOnly(options()), qPrintable(QString::number(offset)));
      QVERIFY(!QFile::exists(path));
    }
    for (qsizetype back = 1; back < 200; back += 13) {  // key and index
      QByteArray bytes = whole;
      bytes[bytes.size() - back] = char(bytes[bytes.size() - back] ^ 4);
      write(path, bytes);
      QVERIFY(!openOnly(options()));
    }
  }

  void whateverRotsTheCellsAreReadAgainAndItIsSaidOnce() {
    open(options());
    const auto memory = openGrid(picture(), {});
    const std::atomic<bool> cancelled{false};
    QVERIFY(!(*memory)->read(cancelled, {}));
    const QString path = files().first();
    const QByteArray whole = contentOf(path);
    const qsizetype data = 4096, step = (whole.size() - data) / 60;
    for (qsizetype offset = data; offset < whole.size(); offset += step) {
      QByteArray bytes = whole;
      bytes[offset] = char(bytes[offset] ^ 1 << offset % 8);
      write(path, bytes);
      told_.clear();
      const Opened second = open(options());
      // In the index: a miss. In the tiles: found when they are asked for. Between them: of no use to
      // anybody.
      QVERIFY(same(*(*memory)->pyramid(), *second.pyramid));
      QVERIFY(!second.pyramid->trouble().any());
      QVERIFY(told_.size() <= 1);
      if (!told_.isEmpty()) {
        QVERIFY(told_.first() == GridDamage::Mended);
        QVERIFY(!QFile::exists(path));
        mended_ = true;
      }
    }
    QVERIFY(mended_);
  }

  void aFileThatIsSpoiltWhileItIsUsedIsNoticed_data() {
    QTest::addColumn<int>("how");
    QTest::newRow("cut short") << 0;
    QTest::newRow("written over with nothing") << 1;
    QTest::newRow("written over with another map's") << 2;
    QTest::newRow("shifted by a page") << 3;
    QTest::newRow("another file took its name") << 4;
  }
  void aFileThatIsSpoiltWhileItIsUsedIsNoticed() {
    QFETCH(int, how);
    for (const bool first_time : {false, true}) {
      init();
      const auto memory = openGrid(picture(), {});
      const std::atomic<bool> cancelled{false};
      QVERIFY(!(*memory)->read(cancelled, {}));
      if (!first_time) open(options());
      const Opened used = open(options());
      QCOMPARE(used.at_once, !first_time);
      const QString path = files().first();
      const QByteArray whole = contentOf(path);
      if (how == 0) {
        QVERIFY(QFile::resize(path, 5000));
      } else if (how == 1) {
        writeInto(path, QByteArray(whole.size(), '\0'));
      } else if (how == 2) {
        GridOptions other = options();
        other.fingerprint = "another map";
        auto bytes = test::roomGrays(kWidth, kHeight);
        for (auto& gray : bytes) gray = std::uint16_t(255 - gray);
        auto opened = openGrid(test::shared(test::png({kWidth, kHeight}, bytes)), other);
        QVERIFY(!(*opened)->read(cancelled, {}));
        for (const QString& file : files()) {
          if (file != path) writeInto(path, contentOf(file));
        }
      } else if (how == 3) {
        writeInto(path, whole.left(4096) + QByteArray(4096, 'x') + whole.mid(4096));
      } else {
        QFile::remove(path);
        write(path, "another");
      }
      told_.clear();
      QVERIFY(same(*used.pyramid, *(*memory)->pyramid()));
      QCOMPARE(int(told_.size()), how == 4 ? 0 : 1);
    }
  }

  void aCellOfADamagedFileIsNotReadAgainForTheWindow() {
    open(options());
    const Opened used = open(options());
    writeInto(files().first(), QByteArray(contentOf(files().first()).size(), '\0'));
    told_.clear();
    // Row 29 is a wall: reading the map for it could take long.
    QCOMPARE(int(used.pyramid->at(0, 29)), int(kTransparentGray));
    QVERIFY(told_.isEmpty());
    QVERIFY(used.pyramid->tile(0, 0, 0));
    QCOMPARE(int(used.pyramid->at(0, 29)), 0);
  }

  void manyThreadsReadItAgainOnce() {
    open(options());
    const Opened used = open(options());
    writeInto(files().first(), QByteArray(contentOf(files().first()).size(), '\0'));
    told_.clear();
    std::vector<std::thread> threads;
    std::atomic<int> right{0};
    const auto memory = openGrid(picture(), {});
    const std::atomic<bool> cancelled{false};
    QVERIFY(!(*memory)->read(cancelled, {}));
    for (int n = 0; n < 4; ++n) {
      threads.emplace_back([&] { right += same(*used.pyramid, *(*memory)->pyramid()); });
    }
    for (std::thread& thread : threads) thread.join();
    QCOMPARE(right.load(), 4);
    QCOMPARE(int(told_.size()), 1);
  }

  void aPictureThatIsGoneToo() {
    const QString source = folder_->filePath(QStringLiteral("map.png"));
    const std::string bytes = *picture();
    write(source, QByteArray::fromStdString(bytes));
    for (const bool renamed : {true, false}) {
      openFile(source);
      const Opened used = openFile(source);
      QVERIFY(used.at_once);
      const QString sidecar =
          QDir(folder_->path()).entryInfoList({QStringLiteral("*.grid")}).first().filePath();
      if (renamed) {
        // The file that was opened is still there, under no name.
        QFile::remove(source);
        write(source, "something else");
      } else {
        QVERIFY(QFile::resize(source, 3000));
      }
      writeInto(sidecar, QByteArray(contentOf(sidecar).size(), '\0'));
      told_.clear();
      const auto tile = used.pyramid->tile(0, 0, 0);
      QVERIFY(tile);
      QCOMPARE(tile->damaged, !renamed);
      QCOMPARE(!used.pyramid->trouble().any(), renamed);
      QCOMPARE(int(told_.size()), 1);
      QVERIFY(told_.first() == (renamed ? GridDamage::Mended : GridDamage::Lost));
      const std::string out = folder_->filePath(QStringLiteral("out.png")).toStdString();
      QCOMPARE(writeGridPng(*used.pyramid, out).has_value(), !renamed);
      QCOMPARE(QFile::exists(QString::fromStdString(out)), renamed);
      QFile::remove(QString::fromStdString(out));
      write(source, QByteArray::fromStdString(bytes));
    }
  }

  void smallPicturesEarnNone() {
    GridOptions large = options();
    large.sidecar_from_cells = kWidth * kHeight;
    open(large);
    QCOMPARE(files().size(), 1);
    cleanup();
    init();
    large.sidecar_from_cells = kWidth * kHeight + 1;
    open(large);
    QVERIFY(files().isEmpty());
  }

  void aPictureThatBrokeOffIsNotKept() {
    auto bytes = *picture();
    bytes.resize(bytes.size() / 2);
    auto opened = openGrid(test::shared(bytes), options());
    const std::atomic<bool> cancelled{false};
    QVERIFY((*opened)->read(cancelled, {}));
    opened->reset();
    QVERIFY(files().isEmpty());
  }

  void givingUpLeavesNothingBehind() {
    auto opened = openGrid(picture(), options());
    const std::atomic<bool> cancelled{true};
    (*opened)->read(cancelled, {});
    opened->reset();
    QVERIFY(files().isEmpty());
  }

  void aFolderThatCannotBeWrittenIsNoError() {
    GridOptions nowhere = options();
    nowhere.sidecar_folder = "/proc/nowhere";
    const Opened opened = open(nowhere);
    QVERIFY(opened.pyramid->complete());
    QVERIFY(same(*opened.pyramid, *open(options()).pyramid));
  }

  void aFolderThatIsMissingIsMade() {
    GridOptions deep = options();
    deep.sidecar_folder += "/a/b";
    open(deep);
    QVERIFY(open(deep).at_once);
  }

  void theFileMayGoWhileThePyramidIsUsed() {
    open(options());
    const Opened second = open(options());
    QFile::remove(files().first());
    QVERIFY(same(*second.pyramid, *open(options()).pyramid));
  }

  void whatWasUsedLeastRecentlyGoesFirst() {
    const QDateTime now = QDateTime::currentDateTime();
    for (int n = 0; n < 5; ++n) {
      const QString path = folder_->filePath(QStringLiteral("%1.grid").arg(n));
      write(path, QByteArray(1000, 'x'));
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadWrite));
      file.setFileTime(now.addSecs(n == 1 ? 50 : n), QFileDevice::FileModificationTime);
    }
    write(folder_->filePath(QStringLiteral("mine.txt")), QByteArray(10'000, 'x'));
    pruneSidecars(folder_->path().toStdString(), 2500);
    const QStringList left = QDir(folder_->path()).entryList(QDir::Files, QDir::Name);
    QCOMPARE(left,
             QStringList({QStringLiteral("1.grid"), QStringLiteral("4.grid"), QStringLiteral("mine.txt")}));
  }

  void usingAFileMakesItRecent() {
    open(options());
    QFile file(files().first());
    QVERIFY(file.open(QIODevice::ReadWrite));
    const QDateTime old = QDateTime::currentDateTime().addDays(-3);
    file.setFileTime(old, QFileDevice::FileModificationTime);
    file.close();
    open(options());
    QVERIFY(QFileInfo(files().first()).lastModified() > old.addDays(1));
  }

  void draftsThatSomebodyLeftGo() {
    const QString left = folder_->filePath(QStringLiteral("0123.grid.part-abcdef"));
    const QString fresh = folder_->filePath(QStringLiteral("4567.grid.part-abcdef"));
    write(left, "x");
    write(fresh, "x");
    QFile file(left);
    QVERIFY(file.open(QIODevice::ReadWrite));
    file.setFileTime(QDateTime::currentDateTime().addDays(-2), QFileDevice::FileModificationTime);
    file.close();
    pruneSidecars(folder_->path().toStdString(), 1 << 20);
    QVERIFY(!QFile::exists(left));
    QVERIFY(QFile::exists(fresh));
  }

 private:
  GridOptions options() const {
    GridOptions options;
    options.sidecar_folder = folder_->path().toStdString();
    options.fingerprint = "etag \"abc\"";
    options.damaged = [this](GridDamage damage) {
      const std::lock_guard lock(mutex_);
      told_ << damage;
    };
    return options;
  }
  std::shared_ptr<const std::string> picture() const {
    return test::shared(test::png({kWidth, kHeight}, test::roomGrays(kWidth, kHeight)));
  }
  Opened open(const GridOptions& options) const {
    auto opened = openGrid(picture(), options);
    const bool at_once = (*opened)->complete();
    const std::atomic<bool> cancelled{false};
    if ((*opened)->read(cancelled, {})) return {};
    return {(*opened)->pyramid(), at_once};
  }
  Opened openFile(const QString& path) const {
    auto opened = openGridFile(path.toStdString(), options());
    const bool at_once = (*opened)->complete();
    const std::atomic<bool> cancelled{false};
    if ((*opened)->read(cancelled, {})) return {};
    return {(*opened)->pyramid(), at_once};
  }
  bool openOnly(const GridOptions& options) const {
    return openSidecar(SidecarKey(options, kWidth, kHeight)) != nullptr;
  }
  QStringList files() const {
    QStringList paths;
    for (const QString& name : QDir(folder_->path()).entryList(QDir::Files)) paths << folder_->filePath(name);
    return paths;
  }
  static QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  static void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) file.write(bytes);
  }
  /// Into the file that is there, as whoever has it open sees it.
  static void writeInto(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (file.open(QIODevice::ReadWrite)) file.write(bytes);
  }
  std::unique_ptr<QTemporaryDir> folder_;
  mutable std::mutex mutex_;
  mutable QList<GridDamage> told_;
  bool mended_ = false;
};

}  // namespace test_grid_sidecar

MAPWRIGHT_TEST(test_grid_sidecar, TestGridSidecar, Core)
#include "test_grid_sidecar.moc"
