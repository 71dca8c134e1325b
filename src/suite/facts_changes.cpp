#include "suite/facts_changes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QLocale>

#include "compare/comparison_sentence.h"
#include "compare/picture_view.h"
#include "overlays/overlay_merge.h"
#include "overlays/overlay_sentence.h"
#include "overlays/overlay_shapes.h"
#include "sentences/plural.h"
#include "words/figures.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::suite {
namespace {

struct FactsChangesText {
  Q_DECLARE_TR_FUNCTIONS(FactsChanges)
};

constexpr double kMovedM = 5e-4, kTurnedRad = 1e-3;
/// What stands for a thing is drawn around it.
constexpr double kDrawnAroundPx = 16, kRobotM = 0.5;
// Of names beside points, as scene draws them: never wider, nor farther away.
constexpr double kLetterPx = 11, kLinePx = 15, kAroundNamePx = 40;
constexpr qsizetype kLongestLabel = 40;
constexpr std::size_t kMostPushed = 32;  // by one change
constexpr qsizetype kMostNamed = 4;

QString metres(double value) { return QLocale::c().toString(value, 'f', value < 0.01 ? 3 : 2); }

QString firstOf(const QStringList& changes, QString (*joined)(const QStringList&)) {
  const QString named = joined(changes.mid(0, kMostNamed));
  if (changes.size() <= kMostNamed) return named;
  return FactsChangesText::tr("%1 and %2 more")
      .arg(named, QString::fromStdString(words::grouped(changes.size() - kMostNamed)));
}

geometry::WorldRect pointBox(const Eigen::Vector2d& at_m) {
  geometry::WorldRect box;
  box.extend(at_m);
  return box;
}

/// As far as the name of a point may stand from it in the view.
geometry::WorldRect withName(const geometry::WorldRect& at, const QString& name,
                             const std::optional<geometry::ViewTransform>& view) {
  if (!view || at.empty()) return at;
  const double aside = kAroundNamePx + kLetterPx * double(std::min(name.size(), kLongestLabel));
  const double over = kAroundNamePx + kLinePx;
  const double along = std::abs(std::cos(view->rotation_rad)),
               across = std::abs(std::sin(view->rotation_rad));
  const double x_m = view->scale_m_per_px * (along * aside + across * over);
  const double y_m = view->scale_m_per_px * (across * aside + along * over);
  return {at.min_x - x_m, at.min_y - y_m, at.max_x + x_m, at.max_y + y_m};
}

bool hasPlace(const FactChange& change) {
  return std::any_of(change.where.begin(), change.where.end(), [](const auto& box) { return !box.empty(); });
}

QString nameOf(const MapFact& map) {
  const QString name = words::plainName(map.name);
  return name.isEmpty() ? words::plainName(map.id) : name;
}

/// Empty: neither moved nor turned by so much that it could be seen.
QString movedText(const geometry::Pose2& before, const geometry::Pose2& after) {
  const double by_m = std::hypot(after.x_m - before.x_m, after.y_m - before.y_m);
  const double by_rad = geometry::normalizeAngle(after.yaw_rad - before.yaw_rad);
  const QString degrees = QLocale::c().toString(geometry::degreesFromRadians(by_rad), 'f', 1);
  const bool moved = by_m > kMovedM, turned = std::abs(by_rad) > kTurnedRad;
  if (moved && turned)
    return FactsChangesText::tr("moved by %1 m and turned by %2°").arg(metres(by_m), degrees);
  if (moved) return FactsChangesText::tr("moved by %1 m").arg(metres(by_m));
  return turned ? FactsChangesText::tr("turned by %1°").arg(degrees) : QString();
}

void compareViews(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  const auto say = [&](const QString& words) { changes.push_back({words, {}, true}); };
  if (before.view && after.view) {
    const geometry::ViewTransform &was = *before.view, &is = *after.view;
    const double half_px_m = was.scale_m_per_px / 2;
    const bool same = was.width_px == is.width_px && was.height_px == is.height_px &&
                      std::abs(was.scale_m_per_px - is.scale_m_per_px) <= 1e-6 * was.scale_m_per_px &&
                      std::abs(geometry::normalizeAngle(is.rotation_rad - was.rotation_rad)) <= 1e-6 &&
                      (is.center_m - was.center_m).norm() <= 1e-3 * half_px_m;
    if (!same) say(FactsChangesText::tr("the view is another one"));
  }
  if (before.theme.empty() || after.theme.empty()) return;
  if (before.theme != after.theme)
    say(FactsChangesText::tr("the theme is %1 instead of %2")
            .arg(words::plainName(after.theme), words::plainName(before.theme)));
  const auto missing = [](const std::vector<std::string>& layers, const std::vector<std::string>& in) {
    QStringList names;
    for (const std::string& layer : layers) {
      if (std::find(in.begin(), in.end(), layer) == in.end()) names << words::plainName(layer);
    }
    return names;
  };
  if (const QStringList more = missing(after.layers, before.layers); !more.isEmpty())
    say(FactsChangesText::tr("layers that are drawn now: %1").arg(firstOf(more, words::listed)));
  if (const QStringList gone = missing(before.layers, after.layers); !gone.isEmpty())
    say(FactsChangesText::tr("layers that are drawn no more: %1").arg(firstOf(gone, words::listed)));
}

std::vector<FactChange> placeChanges(const MapFact& was, const MapFact& is) {
  std::vector<FactChange> changes;
  const auto say = [&](const QString& words) { changes.push_back({words, {}, true}); };
  if (was.resolution_m && is.resolution_m &&
      std::abs(*was.resolution_m - *is.resolution_m) > 1e-6 * *was.resolution_m)
    say(FactsChangesText::tr("map %1 has another resolution").arg(nameOf(is)));
  if (!was.origin || !is.origin) return changes;
  const double by_m = std::hypot(is.origin->x_m - was.origin->x_m, is.origin->y_m - was.origin->y_m);
  const double by_rad = geometry::normalizeAngle(is.origin->yaw_rad - was.origin->yaw_rad);
  if (by_m > kMovedM) say(FactsChangesText::tr("map %1 lies %2 m elsewhere").arg(nameOf(is), metres(by_m)));
  if (std::abs(by_rad) > kTurnedRad)
    say(FactsChangesText::tr("map %1 is turned by %2°")
            .arg(nameOf(is), QLocale::c().toString(geometry::degreesFromRadians(by_rad), 'f', 1)));
  return changes;
}

void compareMaps(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  if (!before.map || !after.map) return;
  const MapFact &was = *before.map, &is = *after.map;
  const bool same_cells = !was.cells.empty() && was.cells == is.cells;
  if (is.origin && !same_cells) {
    if (was.uid != is.uid || was.id != is.id)
      changes.push_back(
          {FactsChangesText::tr("it is map %1 instead of %2").arg(nameOf(is), nameOf(was)), {}});
    else if (was.version != is.version && was.version && is.version)
      changes.push_back({FactsChangesText::tr("map %1 went from version %2 to %3")
                             .arg(nameOf(is))
                             .arg(*was.version)
                             .arg(*is.version),
                         {}});
  }
  for (FactChange& change : placeChanges(was, is)) changes.push_back(std::move(change));
}

void compareCells(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  if (!before.map || !after.map) return;
  const MapFact &was = *before.map, &is = *after.map;
  if (was.cells == is.cells || was.cells.empty() || is.cells.empty()) return;
  std::vector<ChangedPatch> patches;
  if (was.blocks.comparableWith(is.blocks) && is.origin && is.resolution_m && placeChanges(was, is).empty())
    patches = changedPatches(was.blocks, is.blocks, *is.origin, *is.resolution_m);
  for (const ChangedPatch& patch : patches)
    changes.push_back({FactsChangesText::tr("cells of map %1 changed within %2 x %3 m at %4")
                           .arg(nameOf(is), metres(patch.width_m), metres(patch.height_m),
                                compare::placeText(patch.center_m)),
                       patch.blocks});
  if (patches.empty())
    changes.push_back({FactsChangesText::tr("the cells of map %1 changed").arg(nameOf(is)), {}});
}

void compareSubmaps(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  if (before.session != after.session && !before.session.empty() && !after.session.empty())
    changes.push_back({FactsChangesText::tr("it is another SLAM session"), {}});
  const bool textures = after.layers.empty() ||
                        std::find(after.layers.begin(), after.layers.end(), "submaps") != after.layers.end();
  for (const auto& [id, was] : before.submaps) {
    const QString name = QString::fromStdString(map::toText(id));
    const auto found = after.submaps.find(id);
    if (found == after.submaps.end()) {
      changes.push_back({FactsChangesText::tr("submap %1 is gone").arg(name), {was.box}});
      continue;
    }
    const SubmapFact& is = found->second;
    QStringList parts;
    if (was.version != is.version && textures)
      parts << FactsChangesText::tr("went from version %1 to %2").arg(was.version).arg(is.version);
    if (const QString moved = movedText(was.pose, is.pose); !moved.isEmpty()) parts << moved;
    if (!parts.isEmpty())
      changes.push_back(
          {FactsChangesText::tr("submap %1 %2").arg(name, parts.join(FactsChangesText::tr(" and "))),
           {was.box, is.box}});
  }
  for (const auto& [id, is] : after.submaps) {
    if (!before.submaps.contains(id))
      changes.push_back(
          {FactsChangesText::tr("submap %1 is new").arg(QString::fromStdString(map::toText(id))), {is.box}});
  }
}

/// Lines are drawn without their names, and only points with headings.
bool isDrawn(const overlays::Part& part, const overlays::Feature& feature) {
  if (part.name == "id") return false;
  if (part.name == "name") return feature.shape() != overlays::Shape::Line;
  return part.name != "yaw" || feature.shape() == overlays::Shape::Point;
}

/// Where it is drawn, with its name.
geometry::WorldRect boxOf(const overlays::Feature& feature, const Facts& facts) {
  geometry::WorldRect bounds;
  for (const overlays::Path& path : overlays::shapesOf(feature).paths) {
    for (const Eigen::Vector2d& point : path.points) bounds.extend(point);
  }
  if (feature.shape() != overlays::Shape::Point) return bounds;
  return withName(bounds,
                  feature.name().empty() ? overlays::overlayKind(feature) : overlays::overlayName(feature),
                  facts.view);
}

void compareOverlays(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  const auto was = overlays::OverlayDocument::read(before.overlays);
  const auto is = overlays::OverlayDocument::read(after.overlays);
  if (!was || !is) return;
  for (overlays::OverlayChange& change : overlays::changesBetween(*was, *is)) {
    if (change.collection) continue;
    const overlays::Feature& feature = change.to ? is->features()[*change.to] : was->features()[*change.from];
    std::erase_if(change.parts, [&](const overlays::PartChange& one) { return !isDrawn(one.part, feature); });
    if (change.kind == overlays::ChangeKind::Change && change.parts.empty()) continue;
    FactChange made{overlays::changeText(change, *was, *is, overlays::Telling::Event), {}};
    if (change.from) made.where.push_back(boxOf(was->features()[*change.from], before));
    if (change.to) made.where.push_back(boxOf(is->features()[*change.to], after));
    made.moves_names = feature.shape() != overlays::Shape::Line;
    if (hasPlace(made)) changes.push_back(std::move(made));  // what has no place is not drawn
  }
}

QString nameOf(const map::Waypoint& point) {
  return words::plainName(point.name.empty() ? point.id : point.name).left(60);
}

geometry::WorldRect boxOf(const map::Waypoint& point, const Facts& facts) {
  return withName(pointBox(point.position_m), nameOf(point), facts.view);
}

/// Empty: nothing of it that is drawn changed.
QString becameText(const map::Waypoint& was, const map::Waypoint& is) {
  QStringList parts;
  if (nameOf(was) != nameOf(is)) parts << FactsChangesText::tr("is called %1 now").arg(nameOf(is));
  const double yaw_rad = is.yaw_rad.value_or(was.yaw_rad.value_or(0));
  const QString moved = movedText({was.position_m.x(), was.position_m.y(), was.yaw_rad.value_or(yaw_rad)},
                                  {is.position_m.x(), is.position_m.y(), yaw_rad});
  if (!moved.isEmpty()) parts << moved;
  if (was.yaw_rad.has_value() != is.yaw_rad.has_value())
    parts << (is.yaw_rad ? FactsChangesText::tr("has a heading now")
                         : FactsChangesText::tr("has no heading any more"));
  return parts.join(FactsChangesText::tr(" and "));
}

void compareWaypoints(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  const auto same = [](const map::Waypoint& a, const map::Waypoint& b) {
    return a.id.empty() || b.id.empty() ? a.name == b.name : a.id == b.id;
  };
  const auto say = [&](const QString& words, std::vector<geometry::WorldRect> where) {
    changes.push_back({words, std::move(where), false, true});
  };
  std::vector<bool> met(after.waypoints.size(), false);
  for (const map::Waypoint& was : before.waypoints) {
    std::size_t at = 0;
    while (at < after.waypoints.size() && (met[at] || !same(was, after.waypoints[at]))) ++at;
    if (at == after.waypoints.size()) {
      say(FactsChangesText::tr("waypoint %1 is gone").arg(nameOf(was)), {boxOf(was, before)});
      continue;
    }
    met[at] = true;
    const map::Waypoint& is = after.waypoints[at];
    if (const QString became = becameText(was, is); !became.isEmpty())
      say(FactsChangesText::tr("waypoint %1 %2").arg(nameOf(was), became),
          {boxOf(was, before), boxOf(is, after)});
  }
  for (std::size_t at = 0; at < after.waypoints.size(); ++at) {
    const map::Waypoint& is = after.waypoints[at];
    if (!met[at]) say(FactsChangesText::tr("waypoint %1 is new").arg(nameOf(is)), {boxOf(is, after)});
  }
}

void compareRobot(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  const auto box = [](const geometry::Pose2& pose) { return pointBox({pose.x_m, pose.y_m}).grown(kRobotM); };
  if (before.robot && after.robot) {
    if (const QString moved = movedText(*before.robot, *after.robot); !moved.isEmpty())
      changes.push_back({FactsChangesText::tr("the robot %1").arg(moved),
                         {box(*before.robot), box(*after.robot)},
                         false,
                         true});
  } else if (before.robot) {
    changes.push_back(
        {FactsChangesText::tr("the robot is drawn no more"), {box(*before.robot)}, false, true});
  } else if (after.robot) {
    changes.push_back({FactsChangesText::tr("the robot is drawn now"), {box(*after.robot)}, false, true});
  }
}

void compareStamps(const Facts& before, const Facts& after, std::vector<FactChange>& changes) {
  QStringList topics;
  for (const auto& [topic, stamp_s] : before.stamps) {
    const auto found = after.stamps.find(topic);
    if (found == after.stamps.end() || found->second != stamp_s) topics << words::plainName(topic);
  }
  for (const auto& [topic, stamp_s] : after.stamps) {
    if (!before.stamps.contains(topic)) topics << words::plainName(topic);
  }
  if (!topics.isEmpty())
    changes.push_back(
        {FactsChangesText::tr("messages of other times: %1").arg(firstOf(topics, words::listed)), {}});
}

/// Where names are now that others may push aside.
std::vector<geometry::WorldRect> namesIn(const Facts& facts) {
  std::vector<geometry::WorldRect> names;
  for (const map::Waypoint& point : facts.waypoints) names.push_back(boxOf(point, facts));
  if (const auto document = overlays::OverlayDocument::read(facts.overlays)) {
    for (const overlays::Feature& feature : document->features()) {
      if (feature.shape() != overlays::Shape::Line) names.push_back(boxOf(feature, facts));
    }
  }
  return names;
}

/// The names near a change may stand elsewhere because of it.
void addPushed(const Facts& after, std::vector<FactChange>& changes) {
  const auto moves = [](const FactChange& change) { return change.moves_names; };
  if (std::none_of(changes.begin(), changes.end(), moves)) return;
  const std::vector<geometry::WorldRect> names = namesIn(after);
  for (FactChange& change : changes) {
    if (!change.moves_names) continue;
    const std::vector<geometry::WorldRect> own = change.where;
    for (const geometry::WorldRect& name : names) {
      if (change.where.size() >= kMostPushed) break;
      if (std::any_of(own.begin(), own.end(), [&](const auto& box) { return box.intersects(name); }))
        change.where.push_back(name);
    }
  }
}

}  // namespace

std::vector<FactChange> changesBetween(const Facts& before, const Facts& after) {
  std::vector<FactChange> changes;
  for (const auto compare : {compareViews, compareMaps, compareOverlays, compareWaypoints, compareSubmaps,
                             compareRobot, compareCells, compareStamps})
    compare(before, after, changes);
  addPushed(after, changes);
  return changes;
}

Explanation explained(const compare::Comparison& comparison, const geometry::ViewTransform& view,
                      const std::vector<FactChange>& changes) {
  Explanation made;
  made.near.resize(comparison.clusters.size());
  std::vector<geometry::WorldRect> places;
  for (std::size_t i = 0; i < made.near.size(); ++i)
    places.push_back(
        compare::worldOf(view, comparison.clusters[i].box).grown(kDrawnAroundPx * view.scale_m_per_px));
  for (const FactChange& change : changes) {
    if (!hasPlace(change)) {
      (change.whole_picture ? made.everywhere : made.somewhere) << change.words;
      continue;
    }
    bool near = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (std::none_of(change.where.begin(), change.where.end(),
                       [&](const geometry::WorldRect& box) { return places[i].intersects(box); }))
        continue;
      made.near[i] << change.words;
      near = true;
    }
    if (!near) made.elsewhere << change.words;
  }
  const bool all_explained =
      !made.near.empty() && std::int64_t(made.near.size()) == comparison.clusters_in_all &&
      std::none_of(made.near.begin(), made.near.end(), [](const auto& near) { return near.isEmpty(); });
  if (!all_explained) made.everywhere += std::exchange(made.somewhere, {});
  return made;
}

QString firstChanges(const QStringList& changes) { return firstOf(changes, words::joined); }

QString explanationText(const compare::Comparison& comparison, const geometry::ViewTransform& view,
                        const Explanation& explanation) {
  QStringList causes;
  for (const QStringList& near : explanation.near) {
    for (const QString& words : near) {
      if (!causes.contains(words)) causes << words;
    }
  }
  causes += explanation.everywhere;
  QString what = compare::clustersText(comparison, view);
  if (what.isEmpty()) what = FactsChangesText::tr("Changed");
  QStringList said;
  if (causes.isEmpty()) {
    said << words::asSentence(what)
         << (explanation.elsewhere.isEmpty() ? FactsChangesText::tr("No fact that is kept of it changed.")
                                             : FactsChangesText::tr("Nothing changed there that is known."));
  } else {
    said << words::asSentence(words::about(what, firstChanges(causes)));
  }
  const auto unknown = std::count_if(explanation.near.begin(), explanation.near.end(),
                                     [](const QStringList& near) { return near.isEmpty(); });
  if (unknown > 0 && !causes.isEmpty() && explanation.everywhere.isEmpty())
    said << sentences::counted(FactsChangesText::tr("%1 clusters: nothing known changed there.", nullptr,
                                                    sentences::formOf(unknown)),
                               unknown);
  if (!explanation.somewhere.isEmpty())
    said << FactsChangesText::tr("There or elsewhere: %1.").arg(firstChanges(explanation.somewhere));
  if (!explanation.elsewhere.isEmpty())
    said << FactsChangesText::tr("Elsewhere: %1.").arg(firstChanges(explanation.elsewhere));
  return words::paragraph(said);
}

}  // namespace mapwright::suite
