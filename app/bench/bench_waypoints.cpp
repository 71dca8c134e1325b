// Ten thousand waypoints in the window: opening the list, dragging a thousand of them, and what saving them
// takes. The baseline of the drag is copying what is drawn.
#include <memory>
#include <string>
#include <vector>

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <benchmark/benchmark.h>

#include "render/tile_renderer.h"
#include "robot/ros/kabam_plan.h"
#include "ui/scene/map_scene.h"
#include "ui/view/hit_list.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_warnings.h"
#include "ui/waypoints/waypoints_dock.h"
#include "ui/waypoints/waypoints_on_map.h"

namespace {

using namespace mapwright;

edit::Items waypoints(int count) {
  edit::Items items;
  for (int i = 0; i < count; ++i) {
    map::Waypoint point;
    point.id = "0c5f6a1e-77b0-4c11-9d9c-" + std::to_string(100'000 + i);
    point.name = "Shelf " + std::to_string(i);
    point.position_m = {i % 100 * 0.5, i / 100 * 0.5};
    point.yaw_rad = 0.1 * i;
    point.tags = {"shelf", i % 7 == 0 ? "charger" : "aisle"};
    const edit::Key key = point.id;
    items.emplace(key, std::move(point));
  }
  return items;
}

/// List, table, form and map, as the window has them.
struct Desk {
  explicit Desk(int count) : hits(scene), on_map(&editing, &scene, &hits), dock(&editing) {
    document.reset(waypoints(count));
    on_map.setMap(map::MapKey{map::MapKind::Stored, "1"});
    dock.resize(320, 640);
  }
  std::set<edit::Key> some(std::size_t count) const {
    std::set<edit::Key> keys;
    for (const auto& [key, point] : document.items()) {
      if (keys.size() < count) keys.insert(key);
    }
    return keys;
  }

  edit::WaypointDocument document;
  ui::scene::MapScene scene{{}};
  ui::WaypointEditing editing;
  ui::HitList hits;
  ui::WaypointsOnMap on_map;
  ui::WaypointsDock dock;
};

void waypointsOpen(benchmark::State& state) {
  Desk desk(int(state.range(0)));
  for (auto _ : state) {
    desk.editing.setDocument(&desk.document, {});
    desk.dock.grab();
    state.PauseTiming();
    desk.editing.setDocument(nullptr, {});
    state.ResumeTiming();
  }
}
BENCHMARK(waypointsOpen)->Arg(10'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

void waypointsDrag(benchmark::State& state) {
  Desk desk(int(state.range(0)));
  desk.editing.setDocument(&desk.document, {});
  desk.editing.select(desk.some(1'000));
  double x = 0;
  for (auto _ : state) {
    ui::WaypointPreview preview;
    for (const edit::Key& key : desk.editing.selected()) {
      const map::Waypoint& from = *desk.editing.find(key);
      preview.emplace_hint(preview.end(), key,
                           placing::Spot{from.position_m + Eigen::Vector2d(x, 0), from.yaw_rad});
    }
    x += 0.01;
    desk.editing.setPreview(std::move(preview));
  }
}
BENCHMARK(waypointsDrag)->Arg(10'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

/// All of them at once, let go: the document, the table, the form, the map and what is doubtful follow.
void waypointsMoveAll(benchmark::State& state) {
  Desk desk(int(state.range(0)));
  ui::WaypointWarnings warnings(&desk.editing, std::make_shared<work::Workers>());
  desk.on_map.setWarnings(&warnings);
  desk.dock.setWarnings(&warnings);
  desk.editing.setDocument(&desk.document, {});
  desk.editing.selectAll();
  for (auto _ : state) desk.editing.moveSelected({0.01, 0});
}
BENCHMARK(waypointsMoveAll)->Arg(1'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

/// A frame of the map in which all are in the hand.
void waypointsPaintSelected(benchmark::State& state) {
  Desk desk(int(state.range(0)));
  desk.editing.setDocument(&desk.document, {});
  desk.editing.selectAll();
  desk.editing.moveSelected({0.01, 0});
  geometry::ViewTransform camera = desk.scene.view();
  camera.width_px = 1000;
  camera.height_px = 700;
  camera.center_m = {25, 50};
  camera.scale_m_per_px = 0.15;
  desk.scene.setView(camera);
  QImage picture(1000, 700, QImage::Format_ARGB32_Premultiplied);
  for (auto _ : state) {
    QPainter painter(&picture);
    desk.scene.render(&painter, QRectF(0, 0, 1000, 700), QRectF(0, 0, 1000, 700));
  }
}
BENCHMARK(waypointsPaintSelected)->Arg(1'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

void waypointsDragBaseline(benchmark::State& state) {
  ui::scene::DrawnWaypoints drawn{map::MapKey{map::MapKind::Stored, "1"}, {}};
  for (const auto& [key, point] : waypoints(int(state.range(0)))) {
    ui::scene::DrawnWaypoint one;
    one.name = point.name;
    one.position_m = point.position_m;
    drawn.points.push_back(std::move(one));
  }
  for (auto _ : state) {
    auto copy = drawn;
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(waypointsDragBaseline)->Arg(10'000)->Unit(benchmark::kMillisecond);

void waypointsSelectAll(benchmark::State& state) {
  Desk desk(int(state.range(0)));
  desk.editing.setDocument(&desk.document, {});
  const auto all = desk.some(desk.document.items().size());
  for (auto _ : state) {
    desk.editing.select(all);
    desk.editing.select({});
  }
}
BENCHMARK(waypointsSelectAll)->Arg(10'000)->Arg(20'000)->Unit(benchmark::kMillisecond);

/// Every name goes on to the next one: one long ring.
void waypointsSavePlan(benchmark::State& state) {
  const auto items = waypoints(int(state.range(0)));
  robot::StoredWaypoints now;
  std::vector<robot::WaypointChange> changes;
  for (const auto& [key, point] : items) now.points.push_back(point);
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    map::Waypoint after = now.points[i];
    after.name = now.points[(i + 1) % now.points.size()].name;
    after.position_m.x() += 1;
    changes.push_back({after.id, now.points[i], after});
  }
  for (auto _ : state) benchmark::DoNotOptimize(robot::ros::planWaypoints(now, changes));
}
BENCHMARK(waypointsSavePlan)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
