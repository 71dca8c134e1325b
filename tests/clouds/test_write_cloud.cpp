// Clouds as files.
#include <bit>
#include <cstring>
#include <string>

#include <QtTest>

#include "clouds/write_cloud.h"
#include "made_clouds.h"
#include "test_program.h"

namespace test_write_cloud {

using namespace mapwright;
using namespace mapwright::clouds;

namespace {

std::string written(const map::SpatialCloud& cloud, CloudFormat format) {
  std::string bytes;
  if (!writeCloud(cloud, format, [&](std::string_view more) {
        bytes += more;
        return true;
      })) {
    return "failed";
  }
  return bytes;
}

template <class Number>
Number numberAt(const std::string& bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

map::SpatialCloud small() {
  map::SpatialCloud cloud;
  cloud.frame = "map";
  cloud.points = {{1.5F, -2.25F, 0.1F}, {3, 4, 5}};
  cloud.intensity = {0.5F, 7};
  cloud.rgb = {0x102030, 0xffeedd};
  return cloud;
}

}  // namespace

class TestWriteCloud : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theNameTellsTheFormat() {
    QVERIFY(formatOf("a.pcd") == CloudFormat::PcdBinary);
    QVERIFY(formatOf("/x/A.PLY") == CloudFormat::PlyBinary);
    QVERIFY(formatOf("a.csv") == CloudFormat::Csv);
    QVERIFY(!formatOf("a.las") && !formatOf("") && !formatOf("pcd"));
  }

  void asTextEveryNumberIsReadAgainAsItWas() {
    QCOMPARE(written(small(), CloudFormat::PcdAscii),
             std::string("# .PCD v0.7 - Point Cloud Data file format\n# frame map\nVERSION 0.7\n"
                         "FIELDS x y z intensity rgb\nSIZE 4 4 4 4 4\nTYPE F F F F U\nCOUNT 1 1 1 1 1\n"
                         "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n"
                         "1.5 -2.25 0.1 0.5 1056816\n3 4 5 7 16772829\n"));
    QCOMPARE(
        written(small(), CloudFormat::Csv),
        std::string("x,y,z,intensity,red,green,blue\n1.5,-2.25,0.1,0.5,16,32,48\n3,4,5,7,255,238,221\n"));
  }

  void asBytesARowIsItsFieldsWithoutGaps() {
    const std::string pcd = written(small(), CloudFormat::PcdBinary);
    const std::size_t data = pcd.find("DATA binary\n") + 12;
    QCOMPARE(pcd.size() - data, std::size_t(2 * 20));
    QCOMPARE(numberAt<float>(pcd, data + 20), 3.0F);
    QCOMPARE(numberAt<float>(pcd, data + 12), 0.5F);
    QCOMPARE(numberAt<std::uint32_t>(pcd, data + 16), 0x102030U);
    const std::string ply = written(small(), CloudFormat::PlyBinary);
    const std::size_t body = ply.find("end_header\n") + 11;
    QCOMPARE(ply.size() - body, std::size_t(2 * 19));
    QVERIFY(ply.find("element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                     "property float intensity\nproperty uchar red\n") != std::string::npos);
    QCOMPARE(int(static_cast<unsigned char>(ply[body + 16])), 0x10);
    QCOMPARE(numberAt<float>(ply, body + 19 + 8), 5.0F);
  }

  void whatLiesFarFromTheOriginKeepsItsMillimetres() {
    map::SpatialCloud cloud = small();
    cloud.origin_m = {437'112.123, 5'411'002.456, 120};
    const std::string ply = written(cloud, CloudFormat::PlyBinary);
    QVERIFY(ply.find("property double x\n") != std::string::npos);
    const std::size_t body = ply.find("end_header\n") + 11;
    QCOMPARE(numberAt<double>(ply, body), 437'112.123 + 1.5);
    const std::string pcd = written(cloud, CloudFormat::PcdBinary);
    QVERIFY(pcd.find("SIZE 8 8 8 4 4\n") != std::string::npos);
    const std::size_t data = pcd.find("DATA binary\n") + 12;
    QCOMPARE(numberAt<double>(pcd, data + 8), 5'411'002.456 - 2.25);
    QVERIFY(written(cloud, CloudFormat::Csv).find("437113.623,5411000.206,") != std::string::npos);
  }

  void aCloudWithoutPointsIsAFileWithoutPoints() {
    QVERIFY(written({}, CloudFormat::PcdBinary).find("POINTS 0\nDATA binary\n") != std::string::npos);
    QCOMPARE(written({}, CloudFormat::Csv), std::string("x,y,z\n"));
  }

  void aFrameCannotBreakTheHeader() {
    map::SpatialCloud cloud = small();
    cloud.frame = "map\nPOINTS 9\n" + std::string(5'000, 'x') + "\xf0\x9f\xa4\x96";
    const std::string pcd = written(cloud, CloudFormat::PcdBinary);
    QVERIFY(pcd.find("\nPOINTS 9") == std::string::npos);
    QVERIFY(pcd.size() < 1'000);
  }

  void ofASetWhatIsShownIsWritten() {
    NewestClouds newest;
    map::SpatialCloud plain = test::scattered(1'000, 10, 4, 1);
    plain.intensity.clear();
    plain.rgb.clear();
    newest.add(test::came(plain));
    newest.add(test::came(small(), test::box({2, 1, 2}, {4, 8, 6})));
    const CloudSet set = newest.set();
    const HeightRange heights{0, 2};
    std::string bytes;
    const auto done = writeClouds(set, heights, CloudFormat::PlyBinary, [&](std::string_view more) {
      bytes += more;
      return true;
    });
    QVERIFY(done.has_value());
    QCOMPARE(done->points, countShown(set, heights));
    QVERIFY(done->points < 1'000 && done->points > 100);
    QVERIFY(done->intensity && done->rgb && !done->doubles);
    QCOMPARE(bytes.size() - bytes.find("end_header\n") - 11, std::size_t(done->points) * 19);
  }

  void whoeverTakesNoMoreEndsIt() {
    int taken = 0;
    QVERIFY(!writeCloud(test::scattered(50'000, 10, 4, 1), CloudFormat::Csv,
                        [&](std::string_view) { return ++taken < 3; }));
    QCOMPARE(taken, 3);
    const std::atomic<bool> cancelled = true;
    QVERIFY(!writeCloud(
        small(), CloudFormat::Csv, [](std::string_view) { return true; }, &cancelled));
  }
};

}  // namespace test_write_cloud

MAPWRIGHT_TEST(test_write_cloud, TestWriteCloud, Nothing)
#include "test_write_cloud.moc"
