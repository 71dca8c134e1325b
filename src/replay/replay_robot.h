// A bag as a robot: its topics send the recorded messages, and no layer knows the difference. Submaps, whole
// maps and waypoints come from the robot of the bag, as long as it has them.
// Lives on the thread of that robot. During playback messages arrive by topicReceived() in order, with their
// recorded stamps; a jump emits jumped(), and a listener replaces its world (session::Session::reset). The
// sum of both is the world at the present time.
#pragma once

#include <memory>
#include <optional>

#include <QTimer>

#include "replay/reading.h"
#include "robot/offers_topics.h"
#include "robot/robot.h"

namespace mapwright::replay {

class ReplayRobot : public robot::Robot, public robot::OffersTopics {
  Q_OBJECT
 public:
  /// `name`: a bag of `origin`, or a recording. `origin` is not connected: it only provides what the bag
  /// refers to.
  ReplayRobot(std::unique_ptr<robot::Robot> origin, std::string name, Reading::Options options = {},
              QObject* parent = nullptr);
  /// This bag, of a known kind.
  ReplayRobot(std::unique_ptr<robot::Robot> origin, robot::BagKey key, Reading::Options options = {},
              QObject* parent = nullptr);
  ~ReplayRobot() override;
  /// Its name; untrusted.
  const std::string& bag() const { return name_; }

  // That of the robot. It is online once the bag is open; if it cannot be opened the state is Refused.
  QString address() const override { return origin_->address(); }
  bool isLocal() const override { return origin_->isLocal(); }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override { origin_->trustCertificate(sha256); }
  robot::ConnectionState connection() const override { return state_; }
  robot::RobotIdentity identity() const override { return origin_->identity(); }
  robot::SubmapSource* submapSource() override;
  /// Its current map is the one that the messages name (by uid, otherwise by name), if any.
  robot::MapCatalogue* mapCatalogue() override;
  robot::WholeMapSource* wholeMapSource() override { return origin_->wholeMapSource(); }
  robot::WaypointSource* waypointSource() override { return origin_->waypointSource(); }
  robot::LiveTopics* liveTopics() override;
  robot::BagLibrary* bagLibrary() override { return origin_->bagLibrary(); }
  std::optional<std::vector<robot::OfferedTopic>> offered() const override;
  QStringList choicesFor(map::Stream stream) const override;
  /// Reads the bag again.
  void choose(const robot::TopicChoices& choices) override;
  robot::TopicChoices chosen() const override;
  /// Changes would apply to a robot that has moved on since.
  robot::Absence unavailableReason(robot::Capability capability) const override;

  /// Of the bag, once online; null before.
  Reading* reading() { return reading_.get(); }
  /// The current time; nullopt before the first move.
  std::optional<double> at() const { return at_s_; }
  /// How much of the state at that time is known.
  Knowledge knowledge() const { return knowledge_; }
  /// The stamp of the last message of each topic.
  const std::map<std::string, double>& topics() const { return topics_; }
  /// Pictures being fetched that the bag contains only by address; they arrive by topicReceived().
  std::size_t picturesUnderWay() const { return pictures_.size(); }
  /// Goes there. Forward moves within memory deliver the messages on the way one by one; anything else is a
  /// jump. Missing data arrives later in the same ways.
  void goTo(double at_s);

 Q_SIGNALS:
  /// The world from now on. Unless it is Exact, earlier data is still being read and the signal will be
  /// repeated.
  void jumped(const mapwright::map::World& world, mapwright::replay::Knowledge knowledge);
  void knowledgeChanged();

 private:
  class Topics;
  class Submaps;
  class Maps;
  void lookAgain();
  /// While raw messages are wanted: the last one of each topic in the present range.
  void notifyLastRaw();
  void find();
  void open(robot::BagKey key);
  void refuse(const map::Failure& failure);
  void jump();
  /// Reports what is lost until now, once.
  void reportHoles();
  void fetchPicture(const map::GridMessage& grid, const std::string& url);
  bool playTo(double at_s);
  void onMapInfo(const std::optional<map::MapInfo>& info);
  void setState(robot::ConnectionState state);
  void setKnowledge(Knowledge knowledge);

  std::unique_ptr<robot::Robot> origin_;
  std::string name_;
  std::optional<robot::BagKey> key_;  // if known from the start
  Reading::Options options_;
  std::unique_ptr<Topics> live_;
  std::unique_ptr<Submaps> submaps_;
  std::unique_ptr<Maps> maps_;
  std::optional<map::MapInfo> map_info_;  // as it was said last
  bool watching_ = false;                 // raw messages are wanted, too
  std::unique_ptr<Reading> reading_;
  robot::ConnectionState state_;
  robot::Call finding_;
  QTimer look_again_;
  std::optional<double> at_s_;
  Knowledge knowledge_ = Knowledge::Buffering;
  std::vector<Hole> reported_;
  std::map<std::string, double> topics_;
  struct Picture {
    std::uint64_t number = 0;
    robot::Call call;
  };
  std::map<map::GridKind, Picture> pictures_;  // in progress
  std::uint64_t last_picture_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace mapwright::replay
