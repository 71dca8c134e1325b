// The requests to a map dispatcher behind a rosbridge server, and its topics. Lives on the link's thread,
// where answers are parsed, too. Source: docs/protocols/rep130-map-dispatcher.md.
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
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

struct DispatchTimeouts {
  std::chrono::milliseconds region{60'000};
  std::chrono::milliseconds whole{300'000};
  std::chrono::milliseconds save{120'000};
  std::chrono::milliseconds projections{15'000};
  /// Time for the topics to show a change, if nothing else confirms it.
  std::chrono::milliseconds settles{2'500};
};

class DispatchRequests : public QObject {
  Q_OBJECT
 public:
  /// `map_frame` returns the frame of the robot's map; empty while unknown.
  DispatchRequests(net::rosbridge::Client& client, DispatchSettings settings, DispatchTimeouts timeouts,
                   std::function<std::string()> map_frame);

  /// The dispatcher that was found.
  void setDispatcher(Dispatcher found);
  /// The connection is lost: what waits for topics waits no more.
  void lose() { waits_.drop(); }
  /// Another connection: perhaps another robot.
  void beginAnew();
  const Dispatcher& dispatcher() const { return dispatcher_; }
  /// The projected maps received so far, by index.
  const std::map<int, std::shared_ptr<const ProjectedPart>>& projected() const { return projected_; }
  /// The topics to subscribe to.
  std::vector<Endpoint> topics() const;
  /// The topic that is subscribed by its usual name, without knowing whether it exists; or empty.
  std::string triedTopic() const;
  /// Handles a message of one of these topics. Returns why it cannot be read.
  std::optional<Fault> hear(const std::string& topic, const Field& msg);
  /// A subscribed map has arrived.
  void sawMap(const std::string& fingerprint);

  void grid(const wire::TaskPtr& task, const std::optional<map::GridRegion>& region,
            OutcomeTo<map::GridPart> reply);
  void cloud(const wire::TaskPtr& task, CloudKind kind, const std::optional<map::CloudRegion>& region,
             OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply);
  void save(const wire::TaskPtr& task, const std::string& filename, OutcomeTo<std::string> reply);
  void projections(const wire::TaskPtr& task, OutcomeTo<std::vector<map::Projection>> reply);
  /// Ends when each projected map with a topic has arrived, or was waited for.
  void awaitProjected(const wire::TaskPtr& task, OutcomeTo<std::vector<map::Projection>> reply);
  void project(const wire::TaskPtr& task, const std::vector<map::Projection>& wanted,
               OutcomeTo<std::vector<map::Projection>> reply);

 Q_SIGNALS:
  void offersChanged(const mapwright::robot::ros::Dispatcher& found);
  void topicsChanged();
  void lookWanted();  // there may be other topics now
  void mapChanged();
  /// null: it is gone.
  void projectedChanged(int index, const std::shared_ptr<const mapwright::robot::ProjectedPart>& part);
  /// The map size reported by the topics; nothing if they disagree.
  void extentTold(const std::optional<mapwright::map::GridReference>& extent);
  /// Topics that sent nothing while somebody waited for them; emitted before the answer.
  void projectedSilent(const QStringList& topics);

 private:
  using ProjectionsReply = OutcomeTo<std::vector<map::Projection>>;
  /// A request that waits until the topics show the projections.
  struct Watch {
    wire::TaskPtr task;
    ProjectionsReply reply;
    std::set<int> awaited;                // not heard since
    std::vector<map::Projection> wanted;  // what has been set before, where something has
    bool changed = false;                 // something has been set before
    bool answered = true;                 // false: its call is in progress
    bool looked = true;                   // false: which topics there are now is being asked
    bool listed = false;                  // it is asked for by people: that nobody can tell is a failure
  };
  using WatchPtr = std::shared_ptr<Watch>;
  struct Answer {
    std::string service;
    Field values;  // valid while it is handed over
  };

  void ask(const wire::TaskPtr& task, DispatchService service, QByteArray args,
           std::chrono::milliseconds timeout, map::AskedFor asked_for, OutcomeTo<Answer> then);
  void readByService(const wire::TaskPtr& task, ProjectionsReply reply);
  void begin(const WatchPtr& watch);
  void projectNow(const wire::TaskPtr& task, const std::vector<map::Projection>& wanted,
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
  /// Another name for a service that is not listed and was not there by the former ones.
  std::optional<Endpoint> nextToTry(DispatchService service) const;
  void notifyExtent();

  net::rosbridge::Client& client_;
  const DispatchSettings settings_;
  const DispatchTimeouts timeouts_;
  Dispatcher dispatcher_;
  std::set<std::string> not_there_;  // services that were tried
  std::map<int, std::shared_ptr<const ProjectedPart>> projected_;
  int told_ = 0;                             // expected number of projections
  std::optional<int> most_;                  // the number that was set: maps beyond it are outdated
  std::map<int, QByteArray> marks_;          // of the latest messages
  std::map<int, QByteArray> left_;           // of the previous messages, which a topic may repeat
  bool tries_waited_ = false;                // for the one subscribed by its usual name
  std::string map_said_, projections_said_;  // their frames
  std::function<std::string()> map_frame_;
  std::map<std::string, QByteArray> seen_;             // metadata by topic
  std::map<std::string, map::GridReference> extents_;  // the valid ones
  std::optional<map::GridReference> extent_;           // as it was told last
  std::string seen_map_;                               // fingerprint
  std::list<WatchPtr> watches_;
  wire::WaitList waits_;  // those of them that wait
};

/// What a dispatcher is called of which nothing is known.
inline constexpr const char* kDispatcher = QT_TRANSLATE_NOOP("Subject", "map dispatcher (REP 130)");
/// The service that gives points or occupied cells, all or a region of them.
DispatchService cloudService(CloudKind kind, bool region);
/// What is said where there is no dispatcher, or where it lacks a service.
map::Failure notDispatched(DispatchService service, const Dispatcher& dispatcher);

}  // namespace mapwright::robot::ros
