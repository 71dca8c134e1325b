#include "robot/ros/kabam_requests.h"

#include <algorithm>
#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/kabam_failures.h"
#include "robot/ros/kabam_results.h"
#include "robot/ros/ros_calls.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;
using std::chrono::steady_clock;

map::Failure tagsKept(map::Subject subject, const std::string& name) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = std::move(subject),
          .applied = map::Applied::Yes,
          .reason = map::FailureReason::Unfit,
          .cause = {fault::TagsNotTaken, {name}}};
}

bool sameAsKept(const map::Waypoint& kept, const map::Waypoint& now) {
  return sameBesidesTags(kept, now) && kept.tags == now.tags;
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
  if (kept && sameAsKept(*kept, *change.before)) return std::nullopt;
  return map::Failure{.kind = map::FailureKind::Conflict,
                      .subject = subject,
                      .asked_for = map::AskedFor::Change,
                      .cause = {fault::ChangedMeanwhile, {change.before->name}}};
}

}  // namespace

KabamRequests::KabamRequests(net::rosbridge::Client& client, KabamPatience patience, WhenKnown when_known,
                             std::function<std::string()> fixed_frame)
    : client_(client),
      patience_(patience),
      when_known_(std::move(when_known)),
      fixed_frame_(std::move(fixed_frame)) {}

bool KabamRequests::setPlace(const std::optional<std::string>& place) {
  if (place) {
    book_.setPlace(*place);
  } else {
    book_.forget();
  }
  return std::exchange(there_, place.has_value()) != there_;
}

void KabamRequests::tell(const KabamBook::Taken& taken) {
  if (taken.maps) {
    Q_EMIT stands(QString::fromStdString(book_.state()));
    Q_EMIT mapsChanged();
  }
  waits_.look();
  if (taken.waypoints) Q_EMIT waypointsChanged();
}

net::rosbridge::CallRequest KabamRequests::request(const char* service, QByteArray args) const {
  net::rosbridge::CallRequest request;
  request.service = book_.place() + '/' + service;
  request.args = std::move(args);
  request.timeout = patience_.call;
  return request;
}

void KabamRequests::whenListed(const wire::ErrandPtr& errand, const map::Subject& subject,
                               std::function<void(std::optional<map::Failure>)> then) {
  when_known_(errand, subject, map::AskedFor::All,
              [this, errand, subject, then = std::move(then)](std::optional<map::Failure> failure) {
                if (!failure && !there_) failure = unsupported(subject);
                if (failure) return then(std::move(failure));
                waits_.await(
                    errand, patience_.lists, [this] { return book_.listed(); },
                    [this, subject, then](Awaited how) {
                      // A manager without a current map may say nothing of it.
                      const bool enough = how == Awaited::TooLate && book_.partlyListed();
                      if (how == Awaited::Held || enough) return then(std::nullopt);
                      map::Failure late{.kind = map::FailureKind::Cancelled, .subject = subject};
                      if (how == Awaited::TooLate) {
                        late.kind = map::FailureKind::TimedOut;
                        late.cause = {fault::ListsNotTold};
                      }
                      then(std::move(late));
                    });
              });
}

void KabamRequests::list(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  whenListed(errand, {map::SubjectKind::Catalogue, map::kMapsPart},
             [this, reply = std::move(reply)](std::optional<map::Failure> failure) {
               if (failure) return reply(fail(std::move(*failure)));
               reply(book_.entries());
             });
}

void KabamRequests::describe(const wire::ErrandPtr& errand, const map::MapKey& key,
                             OutcomeTo<map::CatalogueEntry> reply) {
  whenListed(errand, map::subjectOf(key),
             [this, key, reply = std::move(reply)](std::optional<map::Failure> failure) {
               if (failure) return reply(fail(std::move(*failure)));
               auto entry = key.kind == map::MapKind::Stored ? book_.entry(key.id) : std::nullopt;
               if (!entry) return reply(fail(wire::notThere(map::subjectOf(key))));
               reply(std::move(*entry));
             });
}

void KabamRequests::waypoints(const wire::ErrandPtr& errand, const map::MapKey& key,
                              OutcomeTo<StoredWaypoints> reply) {
  const map::Subject subject = map::placesOf(key);
  whenListed(errand, subject, [this, errand, key, subject, reply](std::optional<map::Failure> failure) {
    if (failure) return reply(fail(std::move(*failure)));
    if (key.kind != map::MapKind::Stored || !book_.find(key.id)) return reply(fail(wire::notThere(subject)));
    if (book_.isCurrent(key.id)) {
      if (auto stored = book_.waypoints(fixed_frame_())) return reply(std::move(*stored));
    }
    net::rosbridge::CallRequest all = request("get_waypoint", getWaypointArgs(key.id));
    all.timeout = patience_.read;
    call(errand, client_, std::move(all), [this, key, subject, reply](const CallAnswer& answer) {
      if (answer.kind != CallAnswer::Kind::Answered) return reply(fail(failed(answer, subject)));
      auto stored = readWaypoints(answer.values, key.id, fixed_frame_());
      if (stored) return reply(std::move(*stored));
      reply(fail(wire::unfit(subject, robot::wire::fault::PointsAreNoList)));
    });
  });
}

void KabamRequests::perform(const wire::ErrandPtr& errand, const map::MapKey& key,
                            const WaypointRequest& request, OutcomeTo<WaypointReceipt> reply) {
  const map::Subject subject = map::placesOf(key);
  whenListed(errand, subject,
             [this, errand, key, request, subject, reply](std::optional<map::Failure> failure) {
               if (!failure && !book_.find(key.id)) failure = wire::notThere(subject);
               if (!failure && request.changes.size() != 1) failure = wire::notOffered(subject);
               if (failure) {
                 failure->asked_for = map::AskedFor::Change;
                 return reply(fail(std::move(*failure)));
               }
               request.changes.front().before ? lookFirst(errand, key, request, reply)
                                              : send(errand, key, request, reply);
             });
}

// Someone else may have been faster. The topic may lag, and only covers the current map.
void KabamRequests::lookFirst(const wire::ErrandPtr& errand, const map::MapKey& key,
                              const WaypointRequest& asked, OutcomeTo<WaypointReceipt> reply) {
  const std::string id = asked.changes.front().id;
  call(errand, client_, request("get_waypoint", getWaypointArgs(key.id, id)),
       [this, errand, key, asked, reply](const CallAnswer& answer) {
         const map::Subject subject = map::placesOf(key);
         const auto stored = answer.kind == CallAnswer::Kind::Answered
                                 ? readWaypoints(answer.values, key.id, fixed_frame_())
                                 : std::nullopt;
         if (!stored) {
           // A read-only request has changed nothing.
           map::Failure failure = failed(answer, subject);
           failure.asked_for = map::AskedFor::Change;
           failure.applied = map::Applied::No;
           return reply(fail(std::move(failure)));
         }
         if (auto conflict = conflictIn(*stored, asked.changes.front(), subject)) {
           if (book_.isCurrent(key.id)) book_.distrustWaypoints();
           return reply(fail(*conflict));
         }
         // Unknown members are sent back unchanged.
         WaypointRequest fresh = asked;
         if (fresh.changes.front().after)
           fresh.changes.front().after->source = find(*stored, asked.changes.front().id)->source;
         send(errand, key, fresh, reply);
       });
}

void KabamRequests::send(const wire::ErrandPtr& errand, const map::MapKey& key, const WaypointRequest& asked,
                         OutcomeTo<WaypointReceipt> reply) {
  const auto change = std::make_shared<Change>();
  change->key = key;
  change->what = asked.changes.front();
  change->reply = std::move(reply);
  const WaypointService service = serviceOf(change->what);
  const bool creates = service == WaypointService::Create, deletes = service == WaypointService::Delete;
  const map::Waypoint& point = deletes ? *change->what.before : *change->what.after;
  const QByteArray message =
      waypointJson(point, creates ? std::string() : change->what.id, key.id, fixed_frame_());
  call(errand, client_, request(nameOf(service), manageWaypointArgs(message, deletes)),
       [this, errand, change, name = point.name](const CallAnswer& answer) {
         const map::Subject subject = map::placesOf(change->key);
         change->until = steady_clock::now() + patience_.confirm;
         if (answer.kind != CallAnswer::Kind::Answered) {
           map::Failure failure = failed(answer, subject, map::AskedFor::Change);
           const bool ends = failure.applied == map::Applied::No ||
                             answer.kind == CallAnswer::Kind::Cancelled ||
                             answer.kind == CallAnswer::Kind::LinkLost;
           if (ends) return change->reply(fail(std::move(failure)));
           return confirm(errand, change, std::move(failure));
         }
         auto failure = waypointResult(answer.values, subject, name);
         if (failure && failure->applied == map::Applied::No) return change->reply(fail(std::move(*failure)));
         const Field response = answer.values["waypoint_response"];
         change->id = response.isText() ? response.text() : response["id"].text();
         confirm(errand, change, std::move(failure));
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

void KabamRequests::confirm(const wire::ErrandPtr& errand, const ChangePtr& change,
                            std::optional<map::Failure> doubt) {
  const auto shown = std::make_shared<Shown>(Shown::NotYet);
  const bool told = book_.isCurrent(change->key.id) && book_.waypoints(fixed_frame_());
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(change->until - steady_clock::now());
  waits_.await(
      errand, std::clamp(left, std::chrono::milliseconds(0), told ? patience_.topic : change->pause),
      [this, told, change, shown] {
        const auto stored = told ? book_.waypoints(fixed_frame_()) : std::nullopt;
        *shown = stored ? shownIn(*stored, *change) : Shown::NotYet;
        return *shown == Shown::Done;
      },
      [this, errand, change, shown, doubt = std::move(doubt)](Awaited how) {
        if (how == Awaited::Cancelled)
          return endChange(change, *shown, cancelled(map::placesOf(change->key)));
        if (how == Awaited::Held) return endChange(change, *shown, doubt);
        askWhetherShown(errand, change, doubt);
      });
}

// For a map without a topic, or faster than the topic.
void KabamRequests::askWhetherShown(const wire::ErrandPtr& errand, const ChangePtr& change,
                                    std::optional<map::Failure> doubt) {
  // A deleted one is looked up in the whole list: the answer for a missing id is undefined.
  const std::string id = !change->what.after   ? std::string()
                         : change->what.before ? change->what.id
                                               : change->id;
  call(errand, client_, request("get_waypoint", getWaypointArgs(change->key.id, id)),
       [this, errand, change, doubt](const CallAnswer& answer) {
         const bool answered = answer.kind == CallAnswer::Kind::Answered;
         const auto stored =
             answered ? readWaypoints(answer.values, change->key.id, fixed_frame_()) : std::nullopt;
         const Shown shown = stored ? shownIn(*stored, *change) : Shown::NotYet;
         if (shown == Shown::Done && book_.isCurrent(change->key.id)) book_.distrustWaypoints();
         const bool over = answer.kind == CallAnswer::Kind::LinkLost ||
                           answer.kind == CallAnswer::Kind::Cancelled || steady_clock::now() >= change->until;
         if (shown == Shown::Done || over) return endChange(change, shown, doubt);
         change->pause = patience_.look_again;
         confirm(errand, change, doubt);
       });
}

void KabamRequests::endChange(const ChangePtr& change, Shown shown, std::optional<map::Failure> doubt) const {
  const map::Subject subject = map::placesOf(change->key);
  if (shown == Shown::Done) {
    WaypointReceipt receipt;
    if (!change->what.before && change->id != change->what.id) receipt.ids[change->what.id] = change->id;
    return change->reply(std::move(receipt));
  }
  if (doubt) return change->reply(fail(std::move(*doubt)));
  if (shown == Shown::OtherTags) return change->reply(fail(tagsKept(subject, change->what.after->name)));
  change->reply(fail(unconfirmed(subject, patience_.confirm)));
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_requests.cpp"
