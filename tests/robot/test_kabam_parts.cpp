// KABAM's map manager: what its messages say, what its codes mean, and in which order changes are asked for.
#include <cmath>
#include <random>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "map/waypoint.h"
#include "robot/ros/faults.h"
#include "robot/ros/kabam_messages.h"
#include "robot/ros/kabam_plan.h"
#include "robot/ros/kabam_state.h"
#include "ros_messages.h"
#include "sentences/failure_sentence.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_kabam_parts {

using namespace mapwright;
using namespace mapwright::robot::ros;
using robot::StoredWaypoints;
using robot::WaypointChange;
using robot::WaypointRequest;
using test::byJson;
using test::Sent;

namespace {

map::Waypoint point(const char* id, const char* name, double x = 0) {
  map::Waypoint point;
  point.id = id;
  point.name = name;
  point.position_m = {x, 0};
  point.yaw_rad = 0;
  return point;
}

WaypointChange change(const map::Waypoint& before, map::Waypoint after) {
  return {before.id, before, std::move(after)};
}

map::Waypoint called(map::Waypoint point, const char* name) {
  point.name = name;
  return point;
}

StoredWaypoints list(std::vector<map::Waypoint> points) {
  StoredWaypoints stored;
  stored.points = std::move(points);
  stored.revision = "r";
  return stored;
}

/// "rename_waypoint a>b"
QStringList told(const std::vector<WaypointRequest>& requests) {
  QStringList lines;
  for (const WaypointRequest& request : requests) {
    const WaypointChange& change = request.changes.front();
    const auto name = [](const std::optional<map::Waypoint>& point) {
      return point ? QString::fromStdString(point->name) : QStringLiteral("-");
    };
    lines << QStringLiteral("%1 %2>%3")
                 .arg(QLatin1String(nameOf(serviceOf(change))), name(change.before), name(change.after));
  }
  return lines;
}

/// The list after the requests; a name that is used twice on the way is an error.
tl::expected<std::map<std::string, map::Waypoint>, QString> carriedOut(
    const StoredWaypoints& now, const std::vector<WaypointRequest>& requests) {
  std::map<std::string, map::Waypoint> points;
  for (const map::Waypoint& one : now.points) points[one.id] = one;
  for (const WaypointRequest& request : requests) {
    if (request.changes.size() != 1) return tl::make_unexpected(QStringLiteral("not one change"));
    const WaypointChange& change = request.changes.front();
    const auto held = points.find(change.id);
    if (change.before && (held == points.end() || !(held->second == *change.before)))
      return tl::make_unexpected(QStringLiteral("its base is another"));
    if (!change.after) {
      points.erase(change.id);
      continue;
    }
    for (const auto& [id, other] : points) {
      if (id != change.id && other.name == change.after->name)
        return tl::make_unexpected(
            QStringLiteral("%1 is called twice").arg(QString::fromStdString(other.name)));
    }
    points[change.id] = *change.after;
  }
  return points;
}

const char* const kRow =
    R"({"name":"Dock","id":"w1","frame_id":"map","map_id":"m1","waypoint_tags":["localisation"],"extra":7,)"
    R"("pose":{"position":{"x":1.5,"y":-2,"z":0.25},"orientation":{"x":0,"y":0,"z":0.7071067811865475,"w":0.7071067811865476}}})";

QJsonObject object(const QByteArray& json) { return QJsonDocument::fromJson(json).object(); }

}  // namespace

class KabamPartsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aWaypointIsReadWhole() {
    const Sent sent = byJson(QByteArray(R"({"waypoints":[)") + kRow + "]}");
    const auto stored = readWaypoints(sent.msg, "m1", "map");
    QVERIFY(stored && stored->points.size() == 1 && stored->notes.empty());
    const map::Waypoint& read = stored->points.front();
    QCOMPARE(read.id, std::string("w1"));
    QCOMPARE(read.position_m, Eigen::Vector2d(1.5, -2));
    QVERIFY(std::abs(*read.yaw_rad - M_PI / 2) < 1e-9);
    QCOMPARE(read.tags, std::vector<std::string>{"localisation"});
  }

  void twoHundredThousandWaypointsAreAllThere() {
    constexpr int kCount = 200'000;
    QByteArray text = R"({"waypoints":[)";
    for (int i = 0; i < kCount; ++i) {
      const QByteArray n = QByteArray::number(i);
      text +=
          "{\"name\":\"n" + n + "\",\"id\":\"w" + n +
          "\",\"frame_id\":\"map\",\"map_id\":\"m1\",\"waypoint_tags\":[],\"pose\":{\"position\":{\"x\":" +
          n + ",\"y\":0,\"z\":0},\"orientation\":{\"x\":0,\"y\":0,\"z\":0,\"w\":1}}},";
    }
    text.chop(1);
    const auto stored = readWaypoints(byJson(text + "]}").msg, "m1", "map");
    QVERIFY(stored);
    QCOMPARE(stored->points.size(), std::size_t(kCount));
    QVERIFY(stored->notes.empty());
    QCOMPARE(stored->points.back().position_m.x(), double(kCount - 1));
  }

  void whatIsNotChangedGoesBackAsItCame() {
    const Sent sent = byJson(QByteArray(R"({"waypoints":[)") + kRow + "]}");
    map::Waypoint read = readWaypoints(sent.msg, "m1", "map")->points.front();
    QCOMPARE(object(waypointJson(read, read.id, "m1", "map")), object(kRow));
    read.position_m.x() = 3;
    const QJsonObject moved = object(waypointJson(read, read.id, "m1", "map"));
    QCOMPARE(moved[QLatin1String("pose")][QLatin1String("position")][QLatin1String("x")].toDouble(), 3.0);
    QCOMPARE(moved[QLatin1String("pose")][QLatin1String("position")][QLatin1String("z")].toDouble(), 0.25);
    QCOMPARE(moved[QLatin1String("pose")][QLatin1String("orientation")],
             object(kRow)[QLatin1String("pose")][QLatin1String("orientation")]);
    QCOMPARE(moved[QLatin1String("extra")].toInt(), 7);
  }

  // Without a map nobody says which frame is its own. It is kept, or nothing could be done before a map
  // comes.
  void aFrameThatNoMapNamesIsTold() {
    QByteArray row = kRow;
    row.replace("\"frame_id\":\"map\"", "\"frame_id\":\"odom\"");
    QVERIFY(row != kRow);
    const QByteArray list = "{\"waypoints\":[" + row + "]}";
    const auto stored = readWaypoints(byJson(list).msg, "m1", {});
    QVERIFY(stored && stored->points.size() == 1);
    QCOMPARE(stored->notes, std::vector<Fault>({{robot::ros::fault::WaypointFrameUnknown,
                                                 {stored->points.front().name, "odom"}}}));
    QVERIFY(readWaypoints(byJson(list).msg, "m1", "odom")->notes.empty());
    QVERIFY(readWaypoints(byJson(list).msg, "m1", "map")->points.empty());
  }

  void waypointsThatAreLeftOutAreAllCounted() {
    QByteArray row = kRow;
    row.replace("\"frame_id\":\"map\"", "\"frame_id\":\"odom\"");
    const QByteArray list = "{\"waypoints\":[" + (row + ',').repeated(23) + row + "]}";
    const auto stored = readWaypoints(byJson(list).msg, "m1", "map");
    QVERIFY(stored && stored->points.empty());
    QCOMPARE(stored->notes.size(), std::size_t(21));
    QCOMPARE(sentences::sentenceOf(stored->notes.back()), QStringLiteral("4 more waypoints were left out."));
  }

  void aZeroOrientationIsShownUprightAndLeftAlone() {
    QByteArray row = kRow;
    row.replace("0.7071067811865475", "0").replace("0.7071067811865476", "0");
    const Sent sent = byJson("{\"waypoints\":[" + row + "]}");
    auto stored = readWaypoints(sent.msg, "m1", "map");
    QVERIFY(stored && stored->notes.size() == 1);
    QCOMPARE(stored->notes.front().code, robot::ros::fault::WaypointTurnIsZero);
    QCOMPARE(stored->zero_turns, std::set<std::string>{stored->points.front().id});
    map::Waypoint read = stored->points.front();
    QCOMPARE(read.yaw_rad, std::optional(0.0));
    const auto w = [](const QByteArray& json) {
      return object(json)[QLatin1String("pose")][QLatin1String("orientation")][QLatin1String("w")].toDouble();
    };
    QCOMPARE(w(waypointJson(read, read.id, "m1", "map")), 0.0);
    read.yaw_rad = 0.5;  // somebody has turned it
    QVERIFY(w(waypointJson(read, read.id, "m1", "map")) > 0.9);
  }

  void everyZeroOrientationIsKnownHoweverManyAreToldOf() {
    QByteArray zero = kRow;
    zero.replace("0.7071067811865475", "0").replace("0.7071067811865476", "0");
    const QByteArray id = QByteArray::fromStdString(
        readWaypoints(byJson("{\"waypoints\":[" + zero + "]}").msg, "m1", "map")->points.front().id);
    QByteArray rows = QByteArray(kRow);
    for (int i = 0; i < 100; ++i) {
      QByteArray row = zero;
      row.replace("\"" + id + "\"", "\"zero-" + QByteArray::number(i) + "\"");
      rows += "," + row;
    }
    const Sent sent = byJson("{\"waypoints\":[" + rows + "]}");
    const auto stored = readWaypoints(sent.msg, "m1", "map");
    QVERIFY(stored && stored->points.size() == 101);
    QCOMPARE(stored->zero_turns.size(), std::size_t(100));
    QVERIFY(!stored->zero_turns.contains(id.toStdString()));
    QVERIFY(stored->notes.size() < 100);
  }

  void aNewWaypointIsWhole() {
    map::Waypoint fresh = point("", "New", 2);
    fresh.tags = {"a"};
    const QJsonObject message = object(waypointJson(fresh, {}, "m1", "world"));
    QCOMPARE(message[QLatin1String("id")].toString(), QString());
    QVERIFY(message.contains(QLatin1String("id")));
    QCOMPARE(message[QLatin1String("frame_id")].toString(), QStringLiteral("world"));
    QCOMPARE(message[QLatin1String("map_id")].toString(), QStringLiteral("m1"));
    QCOMPARE(message[QLatin1String("pose")][QLatin1String("orientation")][QLatin1String("w")].toDouble(),
             1.0);
    QVERIFY(
        message[QLatin1String("pose")][QLatin1String("position")].toObject().contains(QLatin1String("z")));
  }

  void whatCannotBeUsedIsLeftOutAndTold() {
    const Sent sent = byJson(
        R"({"waypoints":[{"id":"a","name":"A","pose":{"position":{"x":null,"y":1,"z":0}}},)"
        R"({"id":"","name":"B","pose":{"position":{"x":1,"y":1,"z":0},"orientation":{"w":1}}},)"
        R"({"id":"c","name":"C","frame_id":"odom","pose":{"position":{"x":1,"y":1},"orientation":{"w":1}}},)"
        R"({"id":"d","name":"D","pose":{"position":{"x":1,"y":1},"orientation":{"w":1}}},)"
        R"({"id":"d","name":"E","pose":{"position":{"x":1,"y":1},"orientation":{"w":1}}},)"
        R"({"id":"f","name":"F","map_id":"other","pose":{"position":{"x":1,"y":1},"orientation":{"w":1}}}]})");
    const auto stored = readWaypoints(sent.msg, "m1", "map");
    QVERIFY(stored);
    QCOMPARE(stored->points.size(), std::size_t(1));
    QCOMPARE(stored->points.front().name, std::string("D"));
    QCOMPARE(stored->notes.size(), std::size_t(4));
    QVERIFY(!readWaypoints(byJson(R"({"waypoints":7})").msg, "m1", "map"));
  }

  void mapsAreListedOnceAndTheCurrentOneIsMarked() {
    KabamState book;
    const auto give = [&](const char* topic, const char* text) {
      const Sent sent = byJson(text);
      return book.apply(topic, sent.frame, sent.msg);
    };
    give(
        "/map_manager/map_list",
        R"({"maps":[{"map_id":"1","map_name":"a","map_label":"Hall"},{"map_id":"2","map_name":"b","map_label":""},)"
        R"({"map_id":"3","map_name":"c","map_label":"Old"},{"map_name":"nameless"}]})");
    QVERIFY(!book.listed());
    give("/map_manager/archived_map_list", R"({"maps":[{"map_id":"3","map_name":"c","map_label":"Old"}]})");
    QVERIFY(
        give("/map_manager/current_map_info", R"({"map_id":"2","map_name":"b","map_manager_state":"ACTIVE"})")
            .maps);
    QVERIFY(book.listed());
    QVERIFY(!give("/map", "{}").own);
    const auto entries = book.entries();
    QCOMPARE(entries.size(), std::size_t(3));
    QCOMPARE(entries[0].name, std::string("Hall"));
    QCOMPARE(entries[1].name, std::string("b"));
    QVERIFY(entries[1].is_current && !entries[0].is_current);
    QVERIFY(entries[2].is_archived && !entries[0].is_archived);
    QCOMPARE(book.mapInfo().uid, std::string("2"));
  }

  // The order of calls.

  void eachChangeIsOneCall() {
    const map::Waypoint a = point("1", "a"), b = point("2", "b"), c = point("3", "c");
    map::Waypoint moved = b, tagged = c;
    moved.position_m.x() = 5;
    tagged.tags = {"free"};
    const auto requests = planWaypoints(
        list({a, b, c}),
        {change(a, called(a, "x")), change(b, moved), change(c, tagged), {"n", {}, point("n", "new")}});
    QCOMPARE(
        told(requests),
        (QStringList{QStringLiteral("rename_waypoint a>x"), QStringLiteral("create_waypoint ->new"),
                     QStringLiteral("reposition_waypoint b>b"), QStringLiteral("reposition_waypoint c>c")}));
    QVERIFY(planWaypoints(list({a}), {}).empty());
  }

  void whatIsMovedAndRenamedTakesTwoCallsAndItsTagsGoLast() {
    const map::Waypoint a = point("1", "a");
    map::Waypoint both = called(a, "b");
    both.position_m.x() = 4;
    both.tags = {"t"};
    const auto requests = planWaypoints(list({a}), {change(a, both)});
    QCOMPARE(requests.size(), std::size_t(2));
    QVERIFY(requests[0].changes[0].after->tags.empty());
    QCOMPARE(requests[0].changes[0].after->position_m.x(), 0.0);
    QVERIFY(*requests[1].changes[0].after == both);
  }

  void whatDiffersByRoundingTakesNoCall() {
    map::Waypoint a = point("1", "a"), b = point("2", "b");
    a.yaw_rad = b.yaw_rad = 0.5;
    map::Waypoint rounded = a, renamed = called(b, "c");
    rounded.yaw_rad = renamed.yaw_rad = 0.5000000000000001;
    rounded.position_m.x() = std::nextafter(a.position_m.x(), 9);
    QVERIFY(planWaypoints(list({a}), {change(a, rounded)}).empty());
    QCOMPARE(told(planWaypoints(list({b}), {change(b, renamed)})),
             QStringList{QStringLiteral("rename_waypoint b>c")});
  }

  // Yaw goes as a quaternion and comes back: never another heading.
  void headingsComeBackAsTheyWent() {
    std::mt19937 dice(1);
    for (int i = 0; i < 2000; ++i) {
      map::Waypoint sent = point("1", "a");
      sent.yaw_rad = std::uniform_real_distribution<double>(-3.2, 3.2)(dice);
      sent.position_m.x() = std::uniform_real_distribution<double>(-1e4, 1e4)(dice);
      const Sent message = byJson("{\"waypoints\":[" + waypointJson(sent, "1", "m1", "map") + "]}");
      const auto stored = readWaypoints(message.msg, "m1", "map");
      QVERIFY(stored && stored->points.size() == 1);
      const map::Waypoint& came = stored->points.front();
      QVERIFY(map::samePlace(sent.position_m, came.position_m) &&
              map::sameHeading(sent.yaw_rad, came.yaw_rad));
      QVERIFY(planWaypoints(*stored, {change(came, sent)}).empty());
    }
  }

  void namesThatAreExchangedGoByWayOfOneThatNobodyHas() {
    const map::Waypoint a = point("1", "a"), b = point("2", "b"), t = point("3", "a ~1");
    const auto now = list({a, b, t});
    const auto requests = planWaypoints(now, {change(a, called(a, "b")), change(b, called(b, "a"))});
    QCOMPARE(requests.size(), std::size_t(3));
    const auto after = carriedOut(now, requests);
    QVERIFY2(after, after ? "" : qPrintable(after.error()));
    QCOMPARE(after->at("1").name, std::string("b"));
    QCOMPARE(after->at("2").name, std::string("a"));
  }

  void ringsAndChainsOfNamesComeOut() {
    std::vector<map::Waypoint> points;
    std::vector<WaypointChange> changes;
    for (int i = 0; i < 6; ++i)
      points.push_back(point(qPrintable(QString::number(i)), qPrintable(QString::number(i))));
    // 0>1>2>0 is a ring; 3>4>5>free a chain.
    const char* names[] = {"1", "2", "0", "4", "5", "free"};
    for (std::size_t i = 0; i < 6; ++i) changes.push_back(change(points[i], called(points[i], names[i])));
    const auto requests = planWaypoints(list(points), changes);
    QCOMPARE(requests.size(), std::size_t(7));
    const auto after = carriedOut(list(points), requests);
    QVERIFY2(after, after ? "" : qPrintable(after.error()));
    for (std::size_t i = 0; i < 6; ++i) QCOMPARE(after->at(std::to_string(i)).name, std::string(names[i]));
  }

  void aNameIsFreeBeforeSomebodyElseGetsIt() {
    const map::Waypoint a = point("1", "a"), b = point("2", "b");
    const auto now = list({a, b});
    const auto requests = planWaypoints(
        now,
        {{"n", {}, point("n", "a")}, change(b, called(b, "c")), {"m", {}, point("m", "b")}, {"1", a, {}}});
    QVERIFY(carriedOut(now, requests));
    QCOMPARE(told(requests).first(), QStringLiteral("delete_waypoint a>-"));
  }

  // Codes.

  void everyCodeHasASentenceOfItsOwn() {
    QSet<QString> sentences;
    int failures = 0;
    const auto check = [&](const std::optional<map::Failure>& failure) {
      QVERIFY(failure);
      ++failures;
      const QString sentence = QString::fromStdString(sentences::sentenceOf(*failure));
      QVERIFY2(sentence.endsWith(QLatin1Char('.')), qPrintable(sentence));
      sentences << sentence;
    };
    const auto values = [](int code) { return byJson("{\"result\":" + QByteArray::number(code) + "}"); };
    const map::Subject places = map::placesOf({map::MapKind::Stored, "m"});
    for (const int good : {0, 3, 5}) QVERIFY(!resultOf("create_waypoint", values(good).msg, places, "x"));
    for (const int bad : {1, 2, 4, 6, 17}) check(resultOf("create_waypoint", values(bad).msg, places, "x"));
    QCOMPARE(sentences.size(), failures);
    sentences.clear();
    failures = 0;
    for (const int good : {0, 1}) QVERIFY(!resultOf("rename_map", values(good).msg, places));
    for (const int bad : {2, 3, 4, 99}) check(resultOf("rename_map", values(bad).msg, places));
    QCOMPARE(sentences.size(), failures);
    sentences.clear();
    failures = 0;
    QVERIFY(!resultOf("load_map", values(0).msg, places));
    for (const int bad : {1, 2, 3, 4, 5}) check(resultOf("load_map", values(bad).msg, places));
    QCOMPARE(sentences.size(), failures);
    const auto none = resultOf("load_map", byJson("{}").msg, places);
    QVERIFY(none && none->kind == map::FailureKind::MalformedAnswer && none->applied == map::Applied::Maybe);
  }

  void anUnknownCodeShowsItsNumber() {
    const auto failure = resultOf("create_waypoint", byJson(R"({"result":17})").msg, {}, "x");
    QCOMPARE(failure->robot_code, std::string("17"));
    QVERIFY(QString::fromStdString(sentences::sentenceOf(*failure)).contains(QLatin1String("17")));
    QCOMPARE(failure->applied, map::Applied::Maybe);
  }
};

}  // namespace test_kabam_parts

MAPWRIGHT_TEST(test_kabam_parts, KabamPartsTest, Core)
#include "test_kabam_parts.moc"
