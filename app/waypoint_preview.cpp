#include "app/waypoint_preview.h"

#include <cstdio>

#include <QCoreApplication>

#include "app/table.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(WaypointPreview)
};

}  // namespace

QJsonArray callsOf(const ListedWaypoints& list, const std::vector<WaypointEdit>& edits) {
  std::vector<robot::WaypointChange> changes;
  for (const WaypointEdit& edit : edits) changes.push_back({edit.key, edit.before, edit.after});
  return callsJson(*list.store, list.store->plan(list.stored, changes), list.map);
}

void printPreview(const ListedWaypoints& list, const MergedEdits& edits, bool json) {
  const std::vector<WaypointStep> steps = stepsOf(edits.edits);
  if (json) {
    printJson(QJsonObject{{QStringLiteral("changes"), stepsJson(steps, list.mapId())},
                          {QStringLiteral("calls"), callsOf(list, edits.edits)},
                          {QStringLiteral("conflicts"), conflictsJson(edits.conflicts, list.mapId())}});
    return;
  }
  std::vector<QStringList> table{
      {Words::tr("CHANGE"), Words::tr("ID"), Words::tr("NAME"), Words::tr("FROM NOW ON")}};
  for (const WaypointStep& step : steps) {
    const std::string id = step.id();
    table.push_back({wordOf(step.kind), id.empty() ? QStringLiteral("-") : words::plainName(id),
                     words::plainName(step.name()), detailOf(step)});
  }
  for (const QString& line : conflictLines(edits.conflicts))
    table.push_back({Words::tr("conflict"), QString(), QString(), line});
  if (table.size() > 1) {
    printTable(table);
  } else {
    std::printf("%s\n", qUtf8Printable(Words::tr("There is nothing to change.")));
  }
}

}  // namespace mapwright::app
