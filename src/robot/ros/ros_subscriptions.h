// The topics that a ROS robot is asked for, and those of them that stay silent. Lives on the link's thread.
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

/// All that decides which topics are asked for.
struct TopicWish {
  map::Streams streams;
  std::vector<std::string> names;  // by people, whatever they bring
  LiveTopics::Basics basics;
  std::vector<std::string> managers_own;         // of a map manager
  bool whole_map = false;                        // for a request that is under way
  bool map_by_region = false;                    // the whole comes for such a request only
  bool every_message = false;                    // of `names`
  bool recorded = false;                         // whatever comes is kept: every message of all
  std::vector<FoundTopic> dispatchers_own = {};  // of a map dispatcher
  std::string dispatchers_tried = {};            // one of these that may not be there
};

/// A topic that is to be asked for, and what for.
struct WantedTopic {
  net::rosbridge::Subscription subscription;
  std::vector<Source> sources;  // that it is read as; none = only looked at
  bool necessary = false;       // people wait for it: its silence is a warning
  bool tried = false;           // it may not be there: its silence means nothing
  bool operator==(const WantedTopic& other) const {
    return sources == other.sources && necessary == other.necessary && tried == other.tried &&
           subscription.type == other.subscription.type;
  }
};
/// By topic. Pure.
std::map<std::string, WantedTopic> topicsFor(const TopicWish& wish, const std::vector<Source>& sources,
                                             const Found& found);

class RosSubscriptions : public QObject {
  Q_OBJECT
 public:
  struct Patience {
    std::chrono::milliseconds json_after{3'000};    // a compressed topic may be lost in compression
    std::chrono::milliseconds silent_after{5'000};  // then its silence is told, at first and later
    std::chrono::milliseconds look_every{250};
    std::chrono::milliseconds again{10'000};  // servers refuse a topic that is not there yet, for good
  };
  RosSubscriptions(net::rosbridge::Client& client, RosApi& api, Patience patience);

  void ask(std::map<std::string, WantedTopic> wanted, const Found& found);
  /// Another connection: all topics are asked for again by the client, and may be silent anew.
  void beginAnew();
  /// Nothing comes any more, and nobody expects it.
  void pause();
  /// A message of the topic has come. What it is to be read as; nullptr: it is not asked for.
  const WantedTopic* heard(const std::string& topic);
  /// What the silent topic should have brought has come by that service.
  void replacedBy(const std::string& topic, const std::string& service);
  /// What is latched of the topic is to be sent again; nothing where it is not asked for.
  void askAgain(const std::string& topic);

 Q_SIGNALS:
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void dropped(const std::string& topic);  // it is not asked for any more

 private:
  struct Asked {
    WantedTopic wanted;
    QElapsedTimer since, asked_at;
    int came = 0;  // messages of this connection, as far as that matters
    bool plain = false, told = false;
    bool replaced = false;  // by the answer of a service, which has been told
    bool heard() const { return came > 0; }
  };
  void subscribe(Asked& asked);
  void look();
  bool mayBeSilent(const std::string& topic, const Asked& asked) const;
  /// It came again and again, and is of a kind that does so as long as its node runs.
  static bool isSteady(const Asked& asked);
  void tellSilence(const std::string& topic);
  void recover(const std::string& topic, Asked& asked);

  net::rosbridge::Client& client_;
  RosApi& api_;
  Patience patience_;
  QTimer timer_;
  Found found_;
  std::map<std::string, Asked> asked_;
};

}  // namespace mapwright::robot::ros
