// A bag as a robot: what its topics say is what was recorded. No layer knows the difference. Submaps, whole
// maps and waypoints are those of the robot that the bag came from, as long as it has them.
//
// The thread of the robot it came from. While it plays on, messages come by topicReceived() in their order,
// with the stamps of the recording; a jump comes by jumped(), and who keeps a world sets it anew
// (session::Session::reset). The sum of both is the world of the time at any moment.
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
  /// `name`: a bag of `origin`, or else a recording. `origin` is not connected to: it is only asked for what
  /// the bag refers to.
  ReplayRobot(std::unique_ptr<robot::Robot> origin, std::string name, Reading::Options options = {},
              QObject* parent = nullptr);
  /// This one, without looking for its kind.
  ReplayRobot(std::unique_ptr<robot::Robot> origin, robot::BagKey key, Reading::Options options = {},
              QObject* parent = nullptr);
  ~ReplayRobot() override;
  /// What it is called; untrusted.
  const std::string& bag() const { return name_; }

  // Of the robot. It is online once the bag is opened; a bag that cannot be is a refusal.
  QString address() const override { return origin_->address(); }
  bool isLocal() const override { return origin_->isLocal(); }
  void connectToRobot() override;
  void disconnectFromRobot() override;
  void trustCertificate(const QString& sha256) override { origin_->trustCertificate(sha256); }
  robot::ConnectionState connection() const override { return state_; }
  robot::RobotIdentity identity() const override { return origin_->identity(); }
  robot::SubmapSource* submapSource() override { return origin_->submapSource(); }
  /// Its current map is the one that the messages name (uid, else name), as far as they name one.
  robot::MapCatalogue* mapCatalogue() override;
  robot::WholeMapSource* wholeMapSource() override { return origin_->wholeMapSource(); }
  robot::WaypointSource* waypointSource() override { return origin_->waypointSource(); }
  robot::LiveTopics* liveTopics() override;
  robot::BagLibrary* bagLibrary() override { return origin_->bagLibrary(); }
  std::optional<std::vector<robot::OfferedTopic>> offered() const override;
  QStringList choicesFor(map::Stream stream) const override;
  /// The bag is read anew.
  void choose(const robot::TopicChoices& choices) override;
  robot::TopicChoices chosen() const override;
  /// What is changed would be changed on a robot that is elsewhere by now.
  robot::Absence whyNot(robot::Capability capability) const override;

  /// Of the bag, once online; null before.
  Reading* reading() { return reading_.get(); }
  /// Where it is; nullopt before the first move.
  std::optional<double> at() const { return at_s_; }
  /// How much of the world of that time is known.
  Knowledge knowledge() const { return knowledge_; }
  /// What was said last of which topic.
  const std::map<std::string, double>& topics() const { return topics_; }
  /// Pictures that the bag only names, on their way; they come by topicReceived().
  std::size_t picturesUnderWay() const { return pictures_.size(); }
  /// Goes there. Forwards within what is held the messages on the way are told one by one; everything else is
  /// a jump. What is missing comes later, and is told likewise.
  void goTo(double at_s);

 Q_SIGNALS:
  /// The world from now on. It is looked back for what is missing in it unless it is Exact: then it comes
  /// again.
  void jumped(const mapwright::map::World& world, mapwright::replay::Knowledge knowledge);
  void knowledgeChanged();

 private:
  class Topics;
  class Maps;
  void lookAgain();
  /// While somebody watches: what the range at hand said last of each topic.
  void tellLastRaw();
  void find();
  void open(robot::BagKey key);
  void refuse(const map::Failure& failure);
  void jump();
  void fetchPicture(const map::GridMessage& grid, const std::string& url);
  bool playTo(double at_s);
  void takeMapInfo(const std::optional<map::MapInfo>& info);
  void setState(robot::ConnectionState state);
  void setKnowledge(Knowledge knowledge);

  std::unique_ptr<robot::Robot> origin_;
  std::string name_;
  std::optional<robot::BagKey> key_;  // where it is known from the start
  Reading::Options options_;
  std::unique_ptr<Topics> live_;
  std::unique_ptr<Maps> maps_;
  std::optional<map::MapInfo> map_info_;  // as it was said last
  bool watching_ = false;                 // messages as they were recorded are told, too
  std::unique_ptr<Reading> reading_;
  robot::ConnectionState state_;
  robot::Call finding_;
  QTimer look_again_;
  std::optional<double> at_s_;
  Knowledge knowledge_ = Knowledge::Buffering;
  std::map<std::string, double> topics_;
  struct Picture {
    std::uint64_t number = 0;
    robot::Call call;
  };
  std::map<map::GridKind, Picture> pictures_;  // under way
  std::uint64_t last_picture_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace mapwright::replay
