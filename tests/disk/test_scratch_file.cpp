#include <array>

#include <QTemporaryDir>
#include <QTest>

#include "disk/scratch_file.h"
#include "test_program.h"

namespace test_scratch_file {

using mapwright::disk::ScratchFile;

class ScratchFileTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsWrittenAnywhereIsReadBack() {
    const QTemporaryDir folder;
    ScratchFile file(folder.filePath(QStringLiteral("made/for/it")).toStdString());
    const std::array<std::uint8_t, 3> bytes{1, 2, 3};
    QCOMPARE(file.write(bytes, 1'000'000), std::string());
    std::array<std::uint8_t, 3> read{};
    QVERIFY(file.read(read, 1'000'000));
    QCOMPARE(read, bytes);
    QVERIFY2(file.read(read, 5), "what was never written holds zeros");
    QVERIFY2(!file.read(read, 1'000'001), "beyond the end nothing can be read");
  }

  void nobodySeesIt() {
    const QTemporaryDir folder;
    ScratchFile file(folder.path().toStdString());
    const std::array<std::uint8_t, 3> bytes{1, 2, 3};
    QCOMPARE(file.write(bytes, 0), std::string());
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void nothingCanBeReadBeforeAnythingIsWritten() {
    const ScratchFile file{std::string()};
    std::array<std::uint8_t, 3> read{};
    QVERIFY(!file.read(read, 0));
  }
};

}  // namespace test_scratch_file

MAPWRIGHT_TEST(test_scratch_file, ScratchFileTest, Core)
#include "test_scratch_file.moc"
