#include "jobs/change_overlays.h"

#include <algorithm>
#include <memory>
#include <type_traits>
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

/// What the robot held, and what is to be sent.
struct Looked {
  overlays::OverlayMerge merge;
  std::vector<OverlayChange> changes;
  std::size_t held = 0;  // features
  std::string text;      // of what is to be sent
  Fault unreadable;      // why nothing can be merged with what is held
};

Looked lookedAt(const std::optional<OverlayDocument>& base, const OverlayDocument& mine,
                const std::string& text) {
  using Read = tl::expected<OverlayDocument, Fault>;
  const auto theirs = base && base->text() == text ? Read(*base) : OverlayDocument::read(text);
  Looked looked;
  if (!theirs && base) {
    looked.unreadable = theirs.error();
    return looked;
  }
  const OverlayDocument held = theirs ? *theirs : OverlayDocument();
  looked.held = held.features().size();
  if (base) {
    looked.merge = overlays::merge(*base, mine, held);
  } else {
    looked.merge.document = mine;
    looked.merge.mine = overlays::changesBetween(held, mine);
  }
  const bool as_before = base && held.isSameText(*base);
  looked.changes = as_before ? looked.merge.mine : overlays::changesBetween(held, looked.merge.document);
  looked.text = looked.merge.document.text();
  return looked;
}

struct Compared {
  std::vector<OverlayChange> differs;
  std::optional<OverlaysHeld> held;
  Fault unreadable;
};

Compared comparedWith(const std::string& text, const OverlayDocument& sent) {
  Compared compared;
  if (const auto held = OverlayDocument::read(text)) {
    compared.differs = otherwiseHeld(sent, *held);
    compared.held = OverlaysHeld{*held, sent, compared.differs.empty()};
  } else {
    compared.unreadable = held.error();
  }
  return compared;
}

/// The steps of one order, one request after the other.
class OverlayChanging : public std::enable_shared_from_this<OverlayChanging> {
 public:
  OverlayChanging(robot::OverlayStore& store, OverlayOrder order, robot::OutcomeTo<OverlayOutcome> reply)
      : store_(store), order_(std::move(order)), reply_(std::move(reply)) {}

  robot::Call start() {
    // Weak, because what is in progress holds this object.
    state_->cancel = [weak = weak_from_this()] {
      const auto self = weak.lock();
      if (!self) return;
      self->cancelled_ = true;
      self->call_.cancel();
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

  /// `work`: its result is what `then` gets, on this thread. It reads nothing that changes meanwhile.
  template <typename Work, typename Then>
  void compute(Work work, Then then) {
    const auto both = [self = shared_from_this(), work = std::move(work), then] {
      return [self, then, result = std::make_shared<std::invoke_result_t<Work>>(work())] {
        then(*self, std::move(*result));
      };
    };
    order_.elsewhere ? order_.elsewhere(both) : both()();
  }

  void reportSeen(const OverlayText& held, bool saved, const OverlaysHeld* read = nullptr) {
    if (order_.seen) order_.seen(held, saved, read);
  }

  void look(Outcome<OverlayText> now) {
    if (!now) return end(robot::fail(std::move(now.error())));
    if (!order_.only_uid.empty() && !now->map_uid.empty() && order_.only_uid != now->map_uid)
      return end(robot::fail(otherMap(order_.map, now->map_name)));
    outcome_.before = outcome_.held = std::move(*now);
    compute([base = order_.base, mine = order_.mine,
             text = outcome_.before.text] { return lookedAt(base, mine, text); },
            [](OverlayChanging& self, Looked looked) { self.onLooked(std::move(looked)); });
  }

  void onLooked(Looked looked) {
    if (cancelled_)
      return end(robot::fail(map::Failure{.kind = map::FailureKind::Cancelled,
                                          .subject = map::subjectOf(order_.map),
                                          .asked_for = map::AskedFor::Change}));
    if (looked.unreadable.any()) return end(robot::fail(unreadable(order_.map, looked.unreadable)));
    outcome_.merge = std::move(looked.merge);
    outcome_.changes = std::move(looked.changes);
    outcome_.deletes = std::size_t(std::count_if(
        outcome_.merge.mine.begin(), outcome_.merge.mine.end(),
        [](const OverlayChange& change) { return change.kind == overlays::ChangeKind::Remove; }));
    outcome_.keeps = looked.held - std::min(outcome_.deletes, looked.held);
    outcome_.held_back = order_.send && !order_.may_empty && outcome_.deletes > outcome_.keeps;
    if (outcome_.held_back) return end(std::move(outcome_));
    if (!order_.send || !outcome_.merge.conflicts.empty() || looked.text == outcome_.before.text)
      return end(std::move(outcome_));
    outcome_.sent = true;
    call_ =
        store_.write(order_.map, looked.text, [self = shared_from_this()](Outcome<std::monostate> answer) {
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
    outcome_.held = std::move(*now);
    compute([sent = outcome_.merge.document, text = outcome_.held.text] { return comparedWith(text, sent); },
            [](OverlayChanging& self, Compared compared) {
              self.reportSeen(self.outcome_.held, true, compared.held ? &*compared.held : nullptr);
              self.outcome_.differs = std::move(compared.differs);
              self.outcome_.unreadable = std::move(compared.unreadable);
              self.outcome_.unreadable.any() ? self.end(std::move(self.outcome_)) : self.judgeVersions();
            });
  }

  void judgeVersions() {
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
  bool cancelled_ = false;
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
