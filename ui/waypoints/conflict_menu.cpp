#include "ui/waypoints/conflict_menu.h"

#include <QCoreApplication>
#include <QMenu>

#include "placing/arrange.h"
#include "ui/kit/icons.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {
namespace {

class ConflictMenuText {
  Q_DECLARE_TR_FUNCTIONS(ConflictMenu)
};

}  // namespace

std::optional<edit::Key> conflictAt(const edit::WaypointDocument& document, const Eigen::Vector2d& world_m,
                                    double reach_m) {
  std::optional<edit::Key> nearest;
  for (const auto& [key, conflict] : document.conflicts()) {
    const map::Waypoint* const here = document.find(key);
    for (const map::Waypoint* side : {here, conflict.theirs ? &*conflict.theirs : nullptr}) {
      if (!side) continue;
      const double distance = (side->position_m - world_m).norm();
      if (!(distance <= reach_m)) continue;
      reach_m = distance;
      nearest = key;
    }
  }
  return nearest;
}

bool mayKeepBoth(const edit::Conflict& conflict) { return conflict.mine && conflict.theirs; }

void fillConflictMenu(QMenu& menu, const edit::WaypointDocument& document, const edit::Key& key,
                      const std::function<void(ConflictChoice)>& decided) {
  const auto found = document.conflicts().find(key);
  if (found == document.conflicts().end()) return;
  const edit::Conflict& conflict = found->second;
  const auto& any = conflict.mine ? conflict.mine : conflict.theirs;
  // Untrusted names: an ampersand in them is not a mnemonic.
  const QString which =
      any ? shortWaypointName(*any).replace(QLatin1Char('&'), QLatin1String("&&")) : QString();
  menu.addAction(themedIcon(QStringLiteral("problem")),
                 ConflictMenuText::tr("%1 was changed here and elsewhere").arg(which))
      ->setEnabled(false);
  const auto add = [&](const QString& text, const char* name, ConflictChoice choice) {
    QAction* const action = menu.addAction(text, &menu, [decided, choice] { decided(choice); });
    action->setObjectName(QLatin1String(name));
  };
  add(conflict.mine ? ConflictMenuText::tr("Keep &mine") : ConflictMenuText::tr("&Delete it, as I did"),
      "conflictMine", ConflictChoice::Mine);
  add(conflict.theirs ? ConflictMenuText::tr("Take &theirs")
                      : ConflictMenuText::tr("Delete it, as &they did"),
      "conflictTheirs", ConflictChoice::Theirs);
  if (mayKeepBoth(conflict)) add(ConflictMenuText::tr("Keep &both"), "conflictBoth", ConflictChoice::Both);
}

void decideConflict(WaypointEditing& editing, const edit::Key& key, ConflictChoice choice) {
  edit::WaypointDocument* const document = editing.document();
  if (!document || !editing.editable() || !document->conflicts().contains(key)) return;
  if (choice == ConflictChoice::Mine)
    return document->decide(key, edit::Side::Mine, ConflictMenuText::tr("keep mine"));
  const bool both = choice == ConflictChoice::Both && mayKeepBoth(document->conflicts().at(key));
  const map::Waypoint* const here = document->find(key);
  std::optional<map::Waypoint> mine = both && here ? std::optional(*here) : std::nullopt;
  document->decide(key, edit::Side::Theirs, ConflictMenuText::tr("take theirs"));
  if (!mine) return;
  std::set<std::string> taken = editing.names();
  mine->source.clear();  // that is theirs
  if (taken.contains(mine->name)) mine->name = placing::nextName(mine->name, taken);
  editing.addAll({std::move(*mine)}, ConflictMenuText::tr("keep %1 as well"));
}

}  // namespace mapwright::window
