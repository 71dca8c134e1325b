#include <algorithm>
#include <random>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "robot/aimdk/faults.h"
#include "robot/aimdk/parse_rpc.h"
#include "robot/wire/faults.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_aimdk_parse {

using namespace mapwright;
using namespace mapwright::robot::aimdk;

namespace {

const map::MapKey kKey{map::MapKind::Stored, "1764059676131"};

/// Header of a PNG that says 2898 x 2603.
QByteArray png() {
  return QByteArray::fromHex("89504e470d0a1a0a0000000d4948445200000b5200000a2b08000000") + "rest";
}

std::string wholeMap(const std::string& members, const std::string& prefix = {}) {
  return R"({"data":{"map_id":"1764059676131","map_name":"Park","map_url":"",)" + members +
         R"("map_data":)"
         "\"" +
         prefix + png().toBase64().toStdString() + "\"}}";
}

const std::string kUsual = R"("width":2898,"height":2603,"resolution":20,"origin_x":1274,"origin_y":1371,
  "rotate_angle":-5.512457272434708,)";

std::string point(const std::string& u, const std::string& angle) {
  return R"({"data":{"points":[{"point_id":1,"name":"<b>🚪</b>","point_type":"NaviPointType_NAVI_POINT",
    "pixel_pose":{"position":{"u":)" +
         u + R"(,"v":1420},"angle":)" + angle +
         R"(},"pose":{"position":{"x":11.6,"y":-2.45,"z":0}}}],"paths":[]}})";
}

QString said(const RpcError& error) {
  return error.cause.any() ? sentences::wordsOf(error.cause) : QString::fromStdString(error.detail);
}

}  // namespace

class AimdkParseTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theSeedsMapIsPlacedByPixelsPerMetre() {
    for (const char* prefix : {"", "data:image/png;base64,"}) {
      const auto parsed = parseWholeMap(wholeMap(kUsual, prefix), kKey);
      QVERIFY2(parsed.has_value(), parsed ? "" : qPrintable(said(parsed.error())));
      const map::WholeMap& whole = parsed->map;
      QCOMPARE(whole.grid.resolution_m, 0.05);
      QCOMPARE(whole.grid.width, 2898);
      QVERIFY(whole.notes.empty());
      QCOMPARE(*whole.display_rotation_rad, geometry::radiansFromDegrees(-5.512457272434708));
      // pixel_x = origin_x + x * resolution, pixel_y = origin_y - y * resolution
      const Eigen::Vector2d pixel = whole.grid.cellFromWorld({11.6, -2.45});
      QVERIFY((pixel - Eigen::Vector2d(1274 + 11.6 * 20, 1371 + 2.45 * 20)).norm() < 1e-6);
      QCOMPARE(QByteArray::fromStdString(*whole.bytes), png());
    }
  }

  void thePicturesOwnSizeWinsWithAWarning() {
    const auto parsed = parseWholeMap(
        wholeMap(R"("width":10,"height":20,"resolution":20,"origin_x":1274,"origin_y":1371,)"), kKey);
    QCOMPARE(parsed->map.grid.height, 2603);
    QCOMPARE(parsed->map.grid.origin.y_m, (1371.0 - 2603) / 20);
    QCOMPARE(parsed->map.notes.size(), std::size_t(1));
    QCOMPARE(parsed->map.notes[0].severity, map::Severity::Warning);
  }

  void mapsThatCannotBePlacedAreRefused() {
    for (const char* members :
         {R"("resolution":0,"origin_x":1,"origin_y":1,)", R"("origin_x":1,"origin_y":1,)",
          R"("resolution":-20,"origin_x":1,"origin_y":1,)", R"("resolution":20,"origin_x":1,)",
          R"("resolution":NaN,"origin_x":1,"origin_y":1,)",
          R"("resolution":1e-300,"origin_x":1,"origin_y":1,)"}) {
      const auto parsed = parseWholeMap(wholeMap(members), kKey);
      QVERIFY2(!parsed, members);
      QVERIFY(parsed.error().cause.any());
    }
    QVERIFY(!parseWholeMap(R"({"data":{"resolution":20,"origin_x":1,"origin_y":1,"map_data":"!!"}})", kKey));
    QVERIFY(!parseWholeMap(R"({"data":{"resolution":20,"origin_x":1,"origin_y":1,"map_data":""}})", kKey));
    QVERIFY(!parseWholeMap(wholeMap(kUsual), {map::MapKind::Stored, "5"}));
  }

  void whatTheRobotRefusesIsKeptApartFromWhatCannotBeRead_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<bool>("refused");
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QByteArray& body, bool refused, const char* code,
                        const char* says) {
      QTest::newRow(name) << body << refused << QString::fromLatin1(code) << QString::fromLatin1(says);
    };
    row("error text", R"({"error":"no such map"})", true, "", "no such map");
    row("error object", R"({"error":{"message":"busy"}})", true, "", "busy");
    row("code", R"({"code":1003,"message":"bad"})", true, "1003", "bad");
    row("empty data", R"({"data":{}})", true, "", "no data");
    row("null data", R"({"data":null,"msg":"none"})", true, "", "none");
    row("no data", "{}", true, "", "no data");
    row("a code inside", R"({"error":{"code":404,"message":"gone"}})", true, "404", "gone");
    row("html", "<html>", false, "", "not JSON");
    row("nothing", {}, false, "", "not JSON");
  }
  void whatTheRobotRefusesIsKeptApartFromWhatCannotBeRead() {
    QFETCH(QByteArray, body);
    QFETCH(bool, refused);
    QFETCH(QString, code);
    QFETCH(QString, says);
    for (const RpcError& why :
         {parseMapNames(body.toStdString()).error(), parseCurrentMap(body.toStdString()).error(),
          parseWholeMap(body.toStdString(), kKey).error()}) {
      QCOMPARE(why.refused, refused);
      QCOMPARE(why.code, code.toStdString());
      QVERIFY2(said(why).contains(says), qPrintable(said(why)));
    }
  }

  void idsKeepEveryDigitAsTextAndAsNumber() {
    const auto entries = parseMapNames(
        R"({"code":0,"error":"","data":{"map_lists":[{"map_id":"1764137567113","map_name":"River Park","map_index":5},
            {"map_id":1764059676131123456,"map_name":"Park","map_index":"3"},{"map_name":"no id"},
            {"map_id":123456789012345678901234567890}]}})");
    QVERIFY(entries.has_value());
    QCOMPARE(entries->size(), std::size_t(3));
    QCOMPARE(entries->at(0).index, std::optional(5));
    QCOMPARE(entries->at(1).key.id, std::string("1764059676131123456"));
    QCOMPARE(entries->at(2).key.id, std::string("123456789012345678901234567890"));
    QCOMPARE(*parseCurrentMap(R"({"data":{"map_id":1764059676131}})"), std::string("1764059676131"));
    QVERIFY(parseMapNames(R"({"data":{"map_lists":[]}})")->empty());
  }

  void theTopologyIsAskedForByNumber() {
    QCOMPARE(topologyRequest("1764059676131999999"),
             QByteArray(R"({"command":"TopoCommand_GET_TOPO_MSG","map_id":1764059676131999999})"));
    // What is no number goes as the text that it is.
    for (const char* id : {"abc", "1,\"x\":2", "-1", "007", "1e3", "\\u00e9 ü"}) {
      const QJsonObject sent = QJsonDocument::fromJson(topologyRequest(id)).object();
      QCOMPARE(sent[QLatin1String("map_id")], QJsonValue(QString::fromUtf8(id)));
      QCOMPARE(sent.size(), 2);
    }
    QVERIFY(wholeMapRequest("1764059676131").contains("\"map_id\":\"1764059676131\""));
    QVERIFY(wholeMapRequest("a\"b").contains("\"a\\\"b\""));
  }

  void pointsLieWhereTheirMetresSay() {
    const auto frame = parseWholeMap(wholeMap(kUsual), kKey);
    const auto good = parseTopology(point("1506", "0"), &*frame);
    QCOMPARE(good->list.points.size(), std::size_t(1));
    QCOMPARE(good->list.points[0].id, std::string("1"));
    QCOMPARE(good->list.points[0].name, std::string("<b>🚪</b>"));
    QCOMPARE(good->list.points[0].position_m, Eigen::Vector2d(11.6, -2.45));
    QVERIFY(good->list.notes.empty());
    const auto off = parseTopology(point("1520", "0"), &*frame);
    QCOMPARE(off->list.points[0].position_m, Eigen::Vector2d(11.6, -2.45));
    QCOMPARE(off->list.notes.size(), std::size_t(1));
    QVERIFY(parseTopology(point("1520", "0"), nullptr)->list.notes.empty());
  }

  // By the document's formula: pixel_x = origin_x + x * resolution, pixel_y = origin_y - y * resolution.
  void pointsWithPixelsOnlyLieWhereTheirPixelsSay() {
    std::mt19937 dice(19);
    const auto real = [&](double from, double to) {
      return std::uniform_real_distribution<>(from, to)(dice);
    };
    for (int round = 0; round < 200; ++round) {
      ParsedMap frame;
      frame.resolution = real(1, 50);
      frame.u0 = real(-500, 3000);
      frame.v0 = real(-500, 3000);
      QJsonArray rows;
      std::vector<Eigen::Vector2d> places;
      std::int64_t by_pixels = 0;
      for (int i = 0; i < 6; ++i) {
        const double x = real(-80, 80), y = real(-80, 80);
        const QJsonObject pixel{{QStringLiteral("u"), frame.u0 + x * frame.resolution},
                                {QStringLiteral("v"), frame.v0 - y * frame.resolution}};
        QJsonObject row{{QStringLiteral("point_id"), i},
                        {QStringLiteral("pixel_pose"), QJsonObject{{QStringLiteral("position"), pixel}}}};
        if (dice() % 2 == 0) {
          const QJsonObject metres{{QStringLiteral("x"), x}, {QStringLiteral("y"), y}};
          row[QStringLiteral("pose")] = QJsonObject{{QStringLiteral("position"), metres}};
        } else {
          ++by_pixels;
        }
        rows << row;
        places.emplace_back(x, y);
      }
      const QJsonObject answer{{QStringLiteral("data"), QJsonObject{{QStringLiteral("points"), rows}}}};
      const QByteArray body = QJsonDocument(answer).toJson();
      const auto read = parseTopology({body.data(), std::size_t(body.size())}, &frame);
      QVERIFY(read);
      QCOMPARE(read->list.points.size(), places.size());
      for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector2d off = read->list.points[i].position_m - places[i];
        QVERIFY2(off.cwiseAbs().maxCoeff() < 1e-9, qPrintable(QString::number(off.cwiseAbs().maxCoeff())));
      }
      const Fault note(robot::aimdk::fault::PointsByPixels, {by_pixels});
      const auto& notes = read->list.notes;
      QCOMPARE(std::count(notes.begin(), notes.end(), note), by_pixels > 0 ? 1 : 0);
      // Without the map its pixels tell nothing.
      const auto blind = parseTopology({body.data(), std::size_t(body.size())}, nullptr);
      QCOMPARE(blind->list.points.size(), places.size() - std::size_t(by_pixels));
    }
  }

  void whatIsLeftOutIsCounted() {
    std::int64_t left_out = -1;
    QVERIFY(parseMapNames(R"({"data":{"map_lists":[{"map_id":"1"},{"map_name":"a"},{},7]}})", &left_out));
    QCOMPARE(left_out, std::int64_t(3));
    QVERIFY(parseMapNames(R"({"data":{"map_lists":[{"map_id":"1"}]}})", &left_out));
    QCOMPARE(left_out, std::int64_t(0));
    const auto read = parseTopology(
        R"({"data":{"points":[{"point_id":1}],"paths":[{},{}],"regions":[{"id":4}]}})", nullptr);
    namespace fault = robot::aimdk::fault;
    const std::vector<Fault> notes{{fault::PathsNotShown, {std::int64_t(2)}},
                                   {fault::RegionsNotShown, {std::int64_t(1)}},
                                   {robot::wire::fault::PointsUnplaced, {std::int64_t(1)}}};
    QCOMPARE(read->list.notes, notes);
    QCOMPARE(parseTopology(R"({"data":{"paths":[{}]}})", nullptr)->list.notes.size(), std::size_t(1));
    QVERIFY(parseTopology(R"({"data":{"points":[],"paths":[],"regions":[]}})", nullptr)->list.notes.empty());
  }

  void theMeaningOfTheResolutionIsToldByThePoints() {
    ParsedMap frame;
    frame.resolution = 20;
    frame.u0 = frame.v0 = 100;
    const auto at = [&](double scale, double spread_m, int count) {
      std::string rows;
      for (int i = 1; i <= count; ++i) {
        const double at_m = i * spread_m;
        rows += (i > 1 ? "," : "") + ("{\"point_id\":" + std::to_string(i)) +
                ",\"pixel_pose\":{\"position\":{\"u\":" + std::to_string(100 + at_m * scale) +
                ",\"v\":" + std::to_string(100 - at_m * scale) +
                "}},\"pose\":{\"position\":{\"x\":" + std::to_string(at_m) +
                ",\"y\":" + std::to_string(at_m) + "}}}";
      }
      return parseTopology("{\"data\":{\"points\":[" + rows + "]}}", &frame)->scale;
    };
    const auto is = [](const Scale& scale, double pixels_per_m, bool certain, const FaultCode& note) {
      return scale.pixels_per_m == pixels_per_m && scale.certain == certain && scale.note.code == note;
    };
    namespace fault = robot::aimdk::fault;
    QVERIFY(is(at(20, 5, 4), 20, true, {}));
    QVERIFY(is(at(5, 5, 1), 5, true, fault::ScaleInCentimetres));
    QVERIFY(is(at(5, 5, 4), 5, true, fault::ScaleInCentimetres));
    QVERIFY(is(at(20, 0.01, 3), 20, false, fault::ScaleUntold));
    QVERIFY(is(at(20, 5, 0), 20, false, fault::ScaleUntold));
    QVERIFY(is(at(50, 5, 1), 20, false, fault::ScaleUntold));  // it may have been moved
    QVERIFY(is(at(50, 5, 4), 20, false, fault::ScaleFitsNeither));
    frame.resolution = 10;  // the same either way
    QVERIFY(is(at(10, 0.01, 3), 10, true, {}));
    // Without a point nothing tells that the picture lies there, and points that fit nowhere are told.
    QVERIFY(is(at(10, 5, 0), 10, false, {}));
    QVERIFY(is(at(50, 5, 4), 10, false, fault::ScaleFitsNeither));
    QVERIFY(!untoldScale(frame).note.any());
  }

  void aMapIsPlacedAsItsResolutionIsRead() {
    auto parsed = parseWholeMap(
        wholeMap(R"("width":2898,"height":2603,"resolution":5,"origin_x":1274,"origin_y":1371,)"), kKey);
    QCOMPARE(parsed->map.grid.resolution_m, 0.2);
    place(*parsed, {20, true, {robot::aimdk::fault::ScaleInCentimetres, {5.0}}});
    QCOMPARE(parsed->map.grid.resolution_m, 0.05);
    QCOMPARE(parsed->map.grid.origin.x_m, -1274 / 20.0);
    QCOMPARE(parsed->map.notes.size(), std::size_t(1));
  }

  void whoKnowsTheNewerServicesIsToldByAnAnswer() {
    QVERIFY(knowsService(200, R"({"header":{"code":"0"},"data":{}})"));
    QVERIFY(knowsService(200, R"({"header":{"code":"3001","msg":"not mapping"}})"));
    QVERIFY(knowsService(200, R"({"data":{"map_data":"AA=="}})"));
    QVERIFY(!knowsService(404, R"({"header":{"code":"0"}})"));
    QVERIFY(!knowsService(200, R"({"error":{"code":-32601}})"));
    QVERIFY(!knowsService(200, R"({"header":{"code":404}})"));
    QVERIFY(!knowsService(200, "<html>"));
    QVERIFY(*parseRealtimeMap(R"({"header":{"code":"0"},"data":{"map_data":"AA=="}})"));
    QVERIFY(!*parseRealtimeMap(R"({"header":{"code":"0"},"data":{"map_data":""}})"));
    QVERIFY(!*parseRealtimeMap(R"({"header":{"code":"3001"}})"));
  }

  void changesAreAcceptedOrRefusedInAHeader() {
    QVERIFY(parseAcceptance(R"({"header":{"code":"0"}})"));
    QVERIFY(parseAcceptance(R"({"data":{}})"));
    const auto refused = parseAcceptance(R"({"header":{"code":"1006","msg":"in use"}})");
    QVERIFY(!refused && refused.error().refused);
    QCOMPARE(refused.error().code, std::string("1006"));
    QCOMPARE(refused.error().detail, std::string("in use"));
    QVERIFY(!parseAcceptance("<html>").error().refused);
    QCOMPARE(createdPoint(R"({"header":{"code":"0"},"data":{"point_id":12}})"), std::string("12"));
    QVERIFY(createdPoint(R"({"header":{"code":"0"},"data":{}})").empty());
  }

  void aPointGoesBackWithWhatIsNotKnownOfIt() {
    map::Waypoint point;
    point.id = "7";
    point.name = "Dock 2";
    point.type = "T";
    const std::string pixels = R"({"angle":4.5,"position":{"u":1,"v":2}})";
    point.source =
        R"({"point_id":7,"name":"Dock","point_type":"T","speed":3,"pose":{"x":0},"pixel_pose":{}})";
    point.source.replace(point.source.rfind("{}"), 2, pixels);
    const QByteArray sent = pointRequest("1764059676131999999", point, std::nullopt);
    QVERIFY2(sent.contains("\"map_id\":1764059676131999999,\"point\":"), sent.constData());
    QVERIFY2(sent.contains("\"point_id\":7,\"name\":\"Dock 2\",\"pixel_pose\":" +
                           QByteArray::fromStdString(pixels) + ",\"point_type\":\"T\",\"speed\":3"),
             sent.constData());
    QVERIFY(!QJsonDocument::fromJson(sent).isNull() && !sent.contains("\"pose\""));
    const QByteArray moved = pointRequest("17", point, PixelPose{5, 6});
    QVERIFY2(moved.contains(R"({"angle":4.5,"position":{"u":5,"v":6}})"), moved.constData());
    QVERIFY(pointRequest("17", point, PixelPose{5, 6, -90}).contains("\"angle\":-90,"));
    point.source.clear();  // it is new
    QVERIFY(pointRequest("17", point, PixelPose{5, 6, 0}).contains("\"point_id\":0,"));
    QVERIFY(pointRequest("x", point, PixelPose{5, 6, 0}).contains("\"map_id\":\"x\","));
    // An id goes back as it came: as a text if it was one, also where it looks like a number.
    for (const char* id : {"dock-a", "7", "007"}) {
      point.id = id;
      point.source = "{\"point_id\":\"" + point.id + "\",\"name\":\"Dock\"}";
      const QByteArray whole = pointRequest("17", point, PixelPose{5, 6, 0});
      const QJsonObject asked = QJsonDocument::fromJson(whole).object()[QLatin1String("point")].toObject();
      QCOMPARE(asked[QLatin1String("point_id")], QJsonValue(QString::fromLatin1(id)));
    }
  }

  void headingsAreRadiansUpToAFullTurnAndDegreesBeyond() {
    QCOMPARE(*parseTopology(point("1506", "1.5"), nullptr)->list.points[0].yaw_rad, -1.5);
    QCOMPARE(*parseTopology(point("1506", "\"90\""), nullptr)->list.points[0].yaw_rad,
             geometry::radiansFromDegrees(-90));
    QVERIFY(!parseTopology(point("1506", "null"), nullptr)->list.points[0].yaw_rad);
  }

  void oneAngleInDegreesMakesAllOfThemDegrees() {
    const auto list = parseTopology(
        "{\"data\":{\"points\":[{\"pixel_pose\":{\"angle\":5},\"pose\":{\"position\":{\"x\":0,\"y\":0}}},"
        "{\"pixel_pose\":{\"angle\":-90},\"pose\":{\"position\":{\"x\":0,\"y\":0}}}]}}",
        nullptr);
    QCOMPARE(*list->list.points.at(0).yaw_rad, geometry::radiansFromDegrees(-5));
    QCOMPARE(*list->list.points.at(1).yaw_rad, geometry::radiansFromDegrees(90));
  }

  void anOrientationInTheWorldCounts() {
    const auto list = parseTopology(
        "{\"data\":{\"points\":[{\"pixel_pose\":{\"angle\":5},\"pose\":{\"position\":{\"x\":0,\"y\":0},"
        "\"orientation\":{\"x\":0,\"y\":0,\"z\":1,\"w\":1}}}]}}",
        nullptr);
    QVERIFY(map::sameHeading(list->list.points.at(0).yaw_rad, geometry::radiansFromDegrees(90)));
  }

  void pointsWithoutAPlaceAreCountedOnly() {
    const auto list =
        parseTopology(R"({"data":{"points":[{"point_id":1},7,{"pose":{"position":{"x":1}}}]}})", nullptr);
    QVERIFY(list->list.points.empty());
    QCOMPARE(list->list.notes.size(), std::size_t(1));
  }
};

}  // namespace test_aimdk_parse

MAPWRIGHT_TEST(test_aimdk_parse, AimdkParseTest, Core)
#include "test_aimdk_parse.moc"
