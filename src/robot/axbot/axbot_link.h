// The network side of an Autoxing robot. Lives on its own thread; values go in and out by queued calls.
// Source: docs/protocols/autoxing.md, "Requests", "Live topics".
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUrl>

#include "map/live_topics.h"
#include "map/stream.h"
#include "net/http_cache.h"
#include "net/http_client.h"
#include "net/web_socket_link.h"
#include "robot/axbot/bag_requests.h"
#include "robot/axbot/map_changes.h"
#include "robot/axbot/map_requests.h"
#include "robot/axbot/overlay_requests.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/pose_requests.h"
#include "robot/axbot/sighting_requests.h"
#include "robot/axbot/topic_subscriptions.h"
#include "robot/axbot/transfer_requests.h"
#include "robot/wire/robot_link.h"

namespace mapwright::robot::axbot {

/// How to reach a robot. `secret` is sent to `base` only.
struct LinkOptions {
  QUrl base;  // http(s)://host:port[/prefix]
  QByteArray secret;
  net::Trust trust;
  QString cache_folder;  // empty = nothing is kept on disk
  net::WebSocketLinkOptions socket;
  std::chrono::milliseconds fetch_timeout{30'000};   // of submaps
  std::chrono::milliseconds answer_timeout{30'000};  // of requests about maps: without a byte
  std::chrono::milliseconds ask_again_after{1'000};  // after a message that nobody could read, at first
  PoseRequests::Patience pose_patience;
  std::chrono::milliseconds recording_patience{2'000};  // for a new recording to be listed
  std::chrono::milliseconds older_names_after{2'500};   // of silence of a stream that was asked for
  /// The time of day, in seconds since the epoch, that arriving messages are stamped with. On any thread.
  std::function<double()> wall_s = wire::secondsOfDay;
};

class AxbotLink : public wire::RobotLink {
  Q_OBJECT
 public:
  /// To be made on its own thread.
  explicit AxbotLink(LinkOptions options);

  void open() override;
  void close() override;
  void trust(const QByteArray& pinned_sha256) override;
  void submap(const wire::TaskPtr& task, const map::SubmapKey& key, OutcomeTo<map::SubmapAnswer> reply);
  void discardSubmap(const map::SubmapKey& key, std::int32_t answered_version);
  void fetch(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
    maps_.fetch(task, key, std::move(reply));
  }
  void discardPicture(const std::string& fingerprint);
  void setWanted(const map::Streams& streams, const QStringList& topics);
  void setBasics(const LiveTopics::Basics& basics);
  MapRequests& maps() { return maps_; }
  MapChanges& changes() { return changes_; }
  BagRequests& bags() { return bags_; }
  OverlayRequests& overlays() { return overlays_; }
  SightingRequests& sightings() { return sightings_; }
  PoseRequests& poses() { return poses_; }
  TransferRequests& transfers() { return transfers_; }
  /// A request for the overview; also notes if the robot does not support it.
  void fetchOverview(const wire::TaskPtr& task, double resolution_m, OutcomeTo<map::WholeMap> reply);

 Q_SIGNALS:
  void identityChanged(const mapwright::robot::RobotIdentity& identity);
  /// Its answer to a request for an overview, if that says that it does not support it.
  void overviewUnknown(const QString& answer);

 private:
  void askDeviceInfo();
  void onDeviceInfo(const net::HttpAnswer& answer);
  void subscribe();
  RobotServer server();
  void send(const QStringList& requests);
  void askForWanted();
  /// Latched messages are sent again after a new subscription: used after an unreadable message of unknown
  /// topic, for the topics it may have belonged to.
  void askAgainForOnceSaid();
  /// Streams that are silent so far and have another name in older firmware.
  map::Streams silentStreams() const;
  void deliver(std::shared_ptr<const std::string> bytes, const std::string& topic, const char* encoding,
               std::optional<double> said_s);
  void deliverDefinition();
  void onText(const QByteArray& utf8);
  void onBinary(const QByteArray& bytes);
  map::SubmapAnswer onSubmap(const map::SubmapKey& key, const QUrl& url, const net::HttpAnswer& http);
  /// `topic` as it was sent, whatever the message became of it.
  void emitTopic(const std::string& topic, map::TopicMessage message);
  void publishState();
  Fault unavailableReason() const;
  QUrl submapUrl(const map::SubmapKey& key, std::int32_t version) const;

  LinkOptions options_;
  TopicReader topic_reader_;
  TopicSubscriptions subscriptions_;
  std::set<std::string> unreadable_topics_;      // whose last message could not be read
  const std::unique_ptr<net::HttpCache> cache_;  // null: nothing is kept on disk
  net::HttpClient http_;
  MapRequests maps_;
  MapChanges changes_;
  BagRequests bags_;
  OverlayRequests overlays_;
  SightingRequests sightings_;
  TransferRequests transfers_;
  PoseRequests poses_;
  GridFetcher grids_;
  net::WebSocketLink socket_;
  QTimer list_timer_, subscribe_timer_, older_timer_, again_timer_;
  map::Streams streams_;                 // that are wanted
  QStringList topics_;                   // that are wanted by name
  QStringList held_;                     // that are needed for a request in progress
  std::optional<double> robot_ahead_s_;  // of the clock here, by the newest stamp
  map::Streams older_;  // streams whose older names are subscribed as well on this connection
  std::map<std::string, int> heard_topics_;  // number of messages on this connection
  bool delivered_definition_ = false;        // likewise: the definition of binary frames
  bool wanted_ = false;
  bool device_info_answered_ = false;
  bool device_info_asked_ = false;
  bool subscribed_ = false;  // on this connection
  bool topics_confirmed_ = false;
};

}  // namespace mapwright::robot::axbot
