#include "ui/waypoints/left_name.h"

#include <QCoreApplication>

#include "exchange/temporary_names.h"
#include "map/waypoint.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {
namespace {

class LeftNameText {
  Q_DECLARE_TR_FUNCTIONS(LeftName)
};

QString shown(const std::string& name) {
  map::Waypoint point;
  point.name = name;
  return shortWaypointName(point);
}

}  // namespace

std::optional<LeftName> leftName(const edit::WaypointDocument& document,
                                 const std::set<edit::Key>& accepted) {
  for (const edit::Key& key : document.unsaved()) {
    const map::Waypoint *const kept = document.findKept(key), *const here = document.find(key);
    if (!kept || !here || kept->name == here->name || map::permanentName(kept->name).empty()) continue;
    return LeftName{key, LeftName::Remedy::SendRest, here->name,
                    LeftNameText::tr("\"%1\" is a temporary name left by an interrupted swap of names. When "
                                     "the rest is sent, it will be called \"%2\".")
                        .arg(shown(kept->name), shown(here->name)),
                    LeftNameText::tr("Send the rest")};
  }
  for (exchange::TemporaryName& left : exchange::temporaryNamesIn(document.items())) {
    const map::Waypoint* const kept = document.findKept(left.key);
    if (accepted.contains(left.key) || !kept || kept->name != left.name) continue;
    const QString sentence = left.is_free ? LeftNameText::tr(
                                                "\"%1\" looks like a temporary name left by an interrupted "
                                                "swap of names. It was called \"%2\" before.")
                                          : LeftNameText::tr(
                                                "\"%1\" looks like a temporary name left by an interrupted "
                                                "swap of names. Another waypoint is called \"%2\" now.");
    const auto remedy = left.is_free ? LeftName::Remedy::CallItSo : LeftName::Remedy::Ask;
    return LeftName{left.key, remedy, left.permanent, sentence.arg(shown(left.name), shown(left.permanent)),
                    left.is_free ? LeftNameText::tr("Rename back") : LeftNameText::tr("Rename…")};
  }
  return std::nullopt;
}

}  // namespace mapwright::window
