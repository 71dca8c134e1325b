// `mapwright maps rehearse NEW WAY…`: what recorded ways cross on a new map (docs/tasks/new-map.md).
#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>
#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "align/align_placed.h"
#include "align/alignment_sentence.h"
#include "app/bag_reading.h"
#include "app/command_map.h"
#include "app/command_text.h"
#include "app/map_operand.h"
#include "app/maps_align.h"
#include "app/output.h"
#include "app/robot_factory.h"
#include "app/site_options.h"
#include "carry/rehearsal.h"
#include "carry/rehearsal_sentence.h"
#include "disk/written_file.h"
#include "incident/report.h"
#include "page/page.h"
#include "replay/track_file.h"
#include "sentences/fault_sentence.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using carry::Rehearsed;
using carry::Stretch;
using words::text;

constexpr std::size_t kMostTrackBytes = 256 << 20;

struct RehearseArguments : SiteArguments {
  RehearseArguments() { timeout_s = 300; }
  std::string map, from;
  std::vector<std::string> ways;
};

/// As it was recorded.
struct DrivenWay {
  std::vector<carry::WayPoint> points;
  std::vector<map::MapIdentity> maps;  // of WayPoint::map
};

struct RehearsedWay {
  std::string name;
  Rehearsed way;
};

/// How the ways lie on the new map.
struct RehearsalSite {
  OpenedMaps opened;  // the new one last
  carry::RehearsalOptions options;
  align::Alignment alignment;  // without a best one if it was given, or not asked for
};

DrivenWay drivenOf(const std::vector<replay::TrackPoint>& track, std::vector<map::MapIdentity> maps) {
  DrivenWay way{{}, std::move(maps)};
  for (const replay::TrackPoint& point : track)
    way.points.push_back({{point.pose.x_m, point.pose.y_m}, point.stamp_s, point.piece, point.map});
  return way;
}

CommandResult<DrivenWay> trackFile(const std::string& path) {
  const auto bytes = bytesOf(path, kMostTrackBytes);
  const QString file = oneLine(text(path));
  if (!bytes)
    return wrong(Text::tr("%1 cannot be read: %2.").arg(file, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > kMostTrackBytes) return wrong(Text::tr("%1 is larger than 256 MiB.").arg(file));
  std::vector<map::MapIdentity> maps;
  const auto track = replay::trackFrom(*bytes, &maps);
  if (track) return drivenOf(*track, std::move(maps));
  const QString what =
      track.error() == 0
          ? Text::tr("%1 is no track.").arg(file)
          : Text::tr("%1 is no track: line %2 cannot be read.").arg(file).arg(qint64(track.error()));
  return wrong(
      QStringLiteral("%1 %2").arg(what, Text::tr("Pass a recording, or a file that bags track wrote.")));
}

/// A recording on this computer, or one of the robot.
CommandResult<DrivenWay> trackOfBag(RobotCommand& command, const RehearseArguments& args,
                                    const std::string& typed) {
  std::string robot, bag = typed;
  onRecording(robot, bag, args.robot);
  auto opened = BagReading::open(command, text(robot));
  if (!opened) return passOn(opened);
  const auto replayed = opened->readThrough(bag, BagReading::Texts::Short);
  if (!replayed) return passOn(replayed);
  replay::PrefixIndex index;
  const auto read =
      opened->readRanges(std::nullopt, std::nullopt, [&](const replay::Chunk& chunk) -> CommandResult<void> {
        index.add(replay::tickOf(chunk.from_s), replay::digestOf(chunk));
        return {};
      });
  if (!read) return passOn(read);
  opened->reportUnreadable(HUGE_VAL);
  return drivenOf(replay::trackOf(index.digests()), replay::mapsOf(index.digests()));
}

/// What the robot calls one of its maps; empty if it does not say.
map::MapIdentity identityOf(RobotReading& robot, const QString& id) {
  const session::Catalogue& catalogue = robot.session().catalogue();
  if (id == QLatin1String("submaps") || !catalogue.offered() || !robot.catalogue()) return {};
  const map::CatalogueEntry* entry =
      id.isEmpty() || id == QLatin1String("live") ? catalogue.current() : catalogue.called(id.toStdString());
  if (!entry && catalogue.entries().size() == 1) entry = &catalogue.entries().front();
  return entry ? map::MapIdentity{entry->uid, entry->name} : map::MapIdentity();
}

CommandResult<RehearsalSite> openRehearsal(RobotCommand& command, const RehearseArguments& args) {
  RehearsalSite site;
  const auto wishes = wishesFrom(args);
  if (!wishes) return passOn(wishes);
  if (!wishes->pairs.empty() && args.from.empty())
    return wrong(Text::tr("--pair needs --from, the old map that it is a point of."));
  std::vector<std::string> maps{args.map};
  if (!args.from.empty()) maps.insert(maps.begin(), args.from);
  auto opened = openMaps(command, maps, text(args.robot), {args.resolution, args.origin},
                         [&](int index, RobotReading& robot, const QString& id) {
                           if (index == 0) site.options.driven_on = identityOf(robot, id);
                           if (index + 1 == int(maps.size()))
                             site.options.radius_m =
                                 wishes->radius_m ? *wishes->radius_m : robotRadius(robot);
                           return std::optional<CommandFailure>();
                         });
  if (!opened) return passOn(opened);
  site.opened = std::move(*opened);
  if (!args.from.empty()) site.options.old_map = site.opened.maps[0];
  if (wishes->transform) {
    site.options.transform = *wishes->transform;
  } else if (!args.from.empty()) {
    site.alignment = *align::alignPlaced(site.opened.maps[0], site.opened.maps[1], {.pairs = wishes->pairs});
    if (!site.alignment.sure())
      return tl::make_unexpected(CommandFailure{
          kIncomplete, Text::tr("Nothing was rehearsed. %1").arg(align::alignmentText(site.alignment))});
    site.options.transform = site.alignment.best->transform;
  }
  return site;
}

QString reachName(Rehearsed::Reach reach) {
  switch (reach) {
    case Rehearsed::Reach::Reached:
      return QStringLiteral("reached");
    case Rehearsed::Reach::CutOff:
      return QStringLiteral("cut_off");
    case Rehearsed::Reach::NoStart:
      return QStringLiteral("no_start");
    case Rehearsed::Reach::NoEnd:
      return QStringLiteral("no_end");
  }
  return {};
}

QString partName(Rehearsed::Part part) {
  switch (part) {
    case Rehearsed::Part::Only:
      return QStringLiteral("only");
    case Rehearsed::Part::Recorded:
      return QStringLiteral("recorded");
    case Rehearsed::Part::ByGround:
      return QStringLiteral("by_ground");
  }
  return {};
}

QJsonObject stretchJson(const Stretch& stretch) {
  return {{QStringLiteral("what"), QLatin1String(carry::nameOf(stretch.what))},
          {QStringLiteral("from_s"), stretch.from_s},
          {QStringLiteral("to_s"), stretch.to_s},
          {QStringLiteral("length_m"), stretch.length_m},
          {QStringLiteral("x"), stretch.middle_m.x()},
          {QStringLiteral("y"), stretch.middle_m.y()}};
}

/// docs/json.md.
QJsonObject rehearsalJson(const RehearsalSite& site, const std::vector<RehearsedWay>& ways) {
  QJsonArray all;
  for (const RehearsedWay& one : ways) {
    QJsonArray stretches;
    for (const Stretch& stretch : one.way.crossed()) stretches << stretchJson(stretch);
    all << QJsonObject{{QStringLiteral("name"), text(one.name)},
                       {QStringLiteral("free"), one.way.free()},
                       {QStringLiteral("length_m"), one.way.length_m},
                       {QStringLiteral("start_s"), one.way.from_s},
                       {QStringLiteral("end_s"), one.way.to_s},
                       {QStringLiteral("reach"), reachName(one.way.reach)},
                       {QStringLiteral("jumps"), qint64(one.way.jumps)},
                       {QStringLiteral("left_out"), qint64(one.way.unusable)},
                       {QStringLiteral("elsewhere_m"), one.way.elsewhere_m},
                       {QStringLiteral("part"), partName(one.way.part)},
                       {QStringLiteral("of_another_map"), one.way.of_another},
                       {QStringLiteral("stretches"), stretches}};
  }
  return {{QStringLiteral("transform"), transformJson(site.options.transform)},
          {QStringLiteral("radius_m"), site.options.radius_m},
          {QStringLiteral("ways"), all}};
}

/// All stretches, also the free ones, as lines in metres of the new map.
QByteArray rehearsalGeoJson(const std::vector<RehearsedWay>& ways) {
  QJsonArray features;
  for (const RehearsedWay& one : ways) {
    for (const Stretch& stretch : one.way.stretches) {
      QJsonArray line;
      for (const Eigen::Vector2d& at : stretch.line) line << QJsonArray{at.x(), at.y()};
      const bool point = stretch.line.size() == 1;
      QJsonObject properties = stretchJson(stretch);
      properties[QStringLiteral("way")] = text(one.name);
      features << QJsonObject{
          {QStringLiteral("type"), QStringLiteral("Feature")},
          {QStringLiteral("geometry"),
           QJsonObject{
               {QStringLiteral("type"), point ? QStringLiteral("Point") : QStringLiteral("LineString")},
               {QStringLiteral("coordinates"), point ? line[0] : QJsonValue(line)}}},
          {QStringLiteral("properties"), properties}};
    }
  }
  return QJsonDocument(QJsonObject{{QStringLiteral("type"), QStringLiteral("FeatureCollection")},
                                   {QStringLiteral("units"), QStringLiteral("metres")},
                                   {QStringLiteral("features"), features}})
             .toJson(QJsonDocument::Compact) +
         '\n';
}

struct CrossedStretch {
  const RehearsedWay* of;
  Stretch stretch;
};

/// Of all ways, the longest first.
std::vector<CrossedStretch> allCrossed(const std::vector<RehearsedWay>& ways) {
  std::vector<CrossedStretch> all;
  for (const RehearsedWay& one : ways) {
    for (Stretch& stretch : one.way.crossed()) all.push_back({&one, std::move(stretch)});
  }
  std::stable_sort(all.begin(), all.end(), [](const CrossedStretch& a, const CrossedStretch& b) {
    return a.stretch.length_m > b.stretch.length_m;
  });
  return all;
}

QStringList cellsOf(const Stretch& stretch) {
  return {carry::crossingText(stretch.what),     words::fixed(stretch.length_m, 2),
          words::fixed(stretch.middle_m.x(), 2), words::fixed(stretch.middle_m.y(), 2),
          incident::utcText(stretch.from_s),     incident::utcText(stretch.to_s)};
}

void printRehearsal(const RehearsalSite& site, const std::vector<RehearsedWay>& ways) {
  for (const RehearsedWay& one : ways)
    printLine(words::about(oneLine(text(one.name)), carry::rehearsedText(one.way)));
  std::vector<QStringList> table{{Text::tr("MEETS"), Text::tr("LENGTH (m)"), Text::tr("X (m)"),
                                  Text::tr("Y (m)"), Text::tr("FROM (UTC)"), Text::tr("TO (UTC)"),
                                  Text::tr("NAME")}};
  for (const CrossedStretch& crossed : allCrossed(ways))
    table.push_back(cellsOf(crossed.stretch) << words::plainName(crossed.of->name));
  if (table.size() > 1) printTable(table);
  if (site.alignment.best) printLine(align::alignmentText(site.alignment));
}

/// The report for people. nullopt = written.
std::optional<QString> writeRehearsalPage(const RobotCommand& command, const RehearseArguments& args,
                                          const RehearsalSite& site, const std::vector<RehearsedWay>& ways) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    page::Page page(buffer, Text::tr("Recorded ways on a new map"));
    std::vector<page::Page::Fact> facts{{Text::tr("New map"), {page::Cell(page::named(args.map))}}};
    if (!args.from.empty()) facts.push_back({Text::tr("Old map"), {page::Cell(page::named(args.from))}});
    facts.push_back({Text::tr("Old to new"), {page::Cell(align::transformText(site.options.transform))}});
    if (site.alignment.best)
      facts.push_back({Text::tr("Alignment"), {page::Cell(align::alignmentText(site.alignment))}});
    facts.push_back({Text::tr("Radius"), {page::Cell(Text::tr("%1 m").arg(site.options.radius_m))}});
    if (!command.complete())
      facts.push_back({Text::tr("Incomplete"), {page::Cell(command.warnings().join(QLatin1Char('\n')))}});
    page.facts(facts);
    page.section(Text::tr("Ways"));
    page.beginTable({Text::tr("Name"), Text::tr("Result")});
    for (const RehearsedWay& one : ways) {
      page.row(
          {page::Cell(page::named(one.name)),
           page::Cell(carry::rehearsedText(one.way), one.way.free() ? page::Tone::Good : page::Tone::Bad)});
    }
    page.endTable();
    page.section(Text::tr("What they cross"));
    const std::vector<CrossedStretch> all = allCrossed(ways);
    if (all.empty()) page.paragraph(Text::tr("Nothing."));
    if (!all.empty()) {
      page.beginTable({Text::tr("Meets"), Text::tr("Length (m)"), Text::tr("x (m)"), Text::tr("y (m)"),
                       Text::tr("From (UTC)"), Text::tr("To (UTC)"), Text::tr("Name")});
      for (const CrossedStretch& crossed : all) {
        const QStringList cells = cellsOf(crossed.stretch);
        page.row({page::Cell(cells[0]), page::figure(cells[1]), page::figure(cells[2]),
                  page::figure(cells[3]), page::Cell(cells[4]), page::Cell(cells[5]),
                  page::Cell(page::named(crossed.of->name))});
      }
      page.endTable();
    }
    page.end();
  }
  if (const auto trouble = disk::writeFile(args.page, buffer.data().toStdString()))
    return sentences::wordsOf(disk::notWritten(*trouble));
  return std::nullopt;
}

CommandResult<int> mapsRehearse(RobotCommand& command, const RehearseArguments& args) {
  command.answerByCode();
  const QString output = text(args.output), printed = args.json ? QStringLiteral("-") : QString();
  if (const auto why = output.isEmpty() ? std::nullopt : notCreatedReason(output, args.force, args.ways))
    return wrong(*why);
  if (const auto why = args.page.empty() ? std::nullopt : notWritableReason(text(args.page)))
    return wrong(*why);
  if (const auto why = notTogetherReason({output, text(args.page), text(args.report), printed}))
    return sharedOutput(*why);
  std::vector<DrivenWay> driven;
  for (const std::string& typed : args.ways) {
    auto way = replay::isTrackName(typed) ? trackFile(typed) : trackOfBag(command, args, typed);
    if (!way) return passOn(way);
    const bool any = std::any_of(way->points.begin(), way->points.end(), [](const carry::WayPoint& point) {
      return point.position_m.allFinite() && std::isfinite(point.stamp_s);
    });
    if (!any) return wrong(words::about(oneLine(text(typed)), carry::rehearsedText({})));
    driven.push_back(std::move(*way));
  }
  const auto site = openRehearsal(command, args);
  if (!site) return passOn(site);
  if (const auto why = overOwnSource({output, text(args.page)}, site->opened.source_files);
      why && !args.force)
    return wrong(*why);
  const carry::Rehearsal rehearsal(site->opened.maps.back(), site->options);
  std::vector<RehearsedWay> ways;
  for (std::size_t i = 0; i < driven.size(); ++i)
    ways.push_back({args.ways[i], rehearsal.of(driven[i].points, driven[i].maps)});
  QJsonObject json = rehearsalJson(*site, ways);
  json[QStringLiteral("complete")] = command.complete();
  command.report(QStringLiteral("rehearsal"), json);
  if (!args.output.empty()) {
    if (const auto trouble =
            disk::writeFile(args.output, rehearsalGeoJson(ways).toStdString(), existingBy(args.force)))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  }
  if (!args.page.empty()) {
    if (const auto why = writeRehearsalPage(command, args, *site, ways)) return wrong(*why);
  }
  if (args.json) {
    printJson(json);
  } else if (!isStandardOutput(output)) {
    printRehearsal(*site, ways);
  }
  bool free = true;
  for (const RehearsedWay& one : ways) {
    if (one.way.length_m == 0)
      say(Text::tr("%1: there is no line of it to look at.").arg(oneLine(text(one.name))));
    free = free && one.way.free() && one.way.length_m > 0 && one.way.elsewhere_m == 0;
  }
  return free ? kDone : kIncomplete;
}

}  // namespace

void addMapRehearsal(Commands& commands, CLI::App& maps) {
  const auto args = std::make_shared<RehearseArguments>();
  CLI::App* const command =
      addReading(commands, maps, "rehearse", Text::tr("Find out what recorded ways cross on a new map"),
                 Text::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"), args,
                 mapsRehearse, [](RehearseArguments& typed, const Invocation&) {
                   if (isPageName(typed.report)) typed.page.swap(typed.report);
                 });
  command
      ->add_option("new", args->map,
                   help(Text::tr("The new map: a map of --robot, a file or address, or ID@ADDRESS")))
      ->required();
  command
      ->add_option(
          "ways", args->ways,
          help(Text::tr("Recordings, by file or by name on --robot, or tracks that bags track wrote")))
      ->required();
  command->add_option("--from", args->from,
                      help(Text::tr("The old map that they were driven on; it is aligned with the new one. "
                                    "Without it they lie on the new map as they are")));
  addSiteOptions(
      *command, *args,
      Text::tr("Write the ways, cut where they meet something, as GeoJSON; - is the standard output"));
}

}  // namespace mapwright::app
