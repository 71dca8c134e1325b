// A robot whose every word the test speaks.
#pragma once

#include <map>
#include <vector>

#include "robot/robot.h"

namespace mapwright::test {

class FakeRobot : public robot::Robot, public robot::SubmapSource {
  Q_OBJECT
 public:
  QString address() const override { return QStringLiteral("fake:"); }
  void connectToRobot() override { ++connects; }
  void disconnectFromRobot() override { setPhase(robot::ConnectionPhase::Offline); }
  robot::ConnectionState connection() const override { return state_; }
  robot::RobotIdentity identity() const override { return {}; }
  robot::SubmapSource* submapSource() override { return this; }

  void fetch(const map::SubmapKey& key, Reply reply) override {
    asked.push_back(key);
    open.emplace_back(key, std::move(reply));
  }
  void cancelAll() override {
    auto replies = std::move(open);
    open.clear();
    for (auto& [key, reply] : replies) {
      map::SubmapAnswer answer;
      answer.key = key;
      answer.outcome = map::SubmapAnswer::Outcome::Cancelled;
      reply(answer);
    }
  }
  void cancel(const map::SubmapKey&) override {}

  void setPhase(robot::ConnectionPhase phase) {
    state_.phase = phase;
    Q_EMIT connectionChanged();
  }
  void say(const map::TopicMessage& message) { Q_EMIT topicReceived(message); }

  /// Answers the oldest open fetch with 4 x 4 cells of `value`.
  map::SubmapKey answer(map::SubmapAnswer::Outcome outcome, int version = 0, char value = 5, int width = 4) {
    auto [key, reply] = std::move(open.front());
    open.erase(open.begin());
    map::SubmapAnswer answer;
    answer.key = key;
    answer.outcome = outcome;
    answer.reason = outcome == map::SubmapAnswer::Outcome::Ok ? "" : "The robot said no.";
    answer.version = version ? version : key.version;
    answer.bytes = 100;
    map::RawSlice slice;
    slice.width = width;
    slice.height = 4;
    slice.resolution_m = 0.05;
    for (int i = 0; i < 16; ++i) slice.cells += {value, '\0'};
    answer.slices.push_back(slice);
    reply(answer);
    return key;
  }

  std::vector<map::SubmapKey> asked;
  std::vector<std::pair<map::SubmapKey, Reply>> open;
  int connects = 0;

 private:
  robot::ConnectionState state_;
};

}  // namespace mapwright::test
