#include "app/overlay_output.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "app/command_text.h"
#include "app/output.h"
#include "overlays/overlay_sentence.h"
#include "sentences/fault_sentence.h"
#include "words/fixed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using overlays::ChangeKind;
using overlays::OverlayChange;
using overlays::OverlayConflict;
using overlays::OverlayDocument;
using words::text;

/// JSON as a value; what Qt cannot read (NaN) as a text.
QJsonValue valueOf(const std::optional<std::string>& json) {
  if (!json) return {};
  const QJsonDocument read = QJsonDocument::fromJson('[' + QByteArray::fromStdString(*json) + ']');
  return read.isArray() && read.array().size() == 1 ? read.array().first()
                                                    : QJsonValue(QString::fromStdString(*json));
}

/// For scripts, never changes (docs/json.md).
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

}  // namespace

QJsonValue textOrNull(const std::string& plain) {
  return plain.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(plain));
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

void printChanges(const std::vector<OverlayChange>& changes, const OverlayDocument& before,
                  const OverlayDocument& after) {
  if (changes.empty()) return;
  std::vector<QStringList> table{{Text::tr("CHANGE"), Text::tr("ID"), Text::tr("WHAT")}};
  for (const OverlayChange& change : changes) {
    table.push_back({wordOf(change.kind),
                     change.id.empty() ? QStringLiteral("-") : words::plainName(change.id),
                     overlays::changeText(change, before, after)});
  }
  printTable(table);
}

void printConflicts(const std::vector<OverlayConflict>& conflicts) {
  if (conflicts.empty()) return;
  std::vector<QStringList> table{
      {Text::tr("CONFLICT"), Text::tr("BASE"), Text::tr("MINE"), Text::tr("THEIRS"), Text::tr("NAME")}};
  for (const OverlayConflict& conflict : conflicts) {
    const auto shown = [&](const std::optional<std::string>& json) {
      return overlays::valueText(conflict.part, json);
    };
    table.push_back({overlays::partName(conflict.part),
                     conflict.base ? shown(conflict.base) : Text::tr("(not there)"), shown(conflict.mine),
                     shown(conflict.theirs), overlays::featureCalled(conflict.id, conflict.name)});
  }
  printTable(table);
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
  const auto metres = [](double value) { return words::fixed(value, 2); };
  std::vector<QStringList> table{
      {Text::tr("RULE"), Text::tr("X (m)"), Text::tr("Y (m)"), Text::tr("FEATURE"), Text::tr("FLAW")}};
  for (const overlays::Flaw& flaw : flaws) {
    const overlays::Feature& feature = document.features()[flaw.feature];
    table.push_back({text(std::string(overlays::nameOf(flaw.rule))),
                     flaw.at_m ? metres(flaw.at_m->x()) : QStringLiteral("-"),
                     flaw.at_m ? metres(flaw.at_m->y()) : QStringLiteral("-"),
                     oneLine(overlays::featureCalled(feature.id(), feature.name()), 40),
                     words::plainName(sentences::sentenceOf(flaw.why))});
  }
  printTable(table);
}

}  // namespace mapwright::app
