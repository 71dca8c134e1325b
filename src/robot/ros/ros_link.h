// The network side of a ROS robot behind a rosbridge server. Lives on its own thread; values go in and out by
// queued calls. Source: docs/protocols/rosbridge.md, docs/protocols/kabam-map-manager.md.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QUrl>

#include "net/rosbridge/client.h"
#include "robot/offers_topics.h"
#include "robot/ros/dispatch_requests.h"
#include "robot/ros/kabam_pictures.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/live_map.h"
#include "robot/ros/ros_api.h"
#include "robot/ros/ros_deliveries.h"
#include "robot/ros/ros_maps.h"
#include "robot/ros/ros_subscriptions.h"
#include "robot/ros/ros_world.h"
#include "robot/wire/robot_link.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

/// How to reach a robot. `secret` is for rosauth, and is only sent to `url`.
struct LinkOptions {
  QUrl url;  // ws(s)://host:port[/path]
  QByteArray secret;
  std::string ns;           // "/robot1": preferred namespace; empty = none
  bool kabam_only = false;  // without a map manager it is not (yet) the expected robot
  net::Trust trust;
  net::rosbridge::ClientOptions client;
  std::chrono::milliseconds look_every{10'000};  // interval of listing topics and services
  std::chrono::milliseconds look_timeout{3'000};
  std::chrono::milliseconds map_timeout{10'000};
  MapFromService::Timeouts map_service;
  DispatchSettings dispatch;
  DispatchTimeouts dispatch_timeouts;
  /// Which map a picture belongs to is reported on another topic, before or after it: this long both have
  /// time to arrive.
  std::chrono::milliseconds picture_settles{1'000};
  RosSubscriptions::Timeouts topics;
  KabamTimeouts kabam;
};

/// What the robot sends, as far as known.
struct KnownTopics {
  std::vector<Source> sources;                   // with the usual names if the robot does not list topics
  std::optional<std::vector<Endpoint>> offered;  // everything the robot lists
  bool manages_maps = false;                     // its map must not be confused with another one
  bool operator==(const KnownTopics&) const = default;
};

class RosLink : public wire::RobotLink {
  Q_OBJECT
 public:
  /// To be made on its own thread.
  explicit RosLink(LinkOptions options);
  ~RosLink() override;

  void open() override;
  void close() override;
  void trust(const QByteArray& pinned_sha256) override;
  void setWanted(const map::Streams& streams, const QStringList& topics);
  void setBasics(const LiveTopics::Basics& basics);
  /// Somebody records, or not any more: nothing is left out to spare the network, and types are defined.
  void setRecorded(bool on);
  void setEveryMessage(bool on);
  void choose(const Choices& choices);

  /// `then` once it is known what the robot can do, or with a failure about `subject`.
  void whenKnown(const wire::TaskPtr& task, const map::Subject& subject, map::AskedFor asked_for,
                 Checked then);
  // What is asked of it. Their signals may be connected to from any thread, all else happens on this one.
  RosMaps& maps() { return maps_; }
  KabamRequests& kabam() { return kabam_; }
  KabamPictures& pictures() { return pictures_; }
  DispatchRequests& dispatch() { return dispatch_; }

 Q_SIGNALS:
  void topicsKnown(const mapwright::robot::ros::KnownTopics& known);
  void receptionTold(const mapwright::robot::Reception& reception);
  /// OffersTopics::unplacedMarkers(); comes before the messages with the others.
  void unplacedMarkersTold(const std::map<QString, int>& by_topic);
  void pictureServiceKnown(bool there);  // comes before mapManagerKnown()
  void mapManagerKnown(bool there);

 private:
  /// The last problem reported for a topic, and when: the same one is not repeated with every message.
  struct Trouble {
    Fault reason;
    qint64 told_ms = 0;
  };

  net::rosbridge::ClientOptions clientOptions() const;
  void listen();
  void begin();
  void onLink();
  void look();
  void lookAnew();
  void keepUnheard(RosGraph& found) const;
  void onLook(RosGraph found, std::optional<std::string> manager);
  void awaitManager();
  void findSources();
  bool managesMaps() const;
  void notifyReception();
  void reportUnplacedMarkers();
  void recordDelay(const Source& source, const net::rosbridge::TopicMessage& message);
  void sync();
  void publishState();
  void onReceived(const net::rosbridge::TopicMessage& message);
  void onAskedMap(const std::string& service, const net::rosbridge::CallAnswer& answer);
  void onManagerMessage(const net::rosbridge::TopicMessage& message);
  void emitResult(WorldResult result);
  void updateTrouble(const std::string& topic, map::ProblemCode code, const std::optional<Fault>& reason);
  void forgetTrouble(const std::string& topic);
  void notifyPose();
  bool framesComplete() const;
  void emitTopic(const std::string& topic, map::TopicMessage message, double received_s,
                 std::optional<double> recorded_s);
  bool isOpen() const { return client_->link().state() == net::WebSocketLink::State::Open; }
  double wall() const;

  LinkOptions options_;
  RosWorld world_;
  TopicSelection selection_;
  RosGraph graph_;
  std::vector<Source> sources_;
  std::vector<std::string> robots_;  // with transforms of their own
  Choices choices_;
  std::unique_ptr<net::rosbridge::Client> client_;  // goes first: it may call those below
  RosApi api_;
  RosSubscriptions subscriptions_;
  RosDeliveries deliveries_;
  LiveMap live_map_;
  MapFromService map_service_;
  DispatchRequests dispatch_;
  KabamRequests kabam_;
  KabamPictures pictures_;
  RosMaps maps_;
  QTimer look_timer_, pose_timer_, overdue_timer_;
  std::map<std::string, int> unplaced_markers_;  // as they were told
  Reception reception_;                          // of this connection, but for the transforms
  std::size_t before_ = 0;                       // what was replaced on connections before
  std::optional<double> least_late_s_;           // arrival less stamp, at best
  QElapsedTimer reception_told_;
  bool wanted_ = false;
  bool looking_ = false;
  bool look_again_ = false;      // when this look is over: it may tell of before
  bool known_ = false;           // what this connection's robot has
  bool was_known_ = false;       // on a connection before
  bool awaits_manager_ = false;  // connected, and looking for the map manager that is not there yet
  int round_ = 0;                // of connections
  wire::WaitList early_;         // for what the robot has to be known
  std::map<std::string, std::map<map::ProblemCode, Trouble>> troubles_;  // by topic
  QElapsedTimer known_since_;                                            // of this connection
  QElapsedTimer clock_, pose_told_, pose_missing_;
  std::optional<geometry::Pose2> last_pose_;
};

}  // namespace mapwright::robot::ros
