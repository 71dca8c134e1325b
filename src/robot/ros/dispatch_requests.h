// A map dispatcher behind a rosbridge server: what it is asked, what its topics tell. Lives on the link's
// thread, where answers are read, too. Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <chrono>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QStringList>

#include "net/rosbridge/client.h"
#include "robot/map_dispatch.h"
#include "robot/ros/dispatch_names.h"
#include "robot/ros/read_messages.h"
#include "robot/wire/wait_list.h"

namespace mapwright::robot::ros {

struct DispatchPatience {
  std::chrono::milliseconds region{60'000};
  std::chrono::milliseconds whole{300'000};
  std::chrono::milliseconds save{120'000};
  std::chrono::milliseconds projections{15'000};
  /// For the topics to show what has been set, where nothing else tells.
  std::chrono::milliseconds settles{2'500};
};

class DispatchRequests : public QObject {
  Q_OBJECT
 public:
  /// `map_frame` tells the frame of the robot's map; empty while it is not known.
  DispatchRequests(net::rosbridge::Client& client, DispatchWish wish, DispatchPatience patience,
                   std::function<std::string()> map_frame);

  /// What there is, as far as the server tells.
  void take(FoundDispatch found);
  /// The connection is lost: what waits for topics waits no more.
  void lose() { waits_.drop(); }
  /// Another connection: perhaps another robot.
  void beginAnew();
  const FoundDispatch& found() const { return found_; }
  /// The projected maps that have come, by number.
  const std::map<int, std::shared_ptr<const ProjectedPart>>& projected() const { return projected_; }
  /// The topics that are to be subscribed to.
  std::vector<FoundTopic> topics() const;
  /// That one of them that is asked for by its usual name, as nobody tells whether it is there; or empty.
  std::string triedTopic() const;
  /// A message of one of these; else nothing. Why it cannot be read.
  std::optional<Fault> hear(const std::string& topic, const Field& msg);
  /// The map that somebody subscribed to has come.
  void sawMap(const std::string& fingerprint);

  void grid(const wire::ErrandPtr& errand, const std::optional<map::GridRegion>& region,
            OutcomeTo<map::GridPart> reply);
  void cloud(const wire::ErrandPtr& errand, CloudKind kind, const std::optional<map::CloudRegion>& region,
             OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply);
  void save(const wire::ErrandPtr& errand, const std::string& filename, OutcomeTo<std::string> reply);
  void projections(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::Projection>> reply);
  /// Ends when each projected map that there is a topic of has come, or has been waited for.
  void awaitProjected(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::Projection>> reply);
  void project(const wire::ErrandPtr& errand, const std::vector<map::Projection>& wanted,
               OutcomeTo<std::vector<map::Projection>> reply);

 Q_SIGNALS:
  void offersChanged(const mapwright::robot::ros::FoundDispatch& found);
  void topicsChanged();
  void lookWanted();  // there may be other topics now
  void mapChanged();
  void projectedCame(const std::shared_ptr<const mapwright::robot::ProjectedPart>& part);
  void projectedGone(int index);
  /// What the topics tell of the size of the map; where they differ, nothing.
  void extentTold(const std::optional<mapwright::map::GridReference>& extent);
  /// Which topics have told nothing as long as somebody has waited for them; told before he is answered.
  void projectedSilent(const QStringList& topics);

 private:
  using ProjectionsReply = OutcomeTo<std::vector<map::Projection>>;
  /// Somebody who waits for topics to tell what is projected.
  struct Watch {
    wire::ErrandPtr errand;
    ProjectionsReply reply;
    std::set<int> awaited;                // not heard since
    std::vector<map::Projection> wanted;  // what has been set before, where something has
    bool changed = false;                 // something has been set before
    bool answered = true;                 // false: its call is under way
    bool looked = true;                   // false: which topics there are now is being asked
    bool listed = false;                  // it is asked for by people: that nobody can tell is a failure
  };
  using WatchPtr = std::shared_ptr<Watch>;
  struct Answer {
    std::string service;
    Field values;  // valid while it is handed over
  };

  void ask(const wire::ErrandPtr& errand, DispatchService service, QByteArray args,
           std::chrono::milliseconds patience, map::AskedFor asked_for, OutcomeTo<Answer> then);
  void readByService(const wire::ErrandPtr& errand, ProjectionsReply reply);
  void begin(const WatchPtr& watch);
  void projectNow(const wire::ErrandPtr& errand, const std::vector<map::Projection>& wanted,
                  ProjectionsReply reply);
  void looked();
  void end(const WatchPtr& watch, wire::WaitList::End how);
  bool tellsProjections() const;
  std::vector<map::Projection> shown() const;
  std::map<int, std::string> projectedTopics() const;
  std::optional<int> tried() const;
  std::set<int> unheard() const;
  QStringList silentTopics() const;
  std::string knownFrame() const;
  void setMost(std::optional<int> most);
  void forgetProjected(const std::function<bool(int)>& whether);
  std::optional<Fault> hearProjected(int index, const Field& msg);
  void withdraw(DispatchService service);
  void tellExtent();

  net::rosbridge::Client& client_;
  const DispatchWish wish_;
  const DispatchPatience patience_;
  FoundDispatch found_;
  std::set<std::string> not_there_;  // services that were tried
  std::map<int, std::shared_ptr<const ProjectedPart>> projected_;
  int told_ = 0;                             // how many projections there should be
  std::optional<int> most_;                  // so many were set: what is beyond them is of before
  std::map<int, QByteArray> marks_;          // of the messages that came last
  std::map<int, QByteArray> left_;           // those of before, which a topic may say once more
  bool tries_waited_ = false;                // for what is asked for by its usual name
  std::string map_said_, projections_said_;  // their frames
  std::function<std::string()> map_frame_;
  std::map<std::string, QByteArray> seen_;             // metadata by topic
  std::map<std::string, map::GridReference> extents_;  // those that are a size
  std::optional<map::GridReference> extent_;           // as it was told last
  std::string seen_map_;                               // fingerprint
  std::list<WatchPtr> watches_;
  wire::WaitList waits_;  // those of them that wait
};

/// What a dispatcher is called of which nothing is known.
inline constexpr const char* kDispatcher = "map dispatcher (REP 130)";
/// The service that gives points or occupied cells, all or a region of them.
DispatchService cloudService(CloudKind kind, bool region);
/// What is said where there is no dispatcher, or where it lacks a service.
map::Failure notDispatched(DispatchService service, const FoundDispatch& found);

}  // namespace mapwright::robot::ros
