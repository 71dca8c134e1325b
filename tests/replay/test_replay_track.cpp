// Where the robot was, in pieces across which nothing is drawn or measured.
#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "generated_bag.h"
#include "replay/digest.h"
#include "replay/track.h"
#include "replay/track_file.h"
#include "test_program.h"

namespace test_replay_track {

using namespace mapwright;
using namespace mapwright::replay;

namespace {

constexpr double kStart = 1'717'405'200.5;

map::TrackedPose at(double x_m, double yaw_rad = 0) { return {{x_m, 2, yaw_rad}}; }

robot::BagChunkPtr answerOf(double from_s, double until_s, const Bag& bag) {
  auto chunk = std::make_shared<robot::BagChunk>();
  chunk->from_s = from_s;
  chunk->until_s = until_s;
  for (const Recorded& each : bag) {
    if (each.stamp_s < from_s || each.stamp_s >= until_s) continue;
    robot::BagMessage message;
    message.message = {each.message, each.stamp_s, {}, each.topic};
    message.known = true;
    chunk->messages.push_back(message);
  }
  return chunk;
}

/// As if it had been read in ranges of two seconds.
std::map<Tick, Digest> digestsOf(const Bag& bag, double seconds) {
  std::map<Tick, Digest> digests;
  for (double s = 0; s < seconds; s += 2)
    digests[tickOf(kStart + s)] = digestOf(inRange(answerOf(kStart + s, kStart + s + 2, bag)));
  return digests;
}

Recorded say(double s, const char* topic, map::TopicMessage message) {
  return {kStart + s, topic, std::move(message), false, true, {}};
}

/// A metre a second; the stamps are exact.
Bag straight(int seconds) {
  Bag bag;
  for (int i = 0; i < seconds * 8; ++i) bag.push_back(say(i / 8.0, "/tracked_pose", at(i / 8.0)));
  return bag;
}

/// Three pieces, the last one of a single sample.
std::vector<TrackPoint> written() {
  return {{kStart, {1.25, -2, 0.5}, 0, 0, 0},
          {kStart + 0.5, {1.5, -2, 3.1}, 0, 0, 0},
          {kStart + 9, {8, 3, -3.1}, 0, 0, 1},
          {kStart + 9.5, {8.125, 3, 0}, 0, 0, 1},
          {kStart + 20, {0, 0, 0}, 0, 0, 2}};
}

void sortByTime(Bag& bag) {
  std::stable_sort(bag.begin(), bag.end(),
                   [](const Recorded& a, const Recorded& b) { return a.stamp_s < b.stamp_s; });
}

map::SlamStatus quality(int value) {
  map::SlamStatus slam;
  slam.position_quality = value;
  return slam;
}

map::MapInfo onMap(const char* uid) {
  map::MapInfo info;
  info.uid = uid;
  return info;
}

}  // namespace

class ReplayTrackTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStraightWayIsOnePieceWithItsSpeed() {
    const auto track = trackOf(digestsOf(straight(10), 10));
    QCOMPARE(track.size(), std::size_t(80));
    for (const TrackPoint& point : track) {
      QCOMPARE(point.piece, std::size_t(0));
      QCOMPARE(point.speed_m_s, 1.0);
    }
    QVERIFY(std::is_sorted(track.begin(), track.end(),
                           [](const TrackPoint& a, const TrackPoint& b) { return a.stamp_s < b.stamp_s; }));
  }

  void aJumpEndsAPieceAndHasNoSpeed() {
    Bag bag = straight(10);
    for (Recorded& each : bag) {
      if (each.stamp_s >= kStart + 5) std::get<map::TrackedPose>(each.message).pose.y_m += 40;
    }
    const auto track = trackOf(digestsOf(bag, 10));
    QCOMPARE(track[39].piece, std::size_t(0));
    QCOMPARE(track[40].piece, std::size_t(1));
    for (const TrackPoint& point : track) QCOMPARE(point.speed_m_s, 1.0);
  }

  void aWayThatNobodyHeardOfEndsAPiece() {
    // As fast as ever, but for six seconds that are not in the bag.
    Bag bag = straight(20);
    std::erase_if(
        bag, [](const Recorded& each) { return each.stamp_s >= kStart + 7 && each.stamp_s < kStart + 13; });
    const auto track = trackOf(digestsOf(bag, 20));
    QCOMPARE(track.size(), std::size_t(112));
    QCOMPARE(track[55].piece, std::size_t(0));
    QCOMPARE(track[56].piece, std::size_t(1));
    QCOMPARE(track.back().piece, std::size_t(1));
    for (const TrackPoint& point : track) QCOMPARE(point.speed_m_s, 1.0);
  }

  void whoOnlyStoodStillGoesOnInTheSamePiece() {
    Bag bag;
    for (int i = 0; i < 8; ++i) bag.push_back(say(i / 8.0, "/tracked_pose", at(i / 8.0)));
    for (int i = 0; i < 8; ++i) bag.push_back(say(30 + i / 8.0, "/tracked_pose", at(1 + i / 8.0)));
    const auto track = trackOf(digestsOf(bag, 32));
    QCOMPARE(track.size(), std::size_t(16));
    QCOMPARE(track.back().piece, std::size_t(0));
  }

  void anotherMapAndAnotherSessionEndAPiece() {
    Bag bag = straight(10);
    map::SubmapList first, second;
    first.uuid = "first";
    second.uuid = "second";
    bag.push_back(say(0.05, "/map/info", onMap("a")));
    bag.push_back(say(0.06, "/submap_list", first));
    bag.push_back(say(3.05, "/map/info", onMap("a")));  // the same said again
    bag.push_back(say(4.05, "/map/info", onMap("b")));
    bag.push_back(say(7.05, "/submap_list", second));
    sortByTime(bag);
    const auto track = trackOf(digestsOf(bag, 10));
    QCOMPARE(track.size(), std::size_t(80));
    QCOMPARE(track[32].piece, std::size_t(0));
    QCOMPARE(track[33].piece, std::size_t(1));
    QCOMPARE(track[57].piece, std::size_t(2));
    QCOMPARE(track.back().piece, std::size_t(2));
  }

  void whatHasNotBeenReadIsNotBridged() {
    auto digests = digestsOf(straight(10), 10);
    digests.erase(tickOf(kStart + 4));
    const auto track = trackOf(digests);
    QCOMPARE(track.size(), std::size_t(64));
    QCOMPARE(track[31].piece, std::size_t(0));
    QCOMPARE(track[32].piece, std::size_t(1));
  }

  void theQualityIsThatSaidLast() {
    Bag bag = straight(10);
    bag.push_back(say(2.05, "/slam/state", quality(10)));
    bag.push_back(say(5.05, "/slam/state", quality(1)));
    sortByTime(bag);
    const auto track = trackOf(digestsOf(bag, 10));
    QCOMPARE(track[10].quality, 0);
    QCOMPARE(track[24].quality, 10);
    QCOMPARE(track[48].quality, 1);
  }

  void itMakesNoDifferenceInWhichRangesItWasRead() {
    BagWish wish;
    wish.messages = 1500;
    wish.duplicate_stamps = true;
    Bag bag = makeBag(wish);
    const double end_s = bag.back().stamp_s + 1;
    const auto whole = trackOf({{0, digestOf(inRange(answerOf(wish.start_s, end_s, bag)))}});
    std::map<Tick, Digest> parts;
    for (double s = wish.start_s; s < end_s; s += 7)
      parts[tickOf(s)] = digestOf(inRange(answerOf(s, s + 7, bag)));
    QVERIFY(whole.size() > 500);
    QVERIFY(whole == trackOf(parts));
  }

  void csvHasARowForEachSample() {
    const std::string text = csvOf(within(trackOf(digestsOf(straight(10), 10)), kStart + 1, kStart + 1.25));
    QCOMPARE(text, std::string("stamp_s,x_m,y_m,yaw_rad,speed_m_s,quality,piece,map\n"
                               "1717405201.500000,1.000000,2.000000,0.000000000,1.000000,0,0,0\n"
                               "1717405201.625000,1.125000,2.000000,0.000000000,1.000000,0,0,0\n"
                               "1717405201.750000,1.250000,2.000000,0.000000000,1.000000,0,0,0\n"));
  }

  void aMapThatComesBackHasItsNumberAgain() {
    Bag bag = straight(8);
    for (const auto& [at_s, uid] : {std::pair(1.0, "a"), {3.0, "b"}, {5.0, "a"}})
      bag.push_back(say(at_s, "/map/info", onMap(uid)));
    std::stable_sort(bag.begin(), bag.end(),
                     [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
    const auto track = trackOf(digestsOf(bag, 10));
    const auto mapAt = [&](double at_s) {
      return within(track, kStart + at_s, kStart + at_s + 0.3).front().map;
    };
    QCOMPARE(mapAt(0.6), std::size_t(0));
    QCOMPARE(mapAt(4), std::size_t(1));
    QCOMPARE(mapAt(7), std::size_t(0));
    for (const std::string& text : {csvOf(track), geoJsonOf(track)}) {
      const auto read = trackFrom(text);
      QVERIFY(read && read->size() == track.size());
      for (std::size_t i = 0; i < track.size(); ++i) QCOMPARE((*read)[i].map, track[i].map);
    }
  }

  void theUidsAndNamesOfMapsGoThroughAFile() {
    Bag bag = straight(8);
    map::MapInfo hall;
    hall.uid = "u1", hall.name = "Hall \"2\", café";
    bag.push_back(say(1, "/map/info", hall));
    bag.push_back(say(3, "/map/info", onMap("b")));
    bag.push_back(say(5, "/map/info", map::MapInfo()));
    sortByTime(bag);
    const auto digests = digestsOf(bag, 10);
    const std::vector<map::MapIdentity> expected{{"u1", hall.name}, {"b", ""}, {"", ""}};
    QVERIFY(mapsOf(digests) == expected);
    std::vector<map::MapIdentity> maps;
    const auto track = trackOf(digests);
    QVERIFY(trackFrom(geoJsonOf(track, mapsOf(digests)), &maps));
    QVERIFY(maps == std::vector(expected.begin(), expected.begin() + 2));
    maps.clear();
    QVERIFY(trackFrom(csvOf(track), &maps) && maps.empty());
    // Numbers are what anyone writes.
    const std::string far = R"({"features":[{"geometry":{"type":"Point","coordinates":[1,2]},"properties":)"
                            R"({"map":999999999,"map_uid":"x","stamps_s":[1]}}]})";
    QVERIFY(trackFrom(far, &maps) && maps.empty());
  }

  void tumHasQuaternions() {
    const Bag bag{say(0, "/tracked_pose", at(-1.5, 3.141592653589793))};
    QCOMPARE(tumOf(trackOf(digestsOf(bag, 2))),
             std::string("1717405200.500000 -1.500000 2.000000 0 0 0 1.000000000 0.000000000\n"));
  }

  void geoJsonHasALineForEachPiece() {
    Bag bag = straight(4);
    bag.push_back(say(4, "/tracked_pose", at(500)));  // one sample by itself
    const std::string text = geoJsonOf(trackOf(digestsOf(bag, 6)));
    QJsonParseError error;
    const QJsonObject all = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error).object();
    QCOMPARE(error.error, QJsonParseError::NoError);
    const QJsonArray features = all[QStringLiteral("features")].toArray();
    QCOMPARE(features.size(), 2);
    const auto geometry = [&](int i) {
      return features[i].toObject()[QStringLiteral("geometry")].toObject();
    };
    QCOMPARE(geometry(0)[QStringLiteral("type")].toString(), QStringLiteral("LineString"));
    QCOMPARE(geometry(0)[QStringLiteral("coordinates")].toArray().size(), 32);
    QCOMPARE(geometry(1)[QStringLiteral("type")].toString(), QStringLiteral("Point"));
    const QJsonObject properties = features[0].toObject()[QStringLiteral("properties")].toObject();
    QCOMPARE(properties[QStringLiteral("length_m")].toDouble(), 3.875);
    for (const char* list : {"stamps_s", "yaws_rad", "speeds_m_s", "qualities"})
      QCOMPARE(properties[QLatin1String(list)].toArray().size(), 32);
  }

  void nothingIsAnEmptyTrack() {
    QVERIFY(trackOf({}).empty());
    const std::string text = geoJsonOf({});
    QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(text)).isObject());
  }

  void aTrackInAFileIsReadBack_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<bool>("has_pieces");
    const std::vector<TrackPoint> track = written();
    QTest::newRow("csv") << QByteArray::fromStdString(csvOf(track)) << true;
    QTest::newRow("csv with \\r\\n") << QByteArray::fromStdString(csvOf(track)).replace("\n", "\r\n") << true;
    QTest::newRow("geojson") << QByteArray::fromStdString(geoJsonOf(track)) << true;
    QTest::newRow("tum") << QByteArray("# timestamp tx ty tz qx qy qz qw\n") +
                                QByteArray::fromStdString(tumOf(track))
                         << false;
  }
  void aTrackInAFileIsReadBack() {
    QFETCH(QByteArray, file);
    QFETCH(bool, has_pieces);
    const auto read = trackFrom(file.toStdString());
    QVERIFY(read);
    QCOMPARE(read->size(), written().size());
    for (std::size_t i = 0; i < read->size(); ++i) {
      const TrackPoint one = (*read)[i], other = written()[i];
      QVERIFY(std::abs(one.stamp_s - other.stamp_s) < 1e-5);
      QVERIFY(std::abs(one.pose.x_m - other.pose.x_m) < 1e-5 &&
              std::abs(one.pose.y_m - other.pose.y_m) < 1e-5);
      QVERIFY(std::abs(one.pose.yaw_rad - other.pose.yaw_rad) < 1e-6);
      QCOMPARE(one.piece, has_pieces ? other.piece : 0U);
    }
  }

  void whatIsNoTrackIsRefusedWithItsLine_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<int>("line");
    const QByteArray head = "stamp_s,x_m,y_m,yaw_rad,piece\n";
    QTest::newRow("a word") << head + "1,2,3,0,0\n1,x,3,0,0\n" << 3;
    QTest::newRow("cut off") << head + "1,2,3,0,0\n1,2" << 3;
    QTest::newRow("a piece that is none") << head + "1,2,3,0,-1\n" << 2;
    QTest::newRow("no column y") << QByteArray("stamp_s,x_m\n1,2\n") << 1;
    QTest::newRow("other text") << QByteArray("Hello\n") << 1;
    QTest::newRow("tum with seven numbers") << QByteArray("1 2 3 0 0 0 0 1\n1 2 3 0 0 0 1\n") << 2;
    QTest::newRow("other json") << QByteArray("{\"a\":1}") << 0;
    QTest::newRow("broken json") << QByteArray("{\"features\":[{") << 0;
    QTest::newRow("waypoints")
        << QByteArray("{\"features\":[{\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,2]}}]}") << 0;
  }
  void whatIsNoTrackIsRefusedWithItsLine() {
    QFETCH(QByteArray, file);
    QFETCH(int, line);
    const auto read = trackFrom(file.toStdString());
    QVERIFY(!read);
    QCOMPARE(int(read.error()), line);
  }

  void numbersThatAreNoneStayWhatTheyAre() {
    const auto read = trackFrom("stamp_s,x_m,y_m\n1,nan,3\n2,inf,3\n");
    QVERIFY(read && read->size() == 2);
    QVERIFY(std::isnan((*read)[0].pose.x_m) && std::isinf((*read)[1].pose.x_m));
    QVERIFY(trackFrom("") && trackFrom("")->empty());
  }
};

}  // namespace test_replay_track

MAPWRIGHT_TEST(test_replay_track, ReplayTrackTest, Core)
#include "test_replay_track.moc"
