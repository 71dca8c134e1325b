// KabamRequests: changes of maps. Source: docs/protocols/kabam-map-manager.md, "Services".
#include <utility>

#include "robot/ros/kabam_failures.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/kabam_results.h"
#include "robot/ros/ros_calls.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::CallAnswer;

const char* serviceOf(MapChange change) {
  switch (change) {
    case MapChange::Rename:
      return "rename_map";
    case MapChange::Load:
      return "load_map";
    case MapChange::Archive:
    case MapChange::Unarchive:  // by its flag
      return "archive_map";
    case MapChange::Delete:
      return "delete_map";
    case MapChange::StartMapping:
      return "start_mapping";
    case MapChange::StopMapping:
      return "stop_mapping";
    case MapChange::Save:
      break;
  }
  return "save_map";
}

QByteArray argsOf(const MapOrder& order, const KabamMap& map) {
  switch (order.change) {
    case MapChange::Rename:
      // An archived map stays archived, however the flag is interpreted.
      return updateMapArgs(map, order.name, map.archived, false);
    case MapChange::Archive:
    case MapChange::Unarchive:
      return updateMapArgs(map, {}, order.change == MapChange::Archive, false);
    case MapChange::Delete:
      return updateMapArgs(map, {}, map.archived, true);
    case MapChange::Load:
      return loadMapArgs(map.id, order.place);
    case MapChange::Save:
      return saveMapArgs(order.name);
    case MapChange::StartMapping:
    case MapChange::StopMapping:
      break;
  }
  return "{}";
}

bool isOfOneMap(MapChange change) {
  return change != MapChange::StartMapping && change != MapChange::StopMapping && change != MapChange::Save;
}

std::optional<map::Failure> resultOf(const MapOrder& order, const Field& values,
                                     const map::Subject& subject) {
  switch (order.change) {
    case MapChange::Load:
      return loadMapResult(values, subject);
    case MapChange::Save:
      return saveMapResult(values, subject, order.name);
    case MapChange::StartMapping:
    case MapChange::StopMapping:
      return triggerResult(values, subject);
    default:
      return updateMapResult(values, subject);
  }
}

}  // namespace

struct KabamRequests::Ordered {
  MapOrder order;
  OutcomeTo<map::CatalogueEntry> reply;
  map::CatalogueEntry before;  // of one map
  std::string id;              // of the saved map, as reported
  map::Subject subject() const {
    return isOfOneMap(order.change) ? map::subjectOf(order.key, before.name)
                                    : map::Subject(map::SubjectKind::Catalogue, map::kMapsPart);
  }
  /// The topics show it.
  bool holds(const KabamBook& book) const {
    const auto map = book.find(order.key.id);
    switch (order.change) {
      case MapChange::Rename:
        return map && calledOf(*map) == order.name;
      case MapChange::Load:
        return book.isCurrent(order.key.id);
      case MapChange::Archive:
        return map && map->archived;
      case MapChange::Unarchive:
        return map && !map->archived;
      case MapChange::Delete:
        return !map;
      case MapChange::StartMapping:
        return book.isMapping();
      case MapChange::StopMapping:
        return book.current() && !book.isMapping();
      case MapChange::Save:
        return saved(book).has_value();
    }
    return false;
  }
  std::optional<map::CatalogueEntry> saved(const KabamBook& book) const {
    if (!id.empty()) return book.entry(id);
    for (const map::CatalogueEntry& entry : book.entries()) {
      if (entry.name == order.name) return entry;
    }
    return std::nullopt;
  }
  map::CatalogueEntry now(const KabamBook& book) const {
    if (order.change == MapChange::Save) return saved(book).value_or(map::CatalogueEntry{});
    if (order.change == MapChange::Delete) return before;
    if (isOfOneMap(order.change)) return book.entry(order.key.id).value_or(before);
    const auto& current = book.current();
    return current ? book.entry(current->map.id).value_or(map::CatalogueEntry{}) : map::CatalogueEntry{};
  }
};

void KabamRequests::carryOut(const wire::TaskPtr& task, const MapOrder& order,
                             OutcomeTo<map::CatalogueEntry> reply) {
  const auto ordered = std::make_shared<Ordered>(Ordered{order, std::move(reply), {}, {}});
  if (isOfOneMap(order.change)) {
    describe(task, order.key, [this, task, ordered](Outcome<map::CatalogueEntry> entry) {
      if (!entry) {
        entry.error().asked_for = map::AskedFor::Change;
        return ordered->reply(std::move(entry));
      }
      ordered->before = std::move(*entry);
      sendOrder(task, ordered);
    });
    return;
  }
  whenListed(task, ordered->subject(), [this, task, ordered](std::optional<map::Failure> failure) {
    if (!failure) return sendOrder(task, ordered);
    failure->asked_for = map::AskedFor::Change;
    ordered->reply(tl::make_unexpected(std::move(*failure)));
  });
}

void KabamRequests::sendOrder(const wire::TaskPtr& task, const std::shared_ptr<Ordered>& ordered) {
  const MapOrder& order = ordered->order;
  const KabamMap map = book_.find(order.key.id).value_or(KabamMap{});
  call(task, client_, request(serviceOf(order.change), argsOf(order, map)),
       [this, task, ordered](const CallAnswer& answer) {
         const map::Subject subject = ordered->subject();
         const bool answered = answer.kind == CallAnswer::Kind::Answered;
         std::optional<map::Failure> failure =
             answered ? resultOf(ordered->order, answer.values, subject)
                      : std::optional(failed(answer, subject, map::AskedFor::Change));
         if (answered) ordered->id = answer.values["map_id"].text();
         // The requested state is already present.
         if (failure && failure->robot_code == kAlreadyLoaded && ordered->order.change == MapChange::Load &&
             ordered->holds(book_))
           failure.reset();
         const bool ended = failure && (failure->applied == map::Applied::No ||
                                        failure->kind == map::FailureKind::Cancelled ||
                                        failure->kind == map::FailureKind::Unreachable);
         if (ended) return ordered->reply(tl::make_unexpected(std::move(*failure)));
         confirmOrder(task, ordered, std::move(failure));
       });
}

void KabamRequests::confirmOrder(const wire::TaskPtr& task, const std::shared_ptr<Ordered>& ordered,
                                 std::optional<map::Failure> doubt) {
  waits_.await(
      task, patience_.confirm, [this, ordered] { return ordered->holds(book_); },
      [this, ordered, doubt = std::move(doubt)](Awaited how) {
        if (how == Awaited::Held) return ordered->reply(ordered->now(book_));
        if (how == Awaited::Cancelled)
          return ordered->reply(tl::make_unexpected(cancelled(ordered->subject())));
        ordered->reply(
            tl::make_unexpected(doubt ? *doubt : unconfirmed(ordered->subject(), patience_.confirm)));
      });
}

}  // namespace mapwright::robot::ros
