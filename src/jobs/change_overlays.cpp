#include "jobs/change_overlays.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QCoreApplication>
#include <QStringList>

#include "jobs/faults.h"
#include "overlays/overlay_sentence.h"
#include "sentences/fault_sentence.h"
#include "words/listed.h"

namespace mapwright::jobs {
namespace {

using overlays::OverlayChange;
using overlays::OverlayDocument;
using robot::Outcome;
using robot::OverlayText;

class OverlaysText {
  Q_DECLARE_TR_FUNCTIONS(ChangeOverlays)
};

map::Failure otherMap(const map::MapKey& key, const std::string& name) {
  return {
      .kind = map::FailureKind::Conflict,
      .subject = map::subjectOf(key),
      .asked_for = map::AskedFor::Change,
      .reason = map::FailureReason::Unfit,
      .cause = {
          faultText("jobs",
                    "This version is of another map than \"%1\". Pass --map to use it there all the same."),
          {name}}};
}

map::Failure unreadable(const map::MapKey& key, Fault why) {
  return {
      .kind = map::FailureKind::MalformedAnswer,
      .subject = map::subjectOf(key),
      .reason = map::FailureReason::Unfit,
      .cause = {faultText("jobs", "The overlays that the robot holds cannot be read"), {}, {std::move(why)}}};
}

/// The steps of one order, one request after the other.
class OverlayChanging : public std::enable_shared_from_this<OverlayChanging> {
 public:
  OverlayChanging(robot::OverlayStore& store, OverlayOrder order, robot::OutcomeTo<OverlayOutcome> reply)
      : store_(store), order_(std::move(order)), reply_(std::move(reply)) {}

  robot::Call start() {
    // Weak, because what is in progress holds this object.
    state_->cancel = [weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->call_.cancel();
    };
    const robot::Call call(state_);
    if (order_.held) {
      look(*order_.held);
    } else {
      read([](OverlayChanging& self, Outcome<OverlayText> now) {
        if (now) self.reportSeen(*now, false);
        self.look(std::move(now));
      });
    }
    return call;
  }

 private:
  void end(Outcome<OverlayOutcome> outcome) {
    state_->over = true;
    reply_(std::move(outcome));
  }

  template <typename Then>
  void read(Then then) {
    call_ = store_.read(order_.map, [self = shared_from_this(), then](Outcome<OverlayText> now) {
      then(*self, std::move(now));
    });
  }

  void reportSeen(const OverlayText& held, bool saved) {
    if (order_.seen) order_.seen(held, saved);
  }

  void look(Outcome<OverlayText> now) {
    if (!now) return end(robot::fail(std::move(now.error())));
    if (!order_.only_uid.empty() && !now->map_uid.empty() && order_.only_uid != now->map_uid)
      return end(robot::fail(otherMap(order_.map, now->map_name)));
    using Read = tl::expected<OverlayDocument, Fault>;
    auto theirs = order_.base && order_.base->text() == now->text ? Read(*order_.base)
                                                                  : OverlayDocument::read(now->text);
    if (!theirs && order_.base) return end(robot::fail(unreadable(order_.map, theirs.error())));
    const OverlayDocument held = theirs ? std::move(*theirs) : OverlayDocument();
    outcome_.before = outcome_.held = std::move(*now);
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
    if (!order_.send || !outcome_.merge.conflicts.empty() || text == outcome_.before.text)
      return end(std::move(outcome_));
    outcome_.sent = true;
    call_ = store_.write(order_.map, text, [self = shared_from_this()](Outcome<std::monostate> answer) {
      self->lookAgain(answer ? std::nullopt : std::optional(std::move(answer.error())));
    });
  }

  /// No answer is believed, neither a yes nor a no, and one may be lost: what the robot holds counts.
  void lookAgain(const std::optional<map::Failure>& failed) {
    using map::FailureKind;
    if (failed) {
      const FailureKind kind = failed->kind;
      const bool refused = kind == FailureKind::RejectedByRobot || kind == FailureKind::Refused ||
                           kind == FailureKind::Conflict;
      const bool never_sent = failed->applied == map::Applied::No && !refused;
      if (never_sent || kind == FailureKind::Cancelled) return end(robot::fail(*failed));
    }
    read([failed](OverlayChanging& self, Outcome<OverlayText> now) {
      failed ? self.judge(*failed, std::move(now)) : self.compare(std::move(now));
    });
  }

  void judge(map::Failure failed, Outcome<OverlayText> now) {
    const bool changed = !now || now->text != outcome_.before.text;
    const auto held = now ? OverlayDocument::read(now->text) : OverlayDocument();
    if (now && changed && held && otherwiseHeld(outcome_.merge.document, *held).empty())
      return compare(std::move(now));
    if (now) reportSeen(*now, false);
    // That it holds what it held is no proof after a lost answer: it may come yet. What it holds is neither:
    // was it this change? A conflict says that it was somebody else's.
    const bool may = failed.applied != map::Applied::No;
    if (may || (changed && failed.kind != map::FailureKind::Conflict)) failed.applied = map::Applied::Maybe;
    end(robot::fail(std::move(failed)));
  }

  void compare(Outcome<OverlayText> now) {
    if (!now) {
      // It said that it did it; nobody knows.
      now.error().kind = map::FailureKind::Unreachable;
      now.error().asked_for = map::AskedFor::Change;
      now.error().applied = map::Applied::Maybe;
      return end(robot::fail(std::move(now.error())));
    }
    reportSeen(*now, true);
    const auto held = OverlayDocument::read(now->text);
    outcome_.held = std::move(*now);
    if (!held) {
      outcome_.unreadable = held.error();
      return end(std::move(outcome_));
    }
    outcome_.differs = otherwiseHeld(outcome_.merge.document, *held);
    using Between = OverlayOutcome::Between;
    const bool told = outcome_.held.version && outcome_.before.version;
    const int steps = told ? *outcome_.held.version - *outcome_.before.version : 0;
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
  robot::Call call_;
  OverlayOutcome outcome_;
};

}  // namespace

std::vector<OverlayChange> otherwiseHeld(const OverlayDocument& sent, const OverlayDocument& held) {
  std::vector<OverlayChange> differs = overlays::changesBetween(sent, held);
  std::erase_if(differs, [](const OverlayChange& change) {
    return change.kind == overlays::ChangeKind::Change && overlays::onlyNewId(change.parts);
  });
  return differs;
}

map::Applied OverlayOutcome::applied() const {
  if (!merge.conflicts.empty() || held_back) return map::Applied::No;
  if (unreadable.any()) return map::Applied::Maybe;
  if (!sent || differs.empty()) return map::Applied::Yes;
  return held.version && held.version == before.version ? map::Applied::No : map::Applied::Maybe;
}

QString doubtOf(const OverlayOutcome& outcome) {
  using Between = OverlayOutcome::Between;
  if (outcome.certain()) return {};
  if (outcome.unreadable.any())
    return OverlaysText::tr("The overlays were sent, but what the robot holds now cannot be read. %1")
        .arg(sentences::sentenceOf(outcome.unreadable));
  QStringList sentences;
  if (outcome.between == Between::Somebody) {
    sentences << OverlaysText::tr(
                     "Someone else changed the overlays while they were being saved (version %1, then %2).")
                     .arg(*outcome.before.version)
                     .arg(*outcome.held.version);
    if (outcome.differs.empty()) sentences << OverlaysText::tr("Their changes were overwritten.");
  } else if (outcome.between == Between::Unknown) {
    sentences << OverlaysText::tr(
        "The robot does not count versions of its overlays, so someone else may have changed them at the "
        "same time.");
  }
  if (!outcome.differs.empty()) {
    sentences << OverlaysText::tr("The robot has something other than what was sent (%1).")
                     .arg(overlays::featuresCalled(outcome.differs));
    if (outcome.held.version && outcome.held.version == outcome.before.version)
      sentences << OverlaysText::tr(
          "It has not counted a change yet and may still make it. Check again in a moment.");
  }
  return words::paragraph(sentences);
}

robot::Call changeOverlays(robot::OverlayStore& store, OverlayOrder order,
                           robot::OutcomeTo<OverlayOutcome> reply) {
  return std::make_shared<OverlayChanging>(store, std::move(order), std::move(reply))->start();
}

}  // namespace mapwright::jobs
