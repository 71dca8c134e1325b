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
#include "net/http_client.h"
#include "net/web_socket_link.h"
#include "robot/axbot/bag_requests.h"
#include "robot/axbot/grid_fetcher.h"
#include "robot/axbot/map_requests.h"
#include "robot/axbot/parse_topics.h"
#include "robot/axbot/raw_messages.h"
#include "robot/axbot/topic_subscriptions.h"
#include "robot/robot.h"
#include "robot/wire/delivery_place.h"
#include "robot/wire/raw_limit.h"
#include "robot/wire/tap_place.h"
#include "robot/wire/topic_mailbox.h"

namespace mapwright::net {
class HttpCache;
}

namespace mapwright::robot::axbot {

/// The system's clock.
double secondsOfDay();

/// How to reach a robot. `secret` is sent to `base` only.
struct LinkOptions {
  QUrl base;  // http(s)://host:port[/prefix]
  QByteArray secret;
  net::Trust trust;
  QString cache_folder;  // empty = no disk cache
  qint64 cache_budget_bytes = qint64(2) << 30;
  net::WebSocketLinkOptions socket;
  std::chrono::milliseconds fetch_timeout{30'000};         // of submaps
  std::chrono::milliseconds patience{30'000};              // for requests about maps: without a byte
  std::chrono::milliseconds list_expected_within{10'000};  // after subscribing, before it is reported
  std::chrono::milliseconds ask_again_after{1'000};        // first delay after an unreadable message
  std::chrono::milliseconds older_names_after{2'500};      // of silence on a requested stream
  /// The time of arriving messages, in seconds since the epoch. On any thread.
  std::function<double()> wall_s = secondsOfDay;
};

class AxbotLink : public QObject {
  Q_OBJECT
 public:
  /// Large messages go to `mailbox`, frames to `tap`, and everything to `deliveries`: all are shared.
  AxbotLink(LinkOptions options, std::shared_ptr<wire::TopicMailbox> mailbox,
            std::shared_ptr<wire::TapPlace> tap, std::shared_ptr<wire::DeliveryPlace> deliveries);
  ~AxbotLink() override;

  void open();
  void close();
  void trust(const QByteArray& pinned_sha256);  // from now on; also connects
  void fetch(quint64 ticket, const map::SubmapKey& key);
  void cancel(const map::SubmapKey& key);
  void cancelFetch(quint64 ticket);
  void cancelAll();  // the fetches of submaps
  void discard(const map::SubmapKey& key, std::int32_t answered_version);
  void discardPicture(const std::string& fingerprint);
  void setWanted(const map::Streams& streams, const QStringList& topics);
  void setBasics(const LiveTopics::Basics& basics);
  void setWatching(bool on) { watching_ = on; }
  MapRequests& maps();
  BagRequests& bags();
  /// A request for the overview; also notes if the robot does not support it.
  void fetchOverview(wire::ErrandPtr errand, double resolution_m, OutcomeTo<map::WholeMap> reply);

 Q_SIGNALS:
  void stateChanged(const mapwright::robot::ConnectionState& state);
  void silenceChanged(const QDateTime& since);  // as in MeasuresSilence; emitted before stateChanged()
  void identityChanged(const mapwright::robot::RobotIdentity& identity);
  void topicReceived(const mapwright::map::StampedMessage& message);
  void mailArrived();  // the mailbox was empty and has content now
  void rawReceived(const mapwright::robot::RawMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void answered(quint64 ticket, const mapwright::map::SubmapAnswer& answer);
  /// The answer to a request for an overview shows that the robot does not support it.
  void overviewUnknown(const QString& answer);

 private:
  void start();  // creates the network objects, on this object's thread
  void askDeviceInfo();
  void takeDeviceInfo(const net::HttpAnswer& answer);
  void subscribe();
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
  void takeText(const QByteArray& utf8);
  void takeBinary(const QByteArray& bytes);
  void ask(quint64 ticket, const map::SubmapKey& key);
  void takeSubmap(const map::SubmapKey& key, const QUrl& url, const net::HttpAnswer& http, quint64 ticket);
  /// `topic` as sent, whatever became of the message.
  void emitTopic(const std::string& topic, map::TopicMessage message);
  void publishState();
  Fault whyNot() const;
  QUrl submapUrl(const map::SubmapKey& key, std::int32_t version) const;
  map::Problem problem(map::Severity severity, Fault reason) const;

  LinkOptions options_;
  std::shared_ptr<wire::TopicMailbox> mailbox_;
  std::shared_ptr<wire::TapPlace> tap_;
  std::shared_ptr<wire::DeliveryPlace> deliveries_;
  TopicReader topic_reader_;
  TopicSubscriptions subscriptions_;
  std::set<std::string> unreadable_topics_;  // whose last message was unreadable
  wire::RawLimit raw_limit_;
  QElapsedTimer clock_;
  std::unique_ptr<net::HttpCache> cache_;
  std::unique_ptr<net::HttpClient> http_;
  std::unique_ptr<MapRequests> maps_;
  std::unique_ptr<BagRequests> bags_;
  std::unique_ptr<GridFetcher> grids_;
  std::unique_ptr<net::WebSocketLink> socket_;
  std::unique_ptr<QTimer> list_timer_, subscribe_timer_, older_timer_, again_timer_;
  map::Streams streams_;  // that are wanted
  QStringList topics_;    // that are wanted by name
  map::Streams older_;    // streams whose older names are subscribed as well on this connection
  std::map<std::string, int> heard_topics_;  // number of messages on this connection
  bool delivered_definition_ = false;        // likewise: the definition of binary frames
  bool wanted_ = false;
  bool device_info_answered_ = false;
  bool device_info_asked_ = false;
  bool subscribed_ = false;  // on this connection
  bool topics_confirmed_ = false;
  bool watching_ = false;
  struct Fetch {
    map::SubmapKey key;
    net::HttpClient::RequestId request = 0;
  };
  std::map<quint64, Fetch> under_way_;  // by ticket
};

}  // namespace mapwright::robot::axbot
