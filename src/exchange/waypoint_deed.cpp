#include "exchange/waypoint_deed.h"

#include <vector>

#include <QCoreApplication>
#include <QStringList>

#include "edit/merge.h"
#include "geometry/pose.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::exchange {
namespace {

struct WaypointDeedText {
  Q_DECLARE_TR_FUNCTIONS(WaypointDeedText)
};

constexpr double kCloseM = 0.1;  // below, millimetres matter

}  // namespace

QString shortWaypointName(const map::Waypoint& point, int limit) {
  QString text = words::plainName(point.name);
  if (text.isEmpty()) text = words::plainName(point.id);
  return words::shortened(text, limit);
}

QString yawText(const std::optional<double>& yaw_rad) {
  if (!yaw_rad) return {};
  return words::fixed(geometry::degreesFromRadians(geometry::normalizeAngle(*yaw_rad)), 1) + QChar(0xb0);
}

QString deedText(const std::optional<map::Waypoint>& before, const std::optional<map::Waypoint>& after) {
  using namespace edit::waypoint_field;
  if (!before && !after) return {};
  if (!before) return WaypointDeedText::tr("Create %1").arg(shortWaypointName(*after));
  const QString name = shortWaypointName(*before);
  if (!after) return WaypointDeedText::tr("Delete %1").arg(name);
  const edit::FieldMask changed = edit::difference(*before, *after);
  // The first one names it.
  struct Deed {
    QString of_it, also;
  };
  std::vector<Deed> deeds;
  const auto add = [&](const QString& of_it, const QString& also) { deeds.push_back({of_it, also}); };
  if (changed & kName) {
    const QString to = shortWaypointName(*after);
    add(WaypointDeedText::tr("Rename %1 to %2").arg(name, to), {});
  }
  if (changed & kPosition) {
    const double by = (after->position_m - before->position_m).norm();
    const QString metres = words::fixed(by, by < kCloseM ? 3 : 2);
    add(WaypointDeedText::tr("Move %1 by %2 m").arg(name, metres),
        WaypointDeedText::tr("move it by %1 m").arg(metres));
  }
  if (changed & kYaw) {
    if (!after->yaw_rad) {
      add(WaypointDeedText::tr("Remove the heading of %1").arg(name),
          WaypointDeedText::tr("remove its heading"));
    } else if (!before->yaw_rad) {
      const QString to = yawText(after->yaw_rad);
      add(WaypointDeedText::tr("Turn %1 to %2").arg(name, to), WaypointDeedText::tr("turn it to %1").arg(to));
    } else {
      const QString by = yawText(*after->yaw_rad - *before->yaw_rad);
      add(WaypointDeedText::tr("Turn %1 by %2").arg(name, by), WaypointDeedText::tr("turn it by %1").arg(by));
    }
  }
  if (changed & kTags)
    add(WaypointDeedText::tr("Change the tags of %1").arg(name), WaypointDeedText::tr("change its tags"));
  if (changed & kType)
    add(WaypointDeedText::tr("Change the kind of %1").arg(name), WaypointDeedText::tr("change its kind"));
  QStringList texts;
  for (const Deed& deed : deeds) texts << (texts.isEmpty() ? deed.of_it : deed.also);
  return texts.isEmpty() ? WaypointDeedText::tr("Leave %1 as it is").arg(name) : words::listed(texts);
}

}  // namespace mapwright::exchange
