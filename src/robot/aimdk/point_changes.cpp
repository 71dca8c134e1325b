#include "robot/aimdk/point_changes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "robot/aimdk/aimdk_link.h"
#include "robot/aimdk/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/net_results.h"
#include "robot/wire/picture_bytes.h"

namespace mapwright::robot::aimdk {
namespace {

using std::chrono::steady_clock;

constexpr const char* kSetPoint = "aimdk.protocol.LocalizationService/SetNaviPoint";
constexpr double kKeptTurnRad = 0.02;  // angles may come back rounded to a degree

const map::Waypoint* pointIn(const map::WaypointList& list, const std::string& id) {
  const auto found = std::find_if(list.points.begin(), list.points.end(),
                                  [&](const map::Waypoint& point) { return point.id == id; });
  return found == list.points.end() ? nullptr : &*found;
}

double turnBetween(const std::optional<double>& a_rad, const std::optional<double>& b_rad) {
  return std::abs(geometry::normalizeAngle(a_rad.value_or(0) - b_rad.value_or(0)));
}

/// It cannot be asked for; nothing was sent.
map::Failure notAsked(map::Subject subject, Fault why) {
  return {.kind = map::FailureKind::Unsupported,
          .subject = std::move(subject),
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Unfit,
          .cause = std::move(why)};
}

}  // namespace

struct PointChanges::Change {
  wire::TaskPtr task;
  map::MapKey key;
  WaypointChange what;
  OutcomeTo<WaypointReceipt> reply;
  std::set<std::string> ids_before = {};
  std::string id = {};    // as the robot calls it; empty = not known
  double pixel_m = 0.05;  // it is kept no finer
  steady_clock::time_point until = {};
  std::optional<map::Failure> doubt = {};  // the failure, unless the change shows

  map::Subject subject() const { return map::placesOf(key); }
  void fail(map::Failure failure) const {
    failure.asked_for = map::AskedFor::Change;
    reply(robot::fail(std::move(failure)));
  }
  double farOff(const map::Waypoint& kept) const {
    return (kept.position_m - what.after->position_m).cwiseAbs().maxCoeff();
  }
  bool isTurnedSo(const map::Waypoint& kept) const {
    const double off_rad = turnBetween(kept.yaw_rad, what.after->yaw_rad);
    if (!what.before || map::sameHeading(what.before->yaw_rad, what.after->yaw_rad))
      return off_rad <= kKeptTurnRad;
    // A small turn that was ignored is no rounding.
    return off_rad <= kKeptTurnRad && off_rad < turnBetween(what.before->yaw_rad, what.after->yaw_rad);
  }
  /// Rounded to the pixel, or to the next one.
  bool isNear(const map::Waypoint& kept) const { return farOff(kept) <= 1.01 * pixel_m; }
};

void PointChanges::read(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<PixelPoints> reply) {
  link_.topology(task, key, TopologyUse::Editing,
                 [reply = std::move(reply)](Outcome<Topology> now, const ParsedMap* frame) {
                   if (!now) return reply(fail(std::move(now.error())));
                   PixelPoints points;
                   if (frame) points.pixel_m = 1 / now->scale.pixels_per_m;
                   points.stored.notes = std::move(now->list.notes);
                   std::string all;
                   std::set<std::string> ids;
                   for (map::Waypoint& point : now->list.points) {
                     all += point.source;
                     // What has no id of its own can be looked at, and not be changed.
                     const std::string own = point.id;
                     for (int turn = 2; point.id.empty() || !ids.insert(point.id).second; ++turn)
                       point.id = own + " #" + std::to_string(turn);
                     points.stored.points.push_back(std::move(point));
                   }
                   points.stored.revision = wire::fingerprint(all);
                   reply(std::move(points));
                 });
}

void PointChanges::perform(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& request,
                           OutcomeTo<WaypointReceipt> reply) {
  if (request.changes.size() != 1)
    return reply(fail(wire::notOffered(map::placesOf(key), map::AskedFor::Change)));
  const auto change = std::make_shared<Change>(Change{task, key, request.changes.front(), std::move(reply)});
  const WaypointChange& what = change->what;
  if (!what.after) return change->fail(notAsked(change->subject(), fault::PointsStay));
  if (!what.after->tags.empty()) return change->fail(notAsked(change->subject(), fault::PointsWithoutTags));
  // Someone else may have been faster, and where its pixels lie is to be told by the points as they are now.
  link_.topology(task, key, TopologyUse::Changing,
                 [this, change](const Outcome<Topology>& now, const ParsedMap* frame) {
                   if (!now) return change->fail(now.error());
                   auto body = requestFor(*change, *now, frame);
                   if (!body) return change->fail(std::move(body.error()));
                   send(change, *body);
                 });
}

Outcome<QByteArray> PointChanges::requestFor(Change& change, const Topology& now, const ParsedMap* frame) {
  const WaypointChange& what = change.what;
  for (const map::Waypoint& point : now.list.points) change.ids_before.insert(point.id);
  if (frame) change.pixel_m = 1 / now.scale.pixels_per_m;
  map::Waypoint wanted = *what.after;
  wanted.source.clear();
  std::optional<PixelPose> pose;
  const map::Waypoint* const kept = what.before ? pointIn(now.list, what.id) : nullptr;
  if (what.before) {
    const bool same = kept && kept->name == what.before->name && kept->type == what.before->type &&
                      map::samePlace(kept->position_m, what.before->position_m) &&
                      map::sameHeading(kept->yaw_rad, what.before->yaw_rad);
    if (!same) {
      return fail({.kind = map::FailureKind::Conflict,
                   .subject = change.subject(),
                   .asked_for = map::AskedFor::Change,
                   .cause = {faultText("aimdk", "\"%1\" was changed on the robot in the meantime"),
                             {what.before->name}}});
    }
    change.id = what.id;
    wanted.source = kept->source;
  }
  const bool moves = !kept || !map::samePlace(kept->position_m, wanted.position_m);
  const bool turns = !kept || !map::sameHeading(kept->yaw_rad, wanted.yaw_rad);
  if (moves || turns) {
    // On a running site it would otherwise land at the wrong place.
    if (!frame || !now.scale.certain) return fail(notAsked(change.subject(), fault::PointScaleUntold));
    const double scale = now.scale.pixels_per_m;
    pose.emplace();
    pose->u = std::llround(frame->u0 + wanted.position_m.x() * scale);
    pose->v = std::llround(frame->v0 - wanted.position_m.y() * scale);
    const double angle = -wanted.yaw_rad.value_or(0);
    if (turns) pose->angle = now.degrees ? geometry::degreesFromRadians(angle) : angle;
  }
  if (!pose && now.two_places.contains(change.id))
    return fail(notAsked(change.subject(), {fault::PointInTwoPlaces, {kept->name}}));
  return pointRequest(change.key.id, wanted, pose);
}

void PointChanges::send(const ChangePtr& change, const QByteArray& body) {
  link_.post(change->task, kSetPoint, body, [this, change](const net::HttpAnswer& answer) {
    change->doubt = notAccepted(answer, change->subject());
    const bool is_final = change->doubt && isFinal(*change->doubt);
    if (is_final && change->doubt->kind != map::FailureKind::RejectedByRobot)
      return change->fail(std::move(*change->doubt));
    if (change->id.empty() && answer.ok()) change->id = createdPoint(wire::view(answer.body));
    // What was refused is looked at once: some do it all the same.
    change->until = is_final ? steady_clock::now() : steady_clock::now() + times_.confirm;
    look(change);
  });
}

void PointChanges::look(const ChangePtr& change) {
  link_.topology(change->task, change->key, TopologyUse::Changing,
                 [this, change](const Outcome<Topology>& now, const ParsedMap*) {
                   if (!now) {
                     map::Failure failure = now.error();
                     failure.applied = map::Applied::Maybe;
                     return endOrRetry(change, std::move(failure));
                   }
                   const map::Waypoint& wanted = *change->what.after;
                   const map::Waypoint* kept = change->id.empty() ? nullptr : pointIn(now->list, change->id);
                   if (!kept && !change->what.before) {
                     // The creator got no id in the answer.
                     for (const map::Waypoint& point : now->list.points) {
                       if (!change->ids_before.contains(point.id) && point.name == wanted.name) kept = &point;
                     }
                   }
                   if (!kept)
                     return endOrRetry(
                         change, wire::otherwise(change->subject(), {fault::PointNotListed, {wanted.name}}));
                   change->id = kept->id;
                   if (!change->isNear(*kept))
                     return endOrRetry(
                         change, wire::otherwise(change->subject(), {fault::PointElsewhere,
                                                                     {wanted.name, change->farOff(*kept)}}));
                   if (kept->name != wanted.name || (!wanted.type.empty() && kept->type != wanted.type) ||
                       !change->isTurnedSo(*kept))
                     return endOrRetry(
                         change, wire::otherwise(change->subject(), {fault::PointOtherwise, {wanted.name}}));
                   endOrRetry(change, std::nullopt);
                 });
}

void PointChanges::endOrRetry(const ChangePtr& change, std::optional<map::Failure> wrong) {
  if (!wrong) {
    WaypointReceipt receipt;
    if (!change->what.before && change->id != change->what.id) receipt.ids[change->what.id] = change->id;
    return change->reply(std::move(receipt));
  }
  if (steady_clock::now() < change->until && wrong->kind != map::FailureKind::Cancelled) {
    return waits_.await(
        change->task, times_.look_again, [] { return false; },
        [this, change](wire::WaitList::End how) {
          if (how != wire::WaitList::End::Cancelled) return look(change);
          change->fail({.kind = map::FailureKind::Cancelled,
                        .subject = change->subject(),
                        .applied = map::Applied::Maybe});
        });
  }
  change->fail(change->doubt ? std::move(*change->doubt) : std::move(*wrong));
}

}  // namespace mapwright::robot::aimdk
