// The network half of a ROS robot behind a rosbridge server. Lives on a thread of its own; values go in and
// out by queued calls. Source: docs/protocols/rosbridge.md, docs/protocols/kabam-map-manager.md.
#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUrl>

#include "net/rosbridge/client.h"
#include "robot/offers_topics.h"
#include "robot/picture_store.h"
#include "robot/robot.h"
#include "robot/ros/asked_map.h"
#include "robot/ros/dispatch_requests.h"
#include "robot/ros/kabam_pictures.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/live_map.h"
#include "robot/ros/ros_api.h"
#include "robot/ros/ros_subscriptions.h"
#include "robot/ros/ros_world.h"
#include "robot/waypoint_store.h"
#include "robot/wire/delivery_place.h"
#include "robot/wire/errand.h"
#include "robot/wire/link_log.h"
#include "robot/wire/raw_limit.h"
#include "robot/wire/tap_place.h"
#include "robot/wire/topic_mailbox.h"

namespace mapwright::robot::ros {

/// How to reach a robot. `secret` is for rosauth, and is said to `url` only.
struct LinkOptions {
  QUrl url;  // ws(s)://host:port[/path]
  QByteArray secret;
  std::string ns;           // "/robot1": what is below it goes first; empty = none
  bool kabam_only = false;  // without a map manager it is not the robot that was meant, yet
  net::Trust trust;
  net::rosbridge::ClientOptions client;
  std::chrono::milliseconds look_every{10'000};  // which topics and services there are
  std::chrono::milliseconds look_patience{3'000};
  std::chrono::milliseconds pose_every{50};  // told at most so often
  std::chrono::milliseconds map_patience{10'000};
  AskedMap::Patience asked_map;
  DispatchWish dispatch;
  DispatchPatience dispatch_patience;
  /// Which map a picture is of is told by another topic, before it or after it: both have come by then.
  std::chrono::milliseconds picture_settles{1'000};
  RosSubscriptions::Patience topics;
  KabamPatience kabam;
};

/// What the robot sends, as far as that is known.
struct KnownTopics {
  std::vector<Source> sources;                     // of the usual names where the robot does not tell
  std::optional<std::vector<FoundTopic>> offered;  // all that the robot tells of
  bool manages_maps = false;                       // its map is not to be taken for another one
  bool operator==(const KnownTopics&) const = default;
};

class RosLink : public QObject {
  Q_OBJECT
 public:
  /// Large messages go into `mailbox`, frames to whoever sits in `tap`, all messages to whoever sits in
  /// `deliveries`: they are shared with others.
  RosLink(LinkOptions options, std::shared_ptr<wire::TopicMailbox> mailbox,
          std::shared_ptr<wire::TapPlace> tap, std::shared_ptr<wire::DeliveryPlace> deliveries);
  ~RosLink() override;

  void open();
  void close();
  void trust(const QByteArray& pinned_sha256);  // from now on, and connects
  void setWanted(const map::Streams& streams, const QStringList& topics);
  void setBasics(const LiveTopics::Basics& basics);
  void setWatching(bool on) { watching_ = on; }
  /// Whoever sits in the deliveries now gets the definitions of all types that were delivered.
  void defineTypes();
  void setEveryMessage(bool on);
  void setRecorded(bool on);  // somebody sits in the deliveries: nothing is left out to spare the network
  void choose(const Choices& choices);

  void list(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const wire::ErrandPtr& errand, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void fetch(const wire::ErrandPtr& errand, const map::MapKey& key, OutcomeTo<map::WholeMap> reply);
  void waypoints(const wire::ErrandPtr& errand, const map::MapKey& key, OutcomeTo<StoredWaypoints> reply);
  void perform(const wire::ErrandPtr& errand, const map::MapKey& key, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply);
  void carryOut(const wire::ErrandPtr& errand, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);
  void dispatchGrid(const wire::ErrandPtr& errand, const std::optional<map::GridRegion>& region,
                    OutcomeTo<map::GridPart> reply);
  void dispatchCloud(const wire::ErrandPtr& errand, CloudKind kind,
                     const std::optional<map::CloudRegion>& region,
                     OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply);
  void dispatchSave(const wire::ErrandPtr& errand, const std::string& filename, OutcomeTo<std::string> reply);
  void dispatchProjections(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::Projection>> reply);
  void dispatchProject(const wire::ErrandPtr& errand, const std::vector<map::Projection>& wanted,
                       OutcomeTo<std::vector<map::Projection>> reply);
  void writePicture(const wire::ErrandPtr& errand, const PictureChange& change,
                    OutcomeTo<PictureReceipt> reply);

 Q_SIGNALS:
  void stateChanged(const mapwright::robot::ConnectionState& state);
  void silenceChanged(const QDateTime& since);  // as MeasuresSilence says; comes before stateChanged()
  void topicReceived(const mapwright::map::StampedMessage& message);
  void mailArrived();  // the mailbox was empty and is no more
  void rawReceived(const mapwright::robot::RawMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void topicsKnown(const mapwright::robot::ros::KnownTopics& known);
  void receptionTold(const mapwright::robot::Reception& reception);
  void mapManagerKnown(bool there);
  void pictureServiceKnown(bool there);         // comes before mapManagerKnown()
  void pictureChanged(const QString& map_id);   // of the current map: it is another one, or may be
  void mapManagerStands(const QString& state);  // what it does now; comes before mapsChanged()
  void mapsChanged();
  void waypointsChanged();
  void dispatchKnown(const mapwright::robot::ros::FoundDispatch& found);
  void dispatchedMapChanged();
  void projectedCame(const std::shared_ptr<const mapwright::robot::ProjectedPart>& part);
  void projectedGone(int index);
  void mapExtentTold(const std::optional<mapwright::robot::MapExtent>& extent);
  void projectedSilent(const QStringList& topics);  // and no others; comes before the answer

 private:
  /// What was told of a topic last, and when: the same is not told at the rate of its messages.
  struct Trouble {
    Fault reason;
    qint64 told_ms = 0;
  };
  /// A question that waits until it is known what the robot can do.
  struct Early {
    wire::ErrandPtr errand;
    std::function<void(std::optional<map::Failure>)> then;
    int number = 0;
  };
  using EarlyPtr = std::shared_ptr<Early>;

  void start();  // makes the network objects, on this object's thread
  void wireClient();
  void wireParts();
  void begin();
  void noteLink();
  void look();
  void lookAnew();
  void keepUnheard(Found& found) const;
  void takeLook(Found found, std::optional<std::string> manager);
  void awaitManager();
  void findSources();
  bool managesMaps() const;
  void tellReception();
  void noteDelay(const Source& source, const net::rosbridge::TopicMessage& message);
  void sync();
  void publishState();
  void take(const net::rosbridge::TopicMessage& message);
  void deliver(const std::string& name, std::string type, std::string slot,
               const std::shared_ptr<const net::rosbridge::Frame>& frame, const char* member,
               std::optional<double> said_s, double received_s);
  void deliverMessage(const net::rosbridge::TopicMessage& message);
  /// Asks what the types to be defined are made of, one after the other.
  void askDefinition();
  void deliverDefinition(const std::string& type, const std::optional<RosDefinition>& definition);
  void takeAskedMap(const std::string& service, const net::rosbridge::CallAnswer& answer);
  void takeOfManager(const net::rosbridge::TopicMessage& message);
  void comparePicture();
  void tell(WorldResult result);
  void note(const std::string& topic, map::ProblemCode code, const std::optional<Fault>& reason);
  void forgetTrouble(const std::string& topic);
  void tellPose();
  bool framesComplete() const;
  void emitTopic(const std::string& topic, map::TopicMessage message, double received_s,
                 std::optional<double> recorded_s);
  void report(map::Severity severity, Fault reason);
  void whenKnown(const wire::ErrandPtr& errand, map::Subject subject, map::AskedFor asked_for,
                 std::function<void(std::optional<map::Failure>)> then);
  void endEarly(const EarlyPtr& early, std::optional<map::FailureKind> failure);
  std::optional<map::CatalogueEntry> liveEntry() const;
  // What a dispatcher projects is listed and fetched like maps.
  std::shared_ptr<const ProjectedPart> findProjected(const map::MapKey& key) const;
  void listKept(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void addProjected(std::vector<map::CatalogueEntry>& entries) const;
  Outcome<map::WholeMap> projectedMap(const ProjectedPart& projected) const;
  bool open_() const;
  double wall() const;

  LinkOptions options_;
  std::shared_ptr<wire::TopicMailbox> mailbox_;
  std::shared_ptr<wire::TapPlace> tap_;
  std::shared_ptr<wire::DeliveryPlace> deliveries_;
  wire::LinkLog link_log_;
  std::unique_ptr<net::rosbridge::Client> client_;
  std::unique_ptr<RosApi> api_;
  std::unique_ptr<KabamRequests> kabam_;
  std::unique_ptr<RosSubscriptions> subscriptions_;
  std::unique_ptr<LiveMap> live_map_;
  std::unique_ptr<AskedMap> asked_map_;
  std::unique_ptr<DispatchRequests> dispatch_;
  std::unique_ptr<KabamPictures> pictures_;
  std::unique_ptr<QTimer> look_timer_, pose_timer_, overdue_timer_, picture_timer_;
  std::map<std::string, std::string> pictures_seen_;  // fingerprints, by map
  std::set<std::string> pictures_doubted_;            // maps whose picture is to be looked at anew
  RosWorld world_;
  TopicWish wish_;
  Found found_;
  std::vector<Source> sources_;
  // Types of messages that were delivered on this connection, and those whose definition is not known yet.
  std::set<std::string> delivered_types_, defined_types_;
  bool defining_ = false;
  Choices choices_;
  Reception reception_;                 // of this connection, but for the transforms
  std::size_t before_ = 0;              // what made way on connections before
  std::optional<double> least_late_s_;  // arrival less stamp, at best
  QElapsedTimer reception_told_;
  bool wanted_ = false, watching_ = false;
  bool looking_ = false;
  bool look_again_ = false;  // when this look is over: it may tell of before
  bool known_ = false;       // what this connection's robot has
  bool was_known_ = false;   // on a connection before
  bool has_manager_ = false;
  bool awaits_manager_ = false;  // connected, and looking for the map manager that is not there yet
  int round_ = 0;                // of connections
  std::list<EarlyPtr> early_;
  std::map<std::string, std::map<map::ProblemCode, Trouble>> troubles_;  // by topic
  wire::RawLimit raw_limit_;
  QElapsedTimer known_since_;  // of this connection
  QElapsedTimer clock_, pose_told_, pose_missing_;
  std::optional<geometry::Pose2> last_pose_;
};

}  // namespace mapwright::robot::ros
