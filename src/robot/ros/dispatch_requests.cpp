#include "robot/ros/dispatch_requests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCryptographicHash>
#include <QPointer>

#include "robot/faults.h"
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

constexpr const char* kUsualFrame = "map";  // REP 105

}  // namespace

DispatchService cloudService(CloudKind kind, bool region) {
  if (kind == CloudKind::Points) return region ? DispatchService::CloudRegion : DispatchService::Cloud;
  return region ? DispatchService::OccupancyRegion : DispatchService::Occupancy;
}

map::Failure notDispatched(DispatchService service, const Dispatcher& dispatcher) {
  const auto there = dispatcher.serviceOf(service);
  return wire::notOffered(map::Subject(there ? there->name : std::string(kDispatcher)));
}

DispatchRequests::DispatchRequests(net::rosbridge::Client& client, DispatchSettings settings,
                                   DispatchTimeouts timeouts, std::function<std::string()> map_frame)
    : client_(client),
      settings_(std::move(settings)),
      timeouts_(timeouts),
      map_frame_(std::move(map_frame)) {}

void DispatchRequests::setDispatcher(Dispatcher found) {
  for (auto& [service, there] : found.services) {
    const bool tried = there.type.empty() && not_there_.contains(there.name);
    if (const auto next = tried ? nextToTry(service) : std::nullopt) there = *next;
  }
  std::erase_if(found.services, [&](const auto& one) {
    return one.second.type.empty() && not_there_.contains(one.second.name);
  });
  if (found == dispatcher_) return looked();
  const bool other_offers = found.offers() != dispatcher_.offers();
  // Someone else has set more since.
  for (const auto& [index, topic] : found.projected) {
    if (most_ && index >= *most_ && !dispatcher_.projected.contains(index)) most_.reset();
  }
  const bool told_some = !dispatcher_.projected.empty();
  dispatcher_ = std::move(found);
  const bool setting =
      std::any_of(watches_.begin(), watches_.end(), [](const WatchPtr& watch) { return watch->changed; });
  // The server lists more than expected, unless the robot is about to change it.
  const bool tells = !dispatcher_.projected.empty() || (dispatcher_.topics_known && told_some);
  if (tells && !setting) told_ = 0;
  if (tells || dispatcher_.topics_known)
    forgetProjected([this](int index) { return index >= told_ && !dispatcher_.projected.contains(index); });
  if (!dispatcher_.any()) forgetProjected([](int) { return true; });
  std::erase_if(extents_, [this](const auto& one) {
    return std::none_of(dispatcher_.metadata.begin(), dispatcher_.metadata.end(),
                        [&](const Endpoint& topic) { return topic.name == one.first; });
  });
  notifyExtent();
  looked();
  if (other_offers) Q_EMIT offersChanged(dispatcher_);
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
  notifyExtent();
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
    Q_EMIT projectedChanged(index, nullptr);
  }
}

std::optional<int> DispatchRequests::tried() const {
  const bool tries =
      !dispatcher_.topics_known && told_ == 0 && !most_ && dispatcher_.has(DispatchService::ReadProjections);
  const int next = projected_.empty() ? 0 : projected_.rbegin()->first + 1;
  return tries && next < kMostProjected ? std::optional(next) : std::nullopt;
}

std::string DispatchRequests::triedTopic() const {
  const auto index = tried();
  return index ? projectedTopic(settings_, *index) : std::string();
}

std::map<int, std::string> DispatchRequests::projectedTopics() const {
  std::map<int, std::string> all;
  for (const auto& [index, topic] : dispatcher_.projected) {
    if (!most_ || index < std::max(*most_, told_)) all[index] = topic.name;
  }
  // By their usual names: those that should exist; and if topics are not listed, one after the other.
  for (int index = 0; index < std::min(told_, kMostProjected); ++index)
    all.try_emplace(index, projectedTopic(settings_, index));
  if (const auto next = tried()) {
    for (int index = 0; index <= *next; ++index) all.try_emplace(index, projectedTopic(settings_, index));
  }
  return all;
}

std::vector<Endpoint> DispatchRequests::topics() const {
  std::vector<Endpoint> all = dispatcher_.metadata;
  for (const auto& [index, name] : projectedTopics()) {
    const auto found = dispatcher_.projected.find(index);
    all.push_back(found != dispatcher_.projected.end() ? found->second
                                                       : Endpoint{name, "map_msgs/ProjectedMap"});
  }
  return all;
}

std::optional<Fault> DispatchRequests::hear(const std::string& topic, const Field& msg) {
  for (const Endpoint& metadata : dispatcher_.metadata) {
    if (metadata.name != topic) continue;
    const QByteArray now = msg.toJson(10'000);
    QByteArray& before = seen_[topic];
    const bool other = !before.isEmpty() && before != now;
    before = now;
    extents_.erase(topic);
    if (const auto extent = readMapExtent(msg)) extents_[topic] = *extent;
    notifyExtent();
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
    Q_EMIT projectedChanged(index, part);
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

void DispatchRequests::notifyExtent() {
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
  if (!before.empty() && before != fingerprint && dispatcher_.any()) Q_EMIT mapChanged();
}

void DispatchRequests::withdraw(DispatchService service) {
  const auto there = dispatcher_.serviceOf(service);
  if (!there || !there->type.empty()) return;
  not_there_.insert(there->name);
  std::erase_if(dispatcher_.services, [&](const auto& one) { return one.second.name == there->name; });
  if (const auto next = nextToTry(service)) dispatcher_.services[service] = *next;
  Q_EMIT offersChanged(dispatcher_);
}

std::optional<Endpoint> DispatchRequests::nextToTry(DispatchService service) const {
  const std::vector<std::string> names = namesToTry(settings_, service);
  const auto next = std::find_if(names.begin(), names.end(),
                                 [&](const std::string& name) { return !not_there_.contains(name); });
  return names.size() > 1 && next != names.end() ? std::optional(Endpoint{*next, {}}) : std::nullopt;
}

void DispatchRequests::ask(const wire::TaskPtr& task, DispatchService service, QByteArray args,
                           std::chrono::milliseconds timeout, map::AskedFor asked_for,
                           OutcomeTo<Answer> then) {
  const auto there = dispatcher_.serviceOf(service);
  if (!there) return then(fail(notDispatched(service, dispatcher_)));
  net::rosbridge::CallRequest request;
  request.service = there->name;
  request.args = args;
  request.timeout = timeout;
  request.large = true;
  request.arriving = [task](qint64 bytes) { task->reportProgress({bytes, std::nullopt}); };
  call(task, client_, std::move(request),
       [self = QPointer(this), task, service, args, timeout, name = there->name, asked_for,
        then = std::move(then)](const CallAnswer& answer) {
         if (!self) return;
         if (answer.kind == CallAnswer::Kind::Answered) return then(Answer{name, answer.values});
         if (!saysNotThere(answer)) return then(fail(failed(answer, map::Subject(name), asked_for)));
         self->withdraw(service);
         const auto other = self->dispatcher_.serviceOf(service);
         if (other && other->name != name) return self->ask(task, service, args, timeout, asked_for, then);
         map::Failure failure = notDispatched(service, self->dispatcher_);
         failure.subject = map::Subject(name);
         failure.asked_for = asked_for;
         then(fail(std::move(failure)));
       });
}

void DispatchRequests::grid(const wire::TaskPtr& task, const std::optional<map::GridRegion>& region,
                            OutcomeTo<map::GridPart> reply) {
  ask(task, region ? DispatchService::GridRegion : DispatchService::Grid,
      region ? regionArgs(*region) : QByteArray("{}"), region ? timeouts_.region : timeouts_.whole,
      map::AskedFor::All, withValue<Answer>(reply, [this, reply, region](const Answer& answer) {
        auto part = readGridPart(answer.values[region ? "sub_map" : "map"]);
        if (!part) return reply(fail(wire::unfit(map::Subject(answer.service), part.error())));
        if (!part->frame.empty()) map_said_ = part->frame;
        reply(std::move(*part));
      }));
}

void DispatchRequests::cloud(const wire::TaskPtr& task, CloudKind kind,
                             const std::optional<map::CloudRegion>& region,
                             OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) {
  ask(task, cloudService(kind, region.has_value()), region ? regionArgs(*region) : QByteArray("{}"),
      region ? timeouts_.region : timeouts_.whole, map::AskedFor::All,
      withValue<Answer>(reply, [reply, region](const Answer& answer) {
        auto cloud = readSpatialCloud(answer.values[region ? "sub_map" : "map"]);
        if (!cloud) return reply(fail(wire::unfit(map::Subject(answer.service), cloud.error())));
        reply(std::move(*cloud));
      }));
}

void DispatchRequests::save(const wire::TaskPtr& task, const std::string& filename,
                            OutcomeTo<std::string> reply) {
  ask(task, DispatchService::Save, saveArgs(filename), timeouts_.save, map::AskedFor::Change,
      withValue<Answer>(reply, [reply, filename](const Answer&) { reply(filename); }));
}

bool DispatchRequests::tellsProjections() const {
  const auto there = dispatcher_.serviceOf(DispatchService::ReadProjections);
  return there && dispatchType(there->type) == "map_msgs/SetMapProjections";
}

std::vector<map::Projection> DispatchRequests::shown() const {
  std::vector<map::Projection> all;
  for (const auto& [index, part] : projected_) all.push_back(projectionOf(*part));
  return all;
}

void DispatchRequests::projections(const wire::TaskPtr& task, OutcomeTo<std::vector<map::Projection>> reply) {
  const auto there = dispatcher_.serviceOf(DispatchService::ReadProjections);
  if (!there) return reply(fail(notDispatched(DispatchService::ReadProjections, dispatcher_)));
  if (tellsProjections()) return readByService(task, std::move(reply));
  // The present ones: those dropped as outdated may mean something else now.
  setMost(std::nullopt);
  const auto watch = std::make_shared<Watch>();
  watch->task = task;
  watch->reply = std::move(reply);
  watch->looked = false;
  watch->listed = true;
  if (projected_.empty()) tries_waited_ = false;
  begin(watch);
  Q_EMIT lookWanted();
}

void DispatchRequests::awaitProjected(const wire::TaskPtr& task,
                                      OutcomeTo<std::vector<map::Projection>> reply) {
  const auto watch = std::make_shared<Watch>();
  watch->task = task;
  watch->reply = std::move(reply);
  watch->awaited = unheard();
  begin(watch);
}

std::set<int> DispatchRequests::unheard() const {
  std::set<int> all;
  const auto next = tried();
  for (const auto& [index, name] : projectedTopics()) {
    if (!projected_.contains(index) && !(tries_waited_ && index == next)) all.insert(index);
  }
  return all;
}

/// Of those that exist or should exist.
QStringList DispatchRequests::silentTopics() const {
  QStringList all;
  const auto next = tried();
  for (const auto& [index, name] : projectedTopics()) {
    if (!projected_.contains(index) && !left_.contains(index) && index != next)
      all << QString::fromStdString(name);
  }
  return all;
}

/// nullopt: all topics that exist.
void DispatchRequests::setMost(std::optional<int> most) {
  if (most) {
    for (const auto& [index, mark] : marks_) {
      if (index >= *most) left_[index] = mark;
    }
    forgetProjected([most](int index) { return index >= *most; });
  }
  if (std::exchange(most_, most) != most) Q_EMIT topicsChanged();
}

/// The frame of the map, which is the default.
std::string DispatchRequests::knownFrame() const {
  if (!map_said_.empty()) return map_said_;
  const std::string of_map = map_frame_ ? map_frame_() : std::string();
  return of_map.empty() ? projections_said_ : of_map;
}

void DispatchRequests::readByService(const wire::TaskPtr& task, ProjectionsReply reply) {
  ask(task, DispatchService::ReadProjections, "{}", timeouts_.projections, map::AskedFor::All,
      withValue<Answer>(reply, [this, reply](const Answer& answer) {
        auto told = readProjections(answer.values);
        if (!told) return reply(fail(wire::unfit(map::Subject(answer.service), told.error())));
        for (const map::Projection& one : *told) {
          if (!one.frame.empty()) projections_said_ = one.frame;
        }
        const int count = int(std::min<std::size_t>(told->size(), kMostProjected));
        if (std::exchange(told_, count) != count) Q_EMIT topicsChanged();
        reply(std::move(*told));
      }));
}

void DispatchRequests::project(const wire::TaskPtr& task, const std::vector<map::Projection>& wanted,
                               OutcomeTo<std::vector<map::Projection>> reply) {
  // A dispatcher cannot look up an empty frame name.
  const auto lacks_frame = [](const map::Projection& one) { return one.frame.empty(); };
  if (std::none_of(wanted.begin(), wanted.end(), lacks_frame)) return projectNow(task, wanted, reply);
  const auto set_in = [this, task, wanted, reply,
                       lacks_frame](const Outcome<std::vector<map::Projection>>& told) {
    const auto failure = told ? map::FailureKind::None : told.error().kind;
    if (failure == map::FailureKind::Cancelled || failure == map::FailureKind::Unreachable) {
      map::Failure not_set = told.error();
      not_set.asked_for = map::AskedFor::Change;
      return reply(fail(std::move(not_set)));
    }
    const std::string known = knownFrame();
    std::vector<map::Projection> whole = wanted;
    for (map::Projection& one : whole) {
      if (lacks_frame(one)) one.frame = known.empty() ? std::string(kUsualFrame) : known;
    }
    projectNow(task, whole, reply);
  };
  if (!knownFrame().empty()) return set_in(Outcome<std::vector<map::Projection>>());
  // The present projections tell which frame is used.
  if (tellsProjections()) return readByService(task, set_in);
  awaitProjected(task, set_in);
}

void DispatchRequests::projectNow(const wire::TaskPtr& task, const std::vector<map::Projection>& wanted,
                                  ProjectionsReply reply) {
  const auto watch = std::make_shared<Watch>();
  watch->task = task;
  watch->reply = reply;
  watch->changed = true;
  watch->wanted = wanted;
  watch->answered = false;
  const int count = int(std::min<std::size_t>(wanted.size(), kMostProjected));
  for (int index = 0; index < count; ++index) watch->awaited.insert(index);
  std::erase_if(left_, [count](const auto& left) { return left.first < count; });
  // A topic may report before the service answers.
  watches_.push_back(watch);
  if (std::exchange(told_, count) != count) Q_EMIT topicsChanged();
  ask(task, DispatchService::ChangeProjections, projectionArgs(wanted), timeouts_.projections,
      map::AskedFor::Change, [this, watch, count](Outcome<Answer> answer) {
        if (!answer) {
          watches_.remove(watch);
          return watch->reply(fail(std::move(answer.error())));
        }
        watch->answered = true;
        // Topics of former projections may stay while somebody subscribes.
        watch->looked = dispatcher_.projected.empty();
        setMost(count);
        Q_EMIT lookWanted();
        auto told = readProjections(answer->values);
        if (told && int(told->size()) > count) setMost(std::nullopt);
        watches_.remove(watch);
        if (told) return watch->reply(std::move(*told));
        if (!tellsProjections()) return begin(watch);
        readByService(watch->task, [this, watch, count](Outcome<std::vector<map::Projection>> now) {
          // It has been set, whatever became of the question.
          if (!now) now.error().applied = map::Applied::Yes;
          if (now && int(now->size()) > count) setMost(std::nullopt);
          watch->reply(std::move(now));
        });
      });
}

void DispatchRequests::begin(const WatchPtr& watch) {
  watches_.push_back(watch);
  waits_.await(
      watch->task, timeouts_.settles, [watch] { return watch->looked && watch->awaited.empty(); },
      [this, watch](wire::WaitList::End how) { end(watch, how); });
}

void DispatchRequests::end(const WatchPtr& watch, wire::WaitList::End how) {
  using End = wire::WaitList::End;
  watches_.remove(watch);
  std::optional<map::Failure> failure;
  if (how == End::Cancelled || how == End::Dropped)
    failure = failed(how, {}, fault::NoAnswerInTime, fault::LinkBrokeOff);
  if (watch->changed && !dispatcher_.projected.empty() && std::exchange(told_, 0) != 0)
    Q_EMIT topicsChanged();
  if (!failure && !watch->changed) {
    tries_waited_ = true;
    Q_EMIT projectedSilent(silentTopics());
    if (watch->listed && tried() == 0) {
      failure = map::Failure{.kind = map::FailureKind::Unsupported,
                             .reason = map::FailureReason::Unfit,
                             .cause = {robot::fault::ProjectionsNotTold}};
    }
  }
  if (!failure) return watch->reply(shown());
  const auto there = dispatcher_.serviceOf(DispatchService::ReadProjections);
  failure->subject = map::Subject(there ? there->name : std::string("set_map_projections"));
  if (watch->changed) {
    failure->asked_for = map::AskedFor::Change;
    failure->applied = map::Applied::Yes;
  }
  watch->reply(fail(std::move(*failure)));
}

}  // namespace mapwright::robot::ros

#include "moc_dispatch_requests.cpp"
