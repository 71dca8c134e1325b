// Ten thousand overlays in the window: reading and opening them, dragging a thousand, snapping among them,
// one edit, and what others changed. The baseline of the drag is copying what is drawn.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <QApplication>
#include <QGraphicsView>
#include <QImage>
#include <QPainter>
#include <benchmark/benchmark.h>

#include "overlays/overlay_edits.h"
#include "overlays/overlay_merge.h"
#include "overlays/overlay_paste.h"
#include "render/tile_renderer.h"
#include "ui/overlays/overlay_tool.h"
#include "ui/overlays/overlays_dock.h"
#include "ui/overlays/overlays_on_map.h"
#include "ui/scene/map_scene.h"

namespace {

using namespace mapwright;
using overlays::FeatureKey;
using overlays::OverlayDocument;

/// Points, walls and regions of a warehouse.
std::string overlaysText(int count) {
  std::string text = R"({"type": "FeatureCollection", "features": [)";
  for (int i = 0; i < count; ++i) {
    const int x = i % 100 * 2, y = i / 100 * 2;
    const auto place = [&](std::initializer_list<std::pair<int, int>> corners) {
      for (const auto& [dx, dy] : corners) {
        if (text.back() == ']') text += ", ";
        text.append("[").append(std::to_string(x + dx)).append(".25, ");
        text.append(std::to_string(y + dy)).append(".5]");
      }
    };
    text.append(i > 0 ? ",\n" : "\n").append(R"({"id": "65a00000000000000)");
    text.append(std::to_string(1'000'000 + i)).append(R"(", "type": "Feature", "geometry": {"type": ")");
    if (i % 3 == 0) {
      text.append(R"(Point", "coordinates": )");
      place({{0, 0}});
      text.append(R"(}, "properties": {"type": "34", "yaw": 90)");
    } else if (i % 3 == 1) {
      text.append(R"(LineString", "coordinates": [)");
      place({{0, 0}, {1, 0}, {1, 1}});
      text.append(R"(]}, "properties": {"lineType": "2")");
    } else {
      text.append(R"(Polygon", "coordinates": [[)");
      place({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}});
      text.append(R"(]]}, "properties": {"regionType": 1, "blocked": false)");
    }
    text.append(R"(, "mapOverlay": true, "name": "Shelf )").append(std::to_string(i)).append("\"}}");
  }
  return text + "]}";
}

/// List, table, form, tool and map, as the window has them.
struct OverlayDesk {
  OverlayDesk()
      : on_map(&editing, &scene),
        snapping(&editing, &scene, &on_map),
        tool(&editing, &scene, &on_map, &snapping),
        dock(&editing, &tool) {
    on_map.setMap(map::MapKey{map::MapKind::Stored, "1"}, false);
    dock.resize(320, 900);
  }
  std::set<FeatureKey> some(std::size_t count) const {
    std::set<FeatureKey> keys;
    for (FeatureKey key = 0; key < count; ++key) keys.insert(key);
    return keys;
  }

  ui::scene::MapScene scene{{}};
  edit::OverlayEditing editing;
  ui::OverlaysOnMap on_map;
  ui::OverlaySnapping snapping;
  ui::OverlayTool tool;
  ui::OverlaysDock dock;
};

void overlaysRead(benchmark::State& state) {
  const std::string text = overlaysText(int(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(OverlayDocument::read(text));
}
BENCHMARK(overlaysRead)->Arg(10'000)->Unit(benchmark::kMillisecond);

void overlaysOpen(benchmark::State& state) {
  OverlayDesk desk;
  const std::string text = overlaysText(int(state.range(0)));
  for (auto _ : state) {
    desk.editing.open(*OverlayDocument::read(text));
    desk.dock.grab();
    state.PauseTiming();
    desk.editing.close();
    state.ResumeTiming();
  }
}
BENCHMARK(overlaysOpen)->Arg(10'000)->Unit(benchmark::kMillisecond);

void overlaysDrag(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  desk.editing.select(desk.some(1'000));
  double x = 0;
  for (auto _ : state) {
    edit::OverlayEditing::Preview preview;
    x += 0.01;
    for (const FeatureKey key : desk.editing.selected())
      preview.emplace(key, overlays::movedBy(*desk.editing.document().find(key), {x, 0}));
    desk.snapping.place({x, 1}, {}, desk.editing.selected());
    desk.editing.setPreview(std::move(preview));
    QApplication::processEvents();
  }
}
BENCHMARK(overlaysDrag)->Arg(10'000)->Unit(benchmark::kMillisecond);

void overlaysDragPaint(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  desk.editing.select(desk.some(1'000));
  QImage screen(1920, 1080, QImage::Format_ARGB32_Premultiplied);
  for (auto _ : state) {
    QPainter painter(&screen);
    desk.tool.paint(painter);
  }
}
BENCHMARK(overlaysDragPaint)->Arg(10'000)->Unit(benchmark::kMillisecond);

/// A whole frame of a drag of 1,000, all in view.
void overlaysDragFrame(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  desk.editing.select(desk.some(1'000));
  QGraphicsView view(&desk.scene);
  view.setFrameShape(QFrame::NoFrame);
  view.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view.resize(1366, 740);
  view.show();
  geometry::ViewTransform camera;
  camera.width_px = 1366;
  camera.height_px = 740;
  const geometry::WorldRect all = desk.on_map.boundsOf(desk.some(std::size_t(state.range(0))));
  camera.center_m = {(all.min_x + all.max_x) / 2, (all.min_y + all.max_y) / 2};
  camera.scale_m_per_px = std::max((all.max_x - all.min_x) / 1366, (all.max_y - all.min_y) / 740);
  desk.scene.setView(camera);
  QImage screen(1366, 740, QImage::Format_ARGB32_Premultiplied);
  double x = 0;
  for (auto _ : state) {
    edit::OverlayEditing::Preview preview;
    x += 0.01;
    for (const FeatureKey key : desk.editing.selected())
      preview.emplace(key, overlays::movedBy(*desk.editing.document().find(key), {x, 0}));
    desk.editing.setPreview(std::move(preview));
    QApplication::processEvents();
    view.viewport()->repaint();
    QPainter painter(&screen);
    desk.tool.paint(painter);
  }
}
BENCHMARK(overlaysDragFrame)->Arg(10'000)->Unit(benchmark::kMillisecond);

/// The end of a drag: one step, with list, form and map anew.
void overlaysEdit(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  desk.editing.select(desk.some(std::size_t(state.range(1))));
  double x = 0;
  for (auto _ : state) {
    x += 0.01;
    desk.editing.changeSelected(QStringLiteral("move"), [x](const overlays::Feature& feature) {
      return overlays::movedBy(feature, {x, 0});
    });
    QApplication::processEvents();
  }
}
BENCHMARK(overlaysEdit)->Args({10'000, 1})->Args({10'000, 1'000})->Unit(benchmark::kMillisecond);

/// An arrow key that is held down: all steps of it are one.
void overlaysNudge(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  desk.editing.select(desk.some(std::size_t(state.range(0))));
  for (auto _ : state) {
    desk.editing.changeSelected(
        QStringLiteral("move"),
        [](const overlays::Feature& feature) {
          return overlays::movedBy(feature, {0.05, 0});
        },
        1);
    QApplication::processEvents();
  }
}
BENCHMARK(overlaysNudge)->Arg(10'000)->Unit(benchmark::kMillisecond);

/// Everything was moved, and the robot holds one feature more than before: what a save works out.
void overlaysMerge(benchmark::State& state) {
  const OverlayDocument base = *OverlayDocument::read(overlaysText(int(state.range(0))));
  OverlayDocument mine = base, theirs = base;
  for (std::size_t i = 0; i < base.features().size(); ++i)
    mine.replace(i, overlays::movedBy(base.features()[i], {0.05, 0}));
  if (state.range(1) != 0) theirs.add(overlays::movedBy(base.features().front(), {1, 1}));
  for (auto _ : state) benchmark::DoNotOptimize(overlays::merge(base, mine, theirs));
}
BENCHMARK(overlaysMerge)->Args({10'000, 0})->Args({10'000, 1})->Unit(benchmark::kMillisecond);

void overlaysSelect(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  bool other = false;
  for (auto _ : state) {
    desk.editing.select(desk.some((other = !other) ? 1'000 : 999));
    QApplication::processEvents();
  }
}
BENCHMARK(overlaysSelect)->Arg(10'000)->Unit(benchmark::kMillisecond);

void overlaysSnap(benchmark::State& state) {
  OverlayDesk desk;
  desk.editing.open(*OverlayDocument::read(overlaysText(int(state.range(0)))));
  double x = 0;
  for (auto _ : state) {
    x = x > 190 ? 0 : x + 0.37;
    benchmark::DoNotOptimize(desk.snapping.place({x, 77.7}, {}, {}));
  }
}
BENCHMARK(overlaysSnap)->Arg(10'000)->Unit(benchmark::kMicrosecond);

/// Somebody else changed one of them.
void overlaysRebase(benchmark::State& state) {
  OverlayDesk desk;
  const OverlayDocument held = *OverlayDocument::read(overlaysText(int(state.range(0))));
  desk.editing.open(held);
  OverlayDocument theirs = held;
  double x = 0;
  for (auto _ : state) {
    x += 0.01;
    theirs.replace(7, overlays::movedBy(held.features()[7], {x, 0}));
    desk.editing.rebase(theirs, false);
    QApplication::processEvents();
  }
}
BENCHMARK(overlaysRebase)->Arg(10'000)->Unit(benchmark::kMillisecond);

void overlaysPaste(benchmark::State& state) {
  const std::string text = overlaysText(int(state.range(0)));
  const OverlayDocument held = *OverlayDocument::read(text);
  int number = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(overlays::madeFree(held, *overlays::pastedFeatures(text),
                                                [&number] { return "new" + std::to_string(++number); }));
  }
}
BENCHMARK(overlaysPaste)->Arg(10'000)->Unit(benchmark::kMillisecond);

/// All of them once more, selected in the list between those that are there: what Ctrl+V makes.
void overlaysPasteBetween(benchmark::State& state) {
  const std::string text = overlaysText(int(state.range(0)));
  const OverlayDocument held = *OverlayDocument::read(text);
  OverlayDesk desk;
  desk.dock.show();
  for (auto _ : state) {
    state.PauseTiming();
    desk.editing.close();
    desk.editing.open(held);
    desk.editing.select(desk.some(std::size_t(state.range(0))));
    QApplication::processEvents();
    state.ResumeTiming();
    desk.editing.paste(*overlays::pastedFeatures(text), Eigen::Vector2d(5, 5));
  }
}
BENCHMARK(overlaysPasteBetween)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
