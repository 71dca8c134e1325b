// A KABAM map manager whose topic of waypoints lags, stands still or is silent, and which does not check
// names: what is read is what the manager has.
#include <map>
#include <random>

#include <QTest>

#include "edit/open_waypoints.h"
#include "robot/ros/faults.h"
#include "robot/ros/ros_robot.h"
#include "scripted_bridge.h"
#include "sentences/failure_sentence.h"
#include "test_program.h"

namespace test_kabam_lag {

using namespace mapwright;
using namespace mapwright::robot;
using ros::RosRobot;
using std::chrono::milliseconds;
using testing::ScriptedBridge;

namespace {

const map::MapKey kMap{map::MapKind::Stored, "m1"};
const QString kTopic = QStringLiteral("/map_manager/current_map_waypoints");

QString text(const char* latin) { return QString::fromLatin1(latin); }

/// What the manager holds: the message of each waypoint by its id.
using Held = std::map<QString, QJsonObject>;

QJsonObject messageOf(const Held& held, const QString& only = {}) {
  QJsonArray rows;
  for (const auto& [id, row] : held) {
    if (only.isEmpty() || id == only) rows << row;
  }
  return {{text("waypoints"), rows}};
}

QJsonObject rowOf(const QString& id, const QString& name, double x) {
  const QJsonObject position{{text("x"), x}, {text("y"), 0}, {text("z"), 0}},
      orientation{{text("x"), 0}, {text("y"), 0}, {text("z"), 0}, {text("w"), 1}};
  return {{text("id"), id},
          {text("name"), name},
          {text("frame_id"), text("map")},
          {text("map_id"), text("m1")},
          {text("waypoint_tags"), QJsonArray()},
          {text("pose"), QJsonObject{{text("position"), position}, {text("orientation"), orientation}}}};
}

/// "w1 Dock 2.5" of each, in the order of their ids.
QStringList told(const Held& held) {
  QStringList rows;
  for (const auto& [id, row] : held) {
    const double x = row[text("pose")][text("position")][text("x")].toDouble();
    rows << QStringLiteral("%1 %2 %3").arg(id, row[text("name")].toString()).arg(x);
  }
  return rows;
}
QStringList told(const StoredWaypoints& stored) {
  QStringList rows;
  for (const map::Waypoint& point : stored.points) {
    rows << QStringLiteral("%1 %2 %3")
                .arg(QString::fromStdString(point.id), QString::fromStdString(point.name))
                .arg(point.position_m.x());
  }
  rows.sort();
  return rows;
}

template <typename T, typename Ask>
Outcome<T> answerTo(Ask ask) {
  std::optional<Outcome<T>> answer;
  const Call call = ask([&](Outcome<T> given) { answer = std::move(given); });
  if (!QTest::qWaitFor([&] { return answer.has_value(); }, 30'000))
    return tl::make_unexpected(map::Failure{.subject = "test", .detail = "no answer"});
  return *answer;
}

}  // namespace

class KabamLagTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<ScriptedBridge> server_;
  std::unique_ptr<RosRobot> robot_;
  Held held_;
  int ids_ = 0;
  QJsonArray added_tags_;  // given by the manager to what it creates
  bool hides_ = false;     // what it creates shows later

  void serve(const char* name, ScriptedBridge::Service service) {
    server_->serve(text("/map_manager/") + QLatin1String(name), std::move(service));
  }
  void manage() {
    const auto topic = [&](const char* name, const char* type, const QJsonObject& msg) {
      const QString whole = text("/map_manager/") + QLatin1String(name);
      server_->advertise(whole, text("kabam_msgs/") + QLatin1String(type));
      server_->latch(whole, msg);
    };
    const QJsonObject map{{text("map_id"), text("m1")}, {text("map_name"), text("one")}};
    QJsonObject info = map;
    info[text("map_manager_state")] = text("ACTIVE");
    topic("current_map_info", "MapInfo", info);
    topic("map_list", "MapList", {{text("maps"), QJsonArray{map}}});
    topic("archived_map_list", "MapList", {{text("maps"), QJsonArray()}});
    topic("current_map_waypoints", "MapWaypointList", messageOf(held_));
    serve("load_map", [](const QJsonObject&) { return QJsonObject{{text("result"), 4}}; });
    serve("get_waypoint", [this](const QJsonObject& args) {
      return QJsonObject{{text("waypoints"), messageOf(held_, args[text("waypoint_id")].toString())}};
    });
    serve("create_waypoint", [this](const QJsonObject& args) {
      QJsonObject row = args[text("waypoint_info")].toObject();
      const QString id = text("w") + QString::number(++ids_);
      row[text("id")] = id;
      if (!added_tags_.isEmpty()) row[text("waypoint_tags")] = added_tags_;
      if (!hides_) held_[id] = row;
      return QJsonObject{{text("result"), 0}, {text("waypoint_response"), row}};
    });
    for (const char* name : {"rename_waypoint", "reposition_waypoint"}) {
      serve(name, [this](const QJsonObject& args) {
        const QJsonObject row = args[text("waypoint_info")].toObject();
        held_[row[text("id")].toString()] = row;
        return QJsonObject{{text("result"), 3}};
      });
    }
    serve("delete_waypoint", [this](const QJsonObject& args) {
      held_.erase(args[text("waypoint_info")][text("id")].toString());
      return QJsonObject{{text("result"), 5}};
    });
  }
  bool online() {
    ros::LinkOptions options;
    options.url = server_->url();
    options.kabam.confirm = milliseconds(1'500);
    options.kabam.topic = milliseconds(5);
    options.kabam.look_again = milliseconds(5);
    robot_ = std::make_unique<RosRobot>(QStringLiteral("ros+test"), options);
    robot_->connectToRobot();
    return QTest::qWaitFor(
        [&] { return robot_->connection().phase == ConnectionPhase::Online && robot_->waypointStore(); },
        30'000);
  }
  Outcome<StoredWaypoints> read() {
    return answerTo<StoredWaypoints>([&](auto reply) { return robot_->waypointStore()->read(kMap, reply); });
  }
  Outcome<WaypointReceipt> perform(const WaypointChange& change) {
    return answerTo<WaypointReceipt>([&](auto reply) {
      return robot_->waypointStore()->perform(kMap, {{change}, "r"}, reply);
    });
  }

 private Q_SLOTS:
  void init() {
    server_ = std::make_unique<ScriptedBridge>();
    held_.clear();
    ids_ = 0;
    added_tags_ = {};
    hides_ = false;
  }
  void cleanup() {
    robot_.reset();
    server_.reset();
  }

  // Whatever the topic says, and however late: what others and we did is read, and no more.
  void whatIsReadIsWhatTheManagerHas() {
    std::mt19937 dice(17);
    const auto thrown = [&](int below) { return int(dice() % unsigned(below)); };
    for (int i = 0; i < 4; ++i) {
      const QString id = text("w") + QString::number(++ids_);
      held_[id] = rowOf(id, text("Start ") + QString::number(i), i);
    }
    std::vector<Held> history{held_};
    std::size_t shown = 0;  // by the topic
    manage();
    QVERIFY(online());
    for (int step = 0; step < 120; ++step) {
      const auto stored = read();
      QVERIFY2(stored, stored ? "" : sentences::sentenceOf(stored.error()).c_str());
      QCOMPARE(told(*stored), told(held_));
      QVERIFY(stored->notes.empty());
      const QString name = text("Name ") + QString::number(step);
      const int what = stored->points.empty() ? 0 : thrown(4);
      if (thrown(2) == 0) {
        map::Waypoint before, after;
        if (what > 0) before = after = stored->points.at(std::size_t(thrown(int(stored->points.size()))));
        if (what == 0) after.id = "ours " + std::to_string(step);
        after.name = what < 2 ? name.toStdString() : before.name;
        after.position_m.x() = what == 0 || what == 2 ? step : before.position_m.x();
        if (!after.yaw_rad) after.yaw_rad = 0;
        const auto receipt = perform({after.id, what > 0 ? std::optional(before) : std::nullopt,
                                      what < 3 ? std::optional(after) : std::nullopt});
        QVERIFY2(receipt, receipt ? "" : sentences::sentenceOf(receipt.error()).c_str());
        QCOMPARE(receipt->ids.size(), std::size_t(what == 0 ? 1 : 0));
      } else {  // somebody else
        auto one = held_.begin();
        if (what > 0) std::advance(one, thrown(int(held_.size())));
        const QString id = what > 0 ? one->first : text("w") + QString::number(++ids_);
        what < 3 ? void(held_[id] = rowOf(id, name, step)) : void(held_.erase(id));
      }
      history.push_back(held_);
      if (thrown(3) == 0) {  // it brings what was before
        shown += std::size_t(thrown(int(history.size() - shown)));
        server_->latch(kTopic, messageOf(history.at(shown)));
      }
    }
  }

  void theSameChangesAgainCreateNothing_data() {
    QTest::addColumn<bool>("silent");
    QTest::newRow("the topic stands still") << false;
    QTest::newRow("the topic is silent") << true;
  }
  void theSameChangesAgainCreateNothing() {
    QFETCH(bool, silent);
    held_[text("w0")] = rowOf(text("w0"), text("Dock"), 1);
    manage();
    if (silent) server_->forgetLatched(kTopic);
    QVERIFY(online());
    for (int time = 0; time < 2; ++time) {
      edit::OpenWaypoints open(*robot_->waypointStore(), kMap, {}, {});
      QTRY_COMPARE(open.phase(), edit::OpenWaypoints::Phase::Ready);
      std::vector<edit::Change> wanted;
      for (int i = 0; i < 3; ++i) {
        map::Waypoint point;
        point.id = "ours " + std::to_string(i);
        point.name = "New " + std::to_string(i);
        point.yaw_rad = 0;
        // By their names, as from a file.
        const bool is_there = std::any_of(open.document().items().begin(), open.document().items().end(),
                                          [&](const auto& item) { return item.second.name == point.name; });
        if (!is_there) wanted.push_back({point.id, std::nullopt, point});
      }
      open.document().change(wanted, {});
      open.save();
      QTRY_VERIFY(!open.saving());
      QVERIFY(!open.unsaved());
    }
    QCOMPARE(server_->timesCalled(text("/map_manager/create_waypoint")), 3);
    QCOMPARE(held_.size(), std::size_t(4));
  }

  void aListThatNobodyConfirmedIsSaidToBeSo() {
    held_[text("w0")] = rowOf(text("w0"), text("Dock"), 1);
    manage();
    server_->withdraw(text("/map_manager/get_waypoint"));
    QVERIFY(online());
    const auto stored = read();
    QVERIFY(stored);
    QCOMPARE(told(*stored), told(held_));
    QCOMPARE(stored->notes.size(), std::size_t(1));
    QCOMPARE(stored->notes.front().code, ros::fault::WaypointsNotConfirmed);
    // Without the topic there is nothing to show.
    server_->forgetLatched(kTopic);
    QVERIFY(online());
    QVERIFY(!read());
  }

  // The manager named it, so it is ours: with other tags than we wanted, or where somebody else moved it
  // before we saw it.
  void whatTheManagerNamedIsNotTakenForAnothers_data() {
    QTest::addColumn<bool>("late");
    QTest::newRow("with other tags") << false;
    QTest::newRow("moved before it shows") << true;
  }
  void whatTheManagerNamedIsNotTakenForAnothers() {
    QFETCH(bool, late);
    late ? void(hides_ = true) : void(added_tags_ = {text("map_entry")});
    manage();
    QVERIFY(online());
    edit::OpenWaypoints open(*robot_->waypointStore(), kMap, {}, {});
    QTRY_COMPARE(open.phase(), edit::OpenWaypoints::Phase::Ready);
    map::Waypoint point;
    point.id = "ours";
    point.name = "New";
    point.yaw_rad = 0;
    open.document().change({{point.id, std::nullopt, point}}, {});
    open.save();
    QTRY_VERIFY(!open.saving());
    QVERIFY(open.submission().failure());
    if (late) held_[text("w1")] = rowOf(text("w1"), text("New"), 8);
    server_->latch(kTopic, messageOf(held_));
    const auto known = [&] { return open.document().find("ours") && open.document().items().size() == 1; };
    QTRY_VERIFY(open.looked());
    QTRY_COMPARE(open.document().conflicts().count("ours"), std::size_t(late ? 1 : 0));
    QVERIFY(known());
    QCOMPARE(server_->timesCalled(text("/map_manager/create_waypoint")), 1);
  }
};

}  // namespace test_kabam_lag

MAPWRIGHT_TEST(test_kabam_lag, KabamLagTest, Core)
#include "test_kabam_lag.moc"
