// A robot whose every word the test speaks.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QDateTime>

#include "map/live_topics.h"
#include "robot/robot.h"
#include "topic_names.h"

namespace mapwright::test {

/// A binary PGM of one gray level, in bytes.
inline std::shared_ptr<const std::string> grayPicture(int width, int height, int gray) {
  std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  bytes.append(std::size_t(width) * std::size_t(height), char(gray));
  return std::make_shared<const std::string>(std::move(bytes));
}

/// A request that ended in `detail`, in the robot's own words.
inline map::Failure failed(const std::string& detail,
                           map::FailureKind kind = map::FailureKind::RejectedByRobot) {
  return {.kind = kind, .subject = "Somebody", .detail = detail, .reason = map::FailureReason::Unfit};
}

class FakeRobot : public robot::Robot,
                  public robot::SubmapSource,
                  public robot::MapCatalogue,
                  public robot::WholeMapSource,
                  public robot::OverviewSource,
                  public robot::WaypointSource,
                  public robot::LiveTopics {
 public:
  // Capabilities beside submaps are there when the test says so.
  robot::MapCatalogue* mapCatalogue() override { return has_maps ? this : nullptr; }
  robot::WholeMapSource* wholeMapSource() override { return has_maps ? this : nullptr; }
  robot::OverviewSource* overviewSource() override { return offers_overview ? this : nullptr; }
  robot::WaypointSource* waypointSource() override { return has_maps ? this : nullptr; }
  robot::LiveTopics* liveTopics() override { return has_topics ? this : nullptr; }
  robot::MapDispatch* mapDispatch() override { return dispatch; }

  robot::Call list(robot::OutcomeTo<std::vector<map::CatalogueEntry>> reply) override {
    lists.push_back(std::move(reply));
    return {};
  }
  robot::Call describe(const map::MapKey& key, robot::OutcomeTo<map::CatalogueEntry> reply) override {
    descriptions.emplace_back(key, std::move(reply));
    return {};
  }
  robot::Call thumbnail(const map::MapKey& key, robot::OutcomeTo<std::string> reply) override {
    thumbnails.emplace_back(key, std::move(reply));
    return {};
  }
  robot::Call fetch(const map::MapKey& key, robot::OutcomeTo<map::WholeMap> reply) override {
    map_fetches.emplace_back(key, std::move(reply));
    return {};
  }
  robot::Call fetchOverview(double resolution_m, robot::OutcomeTo<map::WholeMap> reply) override {
    overview_resolutions.push_back(resolution_m);
    overviews.push_back(std::move(reply));
    return {};
  }
  robot::Call waypoints(const map::MapKey& key, robot::OutcomeTo<map::WaypointList> reply) override {
    waypoint_asks.emplace_back(key, std::move(reply));
    return {};
  }
  QStringList known() const override { return {}; }
  QStringList topicsOf(map::Stream stream) const override {
    return sends_no_map && stream == map::Stream::WholeMap ? QStringList() : test::topicsOf(stream);
  }
  void setWanted(const map::Streams& streams, const QStringList& topics) override {
    wanted = test::topicsOf(streams) + topics;
    wants.push_back(wanted);
  }
  void setBasics(const Basics& asked_for) override { basics = asked_for; }
  void setWatching(bool) override {}
  void setTap(robot::FrameTap) override {}

  static map::CatalogueEntry entry(const std::string& id, bool current = false) {
    map::CatalogueEntry row;
    row.key = {map::MapKind::Stored, id};
    row.name = "Map " + id;
    row.is_current = current;
    row.has_thumbnail = true;
    row.map_version = 1;
    return row;
  }
  static map::WholeMap wholeMap(const std::string& id, int gray = 254, int size = 40) {
    map::WholeMap map;
    map.key = {map::MapKind::Stored, id};
    map.name = "Map " + id;
    map.grid = {0, 0, 0.05, {-1, -1, 0}};
    map.bytes = grayPicture(size, size, gray);
    map.body_bytes = map.bytes->size();
    return map;
  }
  void answerList(std::vector<map::CatalogueEntry> rows) {
    auto replies = std::exchange(lists, {});
    for (auto& reply : replies) reply(rows);
  }

  bool has_maps = false, has_topics = false, has_submaps = true, offers_overview = false;
  bool sends_no_map = false;
  QDateTime silent_since;
  robot::MapDispatch* dispatch = nullptr;
  std::vector<robot::OutcomeTo<std::vector<map::CatalogueEntry>>> lists;
  std::vector<std::pair<map::MapKey, robot::OutcomeTo<map::CatalogueEntry>>> descriptions;
  std::vector<std::pair<map::MapKey, robot::OutcomeTo<std::string>>> thumbnails;
  std::vector<std::pair<map::MapKey, robot::OutcomeTo<map::WholeMap>>> map_fetches;
  std::vector<std::pair<map::MapKey, robot::OutcomeTo<map::WaypointList>>> waypoint_asks;
  std::vector<robot::OutcomeTo<map::WholeMap>> overviews;
  std::vector<double> overview_resolutions;
  QStringList wanted;
  std::vector<QStringList> wants;  // one after the other
  Basics basics;

  QString address() const override { return QStringLiteral("fake:"); }
  void connectToRobot() override { ++connects; }
  void disconnectFromRobot() override { setPhase(robot::ConnectionPhase::Offline); }
  robot::ConnectionState connection() const override { return state_; }
  QDateTime silentSince() const override { return silent_since; }
  robot::RobotIdentity identity() const override { return {}; }
  robot::SubmapSource* submapSource() override { return has_submaps ? this : nullptr; }

  robot::Call fetch(const map::SubmapKey& key, Reply reply) override {
    asked.push_back(key);
    open.emplace_back(key, std::move(reply));
    return {};
  }
  void cancelAll() override {
    while (!open.empty()) cancel(map::SubmapKey(open.front().first));
  }
  void cancel(const map::SubmapKey& key) override {
    const auto found =
        std::find_if(open.begin(), open.end(), [&](const auto& one) { return one.first == key; });
    if (found == open.end()) return;
    const Reply reply = std::move(found->second);
    open.erase(found);
    map::SubmapAnswer answer;
    answer.key = key;
    answer.outcome = map::SubmapAnswer::Outcome::Cancelled;
    reply(answer);
  }
  void discard(const map::SubmapKey& key, std::int32_t) override { discarded.push_back(key); }
  void discardPicture(const std::string& fingerprint) override { discarded_pictures.push_back(fingerprint); }

  void setPhase(robot::ConnectionPhase phase) {
    state_.phase = phase;
    Q_EMIT connectionChanged();
  }
  /// Stamped with its clock.
  void say(const map::TopicMessage& message, const std::string& topic = {}) {
    Q_EMIT topicReceived({message, double(wall().toMSecsSinceEpoch()) / 1000, std::nullopt, topic});
  }
  std::function<QDateTime()> wall = [] { return QDateTime::currentDateTime(); };

  /// Answers the oldest open fetch with 4 x 4 cells of `value`.
  map::SubmapKey answer(map::SubmapAnswer::Outcome outcome, int version = 0, char value = 5, int width = 4) {
    auto [key, reply] = std::move(open.front());
    open.erase(open.begin());
    map::SubmapAnswer answer;
    answer.key = key;
    answer.outcome = outcome;
    if (outcome != map::SubmapAnswer::Outcome::Ok) answer.reason = fault::said("The robot said no.");
    answer.version = version ? version : key.version;
    answer.bytes = 100;
    answer.from_cache = from_disk;
    map::RawSlice slice;
    slice.width = width;
    slice.height = 4;
    slice.resolution_m = 0.05;
    for (int i = 0; i < 16; ++i) slice.cells += {value, '\0'};
    answer.slices.push_back(slice);
    reply(answer);
    return key;
  }

  bool from_disk = false;  // the answers
  std::vector<map::SubmapKey> asked, discarded;
  std::vector<std::string> discarded_pictures;
  std::vector<std::pair<map::SubmapKey, Reply>> open;
  int connects = 0;

 private:
  robot::ConnectionState state_;
};

}  // namespace mapwright::test
