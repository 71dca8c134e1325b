// Waypoints as items of documents and drafts.
#pragma once

#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include <QJsonObject>

#include "edit/document.h"
#include "edit/draft.h"
#include "map/waypoint.h"
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
  /// Swapped names go through a temporary name.
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

/// Makes it fit for the store: drops unsupported fields, and sets a missing heading to 0 if one is required.
void fit(map::Waypoint& point, const robot::KeptFields& keeps);
/// Which changes the store would certainly refuse because another waypoint has that name.
std::set<Key> refusedNames(const Items<map::Waypoint>& kept,
                           const std::vector<Change<map::Waypoint>>& changes, const robot::KeptFields& keeps);

template <>
struct ItemJson<map::Waypoint> {
  static QJsonObject write(const map::Waypoint& point);
  /// nullopt = invalid: something is missing, has the wrong type or is not finite.
  static std::optional<map::Waypoint> read(const QJsonObject& object);
};

}  // namespace mapwright::edit
