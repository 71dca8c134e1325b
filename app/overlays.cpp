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
#include "app/output.h"
#include "disk/written_file.h"
#include "jobs/change_overlays.h"
#include "overlays/overlay_check.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using overlays::ChangeKind;
using overlays::OverlayChange;
using overlays::OverlayConflict;
using overlays::OverlayDocument;
using words::text;

constexpr std::size_t kMostOverlayBytes = std::size_t(256) << 20;

/// The options as typed; empty = not given.
struct OverlaysArguments : RobotArguments {
  std::string map, file, base, output;
  std::string off, radius;  // validate
  bool force = false, replace = false, dry_run = false;
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
  return tl::make_unexpected(
      QStringLiteral("%1: %2").arg(inputCalled(path), sentences::sentenceOf(document.error())));
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
  if (args.map.empty()) {
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

CommandResult<int> overlaysGet(RobotCommand& command, const OverlaysArguments& args) {
  const QString output = text(args.output);
  const bool printed = isStandardOutput(output);
  if (const auto why = whyNotCreated(output, !printed && QFileInfo::exists(output), args.force))
    return wrong(*why);
  if (const auto why = whyNotTogether({output, text(args.report)})) return wrong(*why);
  const auto of = openOverlays(command, args);
  if (!of) return passOn(of);
  const auto held = of->robot->ask<robot::OverlayText>(
      [&](robot::OutcomeTo<robot::OverlayText> reply) { return of->store->read(of->map, std::move(reply)); });
  if (!held) return failureOf(*of, held.error());
  if (const auto trouble = disk::writeFile(args.output, held->text))
    return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  if (printed || isStandardOutput(text(args.report))) return kDone;
  const auto document = OverlayDocument::read(held->text);
  if (!document) {
    of->robot->note(of->robot->about(
        Text::tr("Its overlays cannot be read. %1").arg(sentences::sentenceOf(document.error()))));
    return kIncomplete;
  }
  const auto count = qint64(document->features().size());
  printLine(QStringLiteral("%1: %2").arg(
      oneLine(output),
      sentences::counted(Text::tr("%1 features", nullptr, sentences::formOf(count)), count)));
  return kDone;
}

QJsonValue textOrNull(const std::string& plain) {
  return plain.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(plain));
}

/// JSON as a value; what Qt cannot read (NaN) as a text.
QJsonValue valueOf(const std::optional<std::string>& json) {
  if (!json) return {};
  const QJsonDocument read = QJsonDocument::fromJson('[' + QByteArray::fromStdString(*json) + ']');
  return read.isArray() && read.array().size() == 1 ? read.array().first()
                                                    : QJsonValue(QString::fromStdString(*json));
}

/// For scripts, never changes (docs/command-line.md).
const char* stableWordOf(ChangeKind kind) {
  return kind == ChangeKind::Add ? "add" : kind == ChangeKind::Remove ? "remove" : "change";
}

QString wordOf(ChangeKind kind) {
  return kind == ChangeKind::Add      ? Text::tr("add")
         : kind == ChangeKind::Remove ? Text::tr("remove")
                                      : Text::tr("change");
}

QStringList partsOf(const OverlayChange& change) {
  QStringList parts;
  for (const overlays::PartChange& part : change.parts) parts << words::plainName(part.part.text());
  return parts;
}

QJsonArray changesJson(const std::vector<OverlayChange>& changes) {
  QJsonArray rows;
  for (const OverlayChange& change : changes) {
    rows << QJsonObject{{QStringLiteral("id"), textOrNull(change.id)},
                        {QStringLiteral("name"), textOrNull(change.name)},
                        {QStringLiteral("kind"), QLatin1String(stableWordOf(change.kind))},
                        {QStringLiteral("parts"), QJsonArray::fromStringList(partsOf(change))}};
  }
  return rows;
}

QJsonArray conflictsJson(const std::vector<OverlayConflict>& conflicts) {
  QJsonArray rows;
  for (const OverlayConflict& conflict : conflicts) {
    rows << QJsonObject{{QStringLiteral("id"), textOrNull(conflict.id)},
                        {QStringLiteral("name"), textOrNull(conflict.name)},
                        {QStringLiteral("property"), textOrNull(conflict.part.text())},
                        {QStringLiteral("base"), valueOf(conflict.base)},
                        {QStringLiteral("mine"), valueOf(conflict.mine)},
                        {QStringLiteral("theirs"), valueOf(conflict.theirs)}};
  }
  return rows;
}

/// Whether the robot holds what was wanted now; null: it cannot be told.
QJsonValue appliedIn(const jobs::OverlayOutcome& outcome, bool wanted) {
  if (!wanted || !outcome.merge.conflicts.empty()) return false;
  if (!outcome.sent || outcome.differs.empty()) return true;
  return outcome.version == outcome.version_before && outcome.version ? QJsonValue(false) : QJsonValue();
}

QJsonObject outcomeJson(const jobs::OverlayOutcome& outcome, bool wanted) {
  return {{QStringLiteral("changes"), changesJson(outcome.merge.mine)},
          {QStringLiteral("theirs"), qint64(outcome.merge.theirs.size())},
          {QStringLiteral("conflicts"), conflictsJson(outcome.merge.conflicts)},
          {QStringLiteral("applied"), appliedIn(outcome, wanted)},
          {QStringLiteral("version"), outcome.version ? QJsonValue(*outcome.version) : QJsonValue()}};
}

QString featureCalled(const std::string& id, const std::string& name) {
  return words::plainName(name.empty() ? id.empty() ? Text::tr("(no id)").toStdString() : id : name);
}

QString featuresCalled(const std::vector<OverlayChange>& changes) {
  constexpr std::size_t kMost = 5;
  QStringList names;
  for (const OverlayChange& change : changes) {
    if (names.size() == qsizetype(kMost)) break;
    names << (change.collection ? Text::tr("the collection") : featureCalled(change.id, change.name));
  }
  if (changes.size() > kMost) names << QStringLiteral("…");
  return names.join(QStringLiteral(", "));
}

void printTables(const jobs::OverlayOutcome& outcome) {
  if (!outcome.merge.mine.empty()) {
    std::vector<QStringList> table{{Text::tr("CHANGE"), Text::tr("ID"), Text::tr("PARTS"), Text::tr("NAME")}};
    for (const OverlayChange& change : outcome.merge.mine) {
      table.push_back(
          {wordOf(change.kind), change.id.empty() ? QStringLiteral("-") : words::plainName(change.id),
           change.parts.empty() ? QStringLiteral("-") : partsOf(change).join(QStringLiteral(", ")),
           change.collection ? Text::tr("the collection") : words::plainName(change.name)});
    }
    printTable(table);
  }
  if (outcome.merge.conflicts.empty()) return;
  const auto shown = [](const std::optional<std::string>& json) {
    return json ? oneLine(words::plainName(*json), 60) : Text::tr("(not there)");
  };
  std::vector<QStringList> table{
      {Text::tr("CONFLICT"), Text::tr("BASE"), Text::tr("MINE"), Text::tr("THEIRS"), Text::tr("NAME")}};
  for (const OverlayConflict& conflict : outcome.merge.conflicts) {
    table.push_back(
        {conflict.part.text().empty() ? Text::tr("all of it") : words::plainName(conflict.part.text()),
         shown(conflict.base), shown(conflict.mine), shown(conflict.theirs),
         featureCalled(conflict.id, conflict.name)});
  }
  printTable(table);
}

/// What became of what was sent, if that is not certain; otherwise empty.
QString doubtOf(const jobs::OverlayOutcome& outcome) {
  using Between = jobs::OverlayOutcome::Between;
  const auto version = [](const std::optional<int>& number) {
    return number ? QString::number(*number) : QString();
  };
  QStringList sentences;
  if (outcome.between == Between::Somebody) {
    sentences << Text::tr(
                     "Somebody else changed the overlays between the look and the request: their version "
                     "went from %1 to %2.")
                     .arg(version(outcome.version_before), version(outcome.version));
    if (outcome.differs.empty())
      sentences << Text::tr("What the others changed was overwritten, and cannot be seen any more.");
  } else if (outcome.between == Between::Unknown) {
    sentences << Text::tr(
        "The robot does not count the versions of its overlays: whether somebody else changed them meanwhile "
        "cannot be told.");
  }
  if (!outcome.differs.empty())
    sentences << Text::tr("The robot holds something else than was sent (%1).")
                     .arg(featuresCalled(outcome.differs));
  return sentences.join(QLatin1Char(' '));
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
    if (const auto why = whyNotWritable(output)) return wrong(*why);
    if (const auto why = overOwnSource({output}, {args.file, args.base}); why && !args.force)
      return wrong(*why);
  }
  if (const auto why =
          whyNotTogether({output, text(args.report), args.json ? QStringLiteral("-") : QString()}))
    return wrong(*why);
  jobs::OverlayOrder order;
  auto mine = overlayFile(args.file);
  if (!mine) return wrong(mine.error());
  order.mine = std::move(*mine);
  if (!args.base.empty()) {
    auto base = overlayFile(args.base);
    if (!base) return wrong(base.error());
    order.base = std::move(*base);
  }
  order.send = send;
  const auto of = openOverlays(command, args);
  if (!of) return passOn(of);
  order.map = of->map;
  const auto outcome =
      of->robot->ask<jobs::OverlayOutcome>([&](robot::OutcomeTo<jobs::OverlayOutcome> reply) {
        return jobs::changeOverlays(*of->store, order, std::move(reply));
      });
  if (!outcome) return failureOf(*of, outcome.error());
  const QJsonObject json = outcomeJson(*outcome, send);
  command.report(QStringLiteral("overlays"), json);
  if (!output.isEmpty()) {
    if (const auto trouble = disk::writeFile(args.output, QJsonDocument(json).toJson().toStdString()))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  }
  if (args.json) printJson(json);
  const bool quiet = args.json || isStandardOutput(output) || isStandardOutput(text(args.report));
  if (!quiet) printTables(*outcome);
  if (!outcome->merge.conflicts.empty()) {
    const auto count = qint64(outcome->merge.conflicts.size());
    return of->robot->failure(
        kRobotError,
        sentences::counted(Text::tr("Nothing was sent: %1 conflicts with what others changed since the base.",
                                    nullptr, sentences::formOf(count)),
                           count));
  }
  if (const QString doubt = outcome->certain() ? QString() : doubtOf(*outcome); !doubt.isEmpty())
    return of->robot->failure(kIncomplete, doubt);
  if (quiet) return kDone;
  if (outcome->merge.mine.empty() || (send && !outcome->sent)) {
    printLine(outcome->merge.mine.empty() ? Text::tr("Nothing to change.")
                                          : Text::tr("The robot holds this already."));
  } else if (send) {
    printLine(outcome->version
                  ? Text::tr("Stored on the robot as version %1, and read back.").arg(*outcome->version)
                  : Text::tr("Stored on the robot, and read back."));
  }
  return kDone;
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
                                     .arg(word.trimmed(), names.join(QStringLiteral(", "))));
    }
    rules.insert(*rule);
  }
  return rules;
}

void printFlaws(const OverlayDocument& document, const std::vector<overlays::Flaw>& flaws, bool json) {
  if (json) {
    QJsonArray rows;
    for (const overlays::Flaw& flaw : flaws) {
      const overlays::Feature& feature = document.features()[flaw.feature];
      rows << QJsonObject{{QStringLiteral("rule"), text(std::string(overlays::nameOf(flaw.rule)))},
                          {QStringLiteral("id"), textOrNull(feature.id())},
                          {QStringLiteral("name"), textOrNull(feature.name())},
                          {QStringLiteral("at"),
                           flaw.at_m ? QJsonValue(QJsonArray{flaw.at_m->x(), flaw.at_m->y()}) : QJsonValue()},
                          {QStringLiteral("sentence"), sentences::sentenceOf(flaw.why)}};
    }
    printJson(rows);
    return;
  }
  if (flaws.empty()) {
    printLine(Text::tr("No flaws."));
    return;
  }
  const auto metres = [](double value) { return QString::number(value, 'f', 2); };
  std::vector<QStringList> table{
      {Text::tr("RULE"), Text::tr("X (m)"), Text::tr("Y (m)"), Text::tr("FEATURE"), Text::tr("FLAW")}};
  for (const overlays::Flaw& flaw : flaws) {
    const overlays::Feature& feature = document.features()[flaw.feature];
    table.push_back({text(std::string(overlays::nameOf(flaw.rule))),
                     flaw.at_m ? metres(flaw.at_m->x()) : QStringLiteral("-"),
                     flaw.at_m ? metres(flaw.at_m->y()) : QStringLiteral("-"),
                     oneLine(featureCalled(feature.id(), feature.name()), 40),
                     words::plainName(sentences::sentenceOf(flaw.why))});
  }
  printTable(table);
}

/// The cells of the map below them, and the robot's radius. True if the map could be had.
CommandResult<bool> lookBelow(RobotReading& reading, const map::MapKey& key, std::optional<double> radius_m,
                              overlays::CheckOptions& options) {
  options.radius_m = radius_m ? *radius_m : robotRadius(reading);
  MapBelow below = mapBelow(reading, key);
  options.map = std::move(below.map);
  if (options.map.cells) return true;
  reading.note(reading.about(
      Text::tr("The map cannot be loaded, so what lies on it was not checked. %1").arg(below.why_not)));
  return false;
}

CommandResult<int> overlaysValidate(RobotCommand& command, const OverlaysArguments& args) {
  overlays::CheckOptions options;
  const auto off = rulesFrom(args.off);
  if (!off) return wrong(off.error());
  options.off = *off;
  const auto radius_m = radiusFrom(args.radius);
  if (!radius_m) return wrong(radius_m.error());
  if (const auto why = whyNotTogether({text(args.report), args.json ? QStringLiteral("-") : QString()}))
    return wrong(*why);
  OverlayDocument document;
  if (!args.file.empty()) {
    auto read = overlayFile(args.file);
    if (!read) return wrong(read.error());
    document = std::move(*read);
  }
  bool looked = true;
  if (args.file.empty()) {
    const auto of = openOverlays(command, args);
    if (!of) return passOn(of);
    const auto held = of->robot->ask<robot::OverlayText>([&](robot::OutcomeTo<robot::OverlayText> reply) {
      return of->store->read(of->map, std::move(reply));
    });
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

}  // namespace

void addOverlays(Commands& commands) {
  const auto shared = std::make_shared<OverlaysArguments>();
  OverlaysArguments& args = *shared;
  CLI::App* overlays = commands.program().add_subcommand(
      "overlays", help(Text::tr("Overlays of a map (walls, regions, doors, chargers): read, change, check")));
  overlays->require_subcommand(1);
  using Run = std::function<CommandResult<int>(RobotCommand&, const OverlaysArguments&)>;
  const auto add = [&](const char* name, const QString& what, Run run) {
    CLI::App* command = overlays->add_subcommand(name, help(what));
    addRobot(*command, args, Text::tr("Robot address (or MAPWRIGHT_ROBOT)"));
    addTimeout(*command, args.timeout_s);
    addReport(*command, args.report);
    command->add_option("--map", args.map, help(Text::tr("Id of a stored map; by default the current one")));
    addReading(commands, command, shared, std::move(run));
    return command;
  };
  CLI::App* get = add("get", Text::tr("Write the overlays to a file, byte for byte as the robot keeps them"),
                      overlaysGet);
  get->add_option("-o,--output", args.output, help(Text::tr("GeoJSON file; - is the standard output")))
      ->required();
  get->add_flag("--force", args.force, help(Text::tr("Replace an existing file")));
  const auto addFiles = [&](CLI::App* command) {
    command->add_option("file", args.file, help(Text::tr("The edited GeoJSON file; - is the standard input")))
        ->required();
    command->add_option(
        "--base", args.base,
        help(Text::tr("The file as overlays get wrote it: only what differs from it is changed")));
    addJson(*command, args.json);
  };
  CLI::App* set =
      add("set", Text::tr("Change the overlays on the robot: merge, store, read back"), overlaysSet);
  addFiles(set);
  set->add_flag("--replace", args.replace,
                help(Text::tr("Replace everything that the robot holds, without a base")));
  set->add_flag("--dry-run", args.dry_run, help(Text::tr("Print the changes, send nothing")));
  CLI::App* plan =
      add("plan", Text::tr("Show what set would change and what conflicts; sends nothing"), overlaysPlan);
  addFiles(plan);
  plan->add_option("-o,--output", args.output, help(Text::tr("Write it as JSON; - is the standard output")));
  plan->add_flag("--force", args.force, help(Text::tr("Overwrite one of the files that were read")));
  CLI::App* validate =
      add("validate", Text::tr("Check a file, or what the robot holds; exit code 1 when there are flaws"),
          overlaysValidate);
  validate->add_option("file", args.file, help(Text::tr("GeoJSON file; by default what the robot holds")));
  validate->add_option("--off", args.off, help(Text::tr("Rules that are not checked, separated by commas")));
  validate->add_option(
      "--radius", args.radius,
      help(Text::tr("Radius of the robot in metres; by default from its footprint, or 0.3")));
  addJson(*validate, args.json);
}

}  // namespace mapwright::app
