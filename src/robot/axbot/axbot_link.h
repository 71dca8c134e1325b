// The network half of an Autoxing robot. Lives on a thread of its own; values go in and out by queued calls.
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
#include "robot/wire/link_log.h"
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
  QString cache_folder;  // empty = nothing is kept on disk
  qint64 cache_budget_bytes = qint64(2) << 30;
  net::WebSocketLinkOptions socket;
  std::chrono::milliseconds fetch_timeout{30'000};         // of submaps
  std::chrono::milliseconds patience{30'000};              // of questions about maps: without a byte
  std::chrono::milliseconds list_expected_within{10'000};  // after subscribing, before it is remarked upon
  std::chrono::milliseconds ask_again_after{1'000};        // after a message that nobody could read, at first
  std::chrono::milliseconds older_names_after{2'500};      // of silence of a stream that was asked for
  /// The time of day, in seconds since the epoch, that arriving messages are stamped with. On any thread.
  std::function<double()> wall_s = secondsOfDay;
};

class AxbotLink : public QObject {
  Q_OBJECT
 public:
  /// Large messages go into `mailbox`, frames to whoever sits in `tap`, all that comes to whoever sits in
  /// `deliveries`: they are shared with others.
  AxbotLink(LinkOptions options, std::shared_ptr<wire::TopicMailbox> mailbox,
            std::shared_ptr<wire::TapPlace> tap, std::shared_ptr<wire::DeliveryPlace> deliveries);
  ~AxbotLink() override;

  void open();
  void close();
  void trust(const QByteArray& pinned_sha256);  // from now on, and connects
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
  /// A question of the overview, to be noted when this robot does not know it.
  void fetchOverview(wire::ErrandPtr errand, double resolution_m, OutcomeTo<map::WholeMap> reply);

 Q_SIGNALS:
  void stateChanged(const mapwright::robot::ConnectionState& state);
  void silenceChanged(const QDateTime& since);  // as MeasuresSilence says; comes before stateChanged()
  void identityChanged(const mapwright::robot::RobotIdentity& identity);
  void topicReceived(const mapwright::map::StampedMessage& message);
  void mailArrived();  // the mailbox was empty and is no more
  void rawReceived(const mapwright::robot::RawMessage& message);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void answered(quint64 ticket, const mapwright::map::SubmapAnswer& answer);
  /// It was asked for an overview and answered so, which is how one answers who knows no such question.
  void overviewUnknown(const QString& answer);

 private:
  void start();  // makes the network objects, on this object's thread
  void askDeviceInfo();
  void takeDeviceInfo(const net::HttpAnswer& answer);
  void subscribe();
  void send(const QStringList& requests);
  void askForWanted();
  /// What is said once is said again to whoever asks anew: after a message that could not even be told whose
  /// it was, for the topics that it may have been.
  void askAgainForOnceSaid();
  /// Streams of which nothing has come, and that older firmware calls otherwise.
  map::Streams silentStreams() const;
  void deliver(std::shared_ptr<const std::string> bytes, const std::string& topic, const char* encoding,
               std::optional<double> said_s);
  void deliverDefinition();
  void takeText(const QByteArray& utf8);
  void takeBinary(const QByteArray& bytes);
  void ask(quint64 ticket, const map::SubmapKey& key);
  void takeSubmap(const map::SubmapKey& key, const QUrl& url, const net::HttpAnswer& http, quint64 ticket);
  /// `topic` as it was sent, whatever the message became of it.
  void emitTopic(const std::string& topic, map::TopicMessage message);
  void publishState();
  Fault whyNot() const;
  QUrl submapUrl(const map::SubmapKey& key, std::int32_t version) const;
  map::Problem problem(map::Severity severity, Fault reason) const;

  LinkOptions options_;
  std::shared_ptr<wire::TopicMailbox> mailbox_;
  std::shared_ptr<wire::TapPlace> tap_;
  std::shared_ptr<wire::DeliveryPlace> deliveries_;
  wire::LinkLog link_log_;
  TopicReader topic_reader_;
  TopicSubscriptions subscriptions_;
  std::set<std::string> unreadable_topics_;  // whose last message could not be read
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
  map::Streams older_;    // streams whose older names are asked for too, on this connection
  std::map<std::string, int> heard_topics_;  // how often, on this connection
  bool delivered_definition_ = false;        // likewise: of what binary frames hold
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
