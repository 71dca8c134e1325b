// The network side of an Agibot robot. Lives on its own thread; values go in and out by queued calls. Source:
// docs/protocols/agibot-aimdk.md.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUrl>

#include "net/backoff.h"
#include "net/http_client.h"
#include "robot/aimdk/map_changes.h"
#include "robot/aimdk/parse_rpc.h"
#include "robot/aimdk/point_changes.h"
#include "robot/wire/robot_link.h"
#include "robot/wire/task.h"

namespace mapwright::robot::aimdk {

struct LinkOptions {
  QUrl base;  // http(s)://host:port[/prefix]
  net::Trust trust;
  std::chrono::milliseconds poll_every{5'000};   // while online, to detect a lost connection
  std::chrono::milliseconds quiet_after{3'000};  // a poll without an answer for this long is reported
  std::chrono::milliseconds timeout{10'000};     // for the small questions
  std::chrono::milliseconds map_timeout{60'000};
  std::chrono::milliseconds mapping_every{30'000};  // while online: whether it is mapping
  std::chrono::milliseconds probe_again{10'000};    // while online: whether it has the newer services
  ChangeTimes changes;
  std::chrono::milliseconds backoff_first{500}, backoff_limit{30'000};
  std::chrono::milliseconds healthy_after{
      30'000};  // online for this long = the next loss starts with the first backoff
  quint32 jitter_seed = 1;
  std::function<double()> wall_s = wire::secondsOfDay;  // seconds since the epoch, on any thread
};

/// What newer firmware has, which only third parties tell of.
struct NewerServices {
  std::optional<bool> there = {};    // nullopt = not known yet
  std::optional<bool> mapping = {};  // likewise
  bool operator==(const NewerServices&) const = default;
};

/// What an answer (2xx) of the robot says instead of a result.
map::Failure said(const net::HttpAnswer& answer, map::Subject subject, const RpcError& error);

/// Why a change was not accepted, or is not known to be; nullopt: it was accepted.
std::optional<map::Failure> notAccepted(const net::HttpAnswer& answer, map::Subject subject);
/// Nothing more will be learned about the change by looking.
bool isFinal(const map::Failure& of_change);

/// What points are asked for. The answer that came with the map serves once for the first two of them, for
/// some seconds; who changes points always asks.
enum class TopologyUse { Showing, Editing, Changing };

class AimdkLink : public wire::RobotLink {
  Q_OBJECT
 public:
  /// To be made on its own thread.
  explicit AimdkLink(LinkOptions options);

  void open() override;
  void close() override;
  void trust(const QByteArray& pinned_sha256) override;
  void list(wire::TaskPtr task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(wire::TaskPtr task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  void fetch(wire::TaskPtr task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply);
  void waypoints(wire::TaskPtr task, const map::MapKey& key, OutcomeTo<map::WaypointList> reply);

  using Reply = std::function<void(const net::HttpAnswer&)>;
  MapChanges& maps() { return map_changes_; }
  PointChanges& points() { return point_changes_; }
  /// A request of `task`.
  void post(const wire::TaskPtr& task, const char* method, const QByteArray& body, Reply reply);
  /// The points as they are now, and the map that they lie on, without its picture (null: unknown).
  using TopologyReply = std::function<void(Outcome<Topology>, const ParsedMap*)>;
  void topology(const wire::TaskPtr& task, const map::MapKey& key, TopologyUse use, TopologyReply reply);
  /// Whether it is mapping. Told by newerKnown(), too.
  void lookAtMapping(const wire::TaskPtr& task, OutcomeTo<bool> reply);

 Q_SIGNALS:
  void currentMapChanged();
  void newerKnown(const mapwright::robot::aimdk::NewerServices& newer);  // before it is online, and later

 private:
  net::HttpRequest request(const char* method, const QByteArray& body,
                           std::chrono::milliseconds timeout) const;
  /// A request of the connection itself.
  void ask(const char* method, const QByteArray& body, Reply reply);
  void deliver(const char* method, const net::HttpAnswer& answer);
  void attempt();
  /// Asks for the newest thing that only reads, GetRealtimeMapData: whoever has it is taken to have all of
  /// the newer services. None of the others can be tried without changing something, so their first use
  /// tells. Its answer has a picture while it is mapping: it may be slow, and nothing else waits for it.
  void probe();
  void onProbe(const net::HttpAnswer& answer);
  /// There is no answer to it in this connection so far.
  void leaveUntold();
  void onNewerFirmware(const NewerServices& newer);
  void poll();
  void goOnline();
  void hear();
  void onSilence();
  void interrupt(const net::HttpAnswer& answer);
  void interrupt(const Fault& reason, map::FailureKind failure);
  void updateCurrent(const std::string& id);
  void enter(ConnectionPhase phase, std::optional<int> retry_in_ms = {});
  void fetchParsed(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<ParsedMap> reply);

  LinkOptions options_;
  net::HttpClient http_;
  QTimer timer_;    // until the next try, or the next poll; or it is online without the answer to the probe
  QTimer healthy_;  // while online, until it counts as healthy
  QTimer quiet_;    // while a poll is in progress, until it takes longer than is usual here
  net::Backoff backoff_;
  bool wanted_ = false;
  net::HttpClient::RequestId asking_ = 0;   // the connection's own request in progress
  net::HttpClient::RequestId probing_ = 0;  // likewise, beside it
  int attempt_ = 0;
  QElapsedTimer polled_;                  // since the current poll was sent
  std::chrono::milliseconds slowest_{0};  // of the recent polls
  QDateTime heard_at_;                    // the last answer; invalid before the first
  std::optional<QDateTime> silent_since_;
  ConnectionPhase phase_ = ConnectionPhase::Offline;
  Fault reason_;  // why it is not online
  std::optional<UntrustedCertificate> certificate_;
  map::FailureKind failure_ = map::FailureKind::None;
  std::optional<std::string> current_;
  bool maps_left_out_ = false;  // of the list that came last
  NewerServices newer_;
  QElapsedTimer probed_;  // since it was last told, or should have been
  /// One request for all concurrent callers; cancelled when none of them needs it any more.
  struct SharedFetch {
    wire::TaskPtr task;
    std::vector<std::pair<wire::TaskPtr, OutcomeTo<ParsedMap>>> waiting;
  };
  void placeFetched(const map::MapKey& key, const std::shared_ptr<SharedFetch>& shared, ParsedMap parsed);
  void endFetch(const map::MapKey& key, const std::shared_ptr<SharedFetch>& shared,
                const Outcome<ParsedMap>& parsed);
  void leave(const map::MapKey& key, const std::shared_ptr<SharedFetch>& shared);
  std::map<map::MapKey, std::shared_ptr<SharedFetch>> fetching_;
  /// The answer of GetTopoMsgs that came with the last map; nullopt: it is too old, or has served that use.
  std::optional<net::HttpAnswer> topologyAtHand(const map::MapKey& key, TopologyUse use);
  std::optional<ParsedMap> frame_;  // of the last fetched map, without its picture: used to check points
  struct FetchedTopology {
    map::MapKey key;
    net::HttpAnswer answer;
    QElapsedTimer since;
    std::set<TopologyUse> served;
  };
  std::optional<FetchedTopology> fetched_topology_;
  MapChanges map_changes_;
  PointChanges point_changes_;
};

}  // namespace mapwright::robot::aimdk
