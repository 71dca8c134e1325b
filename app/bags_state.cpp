// The content of a bag: its messages, its state at a time, its events.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include <QCoreApplication>
#include <QDateTime>
#include <QJsonArray>
#include <QJsonObject>

#include "app/bag_json.h"
#include "app/bag_reading.h"
#include "app/bags.h"
#include "app/exit_code.h"
#include "app/map_wish.h"
#include "app/output_paths.h"
#include "app/table.h"
#include "app/waypoint_list.h"
#include "excerpt/excerpt.h"
#include "robot/sends_map.h"
#include "words/plain.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class BagsStateText {
  Q_DECLARE_TR_FUNCTIONS(Bags)
};

using words::text;

int runBagsCommand(const BagsWords& words, int& argc, char** argv,
                   const std::function<CommandResult<int>(MapsCommand&)>& work) {
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

/// The messages of a range between two times. False: the output accepts no more.
bool printFrames(const replay::Chunk& chunk, const excerpt::TimeSpan& span,
                 const std::vector<std::string>& topics) {
  for (std::size_t place = 0; place < chunk.order.size(); ++place) {
    const robot::BagMessage& message = chunk.at(place);
    if (!span.holds(message.message.received_s)) continue;
    if (!excerpt::isOneOf(topics, message.message.topic)) continue;
    if (!printOut(excerpt::jsonLine(chunk.source->textOf(message)) + "\n")) return false;
  }
  return true;
}

/// What a picture would report: that the file has no map, and which one its messages name.
std::optional<QString> noMapIn(const BagReading& bags, const replay::Moment& moment) {
  robot::Robot& robot = bags.robot().session().robot();
  robot::MapCatalogue* const maps = robot.mapCatalogue();
  if (!robot.isLocal() || robot::sendsItsMap(robot) || !maps) return std::nullopt;
  const auto kept = bags.robot().ask<std::vector<map::CatalogueEntry>>(
      [&](robot::OutcomeTo<std::vector<map::CatalogueEntry>> reply) { return maps->list(std::move(reply)); });
  if (!kept || !kept->empty()) return std::nullopt;
  return noMapSentence(moment.at.world.live.map_info);
}

}  // namespace

int bagsFrames(const BagsWords& words, int& argc, char** argv) {
  return runBagsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto span = timeSpanFrom(words);
    if (!span) return tl::make_unexpected(span.error());
    auto opened = BagReading::open(command, words);
    if (!opened) return tl::make_unexpected(opened.error());
    const auto replayed = opened->readThrough(words.name, BagReading::Texts::Whole);
    if (!replayed) return tl::make_unexpected(replayed.error());
    bool taken = true;
    const auto failed = opened->readRanges(
        span->from_s, span->to_s, [&](const replay::Chunk& chunk) -> std::optional<CommandFailure> {
          taken = printFrames(chunk, *span, words.topics);
          // Stops reading if nobody takes the output; the reason is reported at the end.
          return taken ? std::nullopt : std::optional(CommandFailure{kUsage, {}});
        });
    if (!taken) return kUsage;
    if (failed) return tl::make_unexpected(*failed);
    opened->noteUnknown(words.topics);
    opened->noteUnreadable(HUGE_VAL);
    return kDone;
  });
}

int bagsState(const BagsWords& words, int& argc, char** argv) {
  return runBagsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto at_s = timeFrom(words.at, QStringLiteral("--at"));
    if (!at_s) return tl::make_unexpected(at_s.error());
    std::optional<double> from_s;
    if (!words.from.empty()) {
      const auto time = timeFrom(words.from, QStringLiteral("--from"));
      if (!time) return tl::make_unexpected(time.error());
      from_s = *time;
    }
    auto opened = BagReading::open(command, words);
    if (!opened) return tl::make_unexpected(opened.error());
    const auto replayed = opened->replay(words.name);
    if (!replayed) return tl::make_unexpected(replayed.error());
    // Plays from there: looks at each range on the way.
    while (from_s && *from_s < *at_s) {
      const auto moment = opened->momentAt(*from_s);
      if (!moment) return tl::make_unexpected(moment.error());
      const replay::Cell* cell = (*replayed)->chunks().cellAt(*from_s);
      if (!cell || replay::secondsOf(cell->until) <= *from_s) break;
      from_s = replay::secondsOf(cell->until);
    }
    const auto moment = opened->momentAt(*at_s);
    if (!moment) return tl::make_unexpected(moment.error());
    const robot::BagInfo bag = (*replayed)->info().value_or(robot::BagInfo());
    const std::optional<QString> no_map = noMapIn(*opened, *moment);
    if (words.json) {
      QJsonObject state = stateJson(*at_s, *moment, bag);
      if (no_map) state[QStringLiteral("no_map")] = *no_map;
      printJson(state);
    } else {
      std::vector<QStringList> rows = stateRows(*at_s, *moment, bag);
      if (no_map) rows.insert(rows.begin() + 1, {BagsStateText::tr("map"), *no_map});
      printTable(rows);
    }
    opened->noteUnreadable(*at_s);
    return kDone;
  });
}

namespace {

/// Parses --kind; empty = all of them.
CommandResult<std::set<replay::EventGroup>> groupsFrom(const std::string& kinds) {
  std::set<replay::EventGroup> groups;
  if (kinds.empty()) return std::set(std::begin(replay::kEventGroups), std::end(replay::kEventGroups));
  for (const QString& word : text(kinds).split(QLatin1Char(','))) {
    const auto* const found =
        std::find_if(std::begin(replay::kEventGroups), std::end(replay::kEventGroups),
                     [asked = word.trimmed().toLower().toStdString()](replay::EventGroup group) {
                       return replay::wordOf(group) == asked;
                     });
    if (found == std::end(replay::kEventGroups))
      return tl::make_unexpected(CommandFailure{
          kUsage,
          BagsStateText::tr("--kind: \"%1\" is unknown. Choose from: alerts, planner, position, maps, stops.")
              .arg(word)});
    groups.insert(*found);
  }
  return groups;
}

}  // namespace

int bagsEvents(const BagsWords& words, int& argc, char** argv) {
  return runBagsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto groups = groupsFrom(words.kinds);
    if (!groups) return tl::make_unexpected(groups.error());
    auto opened = BagReading::open(command, words);
    if (!opened) return tl::make_unexpected(opened.error());
    const auto replayed = opened->replay(words.name);
    if (!replayed) return tl::make_unexpected(replayed.error());
    replay::Reading& reading = **replayed;
    if (const auto failed = opened->readWhole()) return tl::make_unexpected(*failed);
    std::vector<replay::Event> events = replay::eventsOf(reading.index().digests());
    std::erase_if(events,
                  [&](const replay::Event& event) { return !groups->contains(replay::groupOf(event.kind)); });
    opened->noteUnreadable(HUGE_VAL);
    if (words.json) {
      printJson(eventsJson(events));
      return kDone;
    }
    std::vector<QStringList> table;
    for (const replay::Event& event : events) table.push_back(eventRow(event));
    if (table.empty()) std::printf("%s\n", qUtf8Printable(BagsStateText::tr("Nothing happened.")));
    printTable(table);
    return kDone;
  });
}

}  // namespace mapwright::app
