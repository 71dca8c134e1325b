// Changes waypoints from files: import, plan, apply.
#include <cstdio>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/waypoint_file.h"
#include "app/waypoint_list.h"
#include "app/waypoint_preview.h"
#include "app/waypoint_sending.h"
#include "app/waypoint_warnings.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "exchange/waypoint_plan.h"
#include "sentences/fault_sentence.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class WaypointsTransferText {
  Q_DECLARE_TR_FUNCTIONS(WaypointsTransfer)
};

using words::text;

CommandResult<int> notAll(const ListedWaypoints& list, const SentWaypoints& sent) {
  return tl::make_unexpected(list.robot->failure(sent.exitCode(), sent.sentence()));
}

/// Sends the changes, or only shows them, and reports the result.
CommandResult<int> carryOut(MapsCommand& command, const ListedWaypoints& list,
                            const std::vector<exchange::WaypointEdit>& edits, const WaypointsWords& words) {
  const bool taken = isStandardOutput(text(words.report));  // nothing else is printed there
  if (words.dry_run) {
    const exchange::MergedEdits together = exchange::merged(edits, exchange::itemsOf(list.stored.points));
    command.report(QStringLiteral("waypoints"), previewReport(list, together));
    if (!taken) printPreview(list, together, words.json);
    if (together.conflicts.empty()) return kDone;
    return notAll(list, SentWaypoints{{}, together.conflicts, {}, {}});
  }
  const auto sent = sendWaypoints(list, edits, words.go_on ? AtFailure::GoOn : AtFailure::Stop);
  if (!sent) return tl::make_unexpected(sent.error());
  command.report(QStringLiteral("waypoints"), sentReport(*sent, list.mapId()));
  if (!taken) words.json ? printJson(sentJson(*sent, list.mapId())) : printSent(*sent);
  if (!taken && !words.json && sent->steps.empty() && sent->conflicts.empty())
    std::printf("%s\n", qUtf8Printable(WaypointsTransferText::tr("There is nothing to change.")));
  if (sent->complete()) return kDone;
  return notAll(list, *sent);
}

/// The changes that the file requires to the present waypoints.
CommandResult<std::vector<exchange::WaypointEdit>> wantedEdits(const ListedWaypoints& list,
                                                               const exchange::WantedList& wanted,
                                                               const WaypointsWords& words,
                                                               exchange::Others others) {
  for (const QString& note : wanted.notes)
    list.robot->note(QStringLiteral("%1: %2").arg(oneLine(inputCalled(words.file), 200), note));
  auto edits = exchange::editsFor(exchange::itemsOf(list.stored.points), wanted.points, others);
  if (!edits) return wrong(QStringLiteral("%1: %2").arg(inputCalled(words.file), edits.error()));
  return fitted(list, std::move(*edits));
}

/// Warnings about the list as the plan makes it; says what cannot be checked.
DoubtsAhead doubtsAhead(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits,
                        std::optional<double> radius_m) {
  exchange::WaypointItems items = exchange::itemsOf(list.stored.points);
  for (const exchange::WaypointEdit& edit : edits) {
    edit.after ? void(items.insert_or_assign(edit.key, *edit.after)) : void(items.erase(edit.key));
  }
  std::vector<map::Waypoint> points;
  for (auto& [key, point] : items) points.push_back(std::move(point));
  const DoubtfulWaypoints doubtful = doubtsOf(list, points, radius_m);
  if (!doubtful.untold.isEmpty()) list.robot->note(doubtful.untold);
  DoubtsAhead ahead;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!doubtful.of[i].empty()) ahead.push_back({points[i].id, points[i].name, doubtful.of[i]});
  }
  return ahead;
}

}  // namespace

int waypointsImport(const WaypointsWords& words, int& argc, char** argv) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const exchange::WantedFile wanted = readWantedFile(words.file, words.format);
    if (!wanted) return wrong(wanted.error());
    const auto list = listWaypoints(command, words, words.map, Use::Changing);
    if (!list) return tl::make_unexpected(list.error());
    const auto edits = wantedEdits(*list, *wanted, words, exchange::Others::Stay);
    if (!edits) return tl::make_unexpected(edits.error());
    return carryOut(command, *list, *edits, words);
  });
}

int waypointsPlan(const WaypointsWords& words, int& argc, char** argv) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const QString output = text(words.output);
    if (!output.isEmpty()) {
      if (const auto why = whyNotWritable(output)) return wrong(*why);
    }
    const auto radius_m = radiusFrom(words.radius);
    if (!radius_m) return wrong(radius_m.error());
    const QString printed = words.json ? QStringLiteral("-") : QString();
    if (const auto why = whyNotTogether({output, text(words.report), printed})) return wrong(*why);
    const exchange::WantedFile wanted = readWantedFile(words.file, words.format);
    if (!wanted) return wrong(wanted.error());
    const auto list = listWaypoints(command, words, words.map, Use::Changing);
    if (!list) return tl::make_unexpected(list.error());
    const auto edits = wantedEdits(*list, *wanted, words, exchange::Others::Go);
    if (!edits) return tl::make_unexpected(edits.error());
    if (!output.isEmpty()) {
      std::vector<std::string> sources = waypointSources(words.robot, list->map);
      if (words.file != "-") sources.push_back(words.file);
      if (const auto why = overOwnSource({output}, sources); why && !words.force) return wrong(*why);
      const exchange::WaypointPlan plan{list->robot->session().robot().address(), list->mapId(),
                                        exchange::itemsOf(list->stored.points), *edits};
      const QByteArray bytes = exchange::planBytes(plan, callsOf(*list, *edits));
      if (const auto trouble = disk::writeFile(words.output, bytes.toStdString()))
        return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
    }
    const bool taken = isStandardOutput(output) || isStandardOutput(text(words.report));
    const DoubtsAhead doubts = doubtsAhead(*list, *edits, *radius_m);
    command.report(QStringLiteral("waypoints"), previewReport(*list, {*edits, {}}, doubts));
    if (!taken) printPreview(*list, {*edits, {}}, words.json, doubts);
    return kDone;
  });
}

int waypointsApply(const WaypointsWords& words, int& argc, char** argv) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const QString file = inputCalled(words.file);
    // A plan contains its base and the changes.
    constexpr std::size_t kMost = 4 * exchange::kMaxWantedBytes;
    const auto bytes = bytesOf(words.file, kMost);
    if (!bytes)
      return wrong(WaypointsTransferText::tr("%1 cannot be read: %2.")
                       .arg(file, sentences::wordsOf(bytes.error().cause)));
    if (bytes->size() > kMost)
      return wrong(WaypointsTransferText::tr("%1 is larger than 256 MiB.").arg(file));
    auto plan = exchange::planFromBytes(*bytes);
    if (!plan) return wrong(QStringLiteral("%1: %2").arg(file, plan.error()));
    const auto list = listWaypoints(command, words, words.map.empty() ? plan->map : words.map, Use::Changing);
    if (!list) return tl::make_unexpected(list.error());
    const QString address = list->robot->session().robot().address();
    if (!words.force && (address != plan->robot || list->mapId() != plan->map))
      return wrong(WaypointsTransferText::tr(
                       "%1 was made for the map %2 of %3. Pass --force to apply it to the map %4 of %5.")
                       .arg(file, text(plan->map), plan->robot, text(list->mapId()), address));
    plan->edits = fitted(*list, std::move(plan->edits));
    return carryOut(command, *list, exchange::withoutCreated(*plan, exchange::itemsOf(list->stored.points)),
                    words);
  });
}

}  // namespace mapwright::app
