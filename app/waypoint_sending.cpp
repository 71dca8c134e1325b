#include "app/waypoint_sending.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QDeadlineTimer>
#include <QEventLoop>

#include "app/command_text.h"
#include "app/output.h"
#include "map/waypoint.h"
#include "robot/faults.h"
#include "sentences/failure_sentence.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

constexpr int kFarewellMs = 150;         // how long to wait for the result of a request that was given up
constexpr double kReconnectWithinS = 5;  // to find out the results after a lost connection
constexpr int kLooksToSettle = 3;        // a submission that was overtaken restarts by itself, later

class Sending {
 public:
  Sending(const ListedWaypoints& list, AtFailure at_failure)
      : robot_(*list.robot),
        list_(list),
        at_failure_(at_failure),
        open_(*list.store, list.map, list.robot->session().robot().address(), {}) {}

  CommandResult<SentWaypoints> run(const std::vector<exchange::WaypointEdit>& edits) {
    robot_.waitUntil([&] { return open_.phase() != edit::OpenWaypoints::Phase::Reading; });
    if (open_.phase() != edit::OpenWaypoints::Phase::Ready) {
      return robot_.failure(open_.failure() ? *open_.failure() : robot_.tooLate({}));
    }
    open_.document().rebase(edits, {});
    for (exchange::WaypointStep& step : exchange::stepsOf(open_.document().allChanges()))
      sent_.steps.push_back({std::move(step)});
    reportConflicts();
    bool looked = true;  // nothing has been sent since
    const bool any_refused = reportRefused();
    if (sent_.conflicts.empty() && !sent_.steps.empty() && (!any_refused || at_failure_ == AtFailure::GoOn))
      looked = send() || look();
    sent_.kept = open_.document().kept();
    if (looked) judge();
    warnOfLeftNames(looked);
    return std::move(sent_);
  }

 private:
  using Row = edit::SubmittedRequest;

  /// True if the stored state was read at the end.
  bool send() {
    open_.save(at_failure_);
    const bool in_time = settle();
    if (!in_time) giveUp();
    reportRows(in_time);
    reportConflicts();
    const auto& submission = open_.submission();
    if (submission.phase() != edit::SubmissionPhase::Stopped)
      return submission.phase() == edit::SubmissionPhase::Done;
    sent_.failure = submission.failure();
    // It was cancelled here, not by the caller.
    if (!in_time && sent_.failure) sent_.failure = robot_.tooLate(*sent_.failure);
    return false;
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
    const QDeadlineTimer farewell(kFarewellMs);
    while (open_.saving() && !farewell.hasExpired()) loop.processEvents(QEventLoop::AllEvents, 10);
    sent_.failure = robot_.tooLate({});
  }

  /// Does not send what would certainly be refused; if the first failure stops everything, sends nothing.
  bool reportRefused() {
    const std::set<edit::Key> refused = open_.refused();
    for (SentStep& sent : sent_.steps) {
      if (!refused.contains(sent.step.key)) continue;
      map::Failure failure{.kind = map::FailureKind::RejectedByRobot, .asked_for = map::AskedFor::Change};
      failure.cause = {robot::fault::WaypointNameTaken, {sent.step.after->name}};
      sent.outcome = {StepState::Failed, failure};
      sent_.failure = std::move(failure);
    }
    return !refused.empty();
  }

  void reportConflicts() {
    for (const auto& [key, conflict] : open_.document().conflicts())
      sent_.conflicts.insert_or_assign(key, conflict);
  }

  exchange::SentOutcome toldBy(const Row& row, bool in_time) const {
    exchange::SentOutcome told = exchange::answered(row);
    if (row.state == Row::State::InProgress) {
      told.failure = robot_.tooLate({.applied = map::Applied::Maybe, .asked_for = map::AskedFor::Change});
    } else if (told.failure && !in_time) {
      told.failure = robot_.tooLate(std::move(*told.failure));
    }
    return told;
  }
  /// A step with several requests is applied if all of them are.
  void reportRows(bool in_time) {
    std::map<SentStep*, exchange::SentOutcome> told;
    for (const Row& row : open_.submission().rows()) {
      const exchange::SentOutcome now = toldBy(row, in_time);
      for (const robot::WaypointChange& change : row.request.changes) {
        const edit::Key key = open_.document().ourName(change.id);
        for (const exchange::WaypointStep& step : exchange::stepsOf({{key, change.before, change.after}})) {
          SentStep* const sent = find(key, step.kind);
          if (!sent) continue;
          // A temporary name is not the intended result.
          const bool aside = step.kind == exchange::StepKind::Rename && sent->step.after &&
                             step.after->name != sent->step.after->name;
          if (aside && now.state == StepState::Applied) continue;
          const auto [known, is_new] = told.try_emplace(sent, now);
          if (!is_new && known->second.state == StepState::Applied) known->second = now;
        }
      }
    }
    for (auto& [sent, now] : told) {
      // Failed requests are not repeated.
      const StepState before = sent->outcome.state;
      if (before != StepState::Failed && before != StepState::Unknown) sent->outcome = std::move(now);
    }
  }
  SentStep* find(const edit::Key& key, exchange::StepKind kind) {
    SentStep* created = nullptr;
    for (SentStep& sent : sent_.steps) {
      if (sent.step.key != key) continue;
      if (sent.step.kind == kind) return &sent;
      if (sent.step.kind == exchange::StepKind::Create) created = &sent;  // its other requests are part of it
    }
    return created;
  }

  /// Reads the stored state; after a lost connection that may take a moment.
  bool look() {
    for (int attempt = 0; attempt < 2 && !robot_.time().over(); ++attempt) {
      auto stored = robot_.ask<robot::StoredWaypoints>([&](robot::OutcomeTo<robot::StoredWaypoints> reply) {
        return list_.store->read(list_.map, std::move(reply));
      });
      if (stored) {
        open_.document().mergeStored(exchange::itemsOf(stored->points));
        reportConflicts();
        return true;
      }
      const auto online = [&] {
        return robot_.session().connection().phase == robot::ConnectionPhase::Online;
      };
      if (!edit::isOfTheLink(stored.error()) || !robot_.waitUntil(online, kReconnectWithinS)) return false;
    }
    return false;
  }

  /// The stored state tells for every step whether it was made.
  void judge() {
    for (SentStep& sent : sent_.steps) {
      const auto kept = sent_.kept.find(sent.step.key);
      const bool is_so = exchange::isDone(sent.step, kept == sent_.kept.end() ? nullptr : &kept->second,
                                          list_.store->keeps().pixel_m);
      sent.outcome = exchange::judged(std::move(sent.outcome), is_so);
    }
  }

  void warnOfLeftNames(bool looked) {
    for (const SentStep& sent : sent_.steps) {
      if (sent.step.kind != exchange::StepKind::Rename) continue;
      const map::Waypoint &before = *sent.step.before, &after = *sent.step.after;
      const auto kept = sent_.kept.find(sent.step.key);
      if (kept == sent_.kept.end() || kept->second.name == after.name) continue;
      LeftName left{kept->second.id, before.name, kept->second.name, after.name, looked};
      const bool has_it = map::isTemporaryFor(left.name, before.name);
      const std::string had(left.name == before.name ? map::permanentName(before.name) : "");
      // It was requested, and may still be carried out.
      if (!has_it && sent.outcome.state == StepState::Unknown) {
        left.certain = false;
        left.name = askedAside(sent.step.key, before.name).value_or(left.name);
      }
      if (!had.empty()) left.before = had;
      if (has_it || !had.empty() || left.name != kept->second.name)
        sent_.left_names.push_back(std::move(left));
    }
  }
  /// The temporary name that it should have got.
  std::optional<std::string> askedAside(const edit::Key& key, const std::string& name) const {
    for (const Row& row : open_.submission().rows()) {
      for (const robot::WaypointChange& change : row.request.changes) {
        if (open_.document().ourName(change.id) == key && change.after &&
            map::isTemporaryFor(change.after->name, name))
          return change.after->name;
      }
    }
    return std::nullopt;
  }

  RobotReading& robot_;
  const ListedWaypoints& list_;
  AtFailure at_failure_;
  edit::OpenWaypoints open_;
  SentWaypoints sent_;
};

QString wordOf(StepState state) {
  return state == StepState::Applied   ? Text::tr("applied")
         : state == StepState::Failed  ? Text::tr("failed")
         : state == StepState::Unknown ? Text::tr("unknown")
                                       : Text::tr("not sent");
}

/// For scripts, never changes (docs/json.md).
const char* stableWordOf(StepState state) {
  return state == StepState::Applied   ? "applied"
         : state == StepState::Failed  ? "failed"
         : state == StepState::Unknown ? "unknown"
                                       : "not_sent";
}

QString shownName(const exchange::WaypointStep& step) { return words::plainName(step.name()); }

QString sentenceOf(const LeftName& left) {
  const QString sentence =
      left.certain ? Text::tr("\"%1\" is temporarily called \"%2\", until the name \"%3\" is free.")
                   : Text::tr("\"%1\" may temporarily be called \"%2\", until the name \"%3\" is free.");
  return sentence.arg(words::plainName(left.before), words::plainName(left.name),
                      words::plainName(left.wanted));
}

QString sentenceOf(const std::vector<LeftName>& left) {
  if (left.empty()) return {};
  QStringList lines;
  for (const LeftName& one : left) lines << sentenceOf(one);
  lines << Text::tr("Run the command again to finish it.");
  return words::paragraph(lines);
}

}  // namespace

std::size_t SentWaypoints::count(StepState state) const {
  return std::size_t(std::count_if(steps.begin(), steps.end(),
                                   [&](const SentStep& sent) { return sent.outcome.state == state; }));
}

int SentWaypoints::exitCode() const {
  if (complete()) return kDone;
  if (count(StepState::Applied) + count(StepState::Unknown) > 0) return kIncomplete;
  return failure ? exitCodeOf(failure->kind) : kRobotError;
}

QString SentWaypoints::sentence() const { return words::paragraph({whatBecame(), sentenceOf(left_names)}); }

QString SentWaypoints::whatBecame() const {
  if (!conflicts.empty()) {
    const QStringList lines = exchange::conflictLines(conflicts);
    const QString first =
        lines.size() > 1 ? Text::tr("%1 (and %2 more)").arg(lines.first(), QString::number(lines.size() - 1))
                         : lines.first();
    return Text::tr(
               "The waypoints have been changed by someone else in the meantime, in a way that conflicts "
               "with this: %1. %2")
        .arg(first, count(StepState::Applied) + count(StepState::Unknown) == 0
                        ? Text::tr("Nothing was sent.")
                        : Text::tr("The rest was not sent."));
  }
  QStringList lines;
  for (const StepState state : {StepState::Unknown, StepState::Failed, StepState::NotSent}) {
    for (const SentStep& sent : steps) {
      const QString why = exchange::sentenceOf(sent.outcome);
      if (sent.outcome.state == state && !why.isEmpty()) lines << words::about(shownName(sent.step), why);
    }
  }
  if (lines.isEmpty() && failure) lines << QString::fromStdString(sentences::sentenceOf(*failure));
  const QString first = lines.isEmpty() ? QString() : lines.first();
  if (steps.size() == 1) return first;
  return Text::tr("Of %1 changes: %2 applied, %3 failed, %4 with unknown result, %5 not sent. %6")
      .arg(QString::number(steps.size()), QString::number(count(StepState::Applied)),
           QString::number(count(StepState::Failed)), QString::number(count(StepState::Unknown)),
           QString::number(count(StepState::NotSent)), first);
}

CommandResult<SentWaypoints> sendWaypoints(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits, AtFailure at_failure) {
  for (exchange::WaypointEdit& edit : edits) {
    if (edit.after && edit.after->id.empty()) edit.after->id = edit.key;
  }
  return Sending(list, at_failure).run(edits);
}

QJsonObject sentJson(const SentWaypoints& sent, const std::string& map) {
  const auto rowsOf = [&](StepState state) {
    QJsonArray rows;
    for (const SentStep& one : sent.steps) {
      if (one.outcome.state != state) continue;
      QJsonObject row = exchange::stepJson(one.step, map);
      row[QStringLiteral("sentence")] = exchange::sentenceOf(one.outcome);
      rows << row;
    }
    return rows;
  };
  QJsonArray left_names;
  for (const LeftName& left : sent.left_names) {
    left_names << QJsonObject{{QStringLiteral("id"), QString::fromStdString(left.id)},
                              {QStringLiteral("before"), QString::fromStdString(left.before)},
                              {QStringLiteral("name"), QString::fromStdString(left.name)},
                              {QStringLiteral("wanted"), QString::fromStdString(left.wanted)},
                              {QStringLiteral("certain"), left.certain}};
  }
  return {{QStringLiteral("applied"), int(sent.count(StepState::Applied))},
          {QStringLiteral("failed"), rowsOf(StepState::Failed)},
          {QStringLiteral("unknown"), rowsOf(StepState::Unknown)},
          {QStringLiteral("remaining"), int(sent.count(StepState::NotSent))},
          {QStringLiteral("complete"), sent.complete()},
          {QStringLiteral("conflicts"), exchange::conflictsJson(sent.conflicts, map)},
          {QStringLiteral("temporary_names"), left_names}};
}

QJsonObject sentReport(const SentWaypoints& sent, const std::string& map) {
  QJsonArray changes;
  for (const SentStep& one : sent.steps) {
    QJsonObject row = exchange::stepJson(one.step, map);
    // A created one has its id by now.
    if (const auto kept = sent.kept.find(one.step.key);
        kept != sent.kept.end() && one.outcome.state == StepState::Applied)
      row[QStringLiteral("id")] = QString::fromStdString(kept->second.id);
    row[QStringLiteral("state")] = QLatin1String(stableWordOf(one.outcome.state));
    if (const QString why = exchange::sentenceOf(one.outcome); !why.isEmpty())
      row[QStringLiteral("sentence")] = why;
    changes << row;
  }
  QJsonObject report = sentJson(sent, map);
  report[QStringLiteral("map")] = QString::fromStdString(map);
  report[QStringLiteral("changes")] = changes;
  return report;
}

void printSent(const SentWaypoints& sent) {
  std::vector<QStringList> table{{Text::tr("STATE"), Text::tr("CHANGE"), Text::tr("ID"), Text::tr("NAME")}};
  for (const SentStep& one : sent.steps) {
    const auto kept = sent.kept.find(one.step.key);
    const std::string id = kept != sent.kept.end() ? kept->second.id : one.step.id();
    const QString why = exchange::sentenceOf(one.outcome);
    table.push_back({wordOf(one.outcome.state), wordOf(one.step.kind), words::plainName(id),
                     why.isEmpty() ? shownName(one.step) : words::about(shownName(one.step), oneLine(why))});
  }
  for (const QString& line : exchange::conflictLines(sent.conflicts))
    table.push_back({Text::tr("conflict"), QString(), QString(), line});
  for (const LeftName& left : sent.left_names)
    table.push_back(
        {Text::tr("temporary name"), QString(), words::plainName(left.id), oneLine(sentenceOf(left))});
  if (table.size() > 1) printTable(table);
}

}  // namespace mapwright::app
