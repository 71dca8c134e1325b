// DispatchRequests: what of a map in space is laid on the plane.
//
// The service of the REP (SetMapProjections) takes nothing and tells all; the one of map_msgs that can set
// something (ProjectedMapsInfo) tells nothing. Asked without arguments, that would set nothing at all, so it
// is never asked to be read: there the topics of the projected maps tell.
#include <algorithm>
#include <utility>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/dispatch_requests.h"
#include "robot/ros/faults.h"
#include "robot/wire/failures.h"

namespace mapwright::robot::ros {
namespace {

constexpr const char* kUsualFrame = "map";  // REP 105

}  // namespace

bool DispatchRequests::tellsProjections() const {
  const auto there = found_.serviceOf(DispatchService::ReadProjections);
  return there && dispatchType(there->type) == "map_msgs/SetMapProjections";
}

std::vector<map::Projection> DispatchRequests::shown() const {
  std::vector<map::Projection> all;
  for (const auto& [index, part] : projected_) all.push_back(projectionOf(*part));
  return all;
}

void DispatchRequests::projections(const wire::TaskPtr& task, OutcomeTo<std::vector<map::Projection>> reply) {
  const auto there = found_.serviceOf(DispatchService::ReadProjections);
  if (!there) return reply(fail(notDispatched(DispatchService::ReadProjections, found_)));
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
  ask(task, DispatchService::ReadProjections, "{}", patience_.projections, map::AskedFor::All,
      [this, reply](Outcome<Answer> answer) {
        if (!answer) return reply(fail(std::move(answer.error())));
        auto told = readProjections(answer->values);
        if (!told) return reply(fail(wire::unfit(map::Subject(answer->service), told.error())));
        for (const map::Projection& one : *told) {
          if (!one.frame.empty()) projections_said_ = one.frame;
        }
        const int count = int(std::min<std::size_t>(told->size(), kMostProjected));
        if (std::exchange(told_, count) != count) Q_EMIT topicsChanged();
        reply(std::move(*told));
      });
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
  ask(task, DispatchService::ChangeProjections, projectionArgs(wanted), patience_.projections,
      map::AskedFor::Change, [this, watch, count](Outcome<Answer> answer) {
        if (!answer) {
          watches_.remove(watch);
          return watch->reply(fail(std::move(answer.error())));
        }
        watch->answered = true;
        // Topics of former projections may stay while somebody subscribes.
        watch->looked = found_.projected.empty();
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
      watch->task, patience_.settles, [watch] { return watch->looked && watch->awaited.empty(); },
      [this, watch](wire::WaitList::End how) { end(watch, how); });
}

void DispatchRequests::end(const WatchPtr& watch, wire::WaitList::End how) {
  using End = wire::WaitList::End;
  watches_.remove(watch);
  std::optional<map::Failure> failure;
  if (how == End::Cancelled) failure = map::Failure{.kind = map::FailureKind::Cancelled};
  if (how == End::Dropped)
    failure = map::Failure{.kind = map::FailureKind::Unreachable, .cause = {fault::LinkBrokeOff}};
  if (watch->changed && !found_.projected.empty() && std::exchange(told_, 0) != 0) Q_EMIT topicsChanged();
  if (!failure && !watch->changed) {
    tries_waited_ = true;
    Q_EMIT projectedSilent(silentTopics());
    if (watch->listed && tried() == 0) {
      failure = map::Failure{.kind = map::FailureKind::Unsupported,
                             .reason = map::FailureReason::Unfit,
                             .cause = {fault::ProjectionsNotTold}};
    }
  }
  if (!failure) return watch->reply(shown());
  const auto there = found_.serviceOf(DispatchService::ReadProjections);
  failure->subject = map::Subject(there ? there->name : std::string("set_map_projections"));
  if (watch->changed) {
    failure->asked_for = map::AskedFor::Change;
    failure->applied = map::Applied::Yes;
  }
  watch->reply(fail(std::move(*failure)));
}

}  // namespace mapwright::robot::ros
