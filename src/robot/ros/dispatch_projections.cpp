// DispatchRequests: what of a map in space is laid on the plane.
//
// The service of the REP (SetMapProjections) takes nothing and tells all; the one of map_msgs that can set
// something (ProjectedMapsInfo) tells nothing. Asked without arguments, that would set nothing at all, so it
// is never asked to be read: there the topics of the projected maps tell.
#include <algorithm>
#include <utility>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/dispatch_requests.h"

namespace mapwright::robot::ros {
namespace {

auto fail(map::Failure failure) { return tl::make_unexpected(std::move(failure)); }

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

void DispatchRequests::projections(const wire::ErrandPtr& errand,
                                   OutcomeTo<std::vector<map::Projection>> reply) {
  const auto there = found_.serviceOf(DispatchService::ReadProjections);
  if (!there) return reply(fail(notDispatched(DispatchService::ReadProjections, found_)));
  if (tellsProjections()) return readByService(errand, std::move(reply));
  awaitProjected(errand, std::move(reply));
}

void DispatchRequests::awaitProjected(const wire::ErrandPtr& errand,
                                      OutcomeTo<std::vector<map::Projection>> reply) {
  const auto watch = std::make_shared<Watch>();
  watch->errand = errand;
  watch->reply = std::move(reply);
  for (const auto& [index, topic] : found_.projected) {
    if (!projected_.contains(index)) watch->awaited.insert(index);
  }
  begin(watch);
}

void DispatchRequests::readByService(const wire::ErrandPtr& errand, ProjectionsReply reply) {
  const std::string name = found_.serviceOf(DispatchService::ReadProjections)->name;
  ask(
      errand, DispatchService::ReadProjections, "{}", patience_.projections, map::AskedFor::All,
      [this, reply, name](const Field& values) {
        auto told = readProjections(values);
        if (told) {
          const int count = int(std::min<std::size_t>(told->size(), kMostProjected));
          if (std::exchange(told_, count) != count) Q_EMIT topicsChanged();
          return reply(std::move(*told));
        }
        map::Failure failure;
        failure.kind = map::FailureKind::MalformedAnswer;
        failure.subject = map::Subject(name);
        failure.reason = map::FailureReason::Unfit;
        failure.cause = told.error();
        reply(fail(std::move(failure)));
      },
      [reply](map::Failure failure) { reply(fail(std::move(failure))); });
}

void DispatchRequests::project(const wire::ErrandPtr& errand, const std::vector<map::Projection>& wanted,
                               OutcomeTo<std::vector<map::Projection>> reply) {
  const auto watch = std::make_shared<Watch>();
  watch->errand = errand;
  watch->reply = reply;
  watch->changed = true;
  watch->wanted = wanted;
  watch->answered = false;
  const int count = int(std::min<std::size_t>(wanted.size(), kMostProjected));
  for (int index = 0; index < count; ++index) watch->awaited.insert(index);
  // A topic may tell before the service answers.
  watches_.push_back(watch);
  if (std::exchange(told_, count) != count) Q_EMIT topicsChanged();
  ask(
      errand, DispatchService::ChangeProjections, projectionArgs(wanted), patience_.projections,
      map::AskedFor::Change,
      [this, watch, count](const Field& values) {
        watch->answered = true;
        // Topics of what is not projected any more go; where nobody tells which there are, by their number.
        watch->looked = found_.projected.empty();
        if (watch->looked) forgetProjected([count](int index) { return index >= count; });
        Q_EMIT lookWanted();
        if (auto told = readProjections(values)) {
          watches_.remove(watch);
          return watch->reply(std::move(*told));
        }
        if (tellsProjections()) {
          watches_.remove(watch);
          return readByService(watch->errand, [watch](Outcome<std::vector<map::Projection>> told) {
            // It has been set, whatever became of the question.
            if (!told) told.error().applied = map::Applied::Yes;
            watch->reply(std::move(told));
          });
        }
        watches_.remove(watch);
        begin(watch);
      },
      [this, watch](map::Failure failure) {
        watches_.remove(watch);
        watch->reply(fail(std::move(failure)));
      });
}

void DispatchRequests::begin(const WatchPtr& watch) {
  watches_.push_back(watch);
  watch->timer.setSingleShot(true);
  const std::weak_ptr<Watch> held = watch;
  connect(&watch->timer, &QTimer::timeout, this, [this, held] {
    if (const WatchPtr now = held.lock()) end(now, std::nullopt);
  });
  watch->number = watch->errand->begun([this, held] {
    QMetaObject::invokeMethod(
        this,
        [this, held] {
          if (const WatchPtr now = held.lock()) end(now, map::Failure{.kind = map::FailureKind::Cancelled});
        },
        Qt::QueuedConnection);
  });
  watch->timer.start(patience_.settles);
  lookAt(watch);
}

void DispatchRequests::lookAt(const WatchPtr& watch) {
  if (watch->answered && watch->looked && watch->awaited.empty()) end(watch, std::nullopt);
}

void DispatchRequests::end(const WatchPtr& watch, std::optional<map::Failure> failure) {
  const auto found = std::find(watches_.begin(), watches_.end(), watch);
  if (found == watches_.end()) return;
  watches_.erase(found);
  watch->timer.stop();
  watch->errand->ended(watch->number);
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
