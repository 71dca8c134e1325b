#include "app/maps_change.h"

#include <cstdio>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/maps_command.h"
#include "app/output_paths.h"
#include "app/report.h"
#include "jobs/change_map.h"
#include "robot/map_dispatch.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class MapsChangeText {
  Q_DECLARE_TR_FUNCTIONS(MapsChange)
};

using Entry = map::CatalogueEntry;
using robot::MapChange;

using words::text;

bool isOfOneMap(MapChange change) {
  return change != MapChange::StartMapping && change != MapChange::StopMapping && change != MapChange::Save;
}

bool names(MapChange change) { return change == MapChange::Rename || change == MapChange::Save; }

/// Why it is not even requested; empty if it is.
QString whyNotAsked(MapChange change, const MapsWords& words) {
  if (names(change)) {
    const QString label = text(words.label);
    if (label.trimmed().isEmpty()) {
      return change == MapChange::Save ? MapsChangeText::tr("Name the map: maps save NAME.")
                                       : MapsChangeText::tr("Name the map: maps rename ID NAME.");
    }
    if (const QString why = jobs::whyNoMapName(label); !why.isEmpty()) return why;
  }
  const map::MapKey key = map::mapKeyFromText(words.id);
  if (isOfOneMap(change) && (key.kind != map::MapKind::Stored || key.id.empty()))
    return MapsChangeText::tr("%1: pass the id of a stored map (see mapwright maps list).")
        .arg(text(words.id));
  if (change == MapChange::Delete && !words.yes)
    return MapsChangeText::tr("Deleting a map cannot be undone. Pass --yes to delete %1.")
        .arg(text(words.id));
  return {};
}

void print(const Entry& entry, bool json) {
  if (json) {
    printJson(entryJson(entry));
  } else if (!entry.key.id.empty()) {
    std::printf("%s  %s\n", qUtf8Printable(words::plainName(map::toText(entry.key))),
                qUtf8Printable(words::plainName(entry.name)));
  }
}

}  // namespace

int mapsChange(MapChange change, const MapsWords& words, int& argc, char** argv) {
  const auto work = [&](MapsCommand& command) -> CommandResult<int> {
    const auto wrong = [](int code, const QString& sentence) {
      return tl::make_unexpected(CommandFailure{code, sentence});
    };
    if (const QString why = whyNotAsked(change, words); !why.isEmpty()) return wrong(kUsage, why);
    const auto access = RobotAccess::read(words.access, text(words.robot));
    if (!access) return wrong(kUsage, access.error());
    const QString address = text(words.robot);
    auto robot = command.open(address, access->forAddress(address), MapReading::Purpose::Maps);
    if (!robot) return tl::make_unexpected(robot.error());
    robot::MapOrder order{.change = change};
    if (isOfOneMap(change)) order.key = map::mapKeyFromText(words.id);
    if (names(change)) order.name = words.label;
    if (change == MapChange::Load) order.place = words.place;
    const auto entry = (*robot)->change(order);
    if (!entry) return tl::make_unexpected(entry.error());
    print(*entry, words.json);
    const QString odd = jobs::oddity(order, *entry);
    if (odd.isEmpty()) return kDone;
    return wrong(kIncomplete, QStringLiteral("%1: %2").arg(address, odd));
  };
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

int mapsSaveOnRobot(const MapsWords& words, int& argc, char** argv) {
  const auto work = [&](MapsCommand& command) -> CommandResult<int> {
    const auto wrong = [](int code, const QString& sentence) {
      return tl::make_unexpected(CommandFailure{code, sentence});
    };
    if (const QString why = jobs::whyNoFilename(text(words.filename)); !why.isEmpty())
      return wrong(kUsage, why);
    const auto access = RobotAccess::read(words.access, text(words.robot));
    if (!access) return wrong(kUsage, access.error());
    const QString address = text(words.robot);
    auto robot = command.open(address, access->forAddress(address), MapReading::Purpose::Maps);
    if (!robot) return tl::make_unexpected(robot.error());
    robot::MapDispatch* const dispatch = (*robot)->session().robot().mapDispatch();
    if (!dispatch) return tl::make_unexpected((*robot)->lacks(robot::Capability::Dispatch));
    const auto saved = (*robot)->ask<std::string>([&](robot::OutcomeTo<std::string> reply) {
      return dispatch->save(words.filename, std::move(reply));
    });
    if (!saved) return tl::make_unexpected((*robot)->failure(saved.error()));
    std::printf("%s\n",
                qUtf8Printable(MapsChangeText::tr("The robot wrote %1.").arg(words::plainName(*saved))));
    return kDone;
  };
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

}  // namespace mapwright::app
