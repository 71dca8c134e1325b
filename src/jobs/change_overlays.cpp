#include "jobs/change_overlays.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "jobs/faults.h"

namespace mapwright::jobs {
namespace {

using overlays::OverlayChange;
using overlays::OverlayDocument;
using robot::Outcome;
using robot::OverlayText;

map::Failure otherMap(const map::MapKey& key, const std::string& name) {
  return {.kind = map::FailureKind::Conflict,
          .subject = map::subjectOf(key),
          .asked_for = map::AskedFor::Change,
          .reason = map::FailureReason::Unfit,
          .cause = {fault::AnotherMap, {name}}};
}

map::Failure unreadable(const map::MapKey& key, Fault why) {
  return {.kind = map::FailureKind::MalformedAnswer,
          .subject = map::subjectOf(key),
          .reason = map::FailureReason::Unfit,
          .cause = {fault::OverlaysNotRead, {}, {std::move(why)}}};
}

/// Robots give an id to features that have none.
bool onlyNewIds(const OverlayChange& change) {
  if (change.kind != overlays::ChangeKind::Change) return false;
  return std::all_of(change.parts.begin(), change.parts.end(), [](const overlays::PartChange& part) {
    return !part.before && part.part.name == "id" && part.part.of != overlays::Part::Of::Whole;
  });
}

/// The steps of one order, one request after the other.
class OverlayChanging : public std::enable_shared_from_this<OverlayChanging> {
 public:
  OverlayChanging(robot::OverlayStore& store, OverlayOrder order, robot::OutcomeTo<OverlayOutcome> reply)
      : store_(store), order_(std::move(order)), reply_(std::move(reply)) {}

  robot::Call start() {
    // Weak, because what is under way holds this object.
    state_->cancel = [weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->under_way_.cancel();
    };
    under_way_ = store_.read(
        order_.map, [self = shared_from_this()](Outcome<OverlayText> now) { self->look(std::move(now)); });
    return robot::Call(state_);
  }

 private:
  void end(Outcome<OverlayOutcome> outcome) {
    state_->over = true;
    reply_(std::move(outcome));
  }

  void look(Outcome<OverlayText> now) {
    if (!now) return end(robot::fail(std::move(now.error())));
    if (order_.seen) order_.seen(*now, false);
    if (!order_.only_uid.empty() && !now->map_uid.empty() && order_.only_uid != now->map_uid)
      return end(robot::fail(otherMap(order_.map, now->map_name)));
    auto theirs = OverlayDocument::read(now->text);
    if (!theirs && order_.base) return end(robot::fail(unreadable(order_.map, theirs.error())));
    const OverlayDocument held = theirs ? std::move(*theirs) : OverlayDocument();
    outcome_.before = std::move(now->text);
    outcome_.version_before = outcome_.version = now->version;
    if (order_.base) {
      outcome_.merge = overlays::merge(*order_.base, order_.mine, held);
    } else {
      outcome_.merge.document = order_.mine;
      outcome_.merge.mine = overlays::changesBetween(held, order_.mine);
    }
    outcome_.deletes = std::size_t(std::count_if(
        outcome_.merge.mine.begin(), outcome_.merge.mine.end(),
        [](const OverlayChange& change) { return change.kind == overlays::ChangeKind::Remove; }));
    outcome_.keeps = held.features().size() - std::min(outcome_.deletes, held.features().size());
    outcome_.held_back = order_.send && !order_.may_empty && outcome_.deletes > outcome_.keeps;
    if (outcome_.held_back) return end(std::move(outcome_));
    const std::string text = outcome_.merge.document.text();
    if (!order_.send || !outcome_.merge.conflicts.empty() || text == outcome_.before)
      return end(std::move(outcome_));
    outcome_.sent = true;
    under_way_ = store_.write(order_.map, text, [self = shared_from_this()](Outcome<OverlayText> stored) {
      self->compare(std::move(stored));
    });
  }

  /// A refusal is not believed either: what the robot holds counts.
  void lookAfterRefusal(const map::Failure& failure) {
    under_way_ = store_.read(order_.map, [self = shared_from_this(), failure](Outcome<OverlayText> now) {
      const bool changed = !now || now->text != self->outcome_.before;
      const auto held = now ? OverlayDocument::read(now->text) : OverlayDocument();
      if (now && changed && held && otherwiseHeld(self->outcome_.merge.document, *held).empty())
        return self->compare(std::move(now));
      map::Failure refused = failure;
      // What it holds is neither: was it this change? A conflict says that it was somebody else's.
      if (changed && failure.kind != map::FailureKind::Conflict) refused.applied = map::Applied::Maybe;
      self->end(robot::fail(std::move(refused)));
    });
  }

  void compare(Outcome<OverlayText> stored) {
    if (!stored) {
      using map::FailureKind;
      const FailureKind kind = stored.error().kind;
      const bool refused = kind == FailureKind::RejectedByRobot || kind == FailureKind::Refused ||
                           kind == FailureKind::Conflict;
      return refused ? lookAfterRefusal(stored.error()) : end(robot::fail(std::move(stored.error())));
    }
    if (order_.seen) order_.seen(*stored, true);
    const auto now = OverlayDocument::read(stored->text);
    outcome_.version = stored->version;
    if (!now) {
      outcome_.unreadable = now.error();
      return end(std::move(outcome_));
    }
    outcome_.differs = otherwiseHeld(outcome_.merge.document, *now);
    using Between = OverlayOutcome::Between;
    const bool told = stored->version && outcome_.version_before;
    const int steps = told ? *stored->version - *outcome_.version_before : 0;
    outcome_.between = steps == 1                          ? Between::None
                       : steps > 1                         ? Between::Somebody
                       : told && !outcome_.differs.empty() ? Between::None  // it did nothing
                                                           : Between::Unknown;
    end(std::move(outcome_));
  }

  robot::OverlayStore& store_;
  OverlayOrder order_;
  robot::OutcomeTo<OverlayOutcome> reply_;
  std::shared_ptr<robot::Call::State> state_ = std::make_shared<robot::Call::State>();
  robot::Call under_way_;
  OverlayOutcome outcome_;
};

}  // namespace

std::vector<OverlayChange> otherwiseHeld(const OverlayDocument& sent, const OverlayDocument& held) {
  std::vector<OverlayChange> differs = overlays::changesBetween(sent, held);
  std::erase_if(differs, onlyNewIds);
  return differs;
}

robot::Call changeOverlays(robot::OverlayStore& store, OverlayOrder order,
                           robot::OutcomeTo<OverlayOutcome> reply) {
  return std::make_shared<OverlayChanging>(store, std::move(order), std::move(reply))->start();
}

}  // namespace mapwright::jobs
