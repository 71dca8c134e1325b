#include "robot/axbot/pose_requests.h"

#include <cmath>
#include <memory>
#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "robot/axbot/faults.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

// It is the pose that was set: the robot may have driven on since.
constexpr double kSameM = 0.15, kSameRad = 0.1;
// An answer that is lost is replaced by a pose that is near enough to have been set.
constexpr double kNearM = 0.5, kNearRad = 0.35;
// It has not moved.
constexpr double kStillM = 0.02, kStillRad = 0.02;

const map::Subject kRobot(map::SubjectKind::Robot);

bool within(const geometry::Pose2& one, const geometry::Pose2& other, double metres, double radians) {
  return std::hypot(one.x_m - other.x_m, one.y_m - other.y_m) <= metres &&
         std::abs(geometry::normalizeAngle(one.yaw_rad - other.yaw_rad)) <= radians;
}

map::Failure unknown(const FaultCode& cause) {
  return {.kind = map::FailureKind::TimedOut,
          .subject = kRobot,
          .applied = map::Applied::Maybe,
          .asked_for = map::AskedFor::Change,
          .cause = cause};
}

map::Failure cancelled() {
  return {.kind = map::FailureKind::Cancelled,
          .subject = kRobot,
          .applied = map::Applied::Maybe,
          .asked_for = map::AskedFor::Change};
}

}  // namespace

void PoseRequests::begin() {
  if (++in_progress_ == 1)
    hold_({QStringLiteral("/tracked_pose"), QStringLiteral("/global_positioning_state")});
}

void PoseRequests::end() {
  if (--in_progress_ == 0) hold_({});
}

void PoseRequests::hear(const map::TopicMessage& message) {
  if (in_progress_ == 0) return;
  if (const auto* pose = std::get_if<map::TrackedPose>(&message)) {
    pose_ = pose->pose;
  } else if (const auto* result = std::get_if<map::GlobalPositioning>(&message)) {
    result_ = *result;
    searching_ = searching_ || result->state == "running";
  } else {
    return;
  }
  waits_.look();
}

void PoseRequests::setPose(const Task& task, const PoseOrder& order, OutcomeTo<geometry::Pose2> reply) {
  begin();
  pose_.reset();
  const auto finish = [this, reply = std::move(reply)](Outcome<geometry::Pose2> outcome) {
    end();
    reply(std::move(outcome));
  };
  // Where it is before, or else a pose near to that one would be taken for what was set.
  waits_.await(
      task, patience_.held, [this] { return pose_.has_value(); },
      [this, task, order, finish](wire::WaitList::End how) {
        if (how == wire::WaitList::End::Cancelled || how == wire::WaitList::End::Dropped) {
          map::Failure failure = cancelled();
          failure.applied = map::Applied::No;
          return finish(fail(std::move(failure)));
        }
        sendPose(task, order, finish);
      });
}

void PoseRequests::sendPose(const Task& task, const PoseOrder& order, OutcomeTo<geometry::Pose2> reply) {
  net::HttpRequest request = server_.request(QStringLiteral("/chassis/pose"));
  request.method = net::HttpMethod::Post;
  QJsonObject body{{QStringLiteral("position"), QJsonArray{order.pose.x_m, order.pose.y_m, 0}},
                   {QStringLiteral("ori"), order.pose.yaw_rad}};
  if (order.adjust) body[QStringLiteral("adjust_position")] = true;
  request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  wire::send(task, server_.http, request,
             [this, task, order, reply = std::move(reply)](const net::HttpAnswer& answer) {
               std::optional<map::Failure> doubt;
               if (answer.ok()) {
                 if (auto refusal = refusalIn(answer, kRobot)) return reply(fail(std::move(*refusal)));
               } else {
                 doubt = wire::failed(answer, kRobot, map::AskedFor::Change);
                 if (doubt->applied == map::Applied::No || doubt->kind == map::FailureKind::Cancelled)
                   return reply(fail(std::move(*doubt)));
                 doubt->applied = map::Applied::Maybe;
               }
               awaitPose(task, order, std::exchange(pose_, std::nullopt), std::move(doubt), reply);
             });
}

void PoseRequests::awaitPose(const Task& task, const PoseOrder& order, std::optional<geometry::Pose2> before,
                             std::optional<map::Failure> doubt, OutcomeTo<geometry::Pose2> reply) {
  const bool asks_move = before && !within(*before, order.pose, kStillM, kStillRad);
  const auto isStill = [this, before, asks_move] {
    return pose_ && asks_move && within(*pose_, *before, kStillM, kStillRad);
  };
  waits_.await(
      task, patience_.pose,
      [this, order, isStill] { return pose_ && !isStill() && within(*pose_, order.pose, kSameM, kSameRad); },
      [this, order, doubt, isStill, reply = std::move(reply)](wire::WaitList::End how) {
        if (how == wire::WaitList::End::Cancelled || how == wire::WaitList::End::Dropped)
          return reply(fail(cancelled()));
        const bool near = pose_ && !isStill() && within(*pose_, order.pose, kNearM, kNearRad);
        if (doubt && !near) return reply(fail(*doubt));
        if (!pose_)
          return reply(
              fail(unknown(faultText("axbot", "the robot accepted the pose, but does not say where it is"))));
        if (isStill()) {
          return reply(fail(map::Failure{
              .kind = map::FailureKind::RejectedByRobot,
              .subject = kRobot,
              .asked_for = map::AskedFor::Change,
              .reason = map::FailureReason::Unfit,
              .cause = faultText(
                  "axbot", "The robot accepted the pose, but says that it is still where it was before.")}));
        }
        reply(*pose_);
      });
}

void PoseRequests::findItself(const Task& task, OutcomeTo<map::GlobalPositioning> reply) {
  begin();
  searching_ = false;
  result_.reset();
  net::HttpRequest request = server_.request(QStringLiteral("/services/start_global_positioning"));
  request.method = net::HttpMethod::Post;
  request.body = "{}";
  const auto finish = [this, reply = std::move(reply)](Outcome<map::GlobalPositioning> outcome) {
    end();
    reply(std::move(outcome));
  };
  wire::send(task, server_.http, request, [this, task, finish](const net::HttpAnswer& answer) {
    std::optional<map::Failure> doubt;
    if (answer.ok()) {
      if (auto refusal = refusalIn(answer, kRobot)) return finish(fail(std::move(*refusal)));
    } else {
      doubt = wire::failed(answer, kRobot, map::AskedFor::Change);
      if (doubt->applied == map::Applied::No || doubt->kind == map::FailureKind::Cancelled)
        return finish(fail(std::move(*doubt)));
    }
    const auto patience = doubt ? patience_.pose * 5 : patience_.search;
    // The last result is sent again to whoever subscribes: that one does not count.
    waits_.await(
        task, patience_.held, [this] { return result_.has_value(); },
        [this, task, patience, doubt, finish](wire::WaitList::End how) {
          if (how == wire::WaitList::End::Cancelled || how == wire::WaitList::End::Dropped)
            return finish(fail(cancelled()));
          awaitResult(task, patience, doubt, finish);
        });
  });
}

void PoseRequests::awaitResult(const Task& task, std::chrono::milliseconds patience,
                               std::optional<map::Failure> doubt, OutcomeTo<map::GlobalPositioning> reply) {
  const auto isNew = [this, before = result_] {
    if (!result_ || result_->state == "running") return false;
    return searching_ || !before || *before != *result_;
  };
  waits_.await(task, patience, isNew, [this, doubt, reply = std::move(reply)](wire::WaitList::End how) {
    if (how == wire::WaitList::End::Held) return reply(*result_);
    if (how != wire::WaitList::End::TooLate) return reply(fail(cancelled()));
    if (doubt) return reply(fail(*doubt));
    reply(fail(unknown(faultText("axbot", "the robot accepted it, but does not say what came of it"))));
  });
}

}  // namespace mapwright::robot::axbot
