// Changes one waypoint, or deletes some.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/option_words.h"
#include "app/output_paths.h"
#include "app/waypoint_list.h"
#include "app/waypoint_preview.h"
#include "app/waypoint_sending.h"
#include "exchange/waypoint_json.h"
#include "exchange/waypoint_plan.h"
#include "exchange/waypoint_table.h"
#include "geometry/pose.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class WaypointsChangeText {
  Q_DECLARE_TR_FUNCTIONS(WaypointsChange)
};

using words::text;

struct PlaceAt {
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad;
};

CommandResult<PlaceAt> placeAt(const std::string& words) {
  const auto numbers = numbersFrom(words);
  if (!numbers || (numbers->size() != 2 && numbers->size() != 3))
    return wrong(
        WaypointsChangeText::tr(
            "--at %1: give X,Y in metres, or X,Y,YAW with the yaw in degrees, for example 1.5,-2,90.")
            .arg(text(words)));
  PlaceAt place{{(*numbers)[0], (*numbers)[1]}, {}};
  if (numbers->size() == 3)
    place.yaw_rad = geometry::normalizeAngle(geometry::radiansFromDegrees((*numbers)[2]));
  return place;
}

CommandResult<std::vector<std::string>> tagsIn(const char* option, const std::string& words) {
  auto tags = exchange::tagsOf(words);
  if (tags) return std::move(*tags);
  return wrong(WaypointsChangeText::tr("%1 %2: give tags as a,b (%3)")
                   .arg(QLatin1String(option), text(words), tags.error()));
}

using Edits = CommandResult<std::vector<exchange::WaypointEdit>>;

/// The change of the selected waypoint.
Edits editOf(const ListedWaypoints& list, const WaypointsWords& words,
             const std::function<void(map::Waypoint&)>& change) {
  const auto point = chosen(list, words.which.front());
  if (!point) return tl::make_unexpected(point.error());
  map::Waypoint after = **point;
  change(after);
  return std::vector<exchange::WaypointEdit>{{after.id, **point, after}};
}

void printChanged(const SentWaypoints& sent, const std::vector<exchange::WaypointEdit>& edits,
                  const ListedWaypoints& list, const WaypointsWords& words) {
  QJsonArray rows;
  for (const exchange::WaypointEdit& edit : edits) {
    const auto kept = sent.kept.find(edit.key);
    const map::Waypoint& point = kept != sent.kept.end() ? kept->second
                                 : edit.after            ? *edit.after
                                                         : *edit.before;
    rows << exchange::waypointJson(point, list.mapId());
    if (!words.json)
      std::printf("%s  %s\n", qUtf8Printable(words::plainName(point.id)),
                  qUtf8Printable(words::plainName(point.name)));
  }
  if (!words.json) return;
  const bool one = rows.size() == 1 && edits.front().after;
  one ? printJson(rows.first().toObject()) : printJson(rows);
}

/// The common part of these commands, given the change.
int change(const WaypointsWords& words, int& argc, char** argv,
           const std::function<std::optional<CommandFailure>()>& check,
           const std::function<Edits(const ListedWaypoints&)>& editsOf) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    if (const auto failure = check()) return tl::make_unexpected(*failure);
    const auto list = listWaypoints(command, words, words.map, Use::Changing);
    if (!list) return tl::make_unexpected(list.error());
    Edits edits = editsOf(*list);
    if (!edits) return tl::make_unexpected(edits.error());
    edits = fitted(*list, std::move(*edits));
    for (const exchange::WaypointEdit& edit : *edits) {
      const QString why = edit.after ? exchange::whyNotKept(edit.before, *edit.after) : QString();
      if (!why.isEmpty()) return wrong(why);
    }
    if (words.dry_run) {
      const exchange::MergedEdits together = exchange::merged(*edits, exchange::itemsOf(list->stored.points));
      command.report(QStringLiteral("waypoints"), previewReport(*list, together));
      if (!isStandardOutput(text(words.report))) printPreview(*list, together, words.json);
      return kDone;
    }
    const auto sent = sendWaypoints(*list, *edits, words.go_on ? AtFailure::GoOn : AtFailure::Stop);
    if (!sent) return tl::make_unexpected(sent.error());
    command.report(QStringLiteral("waypoints"), sentReport(*sent, list->mapId()));
    const bool taken = isStandardOutput(text(words.report));  // nothing else is printed there
    if (sent->complete()) {
      if (!taken) printChanged(*sent, *edits, *list, words);
      return kDone;
    }
    if (edits->size() > 1 && !taken)
      words.json ? printJson(sentJson(*sent, list->mapId())) : printSent(*sent);
    const bool of_the_request =
        edits->size() == 1 && sent->conflicts.empty() && sent->steps.front().outcome.failure;
    return tl::make_unexpected(list->robot->failure(
        of_the_request ? list->failure(*sent->steps.front().outcome.failure).exit_code : sent->exitCode(),
        sent->sentence()));
  });
}

std::optional<CommandFailure> nothingWrong() { return std::nullopt; }

template <typename Result>
std::optional<CommandFailure> failureOf(const Result& result) {
  return result ? std::nullopt : std::optional(result.error());
}

}  // namespace

int waypointsCreate(const WaypointsWords& words, int& argc, char** argv) {
  const auto place = placeAt(words.at);
  const auto tags = tagsIn("--tags", words.tags);
  return change(
      words, argc, argv, [&] { return place ? failureOf(tags) : failureOf(place); },
      [&](const ListedWaypoints&) -> Edits {
        map::Waypoint point;
        point.name = words.name;
        point.position_m = place->position_m;
        point.yaw_rad = place->yaw_rad;
        point.tags = *tags;
        return std::vector<exchange::WaypointEdit>{{exchange::freshKey(), std::nullopt, point}};
      });
}

int waypointsRename(const WaypointsWords& words, int& argc, char** argv) {
  return change(words, argc, argv, nothingWrong, [&](const ListedWaypoints& list) {
    return editOf(list, words, [&](map::Waypoint& point) { point.name = words.name; });
  });
}

int waypointsMove(const WaypointsWords& words, int& argc, char** argv) {
  const auto place = placeAt(words.at);
  return change(
      words, argc, argv, [&] { return failureOf(place); },
      [&](const ListedWaypoints& list) {
        return editOf(list, words, [&](map::Waypoint& point) {
          point.position_m = place->position_m;
          if (place->yaw_rad) point.yaw_rad = place->yaw_rad;
        });
      });
}

int waypointsTag(const WaypointsWords& words, int& argc, char** argv) {
  const auto tags = tagsIn("--set", words.tags), added = tagsIn("--add", words.added_tags),
             removed = tagsIn("--remove", words.removed_tags);
  const auto check = [&]() -> std::optional<CommandFailure> {
    for (const auto* read : {&tags, &added, &removed}) {
      if (!*read) return read->error();
    }
    const bool partly = !added->empty() || !removed->empty();
    if (int(!tags->empty()) + int(words.no_tags) + int(partly) != 1)
      return CommandFailure{
          kUsage, WaypointsChangeText::tr("Which tags? Pass --set a,b, or --clear, or --add and --remove.")};
    for (const std::string& tag : *added) {
      if (std::find(removed->begin(), removed->end(), tag) != removed->end())
        return CommandFailure{
            kUsage, WaypointsChangeText::tr("The tag %1 cannot be both added and removed.").arg(text(tag))};
    }
    return std::nullopt;
  };
  return change(words, argc, argv, check, [&](const ListedWaypoints& list) {
    return editOf(list, words, [&](map::Waypoint& point) {
      if (!tags->empty() || words.no_tags) point.tags = *tags;
      for (const std::string& tag : *removed) std::erase(point.tags, tag);
      for (const std::string& tag : *added) {
        if (std::find(point.tags.begin(), point.tags.end(), tag) == point.tags.end())
          point.tags.push_back(tag);
      }
    });
  });
}

int waypointsDelete(const WaypointsWords& words, int& argc, char** argv) {
  const auto check = [&]() -> std::optional<CommandFailure> {
    if (words.yes || words.dry_run) return std::nullopt;
    return CommandFailure{
        kUsage, WaypointsChangeText::tr("Deleting waypoints cannot be undone. Pass --yes to delete them.")};
  };
  return change(words, argc, argv, check, [&](const ListedWaypoints& list) -> Edits {
    std::vector<exchange::WaypointEdit> edits;
    for (const std::string& word : words.which) {
      const auto point = chosen(list, word);
      if (!point) return tl::make_unexpected(point.error());
      const bool is_new = std::none_of(edits.begin(), edits.end(), [&](const exchange::WaypointEdit& edit) {
        return edit.key == (*point)->id;
      });
      if (is_new) edits.push_back({(*point)->id, **point, std::nullopt});
    }
    return edits;
  });
}

}  // namespace mapwright::app
