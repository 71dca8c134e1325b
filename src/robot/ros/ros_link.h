// The network side of a ROS robot behind a rosbridge server. Lives on its own thread; values go in and out by
// queued calls. Source: docs/protocols/rosbridge.md, docs/protocols/kabam-map-manager.md.
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
#include "robot/wire/raw_limit.h"
#include "robot/wire/tap_place.h"
#include "robot/wire/topic_mailbox.h"

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
  std::chrono::milliseconds look_patience{3'000};
  std::chrono::milliseconds pose_every{50};  // told at most so often
  std::chrono::milliseconds map_patience{10'000};
  AskedMap::Patience asked_map;
  DispatchWish dispatch;
  DispatchPatience dispatch_patience;
  /// Which map a picture belongs to is reported on another topic, before or after it: this long both have
  /// time to arrive.
  std::chrono::milliseconds picture_settles{1'000};
  RosSubscriptions::Patience topics;
  KabamPatience kabam;
};

/// What the robot sends, as far as known.
struct KnownTopics {
  std::vector<Source> sources;                     // with the usual names if the robot does not list topics
  std::optional<std::vector<FoundTopic>> offered;  // everything the robot lists
  bool manages_maps = false;                       // its map must not be confused with another one
  bool operator==(const KnownTopics&) const = default;
};

class RosLink : public QObject {
  Q_OBJECT
 public:
  /// Large messages go to `mailbox`, frames to `tap`, and all messages to `deliveries`: all are shared.
  RosLink(LinkOptions options, std::shared_ptr<wire::TopicMailbox> mailbox,
          std::shared_ptr<wire::TapPlace> tap, std::shared_ptr<wire::DeliveryPlace> deliveries);
  ~RosLink() override;

  void open();
  void close();
  void trust(const QByteArray& pinned_sha256);  // from now on; also connects
  void setWanted(const map::Streams& streams, const QStringList& topics);
  void setBasics(const LiveTopics::Basics& basics);
  void setWatching(bool on) { watching_ = on; }
  /// Sends the definitions of all types delivered so far to the new tap in the deliveries.
  void defineTypes();
  void setEveryMessage(bool on);
  void setRecorded(bool on);  // a recording is running: no message is dropped to save bandwidth
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
  void silenceChanged(const QDateTime& since);  // as in MeasuresSilence; emitted before stateChanged()
  void topicReceived(const mapwright::map::StampedMessage& message);
  void mailArrived();  // the mailbox was empty and has content now
  void rawReceived(const mapwright::robot::RawMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void topicsKnown(const mapwright::robot::ros::KnownTopics& known);
  void receptionTold(const mapwright::robot::Reception& reception);
  void mapManagerKnown(bool there);
  void pictureServiceKnown(bool there);         // comes before mapManagerKnown()
  void pictureChanged(const QString& map_id);   // the picture of the current map has changed, or may have
  void mapManagerStands(const QString& state);  // its present state; emitted before mapsChanged()
  void mapsChanged();
  void waypointsChanged();
  void dispatchKnown(const mapwright::robot::ros::FoundDispatch& found);
  void dispatchedMapChanged();
  void projectedCame(const std::shared_ptr<const mapwright::robot::ProjectedPart>& part);
  void projectedGone(int index);
  void mapExtentTold(const std::optional<mapwright::robot::MapExtent>& extent);
  void projectedSilent(const QStringList& topics);  // exactly these; emitted before the answer

 private:
  /// The last problem reported for a topic, and when: the same one is not repeated with every message.
  struct Trouble {
    Fault reason;
    qint64 told_ms = 0;
  };
  /// A request that waits until the robot's capabilities are known.
  struct Early {
    wire::ErrandPtr errand;
    std::function<void(std::optional<map::Failure>)> then;
    int number = 0;
  };
  using EarlyPtr = std::shared_ptr<Early>;

  void start();  // creates the network objects, on this object's thread
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
  /// Requests missing type definitions, one after the other.
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
  // Projections of a dispatcher are listed and fetched like maps.
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
  std::set<std::string> pictures_doubted_;            // maps whose picture has to be checked again
  RosWorld world_;
  TopicWish wish_;
  Found found_;
  std::vector<Source> sources_;
  // Types of messages delivered on this connection, and those whose definition is still unknown.
  std::set<std::string> delivered_types_, defined_types_;
  bool defining_ = false;
  Choices choices_;
  Reception reception_;                 // of this connection, except the transforms
  std::size_t before_ = 0;              // dropped on earlier connections
  std::optional<double> least_late_s_;  // arrival less stamp, at best
  QElapsedTimer reception_told_;
  bool wanted_ = false, watching_ = false;
  bool looking_ = false;
  bool look_again_ = false;  // look again when this look is over, as its result may be outdated
  bool known_ = false;       // the robot's topics on this connection are known
  bool was_known_ = false;   // they were known on an earlier connection
  bool has_manager_ = false;
  bool awaits_manager_ = false;  // connected, and looking for the missing map manager
  int round_ = 0;                // of connections
  std::list<EarlyPtr> early_;
  std::map<std::string, std::map<map::ProblemCode, Trouble>> troubles_;  // by topic
  wire::RawLimit raw_limit_;
  QElapsedTimer known_since_;  // of this connection
  QElapsedTimer clock_, pose_told_, pose_missing_;
  std::optional<geometry::Pose2> last_pose_;
};

}  // namespace mapwright::robot::ros
