// The waypoint list beside a map.yaml: what is read of it, what stays as it is, and what is refused.
#include <csignal>
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "disk/faults.h"
#include "robot/files/faults.h"
#include "robot/files/file_robot.h"
#include "robot/files/waypoint_file.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_waypoint_file {

using namespace mapwright;
using namespace mapwright::robot;
using namespace mapwright::robot::files;

namespace {

const map::MapKey kTheFile{map::MapKind::File, {}};
const std::string kOffice = R"({
"type": "FeatureCollection",
"crs": {"type": "name", "properties": {"name": "map"}},
"features": [
  {"type":"Feature","id":17,"geometry":{"type":"Point","coordinates":[1.50, 2, 0.3]},"properties":{"id":"dock","name":"Dock \u00e9","yaw_rad":1.57,"tags":["charger"],"type":"9","big":12345678901234567890,"note":"<b>"}},
  {"type":"Feature","geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]},"properties":{"name":"Aisle"}},
  {"type":"Feature","geometry":{"type":"Point","coordinates":[-3,4]},"properties":{"name":"Desk"}}
],
"version": 1.10
}
)";

template <typename T, typename Ask>
Outcome<T> outcomeOf(Ask ask) {
  std::optional<Outcome<T>> outcome;
  ask([&](Outcome<T> given) { outcome = std::move(given); });
  if (outcome || !QTest::qWaitFor([&] { return outcome.has_value(); }, 20'000))
    return tl::make_unexpected(map::Failure{});
  return *outcome;
}

}  // namespace

class TestWaypointFile : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<QTemporaryDir> folder_;

  QString path(const char* name) const { return folder_->filePath(QLatin1String(name)); }
  void write(const char* name, const std::string& bytes) {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), qint64(bytes.size()));
  }
  std::string content(const char* name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string("?");
  }
  std::unique_ptr<FileRobot> open(const char* name) {
    FileOptions options;
    options.path = path(name);
    options.settle = std::chrono::milliseconds(1);
    return std::make_unique<FileRobot>(QStringLiteral("file:test"), options);
  }
  static Outcome<StoredWaypoints> read(FileRobot& robot, const map::MapKey& key = kTheFile) {
    return outcomeOf<StoredWaypoints>([&](auto reply) { robot.waypointStore()->read(key, reply); });
  }
  static Outcome<WaypointReceipt> perform(FileRobot& robot, const WaypointRequest& request,
                                          const map::MapKey& key = kTheFile) {
    return outcomeOf<WaypointReceipt>(
        [&](auto reply) { robot.waypointStore()->perform(key, request, reply); });
  }
  static map::Waypoint named(const std::string& name, double x, double y) {
    map::Waypoint point;
    point.id = "id of " + name;
    point.name = name;
    point.position_m = {x, y};
    return point;
  }

 private Q_SLOTS:
  void initTestCase() { std::signal(SIGXFSZ, SIG_IGN); }
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    write("office.yaml", "image: office.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
    write("office.pgm", "P5 1 1 255 x");
  }

  void headingsOfOtherNamesAreNamedAndDegreesRefused() {
    const char* const point =
        R"("features":[{"type":"Feature","properties":{"name":"A","yaw":1.57},"geometry":{"type":"Point","coordinates":[1,2]}}]})";
    write("office.waypoints.geojson", std::string(R"({"type":"FeatureCollection",)") + point);
    const auto robot = open("office.yaml");
    const auto named = read(*robot);
    QVERIFY(named && !named->points.front().yaw_rad);
    QVERIFY(named->notes == std::vector<Fault>{Fault(files::fault::WaypointHeadingUnread, {"yaw"})});
    write("office.waypoints.geojson",
          std::string(
              R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:4326"}},)") +
              point);
    QVERIFY(!read(*robot));
  }

  void noListIsNotAnEmptyOne() {
    const auto robot = open("office.yaml");
    const auto none = read(*robot);
    QVERIFY(none && none->points.empty() && !none->there);
    write("office.waypoints.geojson", R"({"type":"FeatureCollection","features":[]})");
    const auto empty = read(*robot);
    QVERIFY(empty && empty->points.empty() && empty->there);
  }

  void whoOnlyLooksIsToldTheSameList() {
    write("office.waypoints.geojson", kOffice);
    const auto robot = open("office.yaml");
    const auto stored = read(*robot);
    const auto told = outcomeOf<map::WaypointList>(
        [&](auto reply) { robot->waypointSource()->waypoints(kTheFile, reply); });
    QVERIFY(stored && told);
    QCOMPARE(told->points.size(), std::size_t(2));
    QVERIFY(told->points == stored->points);
    write("office.waypoints.geojson", "{");
    const auto broken = outcomeOf<map::WaypointList>(
        [&](auto reply) { robot->waypointSource()->waypoints(kTheFile, reply); });
    QVERIFY(!broken);
  }

  void liesBesideItsMap() {
    QCOMPARE(waypointPathOf("/maps/office.yaml"), std::string("/maps/office.waypoints.geojson"));
    QCOMPARE(waypointPathOf("/maps.d/office"), std::string("/maps.d/office.waypoints.geojson"));
    QCOMPARE(waypointPathOf("a.b.png"), std::string("a.b.waypoints.geojson"));
  }

  void pointsAreRead() {
    const auto stored = parseWaypoints(kOffice);
    QVERIFY2(stored.has_value(), stored ? "" : qPrintable(sentences::wordsOf(stored.error())));
    QCOMPARE(stored->points.size(), std::size_t(2));
    const map::Waypoint& dock = stored->points[0];
    QCOMPARE(dock.id, std::string("dock"));
    QCOMPARE(dock.name, std::string("Dock \xc3\xa9"));
    QCOMPARE(dock.position_m, Eigen::Vector2d(1.5, 2));
    QCOMPARE(*dock.yaw_rad, 1.57);
    QCOMPARE(dock.tags, std::vector<std::string>{"charger"});
    QCOMPARE(dock.type, std::string("9"));
    QVERIFY(!stored->points[1].yaw_rad);
    QVERIFY(!stored->points[1].id.empty());
    QVERIFY(stored->notes.empty());
  }

  void whatIsNotChangedStaysToTheLetter() {
    QCOMPARE(*patchWaypoints(kOffice, {}), kOffice);
    map::Waypoint dock = parseWaypoints(kOffice)->points[0];
    const map::Waypoint before = dock;
    dock.position_m = {-0.1, 2};
    const auto written = patchWaypoints(kOffice, {{dock.id, before, dock}});
    QVERIFY(written);
    std::string expected = kOffice;
    for (
        const char* kept :
        {"12345678901234567890", "\"version\": 1.10", "\"id\": 17", "\"Dock \\u00e9\"",
         R"("crs": {"type": "name", "properties": {"name": "map"}})", "[-0.1, 2, 0.3]",
         R"({"type":"Feature","geometry":{"type":"Point","coordinates":[-3,4]},"properties":{"name":"Desk"}})",
         R"({"type":"Feature","geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]},"properties":{"name":"Aisle"}})"})
      QVERIFY2(written->find(kept) != std::string::npos, written->c_str());
    QCOMPARE(parseWaypoints(*written)->points[0].position_m, dock.position_m);
  }

  void addedChangedAndDeletedOnesAreReadBack() {
    map::Waypoint odd = named("<b>bold</b> \"q\" \\ \n \xF0\x9F\x9A\xAA", 1e-7, -123456.789);
    odd.yaw_rad = -3.0;
    odd.tags = {"a", "b c"};
    const auto points = parseWaypoints(kOffice)->points;
    map::Waypoint desk = points[1];
    desk.name = "Table";
    desk.tags = {"x"};
    const auto written = patchWaypoints(
        kOffice,
        {{points[0].id, points[0], std::nullopt}, {desk.id, points[1], desk}, {odd.id, std::nullopt, odd}});
    QVERIFY(written);
    auto read = parseWaypoints(*written)->points;
    QCOMPARE(read.size(), std::size_t(2));
    QCOMPARE(read[0].name, std::string("Table"));
    QCOMPARE(read[0].id, desk.id);  // told by its name until now: it goes on being called so
    for (map::Waypoint* one : {&read[1], &odd}) one->source.clear();
    QCOMPARE(read[1], odd);
    QVERIFY(written->find("Aisle") != std::string::npos);
  }

  void oneThatWasDeletedComesBackWithAllThatItHad() {
    const map::Waypoint dock = parseWaypoints(kOffice)->points[0];
    const auto without = patchWaypoints(kOffice, {{dock.id, dock, std::nullopt}});
    QVERIFY(without->find("12345678901234567890") == std::string::npos);
    const auto again = patchWaypoints(*without, {{dock.id, std::nullopt, dock}});
    QVERIFY(again->find("12345678901234567890") != std::string::npos);
    QVERIFY(again->find("\"note\":") != std::string::npos);
    QCOMPARE(parseWaypoints(*again)->points.back().id, dock.id);
  }

  void tagsThatAreNoTextsAreNotThrownAway() {
    const std::string json =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Point","coordinates":[0,0]},"properties":{"id":5,"tags":["a",{"k":1}]}}]})";
    const map::Waypoint before = parseWaypoints(json)->points[0];
    QCOMPARE(before.id, std::string("5"));
    map::Waypoint after = before;
    after.tags = {"b"};
    const auto written = patchWaypoints(json, {{before.id, before, after}});
    QVERIFY2(written->find(R"(["b", {"k":1}])") != std::string::npos, written->c_str());
    QVERIFY(written->find("\"id\":5") != std::string::npos ||
            written->find("\"id\": 5") != std::string::npos);
  }

  void whatIsNotShownOrAssumedIsNoted_data() {
    QTest::addColumn<QByteArray>("more");  // of the collection
    QTest::addColumn<QByteArray>("geometry");
    QTest::addColumn<QByteArray>("properties");
    QTest::addColumn<int>("notes");
    const QByteArray point = R"({"type":"Point","coordinates":[1,2]})";
    QTest::newRow("sound") << QByteArray() << point << QByteArray(R"({"tags":["a"],"frame":"map"})") << 0;
    QTest::newRow("no tags") << QByteArray() << point << QByteArray(R"({"tags":null})") << 0;
    QTest::newRow("a line") << QByteArray()
                            << QByteArray(R"({"type":"LineString","coordinates":[[1,2],[3,4]]})")
                            << QByteArray("{}") << 0;
    QTest::newRow("no place") << QByteArray() << QByteArray("null") << QByteArray("{}") << 0;
    QTest::newRow("tags that are a text") << QByteArray() << point << QByteArray(R"({"tags":"a,b"})") << 1;
    QTest::newRow("tags that are numbers") << QByteArray() << point << QByteArray(R"({"tags":["a",3]})") << 1;
    QTest::newRow("another frame") << QByteArray() << point << QByteArray(R"({"frame":"odom"})") << 1;
    QTest::newRow("another system") << QByteArray(R"("crs":"EPSG:25832",)") << point << QByteArray("{}") << 1;
    QTest::newRow("many points") << QByteArray()
                                 << QByteArray(R"({"type":"MultiPoint","coordinates":[[1,2]]})")
                                 << QByteArray("{}") << 1;
    QTest::newRow("no numbers") << QByteArray() << QByteArray(R"({"type":"Point","coordinates":["1","2"]})")
                                << QByteArray("{}") << 1;
  }
  void whatIsNotShownOrAssumedIsNoted() {
    QFETCH(const QByteArray, more);
    QFETCH(const QByteArray, geometry);
    QFETCH(const QByteArray, properties);
    QFETCH(const int, notes);
    const auto stored = parseWaypoints((R"({"type":"FeatureCollection",)" + more +
                                        R"("features":[{"type":"Feature","geometry":)" + geometry +
                                        R"(,"properties":)" + properties + "}]}")
                                           .toStdString());
    QVERIFY(stored);
    QCOMPARE(int(stored->notes.size()), notes);
  }

  void ofTwoMembersOfOneNameTheOneThatIsReadIsChanged() {
    const std::string json =
        R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Point","coordinates":[0,0]},"geometry":{"type":"LineString","coordinates":[[5,5],[6,6]]},"properties":{"id":"x"}}]})";
    const map::Waypoint before = parseWaypoints(json)->points.at(0);
    map::Waypoint after = before;
    after.position_m = {1, 2};
    const auto written = patchWaypoints(json, {{before.id, before, after}});
    const auto read = parseWaypoints(*written)->points;
    QCOMPARE(read.size(), std::size_t(1));
    QCOMPARE(read[0].position_m, after.position_m);
  }

  void twoOfOneIdAreTwo() {
    const std::string one =
        R"({"type":"Feature","geometry":{"type":"Point","coordinates":[0,0]},"properties":{"id":"x"}})";
    const std::string json = R"({"type":"FeatureCollection","features":[)" + one + "," + one + "]}";
    const auto stored = parseWaypoints(json);
    QCOMPARE(stored->points.size(), std::size_t(2));
    QVERIFY(stored->points[0].id != stored->points[1].id);
    QCOMPARE(stored->notes.size(), std::size_t(1));
  }

  void whatIsNoListIsRefused_data() {
    QTest::addColumn<QByteArray>("json");
    for (const char* json : {"", "[", "{}", "[]", "null", R"({"type":"FeatureCollection"})",
                             R"({"type":"FeatureCollection","features":{}})",
                             R"({"type":"FeatureCollection","features":[],"features":[]})",
                             R"({"type":"FeatureCollection","features":[tru]})",
                             "{\"type\":\"FeatureCollection\",\"features\":[],\"x\":\"\xff\"}"})
      QTest::newRow(*json ? json : "nothing") << QByteArray(json);
  }
  void whatIsNoListIsRefused() {
    QFETCH(QByteArray, json);
    QVERIFY(!parseWaypoints(json.toStdString()));
    write("office.waypoints.geojson", json.toStdString());
    const auto robot = open("office.yaml");
    const auto stored = read(*robot);
    QVERIFY(!stored);
    QCOMPARE(stored.error().kind, map::FailureKind::MalformedAnswer);
    const QString said = QString::fromStdString(sentences::sentenceOf(stored.error()));
    QVERIFY2(said.contains(QLatin1String("office.waypoints.geojson cannot be read: it ")), qPrintable(said));
    QVERIFY2(said.endsWith(QLatin1String(". It is left unchanged.")), qPrintable(said));
    const map::Waypoint point = named("P", 1, 1);
    const auto done = perform(*robot, {{{point.id, std::nullopt, point}}, {}});
    QVERIFY(!done);
    QCOMPARE(done.error().applied, map::Applied::No);
    QCOMPARE(content("office.waypoints.geojson"), json.toStdString());  // never overwritten
  }

  void deepNestingIsRefused() {
    QVERIFY(!parseWaypoints(R"({"type":"FeatureCollection","features":)" + std::string(5'000, '[')));
  }

  void aMapWithoutAListHasAnEmptyOneAndTheFirstSaveMakesIt() {
    const auto robot = open("office.yaml");
    const auto stored = read(*robot);
    QVERIFY(stored);
    QVERIFY(stored->points.empty());
    QVERIFY(!QFile::exists(path("office.waypoints.geojson")));
    const map::Waypoint point = named("P", 1, 1);
    const auto requests = robot->waypointStore()->plan(*stored, {{point.id, std::nullopt, point}});
    QCOMPARE(requests.size(), std::size_t(1));
    QVERIFY(perform(*robot, requests[0]));
    const auto again = read(*robot);
    QCOMPARE(again->points.size(), std::size_t(1));
    QCOMPARE(again->points[0].name, std::string("P"));
    QVERIFY(again->revision != stored->revision);
    QVERIFY(robot->waypointStore()->plan(*again, {}).empty());
  }

  void aFileThatChangedSinceIsAConflictAndStays() {
    const auto robot = open("office.yaml");
    const auto stored = read(*robot);
    write("office.waypoints.geojson", kOffice);
    const map::Waypoint point = named("P", 1, 1);
    const auto done =
        perform(*robot, robot->waypointStore()->plan(*stored, {{point.id, std::nullopt, point}})[0]);
    QVERIFY(!done);
    QCOMPARE(done.error().kind, map::FailureKind::Conflict);
    QCOMPARE(done.error().applied, map::Applied::No);
    QCOMPARE(content("office.waypoints.geojson"), kOffice);
  }

  void changesOnDiskAreTold() {
    const auto robot = open("office.yaml");
    QSignalSpy changed(robot->waypointStore(), &WaypointStore::changed);
    QVERIFY(read(*robot));
    write("office.waypoints.geojson", kOffice);
    QTRY_VERIFY(changed.size() >= 1);
    QCOMPARE(read(*robot)->points.size(), std::size_t(2));
  }

  void aFolderThatMayNotBeWrittenIsSaid() {
    const auto robot = open("office.yaml");
    const auto stored = read(*robot);
    QVERIFY(::chmod(qPrintable(folder_->path()), 0555) == 0);
    // Root may write everywhere: then this program is somebody else for a while, all its threads are.
    const bool root = ::geteuid() == 0;
    if (root) QVERIFY(::seteuid(65'534) == 0);
    const map::Waypoint point = named("P", 1, 1);
    const auto done =
        perform(*robot, robot->waypointStore()->plan(*stored, {{point.id, std::nullopt, point}})[0]);
    if (root) QVERIFY(::seteuid(0) == 0);
    ::chmod(qPrintable(folder_->path()), 0755);
    QVERIFY(!done);
    QCOMPARE(done.error().applied, map::Applied::No);
    QCOMPARE(done.error().cause.code, disk::fault::FileNotWritten);
  }

  void inAFolderEachMapHasItsOwnAndNoIdLeadsOut() {
    write("attic.png", "no picture");
    write("attic.waypoints.geojson", kOffice);
    FileOptions options;
    options.path = folder_->path();
    FileRobot robot(QStringLiteral("file:test"), options);
    QCOMPARE(read(robot, {map::MapKind::File, "attic.png"})->points.size(), std::size_t(2));
    QVERIFY(read(robot, {map::MapKind::File, "office.yaml"})->points.empty());
    QVERIFY(read(robot, {map::MapKind::File, "office.pgm"})->points.empty());  // the same map as its yaml
    QVERIFY(!read(robot, {map::MapKind::File, "../office.yaml"}));
    QVERIFY(!read(robot, {map::MapKind::File, "gone.yaml"}));
  }

  void aPipeInItsPlaceHoldsNothingUp() {
    QVERIFY(::mkfifo(qPrintable(path("office.waypoints.geojson")), 0600) == 0);
    const auto robot = open("office.yaml");
    QVERIFY(!read(*robot));
  }
};

}  // namespace test_waypoint_file

MAPWRIGHT_TEST(test_waypoint_file, TestWaypointFile, Core)
#include "test_waypoint_file.moc"
