#include "robot/ros/dispatch_requests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCryptographicHash>
#include <QPointer>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/ros_calls.h"
#include "robot/wire/failures.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;

/// It is what is wanted at its number, as far as grids of cells can be that.
bool isAbout(const std::vector<map::Projection>& wanted, const ProjectedPart& part) {
  constexpr double kNearM = 0.5;
  if (std::size_t(part.index) >= wanted.size()) return false;
  const map::Projection& one = wanted[std::size_t(part.index)];
  const map::Projection told = projectionOf(part);
  return (one.corner_m - told.corner_m).cwiseAbs().maxCoeff() <= kNearM &&
         (one.size_m - told.size_m).cwiseAbs().maxCoeff() <= kNearM &&
         std::abs(one.min_z_m - told.min_z_m) <= kNearM && std::abs(one.max_z_m - told.max_z_m) <= kNearM;
}

/// Identifies a message, so that repetitions are recognised.
QByteArray markOf(const ProjectedPart& part, const Field& msg) {
  constexpr qsizetype kHeader = 2'000;
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(msg["map"]["header"].toJson(kHeader));
  hash.addData(msg["map"]["info"].toJson(kHeader));
  hash.addData(QByteArray::number(part.min_z_m) + ' ' + QByteArray::number(part.max_z_m));
  if (part.part.cells) {
    hash.addData(QByteArray::fromRawData(reinterpret_cast<const char*>(part.part.cells->data()),
                                         qsizetype(part.part.cells->size())));
  }
  return hash.result();
}

/// Recognises the error for a missing service.
bool saysNotThere(const CallAnswer& answer) {
  return answer.kind == CallAnswer::Kind::Refused && answer.words.find("does not exist") != std::string::npos;
}

}  // namespace

DispatchService cloudService(CloudKind kind, bool region) {
  if (kind == CloudKind::Points) return region ? DispatchService::CloudRegion : DispatchService::Cloud;
  return region ? DispatchService::OccupancyRegion : DispatchService::Occupancy;
}

map::Failure notDispatched(DispatchService service, const FoundDispatch& found) {
  const auto there = found.serviceOf(service);
  return wire::notOffered(map::Subject(there ? there->name : std::string(kDispatcher)));
}

DispatchRequests::DispatchRequests(net::rosbridge::Client& client, DispatchWish wish,
                                   DispatchPatience patience, std::function<std::string()> map_frame)
    : client_(client), wish_(std::move(wish)), patience_(patience), map_frame_(std::move(map_frame)) {}

void DispatchRequests::take(FoundDispatch found) {
  std::erase_if(found.services, [&](const auto& one) {
    return one.second.type.empty() && not_there_.contains(one.second.name);
  });
  if (found == found_) return looked();
  const bool other_offers = found.offers() != found_.offers();
  // Someone else has set more since.
  for (const auto& [index, topic] : found.projected) {
    if (most_ && index >= *most_ && !found_.projected.contains(index)) most_.reset();
  }
  const bool told_some = !found_.projected.empty();
  found_ = std::move(found);
  const bool setting =
      std::any_of(watches_.begin(), watches_.end(), [](const WatchPtr& watch) { return watch->changed; });
  // The server lists more than expected, unless the robot is about to change it.
  const bool tells = !found_.projected.empty() || (found_.topics_told && told_some);
  if (tells && !setting) told_ = 0;
  if (tells || found_.topics_told)
    forgetProjected([this](int index) { return index >= told_ && !found_.projected.contains(index); });
  if (!found_.any()) forgetProjected([](int) { return true; });
  std::erase_if(extents_, [this](const auto& one) {
    return std::none_of(found_.metadata.begin(), found_.metadata.end(),
                        [&](const FoundTopic& topic) { return topic.name == one.first; });
  });
  tellExtent();
  looked();
  if (other_offers) Q_EMIT offersChanged(found_);
}

void DispatchRequests::looked() {
  for (const WatchPtr& watch : watches_) {
    if (!watch->answered) continue;
    if (!watch->looked && !watch->changed) watch->awaited = unheard();
    watch->looked = true;
  }
  waits_.look();
}

void DispatchRequests::beginAnew() {
  lose();
  not_there_.clear();
  told_ = 0;
  most_.reset();
  left_.clear();
  tries_waited_ = false;
  map_said_.clear();
  projections_said_.clear();
  extents_.clear();
  tellExtent();
  forgetProjected([](int) { return true; });
}

void DispatchRequests::forgetProjected(const std::function<bool(int)>& whether) {
  std::vector<int> gone;
  for (const auto& [index, part] : projected_) {
    if (whether(index)) gone.push_back(index);
  }
  for (const int index : gone) {
    projected_.erase(index);
    marks_.erase(index);
    Q_EMIT projectedGone(index);
  }
}

std::optional<int> DispatchRequests::tried() const {
  const bool tries =
      !found_.topics_told && told_ == 0 && !most_ && found_.has(DispatchService::ReadProjections);
  const int next = projected_.empty() ? 0 : projected_.rbegin()->first + 1;
  return tries && next < kMostProjected ? std::optional(next) : std::nullopt;
}

std::string DispatchRequests::triedTopic() const {
  const auto index = tried();
  return index ? projectedTopic(wish_, *index) : std::string();
}

std::map<int, std::string> DispatchRequests::projectedTopics() const {
  std::map<int, std::string> all;
  for (const auto& [index, topic] : found_.projected) {
    if (!most_ || index < std::max(*most_, told_)) all[index] = topic.name;
  }
  // By their usual names: those that should exist; and if topics are not listed, one after the other.
  for (int index = 0; index < std::min(told_, kMostProjected); ++index)
    all.try_emplace(index, projectedTopic(wish_, index));
  if (const auto next = tried()) {
    for (int index = 0; index <= *next; ++index) all.try_emplace(index, projectedTopic(wish_, index));
  }
  return all;
}

std::vector<FoundTopic> DispatchRequests::topics() const {
  std::vector<FoundTopic> all = found_.metadata;
  for (const auto& [index, name] : projectedTopics()) {
    const auto found = found_.projected.find(index);
    all.push_back(found != found_.projected.end() ? found->second
                                                  : FoundTopic{name, "map_msgs/ProjectedMap"});
  }
  return all;
}

std::optional<Fault> DispatchRequests::hear(const std::string& topic, const Field& msg) {
  for (const FoundTopic& metadata : found_.metadata) {
    if (metadata.name != topic) continue;
    const QByteArray now = msg.toJson(10'000);
    QByteArray& before = seen_[topic];
    const bool other = !before.isEmpty() && before != now;
    before = now;
    extents_.erase(topic);
    if (const auto extent = readMapExtent(msg)) extents_[topic] = *extent;
    tellExtent();
    if (other) Q_EMIT mapChanged();
    return std::nullopt;
  }
  for (const auto& [number, name] : projectedTopics()) {
    if (name == topic) return hearProjected(number, msg);
  }
  return std::nullopt;
}

std::optional<Fault> DispatchRequests::hearProjected(int index, const Field& msg) {
  auto read = readProjectedPart(msg, index);
  if (!read) return read.error();
  const auto part = std::make_shared<const ProjectedPart>(std::move(*read));
  const QByteArray mark = markOf(*part, msg);
  const auto left = left_.find(index);
  // An unused topic repeats its last message.
  const bool of_before = left != left_.end() && left->second == mark;
  if (!of_before) {
    left_.erase(index);
    const auto next = tried();
    if (!part->part.frame.empty()) projections_said_ = part->part.frame;
    marks_[index] = mark;
    projected_[index] = part;
    Q_EMIT projectedCame(part);
    if (next && tried() != next) {
      for (const WatchPtr& watch : watches_) {
        if (!watch->changed && tried()) watch->awaited.insert(*tried());
      }
      Q_EMIT topicsChanged();
    }
  }
  for (const WatchPtr& watch : watches_) {
    // A latched one of before may come after what has been set: it is not what is waited for.
    if (!watch->changed || isAbout(watch->wanted, *part)) watch->awaited.erase(index);
  }
  waits_.look();
  return std::nullopt;
}

void DispatchRequests::tellExtent() {
  std::optional<map::GridReference> now;
  for (const auto& [topic, extent] : extents_) {
    if (now && *now != extent) {
      now.reset();  // it is unknown which one belongs to the map
      break;
    }
    now = extent;
  }
  if (std::exchange(extent_, now) != now) Q_EMIT extentTold(now);
}

void DispatchRequests::sawMap(const std::string& fingerprint) {
  const std::string before = std::exchange(seen_map_, fingerprint);
  if (!before.empty() && before != fingerprint && found_.any()) Q_EMIT mapChanged();
}

void DispatchRequests::withdraw(DispatchService service) {
  const auto there = found_.serviceOf(service);
  if (!there || !there->type.empty()) return;
  not_there_.insert(there->name);
  std::erase_if(found_.services, [&](const auto& one) { return one.second.name == there->name; });
  Q_EMIT offersChanged(found_);
}

void DispatchRequests::ask(const wire::ErrandPtr& errand, DispatchService service, QByteArray args,
                           std::chrono::milliseconds patience, map::AskedFor asked_for,
                           OutcomeTo<Answer> then) {
  const auto there = found_.serviceOf(service);
  if (!there) return then(fail(notDispatched(service, found_)));
  net::rosbridge::CallRequest request;
  request.service = there->name;
  request.args = std::move(args);
  request.timeout = patience;
  request.large = true;
  request.arriving = [errand](qint64 bytes) { errand->tell({bytes, std::nullopt}); };
  call(errand, client_, std::move(request),
       [self = QPointer(this), service, name = there->name, asked_for,
        then = std::move(then)](const CallAnswer& answer) {
         if (!self) return;
         if (answer.kind == CallAnswer::Kind::Answered) return then(Answer{name, answer.values});
         if (!saysNotThere(answer)) return then(fail(failed(answer, map::Subject(name), asked_for)));
         self->withdraw(service);
         map::Failure failure = notDispatched(service, self->found_);
         failure.subject = map::Subject(name);
         failure.asked_for = asked_for;
         then(fail(std::move(failure)));
       });
}

void DispatchRequests::grid(const wire::ErrandPtr& errand, const std::optional<map::GridRegion>& region,
                            OutcomeTo<map::GridPart> reply) {
  ask(errand, region ? DispatchService::GridRegion : DispatchService::Grid,
      region ? regionArgs(*region) : QByteArray("{}"), region ? patience_.region : patience_.whole,
      map::AskedFor::All, [this, reply, region](Outcome<Answer> answer) {
        if (!answer) return reply(fail(std::move(answer.error())));
        auto part = readGridPart(answer->values[region ? "sub_map" : "map"]);
        if (!part) return reply(fail(wire::unfit(map::Subject(answer->service), part.error())));
        if (!part->frame.empty()) map_said_ = part->frame;
        reply(std::move(*part));
      });
}

void DispatchRequests::cloud(const wire::ErrandPtr& errand, CloudKind kind,
                             const std::optional<map::CloudRegion>& region,
                             OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) {
  ask(errand, cloudService(kind, region.has_value()), region ? regionArgs(*region) : QByteArray("{}"),
      region ? patience_.region : patience_.whole, map::AskedFor::All,
      [reply, region](Outcome<Answer> answer) {
        if (!answer) return reply(fail(std::move(answer.error())));
        auto cloud = readSpatialCloud(answer->values[region ? "sub_map" : "map"]);
        if (!cloud) return reply(fail(wire::unfit(map::Subject(answer->service), cloud.error())));
        reply(std::move(*cloud));
      });
}

void DispatchRequests::save(const wire::ErrandPtr& errand, const std::string& filename,
                            OutcomeTo<std::string> reply) {
  ask(errand, DispatchService::Save, saveArgs(filename), patience_.save, map::AskedFor::Change,
      [reply, filename](Outcome<Answer> answer) {
        if (!answer) return reply(fail(std::move(answer.error())));
        reply(filename);
      });
}

}  // namespace mapwright::robot::ros

#include "moc_dispatch_requests.cpp"
