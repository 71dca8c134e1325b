// `mapwright overlays …`: the overlays of one map of a robot (docs/command-line.md, "mapwright overlays").
#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/kept_overlays.h"
#include "app/output.h"
#include "app/overlay_output.h"
#include "disk/written_file.h"
#include "jobs/change_overlays.h"
#include "overlays/overlay_check.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using overlays::OverlayChange;
using overlays::OverlayDocument;
using words::text;

constexpr std::size_t kMostOverlayBytes = std::size_t(256) << 20;
constexpr std::size_t kMostSentBytes = std::size_t(32) << 20;  // what is larger might not be read back

/// The options as typed; empty = not given.
struct OverlaysArguments : RobotArguments {
  std::string map, file, base, output;
  std::string off, radius;      // validate
  std::string number, against;  // history: as `history list` counts
  bool force = false, replace = false, dry_run = false, yes = false;
};

tl::expected<std::string, QString> overlayBytes(const std::string& path) {
  auto bytes = bytesOf(path, kMostOverlayBytes);
  if (!bytes)
    return tl::make_unexpected(
        Text::tr("%1 cannot be read: %2.").arg(inputCalled(path), sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > kMostOverlayBytes)
    return tl::make_unexpected(Text::tr("%1 is larger than 256 MiB.").arg(inputCalled(path)));
  return std::move(*bytes);
}

/// The error is a sentence with the name of the file.
tl::expected<OverlayDocument, QString> overlayFile(const std::string& path) {
  auto bytes = overlayBytes(path);
  if (!bytes) return passOn(bytes);
  auto document = OverlayDocument::read(std::move(*bytes));
  if (document) return std::move(*document);
  return tl::make_unexpected(words::about(inputCalled(path), sentences::sentenceOf(document.error())));
}

/// A file that is to become the overlays. An empty one, or something else than a FeatureCollection, is no
/// wish for no overlays: it is taken only for what `base` is, too, as robots hold such things.
tl::expected<OverlayDocument, QString> wantedOverlays(const std::string& path,
                                                      const std::optional<OverlayDocument>& base) {
  auto document = overlayFile(path);
  if (!document) return document;
  const std::string text = document->text();
  const bool as_base = base && !OverlayDocument::isCollection(base->text()) &&
                       (text == base->text() || (!document->features().empty() && !base->features().empty()));
  if (!OverlayDocument::isCollection(text) && !as_base)
    return tl::make_unexpected(
        Text::tr("%1 is no GeoJSON FeatureCollection with a list of features.").arg(inputCalled(path)));
  for (const OverlayChange& change : overlays::changesBetween(base.value_or(OverlayDocument()), *document)) {
    if (change.kind == overlays::ChangeKind::Add && !document->features()[*change.to].root().isObject())
      return tl::make_unexpected(
          Text::tr("%1 has something among its features that is no feature: %2")
              .arg(inputCalled(path),
                   oneLine(words::plainName(document->features()[*change.to].text()), 60)));
  }
  return document;
}

/// A map whose overlays can be read, and changed.
struct OverlaysOf {
  RobotReading* robot = nullptr;         // not null
  robot::OverlayStore* store = nullptr;  // not null
  map::MapKey map;
};

CommandResult<OverlaysOf> openOverlays(RobotCommand& command, const OverlaysArguments& args) {
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  RobotReading& reading = **opened;
  robot::OverlayStore* const store = reading.session().robot().overlayStore();
  if (!store) return reading.lacks(robot::Capability::OverlayEditing);
  if (args.map.empty() && !reading.local()) {
    // A map that was handed to the robot as data is in no list: its overlays are those that are live.
    const auto rows = reading.catalogue();
    if (rows && !reading.session().catalogue().current())
      return OverlaysOf{&reading, store, {map::MapKind::Live, {}}};
  }
  const auto key = storedMap(reading, args.map);
  if (!key) return passOn(key);
  return OverlaysOf{&reading, store, *key};
}

tl::unexpected<CommandFailure> failureOf(const OverlaysOf& of, const map::Failure& failed) {
  return of.robot->failure(failed);
}

/// Kept in the history, too.
robot::Outcome<robot::OverlayText> heldBy(const OverlaysOf& of) {
  auto held = of.robot->ask<robot::OverlayText>(
      [&](robot::OutcomeTo<robot::OverlayText> reply) { return of.store->read(of.map, std::move(reply)); });
  if (held) KeptOverlays(*of.robot, of.map).keep(*held, false);
  return held;
}

CommandResult<int> overlaysGet(RobotCommand& command, const OverlaysArguments& args) {
  const QString output = text(args.output);
  const bool printed = isStandardOutput(output);
  if (const auto why = notCreatedReason(output, args.force)) return wrong(*why);
  if (const auto why = notTogetherReason({output, text(args.report)})) return sharedOutput(*why);
  const auto of = openOverlays(command, args);
  if (!of) return passOn(of);
  const auto held = heldBy(*of);
  if (!held) return failureOf(*of, held.error());
  const auto document = OverlayDocument::read(held->text);
  // Nothing at all is no GeoJSON: set and validate would not take it.
  const bool nothing = held->text.find_first_not_of(" \t\r\n") == std::string::npos;
  const std::string bytes = nothing ? "{\"type\":\"FeatureCollection\",\"features\":[]}\n" : held->text;
  if (const auto trouble = disk::writeFile(args.output, bytes, existingBy(args.force)))
    return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  if (!document) {
    of->robot->addRemark(of->robot->about(
        Text::tr("Its overlays cannot be read. %1").arg(sentences::sentenceOf(document.error()))));
    return kIncomplete;
  }
  if (printed) return kDone;
  const auto count = qint64(document->features().size());
  printLine(
      words::about(oneLine(output),
                   sentences::counted(Text::tr("%1 features", nullptr, sentences::formOf(count)), count)));
  return kDone;
}

/// null: nobody knows.
QJsonValue appliedJson(map::Applied applied) {
  return applied == map::Applied::Maybe ? QJsonValue() : QJsonValue(applied == map::Applied::Yes);
}

QJsonObject outcomeJson(const jobs::OverlayOutcome& outcome, map::Applied applied) {
  return {
      {QStringLiteral("changes"), changesJson(outcome.merge.mine)},
      {QStringLiteral("theirs"), qint64(outcome.merge.theirs.size())},
      {QStringLiteral("conflicts"), conflictsJson(outcome.merge.conflicts)},
      {QStringLiteral("applied"), appliedJson(applied)},
      {QStringLiteral("version"), outcome.held.version ? QJsonValue(*outcome.held.version) : QJsonValue()}};
}

/// What is told of a change that failed: which it was, and whether it may have been made.
QJsonObject failureJson(const jobs::OverlayOrder& order, const map::Failure& failure) {
  jobs::OverlayOutcome outcome;
  if (order.base) outcome.merge.mine = overlays::changesBetween(*order.base, order.mine);
  return outcomeJson(outcome, map::changes(failure.asked_for) ? failure.applied : map::Applied::No);
}

/// Carries it out on the map of the options, and tells what came of it.
CommandResult<int> carryOut(RobotCommand& command, const OverlaysArguments& args, jobs::OverlayOrder order) {
  const auto of = openOverlays(command, args);
  if (!of) return passOn(of);
  order.map = of->map;
  KeptOverlays kept(*of->robot, of->map);
  order.seen = [&kept](const robot::OverlayText& text, bool saved, const jobs::OverlaysHeld*) {
    kept.keep(text, saved);
  };
  const auto outcome =
      of->robot->ask<jobs::OverlayOutcome>([&](robot::OutcomeTo<jobs::OverlayOutcome> reply) {
        return jobs::changeOverlays(*of->store, order, std::move(reply));
      });
  const QJsonObject json = outcome ? outcomeJson(*outcome, order.send ? outcome->applied() : map::Applied::No)
                                   : failureJson(order, outcome.error());
  command.report(QStringLiteral("overlays"), json);
  const QString output = text(args.output);
  if (!output.isEmpty()) {
    if (const auto trouble =
            disk::writeFile(args.output, QJsonDocument(json).toJson().toStdString(), existingBy(args.force)))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  }
  if (args.json) printJson(json);
  if (!outcome) return failureOf(*of, outcome.error());
  const bool quiet = args.json || isStandardOutput(output);
  if (!quiet) {
    const auto held = OverlayDocument::read(outcome->before.text);
    printChanges(outcome->merge.mine, order.base ? *order.base : held.value_or(OverlayDocument()),
                 order.mine);
    printConflicts(outcome->merge.conflicts);
  }
  if (!outcome->merge.conflicts.empty()) {
    const auto count = qint64(outcome->merge.conflicts.size());
    return of->robot->failure(
        kRobotError,
        sentences::counted(Text::tr("Nothing was sent: %1 conflicts with what others changed since the base.",
                                    nullptr, sentences::formOf(count)),
                           count));
  }
  if (outcome->held_back)
    return of->robot->failure(
        kUsage,
        Text::tr("Nothing was sent: this deletes %1 of the %2 features on the robot. Pass --yes to do it.")
            .arg(outcome->deletes)
            .arg(outcome->deletes + outcome->keeps));
  if (QString doubt = jobs::doubtOf(*outcome); !doubt.isEmpty()) {
    if (outcome->unreadable.any())
      doubt += QLatin1Char(' ') + Text::tr("Earlier versions are in mapwright overlays history.");
    return of->robot->failure(kIncomplete, doubt);
  }
  if (quiet) return kDone;
  if (outcome->merge.mine.empty() || (order.send && !outcome->sent)) {
    printLine(outcome->merge.mine.empty() ? Text::tr("Nothing to change.")
                                          : Text::tr("The robot holds this already."));
  } else if (order.send) {
    printLine(of->robot->local() ? Text::tr("Stored in the file, and read back.")
              : outcome->held.version
                  ? Text::tr("Stored on the robot as version %1, and read back.").arg(*outcome->held.version)
                  : Text::tr("Stored on the robot, and read back."));
  }
  return kDone;
}

CommandResult<int> changeIt(RobotCommand& command, const OverlaysArguments& args, bool send) {
  if (args.base.empty() && !args.replace)
    return wrong(send
                     ? Text::tr("Pass --base B.geojson, the file that you edited as overlays get wrote it, "
                                "so that what others change stays; or --replace to replace everything.")
                     : Text::tr("Pass --base B.geojson, the file that you edited as overlays get wrote it."));
  if (!args.base.empty() && args.replace) return wrong(Text::tr("Pass either --base or --replace."));
  if (isStandardInput(args.file) && isStandardInput(args.base))
    return wrong(Text::tr("Only one of the files can be the standard input."));
  const QString output = text(args.output);
  if (!output.isEmpty()) {
    if (const auto why = notCreatedReason(output, args.force)) return wrong(*why);
  }
  if (const auto why =
          notTogetherReason({output, text(args.report), args.json ? QStringLiteral("-") : QString()}))
    return sharedOutput(*why);
  jobs::OverlayOrder order;
  if (!args.base.empty()) {
    auto base = overlayFile(args.base);
    if (!base) return wrong(base.error());
    order.base = std::move(*base);
  }
  auto mine = wantedOverlays(args.file, order.base);
  if (!mine) return wrong(mine.error());
  order.mine = std::move(*mine);
  if (order.mine.text().size() > kMostSentBytes)
    return wrong(
        Text::tr("%1 is larger than 32 MiB: no robot could give it back.").arg(inputCalled(args.file)));
  order.send = send;
  order.may_empty = args.yes;
  return carryOut(command, args, std::move(order));
}

CommandResult<int> overlaysSet(RobotCommand& command, const OverlaysArguments& args) {
  return changeIt(command, args, !args.dry_run);
}
CommandResult<int> overlaysPlan(RobotCommand& command, const OverlaysArguments& args) {
  return changeIt(command, args, false);
}

tl::expected<std::set<overlays::Rule>, QString> rulesFrom(const std::string& typed) {
  std::set<overlays::Rule> rules;
  for (const QString& word : text(typed).split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const auto rule = overlays::ruleCalled(word.trimmed().toStdString());
    if (!rule) {
      QStringList names;
      for (int i = 0; i <= int(overlays::kLastRule); ++i)
        names << text(std::string(overlays::nameOf(overlays::Rule(i))));
      return tl::make_unexpected(Text::tr("--off %1: there is no such rule. Rules are: %2.")
                                     .arg(word.trimmed(), words::listed(names)));
    }
    rules.insert(*rule);
  }
  return rules;
}

/// The cells of the map below them, and the robot's radius. True if the map could be had.
CommandResult<bool> lookBelow(RobotReading& reading, const map::MapKey& key, std::optional<double> radius_m,
                              overlays::CheckOptions& options) {
  options.radius_m = radius_m ? *radius_m : robotRadius(reading);
  MapBelow below = mapBelow(reading, key);
  options.map = std::move(below.map);
  if (options.map.cells) return true;
  reading.lack(
      reading.about(Text::tr("Walls and reachability were not checked. %1").arg(below.unavailable_reason)));
  return false;
}

CommandResult<int> overlaysValidate(RobotCommand& command, const OverlaysArguments& args) {
  overlays::CheckOptions options;
  const auto off = rulesFrom(args.off);
  if (!off) return wrong(off.error());
  options.off = *off;
  const auto radius_m = radiusFrom(args.radius);
  if (!radius_m) return wrong(radius_m.error());
  if (const auto why = notTogetherReason({text(args.report), args.json ? QStringLiteral("-") : QString()}))
    return sharedOutput(*why);
  OverlayDocument document;
  if (!args.file.empty()) {
    auto read = overlayFile(args.file);
    if (!read) return wrong(read.error());
    document = std::move(*read);
    if (document.features().empty() && !OverlayDocument::isCollection(document.text()))
      return wrong(Text::tr("%1 is no GeoJSON FeatureCollection with a list of features.")
                       .arg(inputCalled(args.file)));
  }
  bool looked = true;
  if (args.file.empty()) {
    const auto of = openOverlays(command, args);
    if (!of) return passOn(of);
    const auto held = heldBy(*of);
    if (!held) return failureOf(*of, held.error());
    auto read = OverlayDocument::read(held->text);
    if (!read)
      return of->robot->failure(
          kUsage, Text::tr("Its overlays cannot be read. %1").arg(sentences::sentenceOf(read.error())));
    document = std::move(*read);
    const auto below = lookBelow(*of->robot, of->map, *radius_m, options);
    if (!below) return passOn(below);
    looked = *below;
  } else if (!args.robot.empty()) {
    const auto opened = command.open();
    if (!opened) return passOn(opened);
    const auto key = storedMap(**opened, args.map);
    if (!key) return passOn(key);
    const auto below = lookBelow(**opened, *key, *radius_m, options);
    if (!below) return passOn(below);
    looked = *below;
  } else if (!args.map.empty()) {
    return wrong(
        Text::tr("--map %1: pass --robot ADDRESS, too, or a map file as --robot.").arg(text(args.map)));
  } else if (!args.json) {
    say(Text::tr("Without --robot what lies on the map is not checked."));
  }
  const std::vector<overlays::Flaw> flaws = overlays::flawsOf(document, options);
  printFlaws(document, flaws, args.json);
  return flaws.empty() && looked ? kDone : kIncomplete;
}

CommandResult<int> historyList(const OverlaysArguments& args) {
  const auto versions = keptVersions(args.robot, args.map);
  if (!versions) return wrong(versions.error());
  printVersions(*versions, args.json);
  return kDone;
}

CommandResult<int> historyShow(const OverlaysArguments& args) {
  const QString output = text(args.output);
  if (!output.isEmpty()) {
    if (const auto why = notCreatedReason(output, args.force)) return wrong(*why);
  }
  const auto version = keptVersion(args.number);
  if (!version) return wrong(version.error());
  if (!output.isEmpty()) {
    if (const auto trouble = disk::writeFile(args.output, version->text, existingBy(args.force)))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
    return kDone;
  }
  const auto against = args.against.empty() ? versionBefore(version->about) : keptVersion(args.against);
  if (!against) return wrong(against.error());
  const auto before = OverlayDocument::read(against->text), after = OverlayDocument::read(version->text);
  if (!before || !after) return wrong(sentences::sentenceOf(before ? after.error() : before.error()));
  const auto changes = overlays::changesBetween(*before, *after);
  if (args.json) {
    printJson(changesJson(changes));
  } else if (changes.empty()) {
    printLine(Text::tr("Nothing differs."));
  } else {
    printChanges(changes, *before, *after);
  }
  return kDone;
}

CommandResult<int> historyRestore(RobotCommand& command, const OverlaysArguments& args) {
  const auto version = keptVersion(args.number);
  if (!version) return wrong(version.error());
  auto document = OverlayDocument::read(version->text);
  if (!document) return wrong(sentences::sentenceOf(document.error()));
  OverlaysArguments there = args;
  jobs::OverlayOrder order;
  if (there.map.empty()) {
    there.map = version->about.map.id;
    order.only_uid = version->about.map.uid;
  }
  order.mine = std::move(*document);
  order.send = !args.dry_run;
  return carryOut(command, there, std::move(order));
}

void addHistory(Commands& commands, CLI::App& overlays, const std::shared_ptr<OverlaysArguments>& shared) {
  OverlaysArguments& args = *shared;
  CLI::App* const history = overlays.add_subcommand(
      "history", help(Text::tr("Earlier versions seen on this computer: list, show, restore")));
  history->require_subcommand(1);
  const auto addNumber = [&](CLI::App* command) {
    command->add_option("number", args.number, help(Text::tr("Number of the version, see history list")))
        ->required();
  };
  const auto addOffline = [&](const char* name, const QString& what, auto run) {
    CLI::App* const command = history->add_subcommand(name, help(what));
    addJson(*command, args.json);
    commands.add(command, [shared, run](const Invocation& before) {
      if (shared->robot.empty()) shared->robot = before.robot;
      const CommandResult<int> result = run(*shared);
      return result ? *result : refuse(result.error().exit_code, result.error().sentence);
    });
    return command;
  };
  CLI::App* const list =
      addOffline("list", Text::tr("List the versions, newest first; needs no connection"), historyList);
  list->add_option("--robot", args.robot, help(Text::tr("Only of this robot (or MAPWRIGHT_ROBOT)")));
  list->add_option("--map", args.map, help(Text::tr("Only of this map: its id, uid or name")));
  CLI::App* const show =
      addOffline("show", Text::tr("Show what a version changed, or write it to a file"), historyShow);
  addNumber(show);
  show->add_option("--against", args.against,
                   help(Text::tr("Compare with this version, not with the one before it")))
      ->type_name("INT");
  show->add_option("-o,--output", args.output,
                   help(Text::tr("Write the version as GeoJSON; - is the standard output")));
  addForce(*show, args.force);
  CLI::App* const restore =
      addReading(commands, *history, "restore", Text::tr("Replace the robot's overlays with a version"),
                 Text::tr("Robot address (or MAPWRIGHT_ROBOT)"), shared, historyRestore);
  restore->add_option("--map", args.map, help(Text::tr("Id of a stored map; by default the version's own")));
  restore->add_flag("--dry-run", args.dry_run, help(Text::tr("Print the changes, send nothing")));
  addNumber(restore);
  addJson(*restore, args.json);
}

}  // namespace

void addOverlays(Commands& commands) {
  const auto shared = std::make_shared<OverlaysArguments>();
  OverlaysArguments& args = *shared;
  CLI::App* overlays = commands.program().add_subcommand(
      "overlays", help(Text::tr("Overlays of a map (walls, regions, doors, chargers): read, change, check")));
  overlays->require_subcommand(1);
  using Run = std::function<CommandResult<int>(RobotCommand&, const OverlaysArguments&)>;
  const auto add = [&](const char* name, const QString& what, Run run) {
    CLI::App* command = addReading(commands, *overlays, name, what,
                                   Text::tr("Robot address (or MAPWRIGHT_ROBOT)"), shared, std::move(run));
    command->add_option("--map", args.map, help(Text::tr("Id of a stored map; by default the current one")));
    return command;
  };
  CLI::App* get = add("get", Text::tr("Write the overlays to a file, byte for byte as the robot keeps them"),
                      overlaysGet);
  get->add_option("-o,--output", args.output, help(Text::tr("GeoJSON file; - is the standard output")))
      ->required();
  addForce(*get, args.force);
  const auto addFiles = [&](CLI::App* command) {
    command->add_option("file", args.file, help(Text::tr("The edited GeoJSON file; - is the standard input")))
        ->required();
    command->add_option(
        "--base", args.base,
        help(Text::tr("The file that overlays get wrote: only what differs from it is changed")));
    addJson(*command, args.json);
  };
  CLI::App* set = add("set", Text::tr("Merge your changes into the robot's overlays"), overlaysSet);
  addFiles(set);
  set->add_flag("--replace", args.replace,
                help(Text::tr("Replace all overlays of the robot, without a base")));
  set->add_flag("--yes", args.yes, help(Text::tr("Even if more features are deleted than kept")));
  set->add_flag("--dry-run", args.dry_run, help(Text::tr("Print the changes, send nothing")));
  CLI::App* plan =
      add("plan", Text::tr("Show what set would change and what conflicts; sends nothing"), overlaysPlan);
  addFiles(plan);
  plan->add_option("-o,--output", args.output,
                   help(Text::tr("Write the plan as JSON; - is the standard output")));
  addForce(*plan, args.force);
  CLI::App* validate =
      add("validate", Text::tr("Check a file or the robot's overlays; exit code 1 if there are flaws"),
          overlaysValidate);
  validate->add_option("file", args.file, help(Text::tr("GeoJSON file; by default the robot's overlays")));
  validate->add_option("--off", args.off, help(Text::tr("Rules to skip, separated by commas")));
  validate->add_option(
      "--radius", args.radius,
      help(Text::tr("Radius of the robot in metres; by default from its footprint, or 0.3")));
  addJson(*validate, args.json);
  addHistory(commands, *overlays, shared);
  addCarry(commands, *overlays, CarriedKind::Overlays);
}

}  // namespace mapwright::app
