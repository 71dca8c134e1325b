// The pictures of local maps, changed: whole or not at all, by the map.yaml that stays as it is, and never
// over what somebody else has written.
#include <QtTest>

#include "grids/faults.h"
#include "robot/files/file_robot.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_file_pictures {

using namespace mapwright;
using namespace mapwright::robot;
using namespace mapwright::robot::files;

namespace {

const QByteArray kYaml =
    "# Ground floor, measured twice\nimage: office.pgm\nresolution: 0.05  # m\norigin: [-10.0, -7.5, 0]\n"
    "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nowner: facility\n";

template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  ask([&](Outcome<T> given) { answer = std::move(given); });
  if (answer || !QTest::qWaitFor([&] { return answer.has_value(); }, 20'000))
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "not answered later"});
  return *answer;
}

std::shared_ptr<const grids::GridPyramid> filled(int width, int height, std::uint8_t cell) {
  const auto builder =
      grids::buildGrid(width, height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  for (int y = 0; y < height; ++y) builder->pushRow(std::vector<std::uint8_t>(std::size_t(width), cell));
  builder->finish();
  return builder->pyramid();
}

}  // namespace

class TestFilePictures : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<FileRobot> robot_;

  QString path(const char* name) const { return folder_->filePath(QLatin1String(name)); }
  void write(const char* name, const QByteArray& bytes) {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }
  static QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  Outcome<map::WholeMap> fetch() {
    return answerTo<map::WholeMap>([&](auto reply) {
      robot_->wholeMapSource()->fetch({map::MapKind::File, {}}, reply);
    });
  }
  Outcome<PictureReceipt> put(const PictureChange& change) {
    return answerTo<PictureReceipt>([&](auto reply) { robot_->pictureStore()->write(change, reply); });
  }

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    write("office.yaml", kYaml);
    write("office.pgm", "P5\n3 1\n255\n\xfe\xfe\xfe");
    FileOptions options;
    options.path = path("office.yaml");
    robot_ = std::make_unique<FileRobot>(QStringLiteral("file:test"), options);
    robot_->connectToRobot();
  }
  void cleanup() { robot_.reset(); }

  void aPictureIsWrittenAndItsYamlStays() {
    const auto map = fetch();
    QVERIFY(map);
    QCOMPARE(robot_->pictureStore()->obstacle(*map), std::nullopt);
    QVERIFY(robot_->pictureStore()->holdsUnknown(*map));
    const auto receipt = put({map->key, filled(3, 1, 100), map->fingerprint});
    QVERIFY2(receipt, receipt ? "" : sentences::sentenceOf(receipt.error()).c_str());
    QCOMPARE(content(path("office.pgm")), QByteArray("P5\n3 1\n255\n\0\0\0", 14));
    QCOMPARE(content(path("office.yaml")), kYaml);
    QCOMPARE(receipt->revision, fetch()->fingerprint);
  }

  void whatSomebodyElseHasWrittenIsNotWrittenOver() {
    const auto map = fetch();
    write("office.pgm", "P5\n3 1\n255\n\xcd\xcd\xcd....");
    const auto receipt = put({map->key, filled(3, 1, 100), map->fingerprint});
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().kind, map::FailureKind::Conflict);
    QCOMPARE(receipt.error().applied, map::Applied::No);
    QVERIFY(content(path("office.pgm")).startsWith("P5\n3 1\n255\n\xcd"));
  }

  void anotherReadingIsAnotherRevisionToo() {
    const auto map = fetch();
    write("office.yaml", QByteArray(kYaml).replace("negate: 0", "negate: 1"));
    QVERIFY(!put({map->key, filled(3, 1, 100), map->fingerprint}));
  }

  void whatCannotBeWrittenSaysWhy() {
    const auto map = fetch();
    const auto other = put({map->key, filled(4, 1, 100), map->fingerprint});
    QVERIFY(!other);
    QCOMPARE(other.error().cause.code, grids::fault::PictureOfOtherSize);
    QVERIFY(!put({{map::MapKind::File, "../office.pgm"}, filled(3, 1, 0), map->fingerprint}));
    map::WholeMap bitmap = *map;
    bitmap.path = "a.bmp";
    QCOMPARE(robot_->pictureStore()->obstacle(bitmap), PictureObstacle::FormatNotWritten);
    bitmap.key.kind = map::MapKind::Live;
    QCOMPARE(robot_->pictureStore()->obstacle(bitmap), PictureObstacle::NotStored);
  }
};

}  // namespace test_file_pictures

MAPWRIGHT_TEST(test_file_pictures, TestFilePictures, Core)
#include "test_file_pictures.moc"
