// The picture of a KABAM map, replaced behind a scripted rosbridge server: what is sent, what is shown of it,
// and what may go wrong between the two.
#include <QSignalSpy>
#include <QTest>

#include "robot/ros/faults.h"
#include "robot/ros/kabam_pictures.h"
#include "robot/ros/map_values.h"
#include "robot/ros/ros_robot.h"
#include "robot/wire/picture_bytes.h"
#include "scripted_bridge.h"
#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_kabam_pictures {

using namespace mapwright;
using namespace mapwright::robot;
using map::Applied;
using map::FailureKind;
using std::chrono::milliseconds;
using testing::ScriptedBridge;

namespace {

constexpr const char* kService = "/map_manager/update_map_image";
/// 33 MB as text: more than the system takes at once, and more than a server takes in one frame.
constexpr int kLarge = 5'000;
const map::MapKey kMap{map::MapKind::Stored, "m1"};

QString text(const char* latin) { return QString::fromLatin1(latin); }
QJsonObject json(const QByteArray& bytes) { return QJsonDocument::fromJson(bytes).object(); }

/// Cells from the top row down: -1, 0 .. 100.
struct Cells {
  int width = 0, height = 0;
  std::vector<int> all;
  int& at(int x, int y) { return all[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

Cells room(int width = 40, int height = 30) {
  Cells cells{width, height, std::vector<int>(std::size_t(width) * std::size_t(height), 0)};
  for (int x = 0; x < width; ++x) cells.at(x, 0) = 100;
  for (int y = 0; y < height; ++y) cells.at(width - 1, y) = -1;
  return cells;
}

/// nav_msgs/OccupancyGrid: its first row is the bottom one.
QJsonObject gridOf(Cells cells) {
  QJsonArray data;
  for (int y = cells.height; y-- > 0;) {
    for (int x = 0; x < cells.width; ++x) data << cells.at(x, y);
  }
  const QJsonObject upright{{text("x"), 0}, {text("y"), 0}, {text("z"), 0}, {text("w"), 1}};
  const QJsonObject origin{{text("position"), QJsonObject{{text("x"), 1}, {text("y"), 2}, {text("z"), 0}}},
                           {text("orientation"), upright}};
  return {{text("header"), json(R"({"frame_id":"map","stamp":{"secs":5,"nsecs":0}})")},
          {text("info"), QJsonObject{{text("resolution"), 0.05},
                                     {text("width"), cells.width},
                                     {text("height"), cells.height},
                                     {text("origin"), origin}}},
          {text("data"), data}};
}

/// The same with its cells as bytes, for large ones.
QCborMap packedGridOf(Cells cells) {
  constexpr QCborTag kInt8s{72};
  QByteArray data;
  data.reserve(qsizetype(cells.all.size()));
  for (int y = cells.height; y-- > 0;) {
    for (int x = 0; x < cells.width; ++x) data += char(cells.at(x, y));
  }
  QJsonObject rest = gridOf({1, 1, {0}});
  QJsonObject info = rest[text("info")].toObject();
  info[text("width")] = cells.width;
  info[text("height")] = cells.height;
  rest[text("info")] = info;
  QCborMap packed = QCborMap::fromJsonObject(rest);
  packed[text("data")] = QCborValue(kInt8s, data);
  return packed;
}

std::shared_ptr<const grids::GridPyramid> pyramidOf(Cells cells) {
  const auto builder =
      grids::buildGrid(cells.width, cells.height, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(std::size_t(cells.width));
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) row[std::size_t(x)] = std::uint8_t(cells.at(x, y));
    builder->pushRow(row);
  }
  builder->finish();
  return builder->pyramid();
}

std::string fingerprintOf(Cells cells) {
  std::string pgm = "P5\n" + std::to_string(cells.width) + ' ' + std::to_string(cells.height) + "\n255\n";
  for (const int cell : cells.all) pgm.push_back(char(cell));
  return wire::fingerprint(pgm);
}

/// As map_server reads a picture of mono8.
Cells readBy(const QJsonObject& image) {
  Cells cells{image[text("width")].toInt(), image[text("height")].toInt(), {}};
  const QByteArray data = QByteArray::fromBase64(image[text("data")].toString().toLatin1());
  for (const char shade : data) {
    const double occupied = (255 - int(std::uint8_t(shade))) / 255.0;
    cells.all.push_back(occupied > 0.65 ? 100 : occupied < 0.196 ? 0 : -1);
  }
  return cells;
}

}  // namespace

class KabamPicturesTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<ScriptedBridge> server_;
  std::unique_ptr<ros::RosRobot> robot_;
  std::vector<Progress> progress_;

  void show(const Cells& cells) { server_->latch(text("/map"), gridOf(cells)); }
  void showLarge(const Cells& cells) {
    server_->forgetLatched(text("/map"));
    server_->latch(text("/map"), packedGridOf(cells));
  }
  void serve(const std::function<std::optional<QJsonObject>(const QJsonObject&)>& answer) {
    server_->serve(text(kService), answer);
  }
  void current(const char* id) {
    server_->latch(text("/map_manager/current_map_info"),
                   json(R"({"map_id":")" + QByteArray(id) +
                        R"(","map_name":"one","map_label":"One","map_manager_state":"ACTIVE"})"));
  }
  bool online(const std::function<void(ros::LinkOptions&)>& change = {}) {
    ros::LinkOptions options;
    options.url = server_->url();
    options.look_every = milliseconds(50);
    options.look_timeout = milliseconds(20'000);
    options.picture_settles = milliseconds(30);
    options.kabam.confirm = milliseconds(400);
    options.client.link.backoff_first = milliseconds(5);
    options.client.link.backoff_limit = milliseconds(20);
    if (change) change(options);
    robot_ = std::make_unique<ros::RosRobot>(QStringLiteral("kabam+test"), options);
    robot_->connectToRobot();
    return QTest::qWaitFor([&] { return robot_->connection().phase == ConnectionPhase::Online; }, 30'000);
  }
  static void inPieces(ros::LinkOptions& options) {
    options.client.most_whole_bytes = 200;
    options.client.fragment_bytes = 100;
  }
  Outcome<PictureReceipt> write(const Cells& before, const Cells& after) {
    std::optional<Outcome<PictureReceipt>> ended;
    const Call call = robot_->pictureStore()->write({kMap, pyramidOf(after), fingerprintOf(before)},
                                                    [&](auto outcome) { ended = std::move(outcome); });
    progress_.clear();
    call.onProgress([this](Progress progress) { progress_.push_back(progress); });
    if (!QTest::qWaitFor([&] { return ended.has_value(); }, 30'000))
      return tl::make_unexpected(map::Failure{.subject = "test", .detail = "no answer"});
    return *ended;
  }
  QJsonObject sent() const { return server_->argumentsOf(text(kService)).value(0); }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedBridge>();
    server_->advertise(text("/map"), text("nav_msgs/OccupancyGrid"));
    server_->advertise(text("/map_manager/map_list"), text("kabam_msgs/MapList"));
    server_->latch(text("/map_manager/map_list"),
                   json(R"({"maps":[{"map_id":"m1","map_name":"one","map_label":"One"},)"
                        R"({"map_id":"m2","map_name":"two","map_label":"Two"}]})"));
    server_->latch(text("/map_manager/archived_map_list"), json(R"({"maps":[]})"));
    server_->latch(text("/map_manager/current_map_waypoints"), json(R"({"waypoints":[]})"));
    current("m1");
    server_->serve(text("/map_manager/load_map"), [](const QJsonObject&) { return json(R"({"result":0})"); });
    show(room());
    serve([this](const QJsonObject& args) {
      show(readBy(args[text("updated_image")].toObject()));
      return json(R"({"result":0})");
    });
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  void aPictureIsSentWholeAndShown() {
    QVERIFY(online());
    Cells after = room();
    after.at(3, 1) = 100;
    after.at(4, 1) = -1;
    const auto receipt = write(room(), after);
    QVERIFY2(receipt, receipt ? "" : sentences::sentenceOf(receipt.error()).c_str());
    QCOMPARE(receipt->revision, fingerprintOf(after));
    for (const char* member : {"map_id", "updated_image", "new_map_label", "set_archive", "delete_map"})
      QVERIFY2(sent().contains(QLatin1String(member)), member);
    QCOMPARE(sent()[text("map_id")].toString(), text("m1"));
    QCOMPARE(sent()[text("delete_map")], QJsonValue(false));
    const QJsonObject image = sent()[text("updated_image")].toObject();
    QCOMPARE(image[text("encoding")].toString(), text("mono8"));
    QCOMPARE(image[text("width")].toInt(), 40);
    QCOMPARE(image[text("height")].toInt(), 30);
    QCOMPARE(image[text("step")].toInt(), 40);
    const QByteArray data = QByteArray::fromBase64(image[text("data")].toString().toLatin1());
    QCOMPARE(data.size(), 40 * 30);
    QCOMPARE(int(std::uint8_t(data[0])), 0);     // the wall along the top
    QCOMPARE(int(std::uint8_t(data[40])), 254);  // free below it
    QCOMPARE(int(std::uint8_t(data[43])), 0);    // painted
    QCOMPARE(int(std::uint8_t(data[44])), 205);  // painted
    QCOMPARE(int(std::uint8_t(data[79])), 205);  // unknown along the right
    QVERIFY(!progress_.empty());
    QVERIFY(progress_.back().of_bytes && progress_.back().bytes == *progress_.back().of_bytes);
  }

  void aLargePictureGoesInPieces() {
    QVERIFY(online(inPieces));
    Cells after = room();
    after.at(20, 20) = 100;
    const auto receipt = write(room(), after);
    QVERIFY2(receipt, receipt ? "" : sentences::sentenceOf(receipt.error()).c_str());
    QVERIFY(server_->pieces > 10);
    QCOMPARE(server_->timesCalled(text(kService)), 1);
    QCOMPARE(readBy(sent()[text("updated_image")].toObject()).all, after.all);
    for (std::size_t i = 1; i < progress_.size(); ++i) QVERIFY(progress_[i].bytes >= progress_[i - 1].bytes);
  }

  void aPictureOfOneCellHasItsPadding() {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {3, 1}, {1, 17}, {5, 33}}) {
      ros::PictureArgs args({"m1", "one", "One", false}, pyramidOf(room(width, height)), [] { return true; });
      QByteArray all;
      while (all.size() < args.bytes()) {
        const auto more = args.next();
        QVERIFY(more && !more->isEmpty());
        all += *more;
      }
      QCOMPARE(qint64(all.size()), args.bytes());
      const QJsonObject object = QJsonDocument::fromJson(all).object();
      QCOMPARE(readBy(object[text("updated_image")].toObject()).all, room(width, height).all);
      QCOMPARE(args.fingerprint(), fingerprintOf(room(width, height)));
    }
  }

  void whatHasBeenChangedMeanwhileIsNotWrittenOver() {
    QVERIFY(online());
    Cells theirs = room(), after = room();
    theirs.at(9, 9) = 100;
    after.at(3, 3) = 100;
    show(theirs);
    QSignalSpy changed(robot_->pictureStore(), &PictureStore::changed);
    const auto receipt = write(room(), after);
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().kind, FailureKind::Conflict);
    QCOMPARE(receipt.error().applied, Applied::No);
    QCOMPARE(server_->timesCalled(text(kService)), 0);
    QTRY_COMPARE(changed.size(), 1);
    QVERIFY(changed.first().first().value<map::MapKey>() == kMap);
  }

  void whatIsChangedWhileItTravelsStopsIt() {
    const Cells before = room(kLarge, kLarge);
    Cells after = before, theirs = before;
    after.at(3, 3) = theirs.at(9, 9) = 100;
    showLarge(before);
    const QCborMap other = packedGridOf(theirs);
    QVERIFY(online());
    QSignalSpy changed(robot_->pictureStore(), &PictureStore::changed);
    server_->atPiece = [&](int number) {
      if (number != 0) return;
      server_->latch(text("/map"), other);
      // Nothing more is read before it has been seen.
      QElapsedTimer clock;
      for (clock.start(); changed.isEmpty() && clock.elapsed() < 30'000;) {
        for (QWebSocket* peer : server_->peers) peer->flush();
        QCoreApplication::processEvents(QEventLoop::ExcludeSocketNotifiers);
      }
    };
    const auto receipt = write(before, after);
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().kind, FailureKind::Conflict);
    QCOMPARE(receipt.error().applied, Applied::No);
    QCOMPARE(server_->timesCalled(text(kService)), 0);
  }

  void aLinkThatIsLostHalfwayLeavesNoDoubt() {
    const Cells before = room(kLarge, kLarge);
    Cells after = before;
    after.at(3, 3) = 100;
    showLarge(before);
    server_->atPiece = [&](int number) {
      if (number == 2) server_->cut();
    };
    QVERIFY(online());
    const auto receipt = write(before, after);
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().kind, FailureKind::Unreachable);
    QCOMPARE(receipt.error().applied, Applied::No);
    QCOMPARE(server_->timesCalled(text(kService)), 0);
  }

  void cancellingWhileItTravelsChangesNothing() {
    const Cells before = room(kLarge, kLarge);
    Cells after = before;
    after.at(3, 3) = 100;
    showLarge(before);
    Call call;
    server_->atPiece = [&](int number) {
      if (number == 1) call.cancel();
    };
    QVERIFY(online());
    std::optional<Outcome<PictureReceipt>> ended;
    call = robot_->pictureStore()->write({kMap, pyramidOf(after), fingerprintOf(before)},
                                         [&](auto outcome) { ended = std::move(outcome); });
    QTRY_VERIFY(ended.has_value());
    QCOMPARE(ended->error().kind, FailureKind::Cancelled);
    QCOMPARE(ended->error().applied, Applied::No);
    QCOMPARE(server_->timesCalled(text(kService)), 0);
  }

  void anAnswerThatIsLostIsLookedFor() {
    QVERIFY(online());
    serve([this](const QJsonObject& args) -> std::optional<QJsonObject> {
      show(readBy(args[text("updated_image")].toObject()));
      server_->cut();
      return std::nullopt;
    });
    QSignalSpy changed(robot_->pictureStore(), &PictureStore::changed);
    Cells after = room();
    after.at(3, 3) = 100;
    const auto receipt = write(room(), after);
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().kind, FailureKind::Unreachable);
    QCOMPARE(receipt.error().applied, Applied::Maybe);
    // With the next connection whoever shows the map is told to look.
    QTRY_VERIFY(!changed.isEmpty());
    QTRY_COMPARE(robot_->connection().phase, ConnectionPhase::Online);
  }

  void whatIsDoneAllTheSameIsNoFailure() {
    QVERIFY(online());
    serve([this](const QJsonObject& args) {
      show(readBy(args[text("updated_image")].toObject()));
      return json(R"({"refused":"transport error completing service call"})");
    });
    Cells after = room();
    after.at(3, 3) = 100;
    QVERIFY(write(room(), after));
  }

  void eachCodeSaysWhatItMeans_data() {
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<int>("applied");
    QTest::addColumn<FaultCode>("cause");
    const auto row = [](const char* answer, Applied applied, FaultCode cause) {
      QTest::newRow(answer) << QByteArray(answer) << int(applied) << cause;
    };
    row(R"({"result":2})", Applied::No, robot::ros::fault::ResultMapUnknown);
    row(R"({"result":3})", Applied::No, robot::ros::fault::ResultInvalid);
    row(R"({"result":4})", Applied::Maybe, robot::ros::fault::ResultUndefined);
    row(R"({"result":9})", Applied::Maybe, robot::ros::fault::ResultUnknown);
    row(R"({})", Applied::Maybe, robot::ros::fault::AnswerWithoutResult);
    row(R"({"result":0})", Applied::Maybe, robot::ros::fault::NotConfirmed);
  }
  void eachCodeSaysWhatItMeans() {
    QFETCH(QByteArray, answer);
    QFETCH(int, applied);
    QFETCH(FaultCode, cause);
    QVERIFY(online());
    serve([&](const QJsonObject&) { return json(answer); });
    Cells after = room();
    after.at(3, 3) = 100;
    const auto receipt = write(room(), after);
    QVERIFY(!receipt);
    QCOMPARE(int(receipt.error().applied), applied);
    QVERIFY(receipt.error().cause.code == cause);
    QVERIFY(receipt.error().subject == map::subjectOf(kMap));
    QVERIFY(sentences::sentenceOf(receipt.error()).ends_with('.'));
  }

  void whatIsShownOtherwiseIsCounted() {
    QVERIFY(online());
    serve([this](const QJsonObject& args) {
      Cells shown = readBy(args[text("updated_image")].toObject());
      shown.at(7, 7) = shown.at(8, 8) = 100;
      show(shown);
      return json(R"({"result":0})");
    });
    Cells after = room();
    after.at(3, 3) = 100;
    const auto receipt = write(room(), after);
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().applied, Applied::Yes);
    QVERIFY(receipt.error().cause == Fault(robot::ros::fault::PictureShownOtherwise, {std::int64_t(2)}));
  }

  void aPublisherThatSaysItOnlyWhenAskedIsAsked() {
    QVERIFY(online([](ros::LinkOptions& options) { options.kabam.confirm = milliseconds(2'000); }));
    serve([this](const QJsonObject& args) {
      server_->keep(text("/map"), gridOf(readBy(args[text("updated_image")].toObject())));
      return json(R"({"result":0})");
    });
    Cells after = room();
    after.at(3, 3) = 100;
    QVERIFY(write(room(), after));
  }

  void onlyTheCurrentMapIsTaken() {
    QVERIFY(online());
    current("m2");
    QSignalSpy told(robot_.get(), &Robot::mapsChanged);
    QTRY_VERIFY(!told.isEmpty());
    const auto receipt = write(room(), room());
    QVERIFY(!receipt);
    QCOMPARE(receipt.error().cause.code, robot::ros::fault::OnlyCurrentMapTaken);
    QCOMPARE(server_->timesCalled(text(kService)), 0);
  }

  void cellsInBetweenAreNotSent() {
    Cells before = room();
    before.at(5, 5) = 40;
    show(before);
    QVERIFY(online());
    const auto receipt = write(before, before);
    QVERIFY(!receipt);
    QVERIFY(receipt.error().cause == Fault(robot::ros::fault::CellBetweenKinds, {std::int64_t(40)}));
    QCOMPARE(receipt.error().applied, Applied::No);
    QCOMPARE(server_->timesCalled(text(kService)), 0);
  }

  void itIsOfferedWhereTheServiceIs() {
    server_->withdraw(text(kService));
    QVERIFY(online());
    QVERIFY(!robot_->pictureStore());
    constexpr auto kEditing = Capability::PictureEditing;
    const QString why = sentences::absenceReason(kEditing, robot_->unavailableReason(kEditing));
    QVERIFY2(why.contains(text("/map_manager/update_map_image")), qPrintable(why));
    QSignalSpy changed(robot_.get(), &Robot::capabilitiesChanged);
    serve([](const QJsonObject&) { return json(R"({"result":0})"); });
    QTRY_VERIFY(robot_->pictureStore());
    QVERIFY(!changed.isEmpty());
    map::WholeMap map;
    map.key = kMap;
    QVERIFY(!robot_->pictureStore()->obstacle(map));
    map.key = {map::MapKind::Live, {}};
    QVERIFY(robot_->pictureStore()->obstacle(map) == PictureObstacle::NotStored);
  }

  void whatOthersDrawIsTold() {
    QVERIFY(online());
    robot_->liveTopics()->setWanted({map::Stream::WholeMap}, {});
    QSignalSpy changed(robot_->pictureStore(), &PictureStore::changed);
    Cells theirs = room();
    theirs.at(9, 9) = 100;
    int turn = 0;
    // What comes before it is known which map is the current one counts for none.
    QTRY_VERIFY((show(++turn % 2 == 0 ? theirs : room()), !changed.isEmpty()));
    QVERIFY(changed.first().first().value<map::MapKey>() == kMap);
  }
};

}  // namespace test_kabam_pictures

MAPWRIGHT_TEST(test_kabam_pictures, KabamPicturesTest, Core)
#include "test_kabam_pictures.moc"
