#include "ui/waypoints/waypoint_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "map/waypoint.h"
#include "sentences/failure_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/status_text.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

struct WaypointsText {
  Q_DECLARE_TR_FUNCTIONS(mapwright::ui::Waypoints)
};

QString fieldsText(const std::optional<map::Waypoint>& point, edit::FieldMask fields) {
  using namespace edit::waypoint_field;
  if (!point) return WaypointsText::tr("deleted");
  QStringList parts;
  if (fields & kName) parts << WaypointsText::tr("name “%1”").arg(shortWaypointName(*point));
  if (fields & kPosition)
    parts << WaypointsText::tr("position %1, %2 m")
                 .arg(words::fixed(point->position_m.x(), 3), words::fixed(point->position_m.y(), 3));
  if (fields & kYaw)
    parts << (point->yaw_rad ? WaypointsText::tr("heading %1").arg(yawText(point->yaw_rad))
                             : WaypointsText::tr("no heading"));
  if (fields & kTags)
    parts << (point->tags.empty() ? WaypointsText::tr("no tags")
                                  : WaypointsText::tr("tags %1").arg(tagsText(point->tags)));
  if (fields & kType) parts << WaypointsText::tr("type %1").arg(plainWords(point->type, 40));
  return parts.isEmpty() ? WaypointsText::tr("unchanged") : words::listed(parts);
}

QString shown(const std::string& name) {
  map::Waypoint point;
  point.name = name;
  return shortWaypointName(point);
}

}  // namespace

QString tagsText(const std::vector<std::string>& tags) {
  QStringList texts;
  for (const std::string& tag : tags) texts << words::plainName(tag);
  return words::listed(texts);
}

std::vector<std::string> tagsFrom(const QString& text) {
  std::vector<std::string> tags;
  for (const QString& tag : text.split(QLatin1Char(','))) {
    if (!tag.trimmed().isEmpty()) tags.push_back(tag.trimmed().toStdString());
  }
  return tags;
}

QString waypointsText(qsizetype count) {
  return sentences::counted(WaypointsText::tr("%1 waypoints", nullptr, sentences::formOf(count)), count);
}

QString changesText(qsizetype count) {
  return sentences::counted(WaypointsText::tr("%1 changes", nullptr, sentences::formOf(count)), count);
}

QString stateText(const edit::ItemState& state) {
  if (state.changed_elsewhere)
    return WaypointsText::tr("Changed here and elsewhere: choose which version to keep.");
  if (state.sent) return WaypointsText::tr("Sent, not confirmed yet.");
  return state.unsaved ? WaypointsText::tr("Not saved yet.") : QString();
}

int pendingOf(const edit::ItemState& state, const map::Waypoint* kept, const map::Waypoint* now) {
  using namespace edit::waypoint_field;
  int pending = state.changed_elsewhere ? kConflicting : 0;
  if (!state.unsaved) return pending;
  pending |= kUnsaved;
  if (!kept || !now) return pending | (now ? kNew : kDeleted);
  const edit::FieldMask fields = edit::difference(*kept, *now);
  if (fields & (kPosition | kYaw)) pending |= kMoved;
  if (fields & kName) pending |= kRenamed;
  if (fields & (kTags | kType)) pending |= kRetagged;
  return pending;
}

QString pendingText(const edit::ItemState& state, int pending) {
  if (state.changed_elsewhere || state.sent || !(pending & kUnsaved)) return stateText(state);
  QStringList parts;
  if (pending & kNew) parts << WaypointsText::tr("new");
  if (pending & kDeleted) parts << WaypointsText::tr("deleted");
  if (pending & kRenamed) parts << WaypointsText::tr("renamed");
  if (pending & kMoved) parts << WaypointsText::tr("moved");
  if (pending & kRetagged) parts << WaypointsText::tr("retagged");
  if (parts.isEmpty()) return stateText(state);
  return WaypointsText::tr("Not saved yet: %1.").arg(words::listed(parts));
}

QString changeText(const std::optional<map::Waypoint>& before, const std::optional<map::Waypoint>& after) {
  using namespace edit::waypoint_field;
  if (!before && !after) return {};
  if (!after) return WaypointsText::tr("deleted");
  if (!before) {
    const edit::FieldMask said = kPosition | (after->yaw_rad ? kYaw : 0) | (after->tags.empty() ? 0 : kTags) |
                                 (after->type.empty() ? 0 : kType);
    return WaypointsText::tr("new: %1").arg(fieldsText(after, said));
  }
  const edit::FieldMask changed = edit::difference(*before, *after);
  QStringList parts;
  for (edit::FieldMask field = 1; field <= changed; field <<= 1) {
    if (changed & field)
      parts << WaypointsText::tr("%1 → %2").arg(fieldsText(before, field), fieldsText(after, field));
  }
  return parts.isEmpty() ? WaypointsText::tr("unchanged") : words::joined(parts);
}

QString conflictText(const edit::Conflict& conflict) {
  edit::FieldMask mine = conflict.fields, theirs = conflict.fields;
  if (!conflict.mine || !conflict.theirs) {
    mine = conflict.mine && conflict.base ? edit::difference(*conflict.mine, *conflict.base) : 0;
    theirs = conflict.theirs && conflict.base ? edit::difference(*conflict.theirs, *conflict.base) : 0;
  }
  return WaypointsText::tr("Here: %1. Elsewhere: %2.")
      .arg(fieldsText(conflict.mine, mine), fieldsText(conflict.theirs, theirs));
}

QString failureText(const map::Failure& failure) {
  const bool says_why = !failure.detail.empty() || failure.cause.any() || !failure.robot_code.empty();
  return says_why ? words::plainLine(QString::fromStdString(sentences::sentenceOf(failure)))
                  : reasonText(failure);
}

exchange::SentOutcome outcomeOf(const edit::OpenWaypoints& list, const exchange::SentRequest& sent) {
  return exchange::outcomeOf(sent, list.looked() ? &list.document() : nullptr);
}

exchange::SentCounts countsOf(const edit::OpenWaypoints& list) {
  return exchange::countsOf(list.submission().rows(), list.looked() ? &list.document() : nullptr);
}

QString notSavedText(const edit::OpenWaypoints& list, const map::Failure& stopped_by) {
  const exchange::SentCounts counts = countsOf(list);
  const std::size_t sent = counts.applied + counts.failed + counts.unknown, all = sent + counts.not_sent;
  const QString why = reasonText(stopped_by);
  if (all < 2 || counts.applied + counts.unknown == 0) {
    return counts.unknown > 0 ? WaypointsText::tr("Whether it was saved is unknown. %1").arg(why)
                              : WaypointsText::tr("Not saved. %1").arg(why);
  }
  const auto figure = [](std::size_t count) { return QLocale::c().toString(qulonglong(count)); };
  QString text = WaypointsText::tr("Not everything was saved: %1 of %2 requests succeeded")
                     .arg(figure(counts.applied), figure(all));
  if (counts.unknown > 0)
    text += WaypointsText::tr(", the result of %1 is unknown").arg(figure(counts.unknown));
  return text + QStringLiteral(". ") + why;
}

QString reasonText(const map::Failure& failure) {
  return words::plainLine(QString::fromStdString(sentences::failureReason(failure)));
}

std::optional<LeftName> leftName(const edit::WaypointDocument& document,
                                 const std::set<edit::Key>& accepted) {
  for (const edit::Key& key : document.unsaved()) {
    const map::Waypoint *const kept = document.findKept(key), *const here = document.find(key);
    if (!kept || !here || kept->name == here->name || map::permanentName(kept->name).empty()) continue;
    return LeftName{key, LeftName::Remedy::SendRest, here->name,
                    WaypointsText::tr("\"%1\" is a temporary name left by an interrupted swap of names. When "
                                      "the rest is sent, it will be called \"%2\".")
                        .arg(shown(kept->name), shown(here->name)),
                    WaypointsText::tr("Send the rest")};
  }
  for (exchange::TemporaryName& left : exchange::temporaryNamesIn(document.items())) {
    const map::Waypoint* const kept = document.findKept(left.key);
    if (accepted.contains(left.key) || !kept || kept->name != left.name) continue;
    const QString sentence = left.is_free ? WaypointsText::tr(
                                                "\"%1\" looks like a temporary name left by an interrupted "
                                                "swap of names. It was called \"%2\" before.")
                                          : WaypointsText::tr(
                                                "\"%1\" looks like a temporary name left by an interrupted "
                                                "swap of names. Another waypoint is called \"%2\" now.");
    const auto remedy = left.is_free ? LeftName::Remedy::CallItSo : LeftName::Remedy::Ask;
    return LeftName{left.key, remedy, left.permanent, sentence.arg(shown(left.name), shown(left.permanent)),
                    left.is_free ? WaypointsText::tr("Rename back") : WaypointsText::tr("Rename…")};
  }
  return std::nullopt;
}

}  // namespace mapwright::ui
