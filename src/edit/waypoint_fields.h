// Waypoints as items of a document and of a draft.
#pragma once

#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include <QJsonObject>

#include "edit/document.h"
#include "edit/draft.h"
#include "map/temporary_name.h"
#include "map/waypoint.h"
#include "map/waypoint_likeness.h"
#include "robot/waypoint_store.h"

namespace mapwright::edit {

template <>
struct Fields<map::Waypoint> {
  static constexpr std::tuple all{&map::Waypoint::name, &map::Waypoint::position_m, &map::Waypoint::yaw_rad,
                                  &map::Waypoint::tags, &map::Waypoint::type};
  static void carry(map::Waypoint& into, const map::Waypoint& theirs) {
    into.id = theirs.id;
    into.source = theirs.source;
  }
  static bool alike(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return map::samePlace(a, b); }
  static bool alike(const std::optional<double>& a, const std::optional<double>& b) {
    return map::sameHeading(a, b);
  }
  /// Names that are exchanged go by way of a temporary name.
  static FieldMask onTheWay(const map::Waypoint& base, const map::Waypoint& mine,
                            const map::Waypoint& theirs) {
    const bool renamed = base.name != mine.name;
    return renamed && map::isTemporaryFor(theirs.name, base.name) ? FieldMask(1) : FieldMask(0);
  }
};
namespace waypoint_field {
inline constexpr FieldMask kName = 1, kPosition = 2, kYaw = 4, kTags = 8, kType = 16;
}

using WaypointDocument = Document<map::Waypoint>;

/// As it is going to be kept: what is not kept is left out, a heading that there must be is 0.
void fit(map::Waypoint& point, const robot::KeptFields& keeps);
/// Which of the changes of what is `kept` would be refused for sure: they give a name that another one has.
std::set<Key> refusedNames(const Items<map::Waypoint>& kept,
                           const std::vector<Change<map::Waypoint>>& changes, const robot::KeptFields& keeps);

template <>
struct ItemJson<map::Waypoint> {
  static QJsonObject write(const map::Waypoint& point);
  /// nullopt = it is none: something is missing, of the wrong kind or not finite.
  static std::optional<map::Waypoint> read(const QJsonObject& object);
};

}  // namespace mapwright::edit
