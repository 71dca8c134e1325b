#include "app/kept_overlays.h"

#include <algorithm>
#include <charconv>

#include <QDateTime>
#include <QJsonObject>
#include <QStandardPaths>

#include "app/command_text.h"
#include "app/output.h"
#include "app/overlay_output.h"
#include "app/robot_factory.h"
#include "sentences/fault_sentence.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using history::VersionStore;
using words::text;

tl::expected<VersionStore, Fault> openVersions() { return VersionStore::open(overlaysHistory()); }

tl::unexpected<QString> sentence(const Fault& fault) {
  return tl::make_unexpected(sentences::sentenceOf(fault));
}

}  // namespace

std::string overlaysHistory() {
  return (QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
          QStringLiteral("/mapwright/overlays.sqlite"))
      .toStdString();
}

void KeptOverlays::keep(const robot::OverlayText& held, bool saved) {
  const std::string robot = robot_.session().robot().address().toStdString();
  auto store = openVersions();
  const std::optional<Fault> why =
      store ? store->keep(history::mapName(robot, map::toText(map_), held.map_uid, held.map_name),
                          held.version, saved ? history::Origin::Saved : history::Origin::Read, held.text,
                          double(QDateTime::currentMSecsSinceEpoch()) / 1000)
            : store.error();
  if (why && !std::exchange(failed_, true)) robot_.addRemark(robot_.about(sentences::sentenceOf(*why)));
}

tl::expected<std::vector<history::KeptVersion>, QString> keptVersions(const std::string& robot,
                                                                      const std::string& map) {
  const auto store = openVersions();
  if (!store) return sentence(store.error());
  std::string address = robot;
  if (const auto parsed = knownAddresses().parse(text(robot)); parsed && !robot.empty())
    address = parsed->text.toStdString();
  auto versions = store->list(address, {});
  if (!versions) return sentence(versions.error());
  std::erase_if(*versions, [&](const history::KeptVersion& version) {
    const history::MapName& of = version.map;
    return !map.empty() && of.uid != map && of.id != map && of.name != map;
  });
  return std::move(*versions);
}

tl::expected<WholeVersion, QString> keptVersion(const std::string& number) {
  std::int64_t which = 0;
  const char* const end = number.data() + number.size();
  const auto [read_to, problem] = std::from_chars(number.data(), end, which);
  if (problem != std::errc() || read_to != end)
    return tl::make_unexpected(
        Text::tr("%1: give the number of a version (see mapwright overlays history list).")
            .arg(text(number)));
  const auto store = openVersions();
  if (!store) return sentence(store.error());
  const auto found = store->find(which);
  if (!found) return sentence(found.error());
  auto whole = store->text(which);
  if (!whole) return sentence(whole.error());
  return WholeVersion{**found, std::move(*whole)};
}

tl::expected<WholeVersion, QString> versionBefore(const history::KeptVersion& version) {
  const auto store = openVersions();
  if (!store) return sentence(store.error());
  const auto versions = store->list(version.map.robot, version.map.uid);
  if (!versions) return sentence(versions.error());
  const auto before = std::find_if(versions->begin(), versions->end(), [&](const history::KeptVersion& one) {
    return one.number < version.number;
  });
  if (before == versions->end()) return WholeVersion{};
  auto whole = store->text(before->number);
  if (!whole) return sentence(whole.error());
  return WholeVersion{*before, std::move(*whole)};
}

void printVersions(const std::vector<history::KeptVersion>& versions, bool json) {
  const auto origin = [](const history::KeptVersion& version) {
    return version.origin == history::Origin::Saved;
  };
  if (json) {
    QJsonArray rows;
    for (const history::KeptVersion& version : versions) {
      rows << QJsonObject{
          {QStringLiteral("number"), qint64(version.number)},
          {QStringLiteral("robot"), text(version.map.robot)},
          {QStringLiteral("map"), text(version.map.id)},
          {QStringLiteral("uid"), text(version.map.uid)},
          {QStringLiteral("name"), textOrNull(version.map.name)},
          {QStringLiteral("version"), version.version ? QJsonValue(*version.version) : QJsonValue()},
          {QStringLiteral("at"), version.kept_s},
          {QStringLiteral("kept"), origin(version) ? QStringLiteral("saved") : QStringLiteral("read")},
          {QStringLiteral("bytes"), qint64(version.bytes)}};
    }
    printJson(rows);
    return;
  }
  if (versions.empty()) {
    printLine(Text::tr("No versions are kept here."));
    return;
  }
  std::vector<QStringList> table{{Text::tr("NUMBER"), Text::tr("DATE"), Text::tr("VERSION"),
                                  Text::tr("KEPT WHEN"), Text::tr("BYTES"), Text::tr("MAP"),
                                  Text::tr("ROBOT"), Text::tr("NAME")}};
  for (const history::KeptVersion& version : versions) {
    table.push_back({QString::number(version.number),
                     QDateTime::fromMSecsSinceEpoch(qint64(version.kept_s * 1000))
                         .toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
                     version.version ? QString::number(*version.version) : QStringLiteral("-"),
                     origin(version) ? Text::tr("saved") : Text::tr("read"), QString::number(version.bytes),
                     words::plainName(version.map.id), words::plainName(version.map.robot),
                     words::plainName(version.map.name)});
  }
  printTable(table);
}

}  // namespace mapwright::app
