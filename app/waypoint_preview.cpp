#include "app/waypoint_preview.h"

#include <cstdio>

#include <QCoreApplication>

#include "app/table.h"
#include "app/waypoint_warnings.h"
#include "words/qt_plain.h"

namespace mapwright::app {
namespace {

class WaypointPreviewText {
  Q_DECLARE_TR_FUNCTIONS(WaypointPreview)
};

QJsonArray doubtsJson(const DoubtsAhead& doubts) {
  QJsonArray rows;
  for (const DoubtAhead& one : doubts) {
    rows << QJsonObject{
        {QStringLiteral("id"), one.id.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(one.id))},
        {QStringLiteral("name"), QString::fromStdString(one.name)},
        {QStringLiteral("warnings"), warningsJson(one.warnings)}};
  }
  return rows;
}

std::set<edit::Key> refusedOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits) {
  return edit::refusedNames(exchange::itemsOf(list.stored.points), edits, list.store->keeps());
}

QJsonArray refusedJson(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits) {
  const std::set<edit::Key> refused = refusedOf(list, edits);
  QJsonArray rows;
  for (const exchange::WaypointEdit& edit : edits) {
    if (!refused.contains(edit.key)) continue;
    rows << QJsonObject{
        {QStringLiteral("id"), edit.before ? QJsonValue(QString::fromStdString(edit.key)) : QJsonValue()},
        {QStringLiteral("name"), QString::fromStdString(edit.after->name)}};
  }
  return rows;
}

QJsonObject previewJson(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                        const std::optional<DoubtsAhead>& doubts) {
  QJsonObject json{
      {QStringLiteral("changes"), exchange::stepsJson(exchange::stepsOf(edits.edits), list.mapId())},
      {QStringLiteral("calls"), callsOf(list, edits.edits)},
      {QStringLiteral("conflicts"), exchange::conflictsJson(edits.conflicts, list.mapId())}};
  if (const QJsonArray refused = refusedJson(list, edits.edits); !refused.isEmpty())
    json[QStringLiteral("refused")] = refused;
  if (doubts) json[QStringLiteral("warnings")] = doubtsJson(*doubts);
  return json;
}

}  // namespace

QJsonArray callsOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits) {
  const std::set<edit::Key> refused = refusedOf(list, edits);
  std::vector<robot::WaypointChange> changes;
  for (const exchange::WaypointEdit& edit : edits) {
    if (!refused.contains(edit.key)) changes.push_back({edit.key, edit.before, edit.after});
  }
  return exchange::callsJson(*list.store, list.store->plan(list.stored, changes), list.map);
}

QJsonObject previewReport(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                          const std::optional<DoubtsAhead>& doubts) {
  QJsonObject report = previewJson(list, edits, doubts);
  report[QStringLiteral("dry_run")] = true;
  report[QStringLiteral("map")] = QString::fromStdString(list.mapId());
  return report;
}

void printPreview(const ListedWaypoints& list, const exchange::MergedEdits& edits, bool json,
                  const std::optional<DoubtsAhead>& doubts) {
  const std::vector<exchange::WaypointStep> steps = exchange::stepsOf(edits.edits);
  if (json) {
    printJson(previewJson(list, edits, doubts));
    return;
  }
  std::vector<QStringList> table{{WaypointPreviewText::tr("CHANGE"), WaypointPreviewText::tr("ID"),
                                  WaypointPreviewText::tr("NAME"), WaypointPreviewText::tr("NEW VALUE")}};
  for (const exchange::WaypointStep& step : steps) {
    const std::string id = step.id();
    table.push_back({wordOf(step.kind), id.empty() ? QStringLiteral("-") : words::plainName(id),
                     words::plainName(step.name()), exchange::detailOf(step)});
  }
  for (const QString& line : exchange::conflictLines(edits.conflicts))
    table.push_back({WaypointPreviewText::tr("conflict"), QString(), QString(), line});
  if (const QString why = exchange::refusedText(refusedOf(list, edits.edits), edits.edits); !why.isEmpty())
    table.push_back({WaypointPreviewText::tr("refused"), QString(), QString(), why});
  const bool changes = table.size() > 1;
  for (const DoubtAhead& one : doubts.value_or(DoubtsAhead())) {
    table.push_back({WaypointPreviewText::tr("warning"),
                     one.id.empty() ? QStringLiteral("-") : words::plainName(one.id),
                     words::plainName(one.name), warningsLine(one.warnings)});
  }
  if (table.size() > 1) {
    if (!changes) std::printf("%s\n", qUtf8Printable(WaypointPreviewText::tr("There is nothing to change.")));
    printTable(table);
  } else {
    std::printf("%s\n", qUtf8Printable(WaypointPreviewText::tr("There is nothing to change.")));
  }
}

}  // namespace mapwright::app
