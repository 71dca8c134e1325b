// A robot of the tests' own: says what it is told to say and answers fetches at once, later or badly.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <QTimer>

#include "../session/topic_names.h"
#include "robot/localization.h"
#include "robot/map_administration.h"
#include "robot/map_transfer.h"
#include "robot/pose_graph_source.h"
#include "robot/robot.h"
#include "robot/ros/faults.h"
#include "robot/second_server.h"

namespace mapwright::test {

/// A square of `side` cells of 5 cm: free, with a wall of 10 cells along its first columns.
inline map::RawSlice square(int side) {
  map::RawSlice slice;
  slice.cell_format = 0;
  slice.width = slice.height = side;
  slice.resolution_m = 0.05;
  slice.cells.assign(std::size_t(side) * std::size_t(side), char(1));
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < 10 && column < side; ++column) {
      slice.cells[std::size_t(row) * std::size_t(side) + std::size_t(column)] = char(255);
    }
  }
  return slice;
}

inline map::SubmapEntry entry(int trajectory, int index, int version, double x_m, double y_m) {
  map::SubmapEntry made;
  made.id = {trajectory, index};
  made.version = version;
  made.pose = geometry::poseFromYaw(x_m, y_m, 0);
  return made;
}

/// A gray picture of `width` x `height` cells, free but for a wall of 5 columns.
inline map::WholeMap wholeMap(const map::MapKey& key, const std::string& name, int width, int height) {
  map::WholeMap made;
  made.key = key;
  made.name = name;
  made.grid.resolution_m = 0.05;
  std::string pgm = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) pgm += char(column < 5 ? 0 : 254);
  }
  made.bytes = std::make_shared<const std::string>(std::move(pgm));
  return made;
}

inline map::CatalogueEntry catalogued(const std::string& id, const std::string& name) {
  map::CatalogueEntry made;
  made.key = {map::MapKind::Stored, id};
  made.name = name;
  return made;
}

/// A request that ended in `detail`, in the robot's own words.
inline map::Failure failed(const std::string& detail) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = "Somebody",
          .detail = detail,
          .reason = map::FailureReason::Unfit};
}

/// Answers about maps what it is told to.
class FakeMaps : public QObject, public robot::MapCatalogue, public robot::WholeMapSource {
 public:
  robot::Call list(robot::OutcomeTo<std::vector<map::CatalogueEntry>> reply) override {
    QTimer::singleShot(0, this, [this, reply = std::move(reply)] {
      if (list_error.empty()) {
        reply(entries);
      } else {
        reply(tl::make_unexpected(failed(list_error)));
      }
    });
    return {};
  }
  robot::Call describe(const map::MapKey& key, robot::OutcomeTo<map::CatalogueEntry> reply) override {
    QTimer::singleShot(0, this, [this, key, reply = std::move(reply)] {
      const auto found =
          std::find_if(entries.begin(), entries.end(), [&](const auto& row) { return row.key == key; });
      if (found != entries.end()) {
        reply(*found);
      } else {
        reply(tl::make_unexpected(failed("The robot has no such map.")));
      }
    });
    return {};
  }
  robot::Call thumbnail(const map::MapKey&, robot::OutcomeTo<std::string> reply) override {
    QTimer::singleShot(0, this, [reply = std::move(reply)] { reply(std::string("no picture")); });
    return {};
  }
  robot::Call fetch(const map::MapKey& key, robot::OutcomeTo<map::WholeMap> reply) override {
    opened.push_back(key);
    QTimer::singleShot(0, this, [this, key, reply = std::move(reply)] {
      if (without_picture.contains(key.id)) {
        reply(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Unsupported,
                                               .subject = map::subjectOf(key),
                                               .reason = map::FailureReason::Unfit,
                                               .cause = {robot::ros::fault::OnlyCurrentMapSent}}));
      } else if (pictures.contains(key.id)) {
        reply(pictures.at(key.id));
      } else if (map_error.empty()) {
        reply(wholeMap(key, "Map " + key.id, 80, 60));
      } else {
        reply(tl::make_unexpected(failed(map_error)));
      }
    });
    return {};
  }

  std::vector<map::CatalogueEntry> entries;
  std::string list_error, map_error;
  std::set<std::string> without_picture;          // ids of maps of which none is sent
  std::map<std::string, map::WholeMap> pictures;  // by id, in place of the usual one
  std::vector<map::MapKey> opened;
};

/// Which capabilities it has is set before it is connected; submaps only, unless told otherwise.
class FakeRobot : public robot::Robot,
                  public robot::SubmapSource,
                  public robot::LiveTopics,
                  public robot::WaypointSource,
                  public robot::SecondServer {
 public:
  explicit FakeRobot(QString address = QStringLiteral("axbot+http://192.0.2.7:8090"))
      : address_(std::move(address)) {}

  QString address() const override { return address_; }
  bool isLocal() const override { return address_.startsWith(QLatin1String("file:")); }
  void connectToRobot() override {
    ++connects;
    if (auto_online) goOnline();
  }
  void disconnectFromRobot() override {}
  void trustCertificate(const QString& sha256) override { trusted << sha256; }
  QString hostBeside() const override { return beside ? beside->host : QString(); }
  std::optional<robot::UntrustedCertificate> certificateBeside() const override { return beside; }
  void trustBeside(const QString& sha256) override { trusted_beside << sha256; }
  robot::ConnectionState connection() const override { return state; }
  robot::RobotIdentity identity() const override { return who; }
  robot::SubmapSource* submapSource() override { return has_submaps ? this : nullptr; }
  robot::MapCatalogue* mapCatalogue() override { return has_catalogue ? &maps : nullptr; }
  robot::WholeMapSource* wholeMapSource() override { return has_catalogue ? &maps : nullptr; }
  robot::LiveTopics* liveTopics() override { return has_live ? this : nullptr; }
  robot::PoseGraphSource* poseGraphSource() override { return pose_graph; }
  robot::PictureStore* pictureStore() override { return picture_store; }
  robot::OverlayStore* overlayStore() override { return overlay_store; }
  robot::Absence unavailableReason(robot::Capability capability) const override {
    const bool limited = capability == robot::Capability::Administration && !read_only_maker.isEmpty();
    if (!limited) return {};
    return {robot::Absence::Reason::ReadOnly, {read_only_maker.toStdString()}};
  }
  bool isUnconfirmed(robot::Capability) const override { return unconfirmed; }
  robot::MapAdministration* mapAdministration() override { return administration; }
  robot::Localization* localization() override { return localizing; }
  robot::MapTransfer* mapTransfer() override { return transferring; }
  robot::WaypointStore* waypointStore() override { return waypoint_store; }
  robot::BagLibrary* bagLibrary() override { return bags; }
  robot::WaypointSource* waypointSource() override { return told_waypoints ? this : nullptr; }

  robot::Call waypoints(const map::MapKey&, robot::OutcomeTo<map::WaypointList> reply) override {
    QTimer::singleShot(0, this, [this, reply = std::move(reply)] { reply(*told_waypoints); });
    return {};
  }

  QStringList known() const override { return {QStringLiteral("/alerts"), QStringLiteral("/battery_state")}; }
  QStringList topicsOf(map::Stream stream) const override { return test::topicsOf(stream); }
  void setWanted(const map::Streams& streams, const QStringList& topics) override {
    wanted = test::topicsOf(streams) + topics;
  }
  void setWatching(bool on) override { watching = on; }
  void setTap(robot::FrameTap) override {}
  void sayRaw(const QString& topic, const QByteArray& text, bool binary = false) {
    robot::RawMessage message;
    message.topic = topic;
    message.received = QDateTime::currentDateTime();
    message.bytes = text.size();
    message.binary = binary;
    message.text = text;
    Q_EMIT rawReceived(message);
  }

  robot::Call fetch(const map::SubmapKey& key, Reply reply) override {
    ++fetches;
    held.emplace_back(key, std::move(reply));
    if (!hold) QTimer::singleShot(0, this, [this, key] { release(key, answer(key)); });
    return {};
  }
  void cancelAll() override {
    const auto keys = held;
    for (const auto& [key, reply] : keys) cancel(key);
  }
  void cancel(const map::SubmapKey& key) override {
    map::SubmapAnswer cancelled;
    cancelled.key = key;
    cancelled.outcome = map::SubmapAnswer::Outcome::Cancelled;
    QTimer::singleShot(0, this, [reply = removeHeld(key), cancelled] {
      if (reply) reply(cancelled);
    });
  }
  /// Answers what is held of `key`, once.
  void release(const map::SubmapKey& key, const map::SubmapAnswer& with) {
    if (const Reply reply = removeHeld(key)) reply(with);
  }

  map::SubmapAnswer answer(const map::SubmapKey& key) const {
    map::SubmapAnswer made;
    made.key = key;
    made.version = key.version;
    if (missing.contains(key.id)) {
      made.outcome = map::SubmapAnswer::Outcome::NotFound;
      made.reason = fault::said("The robot does not have it.");
      return made;
    }
    if (failing.contains(key.id)) {
      made.outcome = map::SubmapAnswer::Outcome::Failed;
      made.reason = fault::said("The robot answered <b>500</b>.");
      return made;
    }
    made.outcome = map::SubmapAnswer::Outcome::Ok;
    made.slices = {square(side)};
    if (corrupt.contains(key.id)) made.slices[0].cells.resize(7);
    made.bytes = made.slices[0].cells.size();
    return made;
  }

  void setState(const robot::ConnectionState& to) {
    state = to;
    Q_EMIT connectionChanged();
  }
  void goOnline() {
    robot::ConnectionState online;
    online.phase = robot::ConnectionPhase::Online;
    online.round_trip_ms = 12;
    setState(online);
  }
  void goAway(const QString& why) {
    robot::ConnectionState away;
    away.phase = robot::ConnectionPhase::Interrupted;
    away.reason = fault::said(why.toStdString());
    away.attempt = 2;
    away.retry_in_ms = 3000;
    setState(away);
  }
  void say(const map::TopicMessage& message) {
    Q_EMIT topicReceived({message, double(QDateTime::currentMSecsSinceEpoch()) / 1000});
  }
  void list(std::vector<map::SubmapEntry> entries, const std::string& uuid = "session-a") {
    map::SubmapList made;
    made.uuid = uuid;
    made.slam_state = map::SlamState::Positioning;
    made.entries = std::move(entries);
    say(made);
  }
  void identify(const robot::RobotIdentity& identity) {
    who = identity;
    Q_EMIT identityChanged();
  }

  bool auto_online = true, hold = false;
  bool has_submaps = true, has_catalogue = false, has_live = false;
  bool unconfirmed = false;  // whatever can be changed
  QString read_only_maker;
  robot::MapAdministration* administration = nullptr;  // not owned
  robot::Localization* localizing = nullptr;           // likewise
  robot::MapTransfer* transferring = nullptr;          // likewise
  robot::WaypointStore* waypoint_store = nullptr;      // not owned
  robot::BagLibrary* bags = nullptr;                   // not owned
  robot::PoseGraphSource* pose_graph = nullptr;        // not owned
  robot::PictureStore* picture_store = nullptr;        // not owned
  robot::OverlayStore* overlay_store = nullptr;        // not owned
  const map::WaypointList* told_waypoints = nullptr;   // those that can only be read; not owned
  FakeMaps maps;
  QStringList wanted, trusted, trusted_beside;
  std::optional<robot::UntrustedCertificate> beside;  // of its second server
  bool watching = false;
  int side = 100;
  int connects = 0, fetches = 0;
  std::set<map::SubmapId> missing, failing, corrupt;
  std::vector<std::pair<map::SubmapKey, Reply>> held;
  robot::ConnectionState state;
  robot::RobotIdentity who;

 private:
  Reply removeHeld(const map::SubmapKey& key) {
    const auto found =
        std::find_if(held.begin(), held.end(), [&](const auto& one) { return one.first == key; });
    if (found == held.end()) return {};
    Reply reply = std::move(found->second);
    held.erase(found);
    return reply;
  }

  QString address_;
};

}  // namespace mapwright::test
