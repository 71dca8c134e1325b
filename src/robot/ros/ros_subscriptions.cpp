#include "robot/ros/ros_subscriptions.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QPointer>

#include "robot/faults.h"
#include "robot/ros/drawn_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/robot_transforms.h"

namespace mapwright::robot::ros {
namespace {

using map::Stream;
using net::rosbridge::Subscription;
using Compression = Subscription::Compression;

constexpr int kSteadyFrom = 5;  // messages

/// Each message replaces the one before; many come only when something happens.
bool isDrawnLikeMarkers(const Source& source) {
  return source.form == Form::Markers && isDrawn(plainType(source.type));
}

map::Subject subjectOf(const std::string& topic) { return {map::SubjectKind::Topic, topic}; }

/// How often, how, and on which connection to subscribe. Transforms have many publishers, so none is dropped.
Subscription subscriptionFor(const Source& source) {
  Subscription wanted;
  wanted.topic = source.topic;
  wanted.type = source.type;
  const Form form = source.form;
  wanted.large = form == Form::Grid || form == Form::GridPatch || form == Form::PointCloud;
  if (wanted.large || form == Form::LaserScan) wanted.compression = Compression::Cbor;
  if (form == Form::LaserScan) wanted.throttle_ms = 100;
  if (form == Form::Odometry || form == Form::PoseStamped || form == Form::PoseWithCovariance)
    wanted.throttle_ms = 50;
  // A marker that is lost is missing; of the others the last one counts.
  if (isDrawnLikeMarkers(source) || form == Form::PointCloud || form == Form::Path ||
      form == Form::PoseArray || form == Form::Polygon || form == Form::Battery)
    wanted.throttle_ms = 200;
  return wanted;
}

bool isTransform(const Source& source) { return source.form == Form::Tf || source.form == Form::StaticTf; }

}  // namespace

std::map<std::string, WantedTopic> topicsFor(const TopicSelection& selection,
                                             const std::vector<Source>& sources, const RosGraph& found) {
  map::Streams streams = selection.streams;
  if (selection.basics.pose) streams.insert({Stream::Pose, Stream::Model});
  if (selection.map_by_region) streams.erase(Stream::WholeMap);
  if (selection.whole_map) streams.insert(Stream::WholeMap);
  const bool placed = std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
    return streams.contains(source.stream) && needsTransforms(source.form) &&
           source.stream != Stream::WholeMap;
  });
  const std::vector<std::string> robots = robotsIn(sources, {});
  // The transforms of robots of which nothing is shown are not needed.
  std::set<std::string> shown;
  const auto first = std::find_if(sources.begin(), sources.end(),
                                  [](const Source& source) { return source.form == Form::Tf; });
  if (first != sources.end()) shown.insert(namespaceAmong(robots, first->topic));
  for (const Source& source : sources) {
    if (streams.contains(source.stream) && !isTransform(source))
      shown.insert(namespaceAmong(robots, source.topic));
  }
  std::map<std::string, WantedTopic> wanted;
  for (const Source& source : sources) {
    if (source.form == Form::MapService) continue;
    if (!streams.contains(source.stream) && !(placed && isTransform(source))) continue;
    const std::string robot = namespaceAmong(robots, source.topic);
    if (isTransform(source) && !robot.empty() && !shown.contains(robot)) continue;
    WantedTopic& topic = wanted[source.topic];
    if (topic.sources.empty()) topic.subscription = subscriptionFor(source);
    topic.sources.push_back(source);
    topic.necessary |= source.stream == Stream::WholeMap && source.form == Form::Grid && source.found;
  }
  const auto add = [&](const std::string& name) {
    if (name.empty() || name.size() > kLongestTopicName) return;
    WantedTopic& topic = wanted[name];
    topic.necessary = true;
    if (selection.every_message) topic.subscription.throttle_ms = 0;
    if (!topic.subscription.topic.empty()) return;
    topic.subscription.topic = name;
    topic.subscription.type = typeOf(found, name);
    topic.subscription.throttle_ms = selection.every_message ? 0 : 100;
  };
  for (const std::string& name : selection.names) add(name);
  for (const std::string& name : selection.managers_own) {
    add(name);
    // Every change counts, and compression loses texts in lists.
    wanted[name].subscription.throttle_ms = 0;
  }
  for (const Endpoint& topic : selection.dispatchers_own) {
    if (wanted.contains(topic.name)) continue;
    add(topic.name);
    WantedTopic& own = wanted[topic.name];
    own.necessary = false;  // it only sends something when there is something to report
    own.tried = topic.name == selection.dispatchers_tried;
    own.subscription.type = topic.type;
    own.subscription.compression = Compression::Cbor;
    own.subscription.large = true;
  }
  if (selection.recorded) {
    for (auto& [name, topic] : wanted) topic.subscription.throttle_ms = 0;
  }
  return wanted;
}

RosSubscriptions::RosSubscriptions(net::rosbridge::Client& client, RosApi& api, Timeouts timeouts)
    : client_(client), api_(api), timeouts_(timeouts) {
  timer_.setParent(this);
  timer_.setInterval(timeouts_.look_every);
  connect(&timer_, &QTimer::timeout, this, &RosSubscriptions::look);
}

void RosSubscriptions::subscribe(Subscribed& entry) {
  Subscription subscription = entry.wanted.subscription;
  if (entry.plain) subscription.compression = Compression::None;
  client_.subscribe(subscription);
  entry.asked_at.start();
}

void RosSubscriptions::ask(std::map<std::string, WantedTopic> wanted, const RosGraph& found) {
  graph_ = found;
  for (auto entry = topics_.begin(); entry != topics_.end();) {
    if (wanted.contains(entry->first)) {
      ++entry;
      continue;
    }
    client_.unsubscribe(entry->first);
    recover(entry->first, entry->second);
    const std::string topic = entry->first;
    entry = topics_.erase(entry);
    Q_EMIT dropped(topic);
  }
  for (auto& [topic, want] : wanted) {
    const auto [entry, is_new] = topics_.try_emplace(topic);
    const bool as_often =
        !is_new && entry->second.wanted.subscription.throttle_ms == want.subscription.throttle_ms;
    if (as_often && entry->second.wanted == want) continue;
    const bool same_type = !is_new && entry->second.wanted.subscription.type == want.subscription.type &&
                           entry->second.wanted.subscription.compression == want.subscription.compression;
    entry->second.wanted = std::move(want);
    if (same_type && as_often) continue;
    if (!same_type) entry->second.since.start();
    subscribe(entry->second);
  }
  timer_.start();
}

void RosSubscriptions::askAgain(const std::string& topic) {
  const auto entry = topics_.find(topic);
  if (entry == topics_.end()) return;
  client_.unsubscribe(topic);
  subscribe(entry->second);
}

void RosSubscriptions::beginAnew() {
  for (auto& [topic, entry] : topics_) {
    entry.came = 0;
    entry.replaced = false;
    entry.since.start();
    entry.asked_at.start();
  }
  timer_.start();
}

void RosSubscriptions::pause() {
  timer_.stop();
  for (auto& [topic, entry] : topics_) recover(topic, entry);
}

const WantedTopic* RosSubscriptions::heard(const std::string& topic) {
  const auto entry = topics_.find(topic);
  if (entry == topics_.end()) return nullptr;
  entry->second.came = std::min(entry->second.came + 1, kSteadyFrom);
  entry->second.since.start();
  recover(topic, entry->second);
  return &entry->second.wanted;
}

void RosSubscriptions::recover(const std::string& topic, Subscribed& entry) {
  if (std::exchange(entry.told, false)) Q_EMIT recovered({subjectOf(topic), map::ProblemCode::Unavailable});
}

void RosSubscriptions::replacedBy(const std::string& topic, const std::string& service) {
  const auto found = topics_.find(topic);
  if (found == topics_.end() || found->second.heard()) return;
  recover(topic, found->second);
  found->second.told = found->second.replaced = true;
  Q_EMIT problemFound({map::Severity::Info,
                       subjectOf(topic),
                       {fault::TopicAskedInstead, {service}},
                       map::ProblemCode::Unavailable});
}

void RosSubscriptions::look() {
  std::vector<std::string> silent;
  for (auto& [topic, entry] : topics_) {
    if (entry.heard() && !isSteady(entry)) continue;
    const auto waited = std::chrono::milliseconds(entry.since.elapsed());
    const bool packed = entry.wanted.subscription.compression != Compression::None;
    if (packed && !entry.plain && !entry.heard() && waited > timeouts_.json_after && lists(graph_, topic)) {
      entry.plain = true;
      subscribe(entry);
    }
    // Nothing tells whether it exists by now.
    if (!entry.heard() && !lists(graph_, topic) && entry.asked_at.elapsed() > timeouts_.again.count())
      askAgain(topic);
    if (!entry.told && waited > timeouts_.silent_after && !mayBeSilent(topic, entry)) silent.push_back(topic);
  }
  for (const std::string& topic : silent) reportSilence(topic);
}

bool RosSubscriptions::isSteady(const Subscribed& entry) {
  if (entry.came < kSteadyFrom || entry.wanted.sources.empty()) return false;
  const Form form = entry.wanted.sources.front().form;
  return form == Form::Tf || form == Form::Odometry || form == Form::LaserScan || form == Form::PointCloud;
}

bool RosSubscriptions::mayBeSilent(const std::string& topic, const Subscribed& entry) const {
  if (entry.wanted.tried && !entry.heard()) return true;
  if (entry.heard() || entry.wanted.necessary || entry.wanted.sources.empty()) return false;
  const Source& own = entry.wanted.sources.front();
  if (own.form == Form::GridPatch || own.form == Form::StaticTf || isDrawnLikeMarkers(own)) return true;
  // If a stream has several topics one is enough, and if none arrives the best one is reported.
  const bool one_is_enough = !own.found || own.stream == Stream::Pose;
  if (!one_is_enough) return false;
  for (const auto& [other, beside] : topics_) {
    if (other == topic || beside.wanted.sources.empty()) continue;
    const Source& source = beside.wanted.sources.front();
    if (source.stream != own.stream || source.form == Form::GridPatch || source.form == Form::StaticTf)
      continue;
    if (beside.heard() || beside.told) return true;
  }
  return false;
}

void RosSubscriptions::reportSilence(const std::string& topic) {
  Subscribed& silent = topics_.at(topic);
  // Checks again: another one of the same stream may have been reported meanwhile.
  if (mayBeSilent(topic, silent)) return;
  silent.told = true;
  const auto report = [self = QPointer<RosSubscriptions>(this), topic](FaultCode why) {
    if (!self) return;
    const auto entry = self->topics_.find(topic);
    if (entry == self->topics_.end() || !entry->second.told || entry->second.replaced) return;
    // Data of a topic that has stopped is still shown.
    const bool stopped = entry->second.heard();
    const bool serious = stopped || entry->second.wanted.necessary;
    Fault reason(fault::TopicSilent);
    const QString refusal = self->client_.refusalOf(topic);
    if (!refusal.isEmpty() && why != fault::TopicNotListed) {
      reason.because = {Fault(robot::fault::ItAnswered, {refusal.toStdString()})};
      // If it did arrive before, neither the server nor a missing entry is the cause.
    } else if (!stopped || (why != fault::TopicListedOnly && why != fault::TopicsNotTold)) {
      reason.because = {why};
    }
    Q_EMIT self->problemFound({serious ? map::Severity::Warning : map::Severity::Info, subjectOf(topic),
                               std::move(reason), map::ProblemCode::Unavailable});
  };
  if (!graph_.topics) return report(fault::TopicsNotTold);
  if (!lists(graph_, topic)) return report(fault::TopicNotListed);
  api_.countPublishers(topic, [report](std::optional<std::size_t> publishers) {
    report(publishers == std::size_t(0) ? fault::TopicNobodySends : fault::TopicListedOnly);
  });
}

}  // namespace mapwright::robot::ros

#include "moc_ros_subscriptions.cpp"
