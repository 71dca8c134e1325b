// The topics that a ROS robot is subscribed to, and which of them stay silent. Lives on the link's thread.
// Source: docs/protocols/rosbridge.md, "Topics": nothing is ever confirmed, so silence has to be noticed
// here.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "map/problem.h"
#include "map/stream.h"
#include "net/rosbridge/client.h"
#include "robot/robot.h"
#include "robot/ros/ros_api.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {

/// Everything that determines the subscriptions.
struct TopicSelection {
  map::Streams streams;
  std::vector<std::string> names;  // by people, whatever they bring
  LiveTopics::Basics basics;
  std::vector<std::string> managers_own;       // of a map manager
  bool whole_map = false;                      // for a request in progress
  bool map_by_region = false;                  // the whole map only comes on such a request
  bool every_message = false;                  // of `names`
  bool recorded = false;                       // everything is recorded: every message of all topics
  std::vector<Endpoint> dispatchers_own = {};  // those of a map dispatcher
  std::string dispatchers_tried = {};          // one of these that may not exist
};

/// A topic to subscribe to, and why.
struct WantedTopic {
  net::rosbridge::Subscription subscription;
  std::vector<Source> sources;  // what it is read as; none = only displayed raw
  bool necessary = false;       // users wait for it: its silence is a warning
  bool tried = false;           // it may not exist: its silence means nothing
  bool operator==(const WantedTopic& other) const {
    return sources == other.sources && necessary == other.necessary && tried == other.tried &&
           subscription.type == other.subscription.type;
  }
};
/// By topic. Pure.
std::map<std::string, WantedTopic> topicsFor(const TopicSelection& selection,
                                             const std::vector<Source>& sources, const RosGraph& found);

class RosSubscriptions : public QObject {
  Q_OBJECT
 public:
  struct Timeouts {
    std::chrono::milliseconds json_after{3'000};    // compression may lose the messages of a topic
    std::chrono::milliseconds silent_after{5'000};  // when to report its silence, first and later
    std::chrono::milliseconds look_every{250};
    std::chrono::milliseconds again{10'000};  // servers permanently refuse a topic that does not exist yet
  };
  RosSubscriptions(net::rosbridge::Client& client, RosApi& api, Timeouts timeouts);

  void ask(std::map<std::string, WantedTopic> wanted, const RosGraph& found);
  /// A new connection: the client subscribes to all topics again, and silence is counted anew.
  void beginAnew();
  /// Disconnected: nothing is expected.
  void pause();
  /// A message of the topic has arrived. Returns what to read it as; nullptr: not subscribed.
  const WantedTopic* heard(const std::string& topic);
  /// The data of the silent topic came from that service instead.
  void replacedBy(const std::string& topic, const std::string& service);
  /// Requests the latched message of the topic again; does nothing if it is not subscribed.
  void askAgain(const std::string& topic);

 Q_SIGNALS:
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void dropped(const std::string& topic);  // it is no longer subscribed

 private:
  struct Subscribed {
    WantedTopic wanted;
    QElapsedTimer since, asked_at;
    int came = 0;  // messages on this connection, as far as that matters
    bool plain = false, told = false;
    bool replaced = false;  // by the answer of a service, which has been reported
    bool heard() const { return came > 0; }
  };
  void subscribe(Subscribed& entry);
  void look();
  bool mayBeSilent(const std::string& topic, const Subscribed& entry) const;
  /// It arrived repeatedly, and is of a kind that does so as long as its node runs.
  static bool isSteady(const Subscribed& entry);
  void reportSilence(const std::string& topic);
  void recover(const std::string& topic, Subscribed& entry);

  net::rosbridge::Client& client_;
  RosApi& api_;
  Timeouts timeouts_;
  QTimer timer_;
  RosGraph graph_;
  std::map<std::string, Subscribed> topics_;
};

}  // namespace mapwright::robot::ros
