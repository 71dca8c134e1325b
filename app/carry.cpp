// `mapwright waypoints carry` and `overlays carry`: what was placed by hand on an old map, on a new one
// (docs/tasks/new-map.md). They write a file; `waypoints import` and `overlays set` send it.
#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include <CLI/CLI.hpp>
#include <QBuffer>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "align/align_placed.h"
#include "align/alignment_sentence.h"
#include "app/command_map.h"
#include "app/command_text.h"
#include "app/map_operand.h"
#include "app/maps_align.h"
#include "app/output.h"
#include "app/site_options.h"
#include "app/waypoint_list.h"
#include "carry/carried.h"
#include "carry/overlays_carried.h"
#include "carry/verdict_sentence.h"
#include "disk/written_file.h"
#include "exchange/waypoint_json.h"
#include "overlays/overlay_box.h"
#include "page/page.h"
#include "robot/overlay_store.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using carry::Carried;
using overlays::OverlayDocument;
using words::text;

struct CarryArguments : SiteArguments {
  std::string from, to;
  bool adjust = false, all = false, dry_run = false;
};

/// One thing that is carried over.
struct CarryRow {
  std::string id, name;
  Carried carried;
  bool there_already = false;
  bool one_there = false;  // one that belongs to it is on the new map already
  QStringList with = {};   // names of what goes along with it
  std::vector<std::string> with_ids = {};
  bool goes(bool all) const { return !there_already && !one_there && (all || carry::sound(carried.verdict)); }
};

struct CarrySite {
  geometry::Pose2 transform;
  align::Alignment alignment;  // without a best one if the transform was given
  OpenedMaps pair;
  double radius_m = 0;
};

const QString kOfSubmaps = QStringLiteral("submaps");

CommandFailure nothingOnSubmaps(const RobotReading& robot) {
  return robot
      .failure(kUsage,
               Text::tr("Submaps have no waypoints and no overlays of their own. Pass the map that they "
                        "were placed on as --from."))
      .value();
}

/// Nothing is carried over where it is not known how the maps lie.
CommandResult<CarrySite> openSite(RobotCommand& command, const CarryArguments& args,
                                  const BeforeMap& before) {
  CarrySite site;
  const auto wishes = wishesFrom(args);
  if (!wishes) return passOn(wishes);
  auto pair = openMaps(command, {args.from, args.to}, text(args.robot), {args.resolution, args.origin},
                       [&](int index, RobotReading& robot, const QString& id) {
                         if (index == 0 && id == kOfSubmaps) return std::optional(nothingOnSubmaps(robot));
                         if (index == 1)
                           site.radius_m = wishes->radius_m ? *wishes->radius_m : robotRadius(robot);
                         return before(index, robot, id);
                       });
  if (!pair) return passOn(pair);
  site.pair = std::move(*pair);
  if (wishes->transform) {
    site.transform = *wishes->transform;
    return site;
  }
  site.alignment = *align::alignPlaced(site.pair.maps[0], site.pair.maps[1], {.pairs = wishes->pairs});
  if (!site.alignment.sure())
    return tl::make_unexpected(CommandFailure{
        kIncomplete, Text::tr("Nothing was carried over. %1").arg(align::alignmentText(site.alignment))});
  site.transform = site.alignment.best->transform;
  return site;
}

QJsonValue numberOrNull(const std::optional<double>& number) {
  return number ? QJsonValue(*number) : QJsonValue();
}

/// docs/json.md.
QJsonObject carriedJson(const geometry::Pose2& transform, const std::vector<CarryRow>& rows, bool all) {
  QJsonArray items;
  for (const CarryRow& row : rows) {
    QJsonArray with;
    for (const std::string& id : row.with_ids) with << text(id);
    items << QJsonObject{{QStringLiteral("id"), text(row.id)},
                         {QStringLiteral("name"), text(row.name)},
                         {QStringLiteral("verdict"), QLatin1String(carry::nameOf(row.carried.verdict))},
                         {QStringLiteral("carried"), row.goes(all)},
                         {QStringLiteral("there_already"), row.there_already},
                         {QStringLiteral("with"), with},
                         {QStringLiteral("x"), row.carried.spot.position_m.x()},
                         {QStringLiteral("y"), row.carried.spot.position_m.y()},
                         {QStringLiteral("yaw_rad"), numberOrNull(row.carried.spot.yaw_rad)},
                         {QStringLiteral("local_residual_m"), numberOrNull(row.carried.local_residual_m)}};
  }
  return {{QStringLiteral("transform"), transformJson(transform)}, {QStringLiteral("items"), items}};
}

QString becameText(const CarryRow& row) {
  QString became =
      row.there_already ? Text::tr("on the new map already") : carry::verdictText(row.carried.verdict);
  if (row.one_there) became = Text::tr("left out: what belongs to it is on the new map already");
  if (!row.with.isEmpty()) became += Text::tr(" (together with %1)").arg(words::listed(row.with));
  return became;
}

QString metresOrDash(const std::optional<double>& metres) {
  return metres ? words::fixed(*metres, 2) : QStringLiteral("-");
}

QString calledText(const CarryRow& row) { return words::plainName(row.name.empty() ? row.id : row.name); }

void printRows(const std::vector<CarryRow>& rows) {
  std::vector<QStringList> table{{Text::tr("BECAME"), Text::tr("X (m)"), Text::tr("Y (m)"),
                                  Text::tr("YAW (°)"), Text::tr("WALLS OFF (m)"), Text::tr("NAME")}};
  for (const CarryRow& row : rows) {
    const carry::Spot& spot = row.carried.spot;
    table.push_back(
        {becameText(row), words::fixed(spot.position_m.x(), 3), words::fixed(spot.position_m.y(), 3),
         spot.yaw_rad ? words::fixed(geometry::degreesFromRadians(*spot.yaw_rad), 1) : QStringLiteral("-"),
         metresOrDash(row.carried.local_residual_m), calledText(row)});
  }
  printTable(table);
}

/// "12 carried over, 2 left out (1 in an obstacle, 1 outside)".
QString sumText(const std::vector<CarryRow>& rows, bool all) {
  std::array<qint64, carry::kVerdicts> left{};
  qint64 carried = 0, there = 0;
  for (const CarryRow& row : rows) {
    row.there_already || row.one_there ? ++there
    : row.goes(all)                    ? ++carried
                                       : ++left[std::size_t(row.carried.verdict)];
  }
  QStringList parts{Text::tr("%1 carried over").arg(carried)}, reasons;
  qint64 out = 0;
  for (int i = 0; i < carry::kVerdicts; ++i) {
    if (left[std::size_t(i)] == 0) continue;
    out += left[std::size_t(i)];
    reasons << QStringLiteral("%1 %2").arg(left[std::size_t(i)]).arg(carry::verdictText(carry::Verdict(i)));
  }
  if (there > 0) parts << Text::tr("%1 on the new map already").arg(there);
  if (out > 0) parts << Text::tr("%1 left out (%2)").arg(out).arg(words::listed(reasons));
  return words::listed(parts);
}

page::Tone toneOf(const CarryRow& row) {
  return row.there_already                   ? page::Tone::Muted
         : carry::sound(row.carried.verdict) ? page::Tone::Good
                                             : page::Tone::Bad;
}

/// The report for people. nullopt = written.
std::optional<QString> writePage(const CarryArguments& args, const QString& title, const CarrySite& site,
                                 const std::vector<CarryRow>& rows) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    page::Page page(buffer, title);
    std::vector<page::Page::Fact> facts{
        {Text::tr("Old map"), {page::Cell(page::named(args.from))}},
        {Text::tr("New map"), {page::Cell(page::named(args.to))}},
        {Text::tr("Old to new"), {page::Cell(align::transformText(site.transform))}},
        {Text::tr("Alignment"),
         {page::Cell(site.alignment.best ? align::alignmentText(site.alignment)
                                         : Text::tr("Given by hand."))}},
        {Text::tr("Result"), {page::Cell(sumText(rows, args.all))}}};
    page.facts(facts);
    page.section(Text::tr("What became of each"));
    page.beginTable({Text::tr("Name"), Text::tr("Became"), Text::tr("x (m)"), Text::tr("y (m)"),
                     Text::tr("Yaw (°)"), Text::tr("Walls off (m)")});
    for (const CarryRow& row : rows) {
      const carry::Spot& spot = row.carried.spot;
      page.row({page::Cell(page::named(row.name.empty() ? row.id : row.name)),
                page::Cell(becameText(row), toneOf(row)), page::figure(words::fixed(spot.position_m.x(), 3)),
                page::figure(words::fixed(spot.position_m.y(), 3)),
                page::figure(spot.yaw_rad ? words::fixed(geometry::degreesFromRadians(*spot.yaw_rad), 1)
                                          : QStringLiteral("-")),
                page::figure(metresOrDash(row.carried.local_residual_m))});
    }
    page.endTable();
    page.section(Text::tr("What the words mean"));
    for (int i = 0; i < carry::kVerdicts; ++i) {
      page.paragraph(
          words::about(carry::verdictText(carry::Verdict(i)), carry::meaningOf(carry::Verdict(i))));
    }
    page.end();
  }
  if (const auto trouble = disk::writeFile(args.page, buffer.data().toStdString()))
    return sentences::wordsOf(disk::notWritten(*trouble));
  return std::nullopt;
}

/// Before anything is read.
std::optional<CommandFailure> unusable(const CarryArguments& args) {
  const QString output = text(args.output), printed = args.json ? QStringLiteral("-") : QString();
  if (args.output.empty() && !args.dry_run)
    return wrong(Text::tr("Pass -o F.geojson to write what is carried over, or --dry-run to look only."))
        .value();
  const QString suffix = QFileInfo(output).suffix().toLower();
  if (!output.isEmpty() && !isStream(output) && suffix != QLatin1String("geojson") &&
      suffix != QLatin1String("json"))
    return wrong(Text::tr("--output %1: what is written is GeoJSON. Name it NAME.geojson.")
                     .arg(oneLine(output)))
        .value();
  if (!args.output.empty() && args.dry_run) return wrong(Text::tr("Pass either -o or --dry-run.")).value();
  if (const auto why = output.isEmpty() ? std::nullopt : notCreatedReason(output, args.force))
    return wrong(*why).value();
  if (const auto why = args.page.empty() ? std::nullopt : notWritableReason(text(args.page)))
    return wrong(*why).value();
  if (const auto why = notTogetherReason({output, text(args.page), text(args.report), printed}))
    return sharedOutput(*why).value();
  return std::nullopt;
}

/// Writes, prints and reports what became of all.
CommandResult<int> finish(RobotCommand& command, const CarryArguments& args, const QString& title,
                          const CarrySite& site, const std::vector<CarryRow>& rows,
                          const std::string& bytes) {
  const QJsonObject json = carriedJson(site.transform, rows, args.all);
  command.report(QStringLiteral("carry"), json);
  if (const auto why = overOwnSource({text(args.output), text(args.page)}, site.pair.source_files);
      why && !args.force)
    return wrong(*why);
  if (!args.output.empty()) {
    if (const auto trouble = disk::writeFile(args.output, bytes, existingBy(args.force)))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  }
  if (!args.page.empty()) {
    if (const auto why = writePage(args, title, site, rows)) return wrong(*why);
  }
  const bool printed = isStandardOutput(text(args.output));
  if (args.json) {
    printJson(json);
  } else if (!printed) {
    printRows(rows);
    if (site.alignment.best) printLine(align::alignmentText(site.alignment));
    printLine(args.output.empty() ? sumText(rows, args.all)
                                  : words::about(oneLine(text(args.output)), sumText(rows, args.all)));
  }
  const bool all_go = std::all_of(rows.begin(), rows.end(),
                                  [](const CarryRow& row) { return row.goes(false) || row.there_already; });
  return all_go ? kDone : kIncomplete;
}

CommandResult<int> waypointsCarry(RobotCommand& command, const CarryArguments& args) {
  if (auto failed = unusable(args)) return tl::make_unexpected(std::move(*failed));
  std::vector<map::Waypoint> points;
  std::string new_map;
  std::set<std::string> there;  // names
  const auto site = openSite(command, args, [&](int index, RobotReading& robot, const QString& id) {
    const bool has_none =
        !robot.session().robot().waypointStore() && !robot.session().robot().waypointSource();
    if (index == 1 && id != kOfSubmaps) new_map = id.toStdString();
    if (index == 1 && (has_none || id == kOfSubmaps)) return std::optional<CommandFailure>();
    auto list = listWaypoints(robot, id.toStdString(), Use::Reading);
    if (!list) return std::optional(list.error());
    for (const map::Waypoint& point : list->stored.points) {
      // Those without a name are not one and the same.
      if (index == 1 && !point.name.empty()) there.insert(point.name);
    }
    if (index == 0) points = std::move(list->stored.points);
    return std::optional<CommandFailure>();
  });
  if (!site) return passOn(site);
  std::vector<carry::Spot> spots;
  for (const map::Waypoint& point : points) spots.push_back({point.position_m, point.yaw_rad});
  const carry::Site both(site->pair.maps[0], site->pair.maps[1], site->transform);
  const std::vector<Carried> carried = both.carried(spots, {site->radius_m, args.adjust});
  std::vector<CarryRow> rows;
  std::vector<map::Waypoint> going;
  for (std::size_t i = 0; i < points.size(); ++i) {
    rows.push_back({points[i].id, points[i].name, carried[i], there.contains(points[i].name)});
    if (!rows.back().goes(args.all)) continue;
    map::Waypoint point = points[i];
    point.position_m = carried[i].spot.position_m;
    point.yaw_rad = carried[i].spot.yaw_rad;
    point.id.clear();  // it is a new one on the new map
    going.push_back(std::move(point));
  }
  return finish(command, args, Text::tr("Waypoints carried over"), *site, rows,
                exchange::waypointsGeoJson(going, new_map).toStdString());
}

/// The overlays of a map, as its robot keeps them.
CommandResult<OverlayDocument> overlaysOf(RobotReading& robot, const QString& id) {
  robot::OverlayStore* const store = robot.session().robot().overlayStore();
  if (!store) return robot.lacks(robot::Capability::OverlayEditing);
  const auto key = storedMap(robot, id.toStdString());
  if (!key) return passOn(key);
  const auto held = robot.ask<robot::OverlayText>(
      [&](robot::OutcomeTo<robot::OverlayText> reply) { return store->read(*key, std::move(reply)); });
  if (!held) return robot.failure(held.error());
  auto document = OverlayDocument::read(held->text);
  if (!document)
    return robot.failure(
        kUsage, Text::tr("Its overlays cannot be read. %1").arg(sentences::sentenceOf(document.error())));
  return std::move(*document);
}

CommandResult<int> overlaysCarry(RobotCommand& command, const CarryArguments& args) {
  if (auto failed = unusable(args)) return tl::make_unexpected(std::move(*failed));
  std::array<OverlayDocument, 2> documents;
  RobotReading* to = nullptr;
  const auto site = openSite(command, args, [&](int index, RobotReading& robot, const QString& id) {
    to = &robot;
    if (id == kOfSubmaps) return std::optional<CommandFailure>();  // a map that is not saved yet has none
    auto document = overlaysOf(robot, id);
    if (!document) return std::optional(document.error());
    documents[std::size_t(index)] = std::move(*document);
    return std::optional<CommandFailure>();
  });
  if (!site) return passOn(site);
  const carry::Site both(site->pair.maps[0], site->pair.maps[1], site->transform);
  const auto carried = carry::carriedOverlays(both, documents[0], documents[1], site->pair.maps[1],
                                              {site->radius_m, args.adjust});
  std::vector<CarryRow> rows;
  OverlayDocument going = documents[1];
  qint64 boxes = 0;
  for (const carry::CarriedFeature& one : carried) {
    CarryRow row{one.moved.id(), one.moved.name(), one.carried, one.there_already, one.one_there};
    for (const std::size_t other : one.with) {
      const overlays::Feature& feature = documents[0].features()[other];
      row.with << words::plainName(feature.name().empty() ? feature.id() : feature.name());
      row.with_ids.push_back(feature.id());
    }
    if (row.goes(args.all)) going.add(one.moved), boxes += one.box_removed;
    rows.push_back(std::move(row));
  }
  const auto odd = qint64(documents[0].features().size() - carried.size());
  if (odd > 0) {
    to->lack(sentences::counted(
        Text::tr("%1 overlays of the old map have no usable coordinates and were left out.", nullptr,
                 sentences::formOf(odd)),
        odd));
  }
  if (boxes > 0)
    to->addRemark(Text::tr("Boxes (bbox) left out because they did not fit their overlay: %1.").arg(boxes));
  const bool any = going.features().size() > documents[1].features().size();
  if (any && !overlays::rebox(going, documents[1]))
    to->addRemark(Text::tr("The box (bbox) of the new map's overlays did not fit them, and stays as it is."));
  return finish(command, args, Text::tr("Overlays carried over"), *site, rows, going.text());
}

}  // namespace

void addCarry(Commands& commands, CLI::App& parent, CarriedKind kind) {
  const auto args = std::make_shared<CarryArguments>();
  const bool waypoints = kind == CarriedKind::Waypoints;
  CLI::App* const command =
      addReading(commands, parent, "carry",
                 waypoints ? Text::tr("Bring the waypoints of an old map of a site to a new one")
                           : Text::tr("Bring the overlays of an old map of a site to a new one"),
                 Text::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"), args,
                 waypoints ? waypointsCarry : overlaysCarry, [](CarryArguments& typed, const Invocation&) {
                   if (isPageName(typed.report)) typed.page.swap(typed.report);
                 });
  command
      ->add_option("--from", args->from,
                   help(Text::tr("The old map: a map of --robot, a file or address, or ID@ADDRESS")))
      ->required();
  command->add_option("--to", args->to, help(Text::tr("The same for the new map")))->required();
  command->add_flag("--adjust", args->adjust,
                    help(Text::tr("Move each a little further, to where the walls around it are now")));
  command->add_flag("--all", args->all, help(Text::tr("Also carry over what is not sound")));
  command->add_flag("--dry-run", args->dry_run, help(Text::tr("Only say what would become of each")));
  addSiteOptions(*command, *args,
                 waypoints
                     ? Text::tr("Write the waypoints, for waypoints import; - is the standard output")
                     : Text::tr("Write the overlays of the new map with those that are carried over, for "
                                "overlays set; - is the standard output"));
}

}  // namespace mapwright::app
