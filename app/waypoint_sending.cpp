#include "app/waypoint_sending.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QEventLoop>

#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/table.h"
#include "edit/open_waypoints.h"
#include "sentences/failure_sentence.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(WaypointSending)
};

constexpr int kFarewellMs = 150;         // until a request that is given up says what became of it
constexpr double kReconnectWithinS = 5;  // to see what became of the requests of a lost link
constexpr int kLooksToSettle = 3;        // a submission that was overtaken begins again by itself, later

bool isOfTheLink(const map::Failure& failure) {
  switch (failure.kind) {
    case map::FailureKind::Unreachable:
    case map::FailureKind::TimedOut:
    case map::FailureKind::Refused:
    case map::FailureKind::NotARobot:
    case map::FailureKind::Certificate:
    case map::FailureKind::Cancelled:
      return true;
    default:
      return false;
  }
}

class Sending {
 public:
  Sending(const ListedWaypoints& list, AtFailure at_failure)
      : robot_(*list.robot),
        list_(list),
        at_failure_(at_failure),
        open_(*list.store, list.map, list.robot->session().robot().address(), {}) {}

  CommandResult<SentWaypoints> run(const std::vector<WaypointEdit>& edits) {
    robot_.waitUntil([&] { return open_.phase() != edit::OpenWaypoints::Phase::Reading; });
    if (open_.phase() != edit::OpenWaypoints::Phase::Ready) {
      return tl::make_unexpected(list_.failure(open_.failure() ? *open_.failure() : robot_.tooLate({})));
    }
    open_.document().rebase(edits, {});
    for (WaypointStep& step : stepsOf(open_.document().allChanges()))
      sent_.steps.push_back({std::move(step)});
    takeConflicts();
    bool looked = true;  // nothing has been sent since
    if (sent_.conflicts.empty() && !sent_.steps.empty()) looked = send() || look();
    sent_.kept = open_.document().kept();
    if (looked) judge();
    return std::move(sent_);
  }

 private:
  using Row = edit::WaypointSubmission::Row;

  /// True when what is kept now has been read at the end.
  bool send() {
    for (;;) {
      open_.save();
      const bool in_time = settle();
      if (!in_time) giveUp();
      noteRows(in_time);
      takeConflicts();
      const auto& submission = open_.submission();
      if (submission.phase() != edit::SubmissionPhase::Stopped)
        return submission.phase() == edit::SubmissionPhase::Done;
      sent_.failure = submission.failure();
      const bool one_of_them = std::any_of(submission.rows().begin(), submission.rows().end(),
                                           [](const Row& row) { return row.state == Row::State::Failed; });
      if (at_failure_ == AtFailure::Stop || !in_time || !one_of_them || isOfTheLink(*sent_.failure))
        return false;
      leaveOutFailed();
    }
  }

  bool settle() {
    int still = 0;
    return robot_.waitUntil([&] {
      still = open_.saving() ? 0 : still + 1;
      return still >= kLooksToSettle;
    });
  }

  void giveUp() {
    open_.cancelSaving();
    QEventLoop loop;
    const QDeadlineTimer patience(kFarewellMs);
    while (open_.saving() && !patience.hasExpired()) loop.processEvents(QEventLoop::AllEvents, 10);
    sent_.failure = robot_.tooLate({});
  }

  void takeConflicts() {
    for (const auto& [key, conflict] : open_.document().conflicts())
      sent_.conflicts.insert_or_assign(key, conflict);
  }

  struct Told {
    StepState state;
    std::optional<map::Failure> failure;
  };
  Told toldBy(const Row& row, bool in_time) const {
    switch (row.state) {
      case Row::State::Done:
        return {StepState::Applied, std::nullopt};
      case Row::State::Failed: {
        map::Failure failure = *row.failure;
        if (!in_time) failure = robot_.tooLate(std::move(failure));
        if (failure.applied == map::Applied::Yes) return {StepState::Applied, std::nullopt};
        const bool maybe = failure.applied == map::Applied::Maybe;
        return {maybe ? StepState::Unknown : StepState::Failed, std::move(failure)};
      }
      case Row::State::UnderWay: {
        map::Failure failure;
        failure.applied = map::Applied::Maybe;
        return {StepState::Unknown, robot_.tooLate(std::move(failure))};
      }
      case Row::State::Waiting:
      case Row::State::NotSent:
        break;
    }
    return {StepState::NotSent, std::nullopt};
  }
  /// A step of several requests is applied when all of them are.
  void noteRows(bool in_time) {
    std::map<SentStep*, Told> told;
    for (const Row& row : open_.submission().rows()) {
      const Told now = toldBy(row, in_time);
      for (const robot::WaypointChange& change : row.request.changes) {
        const edit::Key key = open_.document().ourName(change.id);
        for (const WaypointStep& step : stepsOf({{key, change.before, change.after}})) {
          SentStep* const sent = find(key, step.kind);
          if (!sent) continue;
          const auto [known, is_new] = told.try_emplace(sent, now);
          if (!is_new && known->second.state == StepState::Applied) known->second = now;
        }
      }
    }
    for (auto& [sent, now] : told) {
      // What failed is not asked for again.
      if (sent->state == StepState::Failed || sent->state == StepState::Unknown) continue;
      sent->state = now.state;
      sent->failure = std::move(now.failure);
      if (sent->failure) sent->failure->asked_for = map::AskedFor::Change;
    }
  }
  SentStep* find(const edit::Key& key, StepKind kind) {
    SentStep* created = nullptr;
    for (SentStep& sent : sent_.steps) {
      if (sent.step.key != key) continue;
      if (sent.step.kind == kind) return &sent;
      if (sent.step.kind == StepKind::Create) created = &sent;  // its other requests are part of it
    }
    return created;
  }

  /// What failed is as it is kept, so that it is not asked for again.
  void leaveOutFailed() {
    edit::WaypointDocument& document = open_.document();
    const WaypointItems kept = document.kept();
    for (const Row& row : open_.submission().rows()) {
      if (row.state != Row::State::Failed) continue;
      for (const robot::WaypointChange& change : row.request.changes) {
        const edit::Key key = document.ourName(change.id);
        const map::Waypoint* const mine = document.find(key);
        const auto base = kept.find(key);
        std::optional<map::Waypoint> back = base == kept.end() ? std::nullopt : std::optional(base->second);
        if (back && mine && change.before && change.after) {
          back = *mine;
          edit::assign(*back, base->second, edit::difference(*change.before, *change.after));
        }
        document.change({document.to(key, std::move(back))}, {});
      }
    }
  }

  /// How they are kept now; after a lost link it may take a moment until they can be read again.
  bool look() {
    for (int attempt = 0; attempt < 2 && !robot_.time().over(); ++attempt) {
      auto stored = robot_.ask<robot::StoredWaypoints>([&](robot::OutcomeTo<robot::StoredWaypoints> reply) {
        return list_.store->read(list_.map, std::move(reply));
      });
      if (stored) {
        open_.document().take(itemsOf(stored->points));
        takeConflicts();
        return true;
      }
      const auto online = [&] {
        return robot_.session().connection().phase == robot::ConnectionPhase::Online;
      };
      if (!isOfTheLink(stored.error()) || !robot_.waitUntil(online, kReconnectWithinS)) return false;
    }
    return false;
  }

  /// What is kept now tells of every step whether it has been made.
  void judge() {
    for (SentStep& sent : sent_.steps) {
      const auto kept = sent_.kept.find(sent.step.key);
      if (isDone(sent.step, kept == sent_.kept.end() ? nullptr : &kept->second)) {
        sent.state = StepState::Applied;
        sent.failure.reset();
      } else if (sent.state == StepState::Applied) {
        sent.state = StepState::Failed;  // see SentStep::sentence()
        sent.failure.reset();
      } else if (sent.state == StepState::Unknown) {
        sent.state = StepState::Failed;
        sent.failure->applied = map::Applied::No;
      }
    }
  }

  MapReading& robot_;
  const ListedWaypoints& list_;
  AtFailure at_failure_;
  edit::OpenWaypoints open_;
  SentWaypoints sent_;
};

QString wordOf(StepState state) {
  switch (state) {
    case StepState::Applied:
      return Words::tr("applied");
    case StepState::Failed:
      return Words::tr("failed");
    case StepState::Unknown:
      return Words::tr("not known");
    case StepState::NotSent:
      break;
  }
  return Words::tr("not sent");
}

QString shownName(const WaypointStep& step) { return words::plainName(step.name()); }

}  // namespace

QString SentStep::sentence() const {
  if (failure) return QString::fromStdString(sentences::sentenceOf(*failure));
  return state == StepState::Failed ? Words::tr("It was taken, but afterwards it is not so.") : QString();
}

std::size_t SentWaypoints::count(StepState state) const {
  return std::size_t(
      std::count_if(steps.begin(), steps.end(), [&](const SentStep& sent) { return sent.state == state; }));
}

int SentWaypoints::exitCode() const {
  if (complete()) return kDone;
  return count(StepState::Applied) + count(StepState::Unknown) == 0 ? kRobotError : kIncomplete;
}

QString SentWaypoints::sentence() const {
  if (!conflicts.empty()) {
    const QStringList lines = conflictLines(conflicts);
    const QString first =
        lines.size() > 1 ? Words::tr("%1 (and %2 more)").arg(lines.first(), QString::number(lines.size() - 1))
                         : lines.first();
    return Words::tr("Others have changed the waypoints meanwhile, and that does not go together: %1. %2")
        .arg(first, count(StepState::Applied) + count(StepState::Unknown) == 0
                        ? Words::tr("Nothing has been sent.")
                        : Words::tr("The rest has not been sent."));
  }
  QStringList lines;
  for (const StepState state : {StepState::Unknown, StepState::Failed}) {
    for (const SentStep& sent : steps) {
      if (sent.state == state) lines << QStringLiteral("%1: %2").arg(shownName(sent.step), sent.sentence());
    }
  }
  if (lines.isEmpty() && failure) lines << QString::fromStdString(sentences::sentenceOf(*failure));
  const QString first = lines.isEmpty() ? QString() : lines.first();
  if (steps.size() == 1) return first;
  return Words::tr("Of %1 changes %2 are applied, %3 failed, %4 are not known and %5 not sent. %6")
      .arg(QString::number(steps.size()), QString::number(count(StepState::Applied)),
           QString::number(count(StepState::Failed)), QString::number(count(StepState::Unknown)),
           QString::number(count(StepState::NotSent)), first);
}

CommandResult<SentWaypoints> sendWaypoints(const ListedWaypoints& list, std::vector<WaypointEdit> edits,
                                           AtFailure at_failure) {
  for (WaypointEdit& edit : edits) {
    if (edit.after && edit.after->id.empty()) edit.after->id = edit.key;
  }
  return Sending(list, at_failure).run(edits);
}

QJsonObject sentJson(const SentWaypoints& sent, const std::string& map) {
  const auto rowsOf = [&](StepState state) {
    QJsonArray rows;
    for (const SentStep& one : sent.steps) {
      if (one.state != state) continue;
      QJsonObject row = stepJson(one.step, map);
      row[QStringLiteral("sentence")] = one.sentence();
      rows << row;
    }
    return rows;
  };
  return {{QStringLiteral("applied"), int(sent.count(StepState::Applied))},
          {QStringLiteral("failed"), rowsOf(StepState::Failed)},
          {QStringLiteral("unknown"), rowsOf(StepState::Unknown)},
          {QStringLiteral("remaining"), int(sent.count(StepState::NotSent))},
          {QStringLiteral("complete"), sent.complete()},
          {QStringLiteral("conflicts"), conflictsJson(sent.conflicts, map)}};
}

void printSent(const SentWaypoints& sent) {
  std::vector<QStringList> table{
      {Words::tr("STATE"), Words::tr("CHANGE"), Words::tr("ID"), Words::tr("NAME")}};
  for (const SentStep& one : sent.steps) {
    const auto kept = sent.kept.find(one.step.key);
    const std::string id = kept != sent.kept.end() ? kept->second.id : one.step.id();
    const QString why = one.sentence();
    table.push_back({wordOf(one.state), wordOf(one.step.kind), words::plainName(id),
                     why.isEmpty() ? shownName(one.step)
                                   : QStringLiteral("%1: %2").arg(shownName(one.step), oneLine(why))});
  }
  for (const QString& line : conflictLines(sent.conflicts))
    table.push_back({Words::tr("conflict"), QString(), QString(), line});
  if (table.size() > 1) printTable(table);
}

}  // namespace mapwright::app
