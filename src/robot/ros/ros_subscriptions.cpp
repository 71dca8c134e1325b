#include "robot/ros/ros_subscriptions.h"

#include <algorithm>
#include <utility>

#include <QPointer>

#include "robot/ros/faults.h"

namespace mapwright::robot::ros {
namespace {

using map::Stream;
using net::rosbridge::Subscription;
using Compression = Subscription::Compression;

constexpr int kSteadyFrom = 5;  // messages

map::Subject subjectOf(const std::string& topic) { return {map::SubjectKind::Topic, topic}; }

/// How often, how, and on which connection to subscribe. Transforms have many publishers, so none is dropped.
Subscription subscriptionFor(const Source& source) {
  Subscription wanted;
  wanted.topic = source.topic;
  wanted.type = source.type;
  switch (source.form) {
    case Form::Grid:
    case Form::GridPatch:
      wanted.compression = Compression::Cbor;
      wanted.large = true;
      break;
    case Form::PointCloud:
      wanted.compression = Compression::Cbor;
      wanted.large = true;
      wanted.throttle_ms = 200;
      break;
    case Form::LaserScan:
      wanted.compression = Compression::Cbor;
      wanted.throttle_ms = 100;
      break;
    case Form::Odometry:
    case Form::PoseStamped:
    case Form::PoseWithCovariance:
      wanted.throttle_ms = 50;
      break;
    case Form::Path:
    case Form::PoseArray:
    case Form::Polygon:
    case Form::Battery:
      wanted.throttle_ms = 200;
      break;
    case Form::Markers:
    case Form::Tf:
    case Form::StaticTf:
    case Form::MapService:  // no topic
      break;
  }
  return wanted;
}

bool isTransform(const Source& source) { return source.form == Form::Tf || source.form == Form::StaticTf; }

}  // namespace

std::map<std::string, WantedTopic> topicsFor(const TopicWish& wish, const std::vector<Source>& sources,
                                             const Found& found) {
  map::Streams streams = wish.streams;
  if (wish.basics.pose) streams.insert({Stream::Pose, Stream::Model});
  if (wish.map_by_region) streams.erase(Stream::WholeMap);
  if (wish.whole_map) streams.insert(Stream::WholeMap);
  const bool placed = std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
    return streams.contains(source.stream) && needsTransforms(source.form) &&
           source.stream != Stream::WholeMap;
  });
  std::map<std::string, WantedTopic> wanted;
  for (const Source& source : sources) {
    if (source.form == Form::MapService) continue;
    if (!streams.contains(source.stream) && !(placed && isTransform(source))) continue;
    WantedTopic& topic = wanted[source.topic];
    if (topic.sources.empty()) topic.subscription = subscriptionFor(source);
    topic.sources.push_back(source);
    topic.necessary |= source.stream == Stream::WholeMap && source.form == Form::Grid && source.found;
  }
  const auto add = [&](const std::string& name) {
    if (name.empty() || name.size() > kLongestTopicName) return;
    WantedTopic& topic = wanted[name];
    topic.necessary = true;
    if (wish.every_message) topic.subscription.throttle_ms = 0;
    if (!topic.subscription.topic.empty()) return;
    topic.subscription.topic = name;
    topic.subscription.type = typeOf(found, name);
    topic.subscription.throttle_ms = wish.every_message ? 0 : 100;
  };
  for (const std::string& name : wish.names) add(name);
  for (const std::string& name : wish.managers_own) {
    add(name);
    // Every change counts, and compression loses texts in lists.
    wanted[name].subscription.throttle_ms = 0;
  }
  for (const FoundTopic& topic : wish.dispatchers_own) {
    if (wanted.contains(topic.name)) continue;
    add(topic.name);
    WantedTopic& own = wanted[topic.name];
    own.necessary = false;  // it only sends something when there is something to report
    own.tried = topic.name == wish.dispatchers_tried;
    own.subscription.type = topic.type;
    own.subscription.compression = Compression::Cbor;
    own.subscription.large = true;
  }
  if (wish.recorded) {
    for (auto& [name, topic] : wanted) topic.subscription.throttle_ms = 0;
  }
  return wanted;
}

RosSubscriptions::RosSubscriptions(net::rosbridge::Client& client, RosApi& api, Patience patience)
    : client_(client), api_(api), patience_(patience) {
  timer_.setParent(this);
  timer_.setInterval(patience_.look_every);
  connect(&timer_, &QTimer::timeout, this, &RosSubscriptions::look);
}

void RosSubscriptions::subscribe(Asked& asked) {
  Subscription subscription = asked.wanted.subscription;
  if (asked.plain) subscription.compression = Compression::None;
  client_.subscribe(subscription);
  asked.asked_at.start();
}

void RosSubscriptions::ask(std::map<std::string, WantedTopic> wanted, const Found& found) {
  found_ = found;
  for (auto asked = asked_.begin(); asked != asked_.end();) {
    if (wanted.contains(asked->first)) {
      ++asked;
      continue;
    }
    client_.unsubscribe(asked->first);
    recover(asked->first, asked->second);
    const std::string topic = asked->first;
    asked = asked_.erase(asked);
    Q_EMIT dropped(topic);
  }
  for (auto& [topic, want] : wanted) {
    const auto [asked, is_new] = asked_.try_emplace(topic);
    const bool as_often =
        !is_new && asked->second.wanted.subscription.throttle_ms == want.subscription.throttle_ms;
    if (as_often && asked->second.wanted == want) continue;
    const bool same_type = !is_new && asked->second.wanted.subscription.type == want.subscription.type &&
                           asked->second.wanted.subscription.compression == want.subscription.compression;
    asked->second.wanted = std::move(want);
    if (same_type && as_often) continue;
    if (!same_type) asked->second.since.start();
    subscribe(asked->second);
  }
  timer_.start();
}

void RosSubscriptions::askAgain(const std::string& topic) {
  const auto asked = asked_.find(topic);
  if (asked == asked_.end()) return;
  client_.unsubscribe(topic);
  subscribe(asked->second);
}

void RosSubscriptions::beginAnew() {
  for (auto& [topic, asked] : asked_) {
    asked.came = 0;
    asked.replaced = false;
    asked.since.start();
    asked.asked_at.start();
  }
  timer_.start();
}

void RosSubscriptions::pause() {
  timer_.stop();
  for (auto& [topic, asked] : asked_) recover(topic, asked);
}

const WantedTopic* RosSubscriptions::heard(const std::string& topic) {
  const auto asked = asked_.find(topic);
  if (asked == asked_.end()) return nullptr;
  asked->second.came = std::min(asked->second.came + 1, kSteadyFrom);
  asked->second.since.start();
  recover(topic, asked->second);
  return &asked->second.wanted;
}

void RosSubscriptions::recover(const std::string& topic, Asked& asked) {
  if (std::exchange(asked.told, false)) Q_EMIT recovered({subjectOf(topic), map::ProblemCode::Unavailable});
}

void RosSubscriptions::replacedBy(const std::string& topic, const std::string& service) {
  const auto found = asked_.find(topic);
  if (found == asked_.end() || found->second.heard()) return;
  recover(topic, found->second);
  found->second.told = found->second.replaced = true;
  Q_EMIT problemFound({map::Severity::Info,
                       subjectOf(topic),
                       {fault::TopicAskedInstead, {service}},
                       map::ProblemCode::Unavailable});
}

void RosSubscriptions::look() {
  std::vector<std::string> silent;
  for (auto& [topic, asked] : asked_) {
    if (asked.heard() && !isSteady(asked)) continue;
    const auto waited = std::chrono::milliseconds(asked.since.elapsed());
    const bool packed = asked.wanted.subscription.compression != Compression::None;
    if (packed && !asked.plain && !asked.heard() && waited > patience_.json_after && lists(found_, topic)) {
      asked.plain = true;
      subscribe(asked);
    }
    // Nothing tells whether it exists by now.
    if (!asked.heard() && !lists(found_, topic) && asked.asked_at.elapsed() > patience_.again.count())
      askAgain(topic);
    if (!asked.told && waited > patience_.silent_after && !mayBeSilent(topic, asked)) silent.push_back(topic);
  }
  for (const std::string& topic : silent) tellSilence(topic);
}

bool RosSubscriptions::isSteady(const Asked& asked) {
  if (asked.came < kSteadyFrom || asked.wanted.sources.empty()) return false;
  const Form form = asked.wanted.sources.front().form;
  return form == Form::Tf || form == Form::Odometry || form == Form::LaserScan || form == Form::PointCloud;
}

bool RosSubscriptions::mayBeSilent(const std::string& topic, const Asked& asked) const {
  if (asked.wanted.tried && !asked.heard()) return true;
  if (asked.heard() || asked.wanted.necessary || asked.wanted.sources.empty()) return false;
  const Source& own = asked.wanted.sources.front();
  if (own.form == Form::GridPatch || own.form == Form::StaticTf) return true;
  // If a stream has several topics one is enough, and if none arrives the best one is reported.
  const bool one_is_enough = !own.found || own.stream == Stream::Pose;
  if (!one_is_enough) return false;
  for (const auto& [other, beside] : asked_) {
    if (other == topic || beside.wanted.sources.empty()) continue;
    const Source& source = beside.wanted.sources.front();
    if (source.stream != own.stream || source.form == Form::GridPatch || source.form == Form::StaticTf)
      continue;
    if (beside.heard() || beside.told) return true;
  }
  return false;
}

void RosSubscriptions::tellSilence(const std::string& topic) {
  Asked& silent = asked_.at(topic);
  // Checks again: another one of the same stream may have been reported meanwhile.
  if (mayBeSilent(topic, silent)) return;
  silent.told = true;
  const auto tell = [self = QPointer<RosSubscriptions>(this), topic](FaultCode why) {
    if (!self) return;
    const auto asked = self->asked_.find(topic);
    if (asked == self->asked_.end() || !asked->second.told || asked->second.replaced) return;
    // Data of a topic that has stopped is still shown.
    const bool stopped = asked->second.heard();
    const bool serious = stopped || asked->second.wanted.necessary;
    Fault reason(fault::TopicSilent);
    // If it did arrive before, neither the server nor a missing entry is the cause.
    if (!stopped || (why != fault::TopicListedOnly && why != fault::TopicsNotTold)) reason.because = {why};
    Q_EMIT self->problemFound({serious ? map::Severity::Warning : map::Severity::Info, subjectOf(topic),
                               std::move(reason), map::ProblemCode::Unavailable});
  };
  if (!found_.topics) return tell(fault::TopicsNotTold);
  if (!lists(found_, topic)) return tell(fault::TopicNotListed);
  api_.countPublishers(topic, [tell](std::optional<std::size_t> publishers) {
    tell(publishers == std::size_t(0) ? fault::TopicNobodySends : fault::TopicListedOnly);
  });
}

}  // namespace mapwright::robot::ros

#include "moc_ros_subscriptions.cpp"
