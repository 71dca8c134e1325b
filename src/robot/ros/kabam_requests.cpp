#include "robot/ros/kabam_requests.h"

#include <algorithm>
#include <utility>

#include "robot/faults.h"
#include "robot/ros/dispatch_names.h"
#include "robot/ros/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

map::Failure tagsKept(map::Subject subject, const std::string& name) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .applied = map::Applied::Yes,
          .reason = map::FailureReason::Unfit,
          .cause = {fault::TagsNotTaken, {name}}};
}

const map::Waypoint* find(const StoredWaypoints& stored, const std::string& id) {
  const auto found = std::find_if(stored.points.begin(), stored.points.end(),
                                  [&](const map::Waypoint& point) { return point.id == id; });
  return found == stored.points.end() ? nullptr : &*found;
}

/// The stored waypoint differs from the one that the change was made for.
std::optional<map::Failure> conflictIn(const StoredWaypoints& stored, const WaypointChange& change,
                                       const map::Subject& subject) {
  const map::Waypoint* const kept = find(stored, change.id);
  if (kept && sameBesidesTags(*kept, *change.before) && kept->tags == change.before->tags)
    return std::nullopt;
  return map::Failure{.kind = map::FailureKind::Conflict,
                      .subject = subject,
                      .asked_for = map::AskedFor::Change,
                      .cause = {fault::ChangedMeanwhile, {change.before->name}}};
}

const char* serviceOf(MapChange change) {
  constexpr std::pair<MapChange, const char*> kServices[] = {
      {MapChange::Rename, "rename_map"},       {MapChange::Load, "load_map"},
      {MapChange::Archive, "archive_map"},     {MapChange::Unarchive, "archive_map"},  // by its flag
      {MapChange::Delete, "delete_map"},       {MapChange::StartMapping, "start_mapping"},
      {MapChange::StopMapping, "stop_mapping"}};
  for (const auto& [of, service] : kServices) {
    if (of == change) return service;
  }
  return "save_map";
}

bool isOfOneMap(MapChange change) { return !isOfMapping(change); }

QByteArray argsOf(const MapOrder& order, const KabamMap& map) {
  if (order.change == MapChange::Load) return loadMapArgs(map.id, order.place);
  if (order.change == MapChange::Save) return saveMapArgs(order.name);
  if (!isOfOneMap(order.change)) return "{}";
  // An archived map that is renamed stays archived, however the flag is interpreted.
  const bool archived =
      order.change == MapChange::Archive || (map.archived && order.change != MapChange::Unarchive);
  const std::string label = order.change == MapChange::Rename ? order.name : std::string();
  return updateMapArgs(map, label, archived, order.change == MapChange::Delete);
}

}  // namespace

/// A change of maps.
struct KabamRequests::Order {
  wire::TaskPtr task;
  MapOrder what;
  OutcomeTo<map::CatalogueEntry> reply;
  map::CatalogueEntry before = {};  // of one map
  std::string id = {};              // of the saved map, as reported
  map::Subject subject() const {
    return isOfOneMap(what.change) ? map::subjectOf(what.key, before.name) : wire::kMapList;
  }
  /// The topics show it.
  bool holds(const KabamState& state) const {
    const auto map = state.find(what.key.id);
    switch (what.change) {
      case MapChange::Rename:
        return map && calledOf(*map) == what.name;
      case MapChange::Load:
        return state.isCurrent(what.key.id);
      case MapChange::Archive:
        return map && map->archived;
      case MapChange::Unarchive:
        return map && !map->archived;
      case MapChange::Delete:
        return !map;
      case MapChange::StartMapping:
        return state.isMapping();
      case MapChange::StopMapping:
        return state.current() && !state.isMapping();
      case MapChange::ContinueMapping:
      case MapChange::CancelMapping:  // not offered
        return false;
      case MapChange::Save:
        break;
    }
    return saved(state).has_value();
  }
  std::optional<map::CatalogueEntry> saved(const KabamState& state) const {
    if (!id.empty()) return state.entry(id);
    for (const map::CatalogueEntry& entry : state.entries()) {
      if (entry.name == what.name) return entry;
    }
    return std::nullopt;
  }
  map::CatalogueEntry now(const KabamState& state) const {
    if (what.change == MapChange::Save) return saved(state).value_or(map::CatalogueEntry{});
    if (what.change == MapChange::Delete) return before;
    if (isOfOneMap(what.change)) return state.entry(what.key.id).value_or(before);
    const auto& current = state.current();
    return current ? state.entry(current->map.id).value_or(map::CatalogueEntry{}) : map::CatalogueEntry{};
  }
};

KabamRequests::KabamRequests(net::rosbridge::Client& client, KabamTimeouts timeouts, WhenKnown when_known,
                             std::function<std::string()> fixed_frame)
    : client_(client),
      timeouts_(timeouts),
      when_known_(std::move(when_known)),
      fixed_frame_(std::move(fixed_frame)) {}

bool KabamRequests::setNamespace(const std::optional<std::string>& ns) {
  if (ns) {
    state_.setNamespace(*ns);
  } else {
    state_.forget();
  }
  return std::exchange(there_, ns.has_value()) != there_;
}

void KabamRequests::emitChanges(const KabamState::Update& update) {
  if (update.maps) {
    Q_EMIT stands(QString::fromStdString(state_.managerState()));
    Q_EMIT mapsChanged();
  }
  waits_.look();
  if (update.waypoints) Q_EMIT waypointsChanged();
}

void KabamRequests::ask(const wire::TaskPtr& task, const char* service, QByteArray args,
                        net::rosbridge::Reply reply, std::optional<milliseconds> timeout) {
  net::rosbridge::CallRequest request;
  request.service = state_.ns() + '/' + service;
  request.args = std::move(args);
  request.timeout = timeout.value_or(timeouts_.call);
  call(task, client_, std::move(request), std::move(reply));
}

std::optional<StoredWaypoints> KabamRequests::storedIn(const CallAnswer& answer,
                                                       const map::MapKey& key) const {
  if (answer.kind != CallAnswer::Kind::Answered) return std::nullopt;
  return readWaypoints(answer.values, key.id, fixed_frame_());
}

void KabamRequests::whenListed(const wire::TaskPtr& task, const map::Subject& subject,
                               map::AskedFor asked_for, Checked then) {
  const auto ended = [this, subject, asked_for, then](End how) {
    // A manager without a current map may say nothing of it.
    const bool enough = how == End::TooLate && state_.partlyListed();
    if (how == End::Held || enough) return then(std::nullopt);
    map::Failure failure = failed(
        how, subject,
        faultText("ros",
                  "the robot's map manager did not list its maps in time; it may be busy, or the rosbridge "
                  "server may lack its message types (kabam_msgs)"),
        fault::LinkBrokeOff);
    const QString refusal = client_.refusalOf(state_.ns() + "/map_list");
    if (how == End::TooLate && !refusal.isEmpty())
      failure.cause.because = {Fault(robot::fault::ItAnswered, {refusal.toStdString()})};
    failure.asked_for = asked_for;
    then(std::move(failure));
  };
  when_known_(task, subject, asked_for,
              [this, task, subject, asked_for, then, ended](std::optional<map::Failure> failure) {
                if (!failure && !there_) {
                  failure = unsupported(subject);
                  failure->asked_for = asked_for;
                }
                if (failure) return then(std::move(failure));
                waits_.await(
                    task, timeouts_.lists, [this] { return state_.listed(); }, ended);
              });
}

void KabamRequests::list(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  whenListed(task, wire::kMapList, map::AskedFor::All,
             unlessFailed(reply, [this, reply] { reply(state_.entries()); }));
}

void KabamRequests::describe(const wire::TaskPtr& task, const map::MapKey& key,
                             OutcomeTo<map::CatalogueEntry> reply, map::AskedFor asked_for) {
  const map::Subject subject = map::subjectOf(key);
  whenListed(task, subject, asked_for, unlessFailed(reply, [this, key, reply, subject, asked_for] {
               auto entry = key.kind == map::MapKind::Stored ? state_.entry(key.id) : std::nullopt;
               if (entry) return reply(std::move(*entry));
               map::Failure failure = wire::notThere(subject);
               failure.asked_for = asked_for;
               reply(fail(std::move(failure)));
             }));
}

void KabamRequests::waypoints(const wire::TaskPtr& task, const map::MapKey& key,
                              OutcomeTo<StoredWaypoints> reply) {
  const map::Subject subject = map::placesOf(key);
  const auto onAnswer = [this, key, subject, reply](const CallAnswer& answer) {
    using Kind = CallAnswer::Kind;
    if (auto stored = storedIn(answer, key)) return reply(std::move(*stored));
    map::Failure failure = answer.kind == Kind::Answered
                               ? wire::unfit(subject, robot::wire::fault::PointsAreNoList)
                               : failed(answer, subject);
    const bool ended = answer.kind == Kind::LinkLost || answer.kind == Kind::Cancelled;
    auto told = ended ? std::nullopt : toldByTopic(key);
    if (!told) return reply(fail(std::move(failure)));
    Fault why = failure.cause.any() ? failure.cause : fault::said(failure.detail.substr(0, 300));
    told->notes.insert(told->notes.begin(), Fault(fault::WaypointsNotConfirmed, {}, {std::move(why)}));
    reply(std::move(*told));
  };
  whenListed(task, subject, map::AskedFor::All, unlessFailed(reply, [=, this] {
               if (key.kind != map::MapKind::Stored || !state_.find(key.id)) {
                 // That of a dispatcher beside the manager has no waypoints.
                 StoredWaypoints none;
                 none.there = false;
                 if (isProjected(key)) return reply(std::move(none));
                 return reply(fail(wire::notThere(subject)));
               }
               // The topic may lag or stand still, so its list only counts where the manager does not answer.
               ask(task, "get_waypoint", getWaypointArgs(key.id), onAnswer,
                   toldByTopic(key) ? std::min(timeouts_.call, timeouts_.read) : timeouts_.read);
             }));
}

std::optional<StoredWaypoints> KabamRequests::toldByTopic(const map::MapKey& key) const {
  return state_.isCurrent(key.id) ? state_.waypoints(fixed_frame_()) : std::nullopt;
}

void KabamRequests::perform(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& request,
                            OutcomeTo<WaypointReceipt> reply) {
  const map::Subject subject = map::placesOf(key);
  whenListed(
      task, subject, map::AskedFor::Change, unlessFailed(reply, [this, task, key, request, subject, reply] {
        std::optional<map::Failure> failure;
        if (!state_.find(key.id)) failure = wire::notThere(subject);
        if (!failure && request.changes.size() != 1) failure = wire::notOffered(subject);
        if (failure) {
          failure->asked_for = map::AskedFor::Change;
          return reply(fail(std::move(*failure)));
        }
        const auto change = std::make_shared<Change>(Change{task, key, request.changes.front(), reply});
        change->what.before ? lookFirst(change) : send(change);
      }));
}

// Someone else may have been faster. The topic may lag, and only covers the current map.
void KabamRequests::lookFirst(const ChangePtr& change) {
  const std::string& id = change->what.id;
  ask(change->task, "get_waypoint", getWaypointArgs(change->key.id, id),
      [this, change, id](const CallAnswer& answer) {
        const auto stored = storedIn(answer, change->key);
        if (!stored) {
          // A read-only request has changed nothing.
          map::Failure failure = failed(answer, change->subject());
          failure.asked_for = map::AskedFor::Change;
          failure.applied = map::Applied::No;
          return change->reply(fail(std::move(failure)));
        }
        if (auto conflict = conflictIn(*stored, change->what, change->subject())) {
          if (state_.isCurrent(change->key.id)) state_.distrustWaypoints();
          return change->reply(fail(*conflict));
        }
        // Unknown members are sent back unchanged.
        if (change->what.after) change->what.after->source = find(*stored, id)->source;
        send(change);
      });
}

void KabamRequests::send(const ChangePtr& change) {
  const WaypointService service = serviceOf(change->what);
  const bool creates = service == WaypointService::Create, deletes = service == WaypointService::Delete;
  const map::Waypoint& point = deletes ? *change->what.before : *change->what.after;
  const QByteArray message =
      waypointJson(point, creates ? std::string() : change->what.id, change->key.id, fixed_frame_());
  ask(change->task, nameOf(service), manageWaypointArgs(message, deletes),
      [this, change, service, name = point.name](const CallAnswer& answer) {
        const bool answered = answer.kind == CallAnswer::Kind::Answered;
        change->until = steady_clock::now() + timeouts_.confirm;
        change->doubt = answered ? resultOf(nameOf(service), answer.values, change->subject(), name)
                                 : std::optional(failed(answer, change->subject(), map::AskedFor::Change));
        if (change->doubt && isFinal(*change->doubt)) return change->reply(fail(*change->doubt));
        const Field response = answer.values["waypoint_response"];
        change->id = response.isText() ? response.text() : response["id"].text();
        // Whatever becomes of the request: a waypoint of this id is ours.
        const bool created = service == WaypointService::Create;
        if (created && !change->id.empty() && change->id != change->what.id)
          Q_EMIT named(QString::fromStdString(change->what.id), QString::fromStdString(change->id));
        confirm(change);
      });
}

KabamRequests::Shown KabamRequests::shownIn(const StoredWaypoints& stored, Change& change) {
  const WaypointChange& what = change.what;
  if (!what.after) return find(stored, what.id) ? Shown::NotYet : Shown::Done;
  const map::Waypoint* shown = find(stored, what.before ? what.id : change.id);
  if (!shown && !what.before) {
    // The creator got no id in the answer.
    const auto found =
        std::find_if(stored.points.begin(), stored.points.end(),
                     [&](const map::Waypoint& point) { return sameBesidesTags(point, *what.after); });
    if (found != stored.points.end()) shown = &*found;
  }
  if (!shown || !sameBesidesTags(*shown, *what.after)) return Shown::NotYet;
  change.id = shown->id;
  return shown->tags == what.after->tags ? Shown::Done : Shown::OtherTags;
}

void KabamRequests::confirm(const ChangePtr& change) {
  const auto shown = std::make_shared<Shown>(Shown::NotYet);
  const bool told = toldByTopic(change->key).has_value();
  const auto left = std::chrono::duration_cast<milliseconds>(change->until - steady_clock::now());
  waits_.await(
      change->task, std::clamp(left, milliseconds(0), told ? timeouts_.topic : change->pause),
      [this, told, change, shown] {
        const auto stored = told ? state_.waypoints(fixed_frame_()) : std::nullopt;
        *shown = stored ? shownIn(*stored, *change) : Shown::NotYet;
        return *shown == Shown::Done;
      },
      [this, change, shown](End how) {
        if (how == End::Cancelled) change->doubt = cancelled(change->subject());
        if (how == End::Cancelled || how == End::Held) return end(change, *shown);
        askWhetherShown(change);
      });
}

// For a map without a topic, or faster than the topic.
void KabamRequests::askWhetherShown(const ChangePtr& change) {
  // A deleted one is looked up in the whole list: the answer for a missing id is undefined.
  const std::string id = !change->what.after   ? std::string()
                         : change->what.before ? change->what.id
                                               : change->id;
  ask(change->task, "get_waypoint", getWaypointArgs(change->key.id, id),
      [this, change](const CallAnswer& answer) {
        const auto stored = storedIn(answer, change->key);
        const Shown shown = stored ? shownIn(*stored, *change) : Shown::NotYet;
        if (shown == Shown::Done && state_.isCurrent(change->key.id)) state_.distrustWaypoints();
        const bool over = answer.kind == CallAnswer::Kind::LinkLost ||
                          answer.kind == CallAnswer::Kind::Cancelled || steady_clock::now() >= change->until;
        if (shown == Shown::Done || over) return end(change, shown);
        change->pause = timeouts_.look_again;
        confirm(change);
      });
}

void KabamRequests::end(const ChangePtr& change, Shown shown) const {
  if (shown == Shown::Done) {
    WaypointReceipt receipt;
    if (!change->what.before && change->id != change->what.id) receipt.ids[change->what.id] = change->id;
    return change->reply(std::move(receipt));
  }
  if (change->doubt) return change->reply(fail(*change->doubt));
  if (shown == Shown::OtherTags)
    return change->reply(fail(tagsKept(change->subject(), change->what.after->name)));
  change->reply(fail(unconfirmed(change->subject(), timeouts_.confirm)));
}

void KabamRequests::carryOut(const wire::TaskPtr& task, const MapOrder& what,
                             OutcomeTo<map::CatalogueEntry> reply) {
  const auto order = std::make_shared<Order>(Order{task, what, reply});
  if (!isOfOneMap(what.change)) {
    return whenListed(task, order->subject(), map::AskedFor::Change,
                      unlessFailed(reply, [this, order] { send(order); }));
  }
  describe(task, what.key,
           withValue<map::CatalogueEntry>(reply,
                                          [this, order](map::CatalogueEntry entry) {
                                            order->before = std::move(entry);
                                            send(order);
                                          }),
           map::AskedFor::Change);
}

void KabamRequests::send(const OrderPtr& order) {
  const KabamMap map = state_.find(order->what.key.id).value_or(KabamMap{});
  ask(order->task, serviceOf(order->what.change), argsOf(order->what, map),
      [this, order](const CallAnswer& answer) {
        const MapOrder& what = order->what;
        const map::Subject subject = order->subject();
        const bool answered = answer.kind == CallAnswer::Kind::Answered;
        std::optional<map::Failure> failure =
            answered ? resultOf(serviceOf(what.change), answer.values, subject, what.name)
                     : std::optional(failed(answer, subject, map::AskedFor::Change));
        if (answered) order->id = answer.values["map_id"].text();
        // The requested state is already present.
        if (failure && failure->robot_code == kAlreadyLoaded && what.change == MapChange::Load &&
            order->holds(state_))
          failure.reset();
        if (failure && isFinal(*failure)) return order->reply(fail(std::move(*failure)));
        confirm(order, std::move(failure));
      });
}

void KabamRequests::confirm(const OrderPtr& order, std::optional<map::Failure> doubt) {
  waits_.await(
      order->task, timeouts_.confirm, [this, order] { return order->holds(state_); },
      [this, order, doubt = std::move(doubt)](End how) {
        if (how == End::Held) return order->reply(order->now(state_));
        if (how == End::Cancelled) return order->reply(fail(cancelled(order->subject())));
        order->reply(fail(doubt ? *doubt : unconfirmed(order->subject(), timeouts_.confirm)));
      });
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_requests.cpp"
