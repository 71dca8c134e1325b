#include "app/maps_change.h"

#include <cstdio>
#include <functional>

#include <QCoreApplication>
#include <QJsonDocument>

#include "app/exit_code.h"
#include "app/maps_command.h"
#include "app/report.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(MapsChange)
};

using Entry = map::CatalogueEntry;
using Ask =
    std::function<robot::Call(robot::MapAdministration&, const map::MapKey&, robot::OutcomeTo<Entry>)>;

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

CommandResult<Entry> changed(MapsCommand& command, const MapsWords& words, const Ask& ask) {
  const auto wrong = [](const QString& sentence) {
    return tl::make_unexpected(CommandFailure{kUsage, sentence});
  };
  const map::MapKey key = map::mapKeyFromText(words.id);
  if (key.kind != map::MapKind::Stored || key.id.empty()) {
    return wrong(Words::tr("%1: give the id of a stored map (mapwright maps list).").arg(text(words.id)));
  }
  const auto access = RobotAccess::read(words.access, text(words.robot));
  if (!access) return wrong(access.error());
  const QString address = text(words.robot);
  auto robot = command.open(address, access->forAddress(address), MapReading::Purpose::Maps);
  if (!robot) return tl::make_unexpected(robot.error());
  return (*robot)->change(
      [&](robot::MapAdministration& maps, robot::OutcomeTo<Entry> reply) { return ask(maps, key, reply); });
}

void print(const Entry& entry, bool json) {
  if (json) {
    std::printf("%s", words::escapedJson(QJsonDocument(entryJson(entry)).toJson()).constData());
  } else {
    std::printf("%s  %s\n", qUtf8Printable(words::plainName(map::toText(entry.key))),
                qUtf8Printable(words::plainName(entry.name)));
  }
}

int run(const MapsWords& words, int& argc, char** argv,
        const std::function<CommandResult<int>(MapsCommand&)>& work) {
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

}  // namespace

int mapsRename(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const QString label = text(words.label);
    if (std::any_of(label.begin(), label.end(),
                    [](QChar c) { return c.category() == QChar::Other_Control; })) {
      return tl::make_unexpected(CommandFailure{
          kUsage, Words::tr("The name of a map is one line of text, without control characters.")});
    }
    if (label.trimmed().isEmpty()) {
      return tl::make_unexpected(
          CommandFailure{kUsage, Words::tr("A map must have a name: maps rename ID NAME.")});
    }
    const auto entry =
        changed(command, words, [&](robot::MapAdministration& maps, const map::MapKey& key, auto reply) {
          return maps.rename(key, words.label, reply);
        });
    if (!entry) return tl::make_unexpected(entry.error());
    print(*entry, words.json);
    if (entry->name == words.label) return kDone;
    return tl::make_unexpected(CommandFailure{
        kIncomplete, Words::tr("%1: The robot took it, but says that the map is called \"%2\".")
                         .arg(text(words.robot), words::plainName(entry->name))});
  });
}

int mapsLoad(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto entry =
        changed(command, words, [](robot::MapAdministration& maps, const map::MapKey& key, auto reply) {
          return maps.load(key, reply);
        });
    if (!entry) return tl::make_unexpected(entry.error());
    print(*entry, words.json);
    if (entry->is_current) return kDone;
    return tl::make_unexpected(CommandFailure{
        kIncomplete,
        Words::tr("%1: The robot took it, but says that it works with another map.").arg(text(words.robot))});
  });
}

}  // namespace mapwright::app
