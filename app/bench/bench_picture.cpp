// Editing a whole map: a step of a stroke, filling all of it, undoing that, tidying up, and all that in the
// window. The fill's baseline is OpenCV's on one picture in memory, which has no levels of detail and cannot
// be undone.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "picture/draw.h"
#include "picture/merge.h"
#include "picture/tidy.h"
#include "robot/files/file_address.h"
#include "robot/files/file_robot.h"
#include "ui/picture/picture_controller.h"
#include "ui/picture/picture_tool.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_view.h"
#include "ui/view/tool_choice.h"
#include "ui/window/main_window.h"

namespace {

using namespace mapwright;
using namespace mapwright::picture;

constexpr std::uint8_t kFree = 0, kOccupied = 100, kUnknown = 255;

std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

/// Rooms with doors, a speck in every 200 cells.
std::uint8_t cellAt(int x, int y) {
  const int room_x = x % 400, room_y = y % 400;
  const bool door = (room_x > 150 && room_x < 190) || (room_y > 150 && room_y < 190);
  if ((room_x < 3 || room_y < 3) && !door) return kOccupied;
  const std::uint32_t dice = noise(std::uint32_t(y) * 65'599u + std::uint32_t(x));
  return dice % 200 == 0 ? kOccupied : dice % 331 == 0 ? kUnknown : kFree;
}

std::shared_ptr<const grids::GridPyramid> mapOf(int edge) {
  static std::shared_ptr<const grids::GridPyramid> made;
  if (made && made->width() == edge) return made;
  const auto builder =
      grids::buildGrid(edge, edge, grids::CellCode::Occupancy, grids::Reduction::OccupiedWins);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(edge));
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) row[std::size_t(x)] = cellAt(x, y);
    builder->pushRow(row);
  }
  builder->finish();
  made = builder->pyramid();
  return made;
}

/// One movement of the hand, 12 cells far, with all that the window reckons for it but drawing. Round and
/// round, each lap in another colour: what is painted already costs nothing.
void pictureStroke(benchmark::State& state) {
  constexpr int kLap = 126;
  EditedGrid grid(mapOf(int(state.range(0))));
  std::optional<Stroke> stroke;
  Eigen::Vector2d at(double(state.range(0)) / 2, double(state.range(0)) / 2);
  std::size_t tiles = 0;
  int step = 0;
  for (auto _ : state) {
    if (step % kLap == 0) {
      const std::uint8_t byte = step / kLap % 2 == 0 ? kOccupied : kFree;
      stroke.emplace(grid, Brush{int(state.range(1)), {byte, {}}});
    }
    const double angle = 2 * M_PI * step / kLap;
    at += Eigen::Vector2d(std::cos(angle), std::sin(angle)) * 12;
    ++step;
    benchmark::DoNotOptimize(stroke->to(at));
    tiles = std::max(tiles, stroke->soFar().tiles.size());
  }
  state.counters["tiles held"] = double(tiles);
}
BENCHMARK(pictureStroke)
    ->Name("PictureStroke")
    ->ArgNames({"map", "brush"})
    ->Args({1'000, 9})
    ->Args({12'000, 9})
    ->Args({12'000, 101})
    ->Args({12'000, 1'000})
    ->Unit(benchmark::kMicrosecond);

void pictureFill(benchmark::State& state) {
  const EditedGrid grid(mapOf(int(state.range(0))));
  std::size_t tiles = 0;
  for (auto _ : state) {
    const auto copy = grid.snapshot();
    Canvas canvas(*copy);
    floodFill(canvas, 5, 5, {kUnknown, {}});
    const Patch patch = canvas.take();
    copy->apply(patch);
    tiles = patch.tiles.size();
  }
  state.counters["tiles"] = double(tiles);
}
BENCHMARK(pictureFill)
    ->Name("PictureFill")
    ->ArgName("map")
    ->Arg(4'000)
    ->Arg(12'000)
    ->Unit(benchmark::kMillisecond);

void pictureFillOpenCv(benchmark::State& state) {
  const int edge = int(state.range(0));
  cv::Mat cells(edge, edge, CV_8U);
  for (int y = 0; y < edge; ++y) {
    for (int x = 0; x < edge; ++x) cells.at<std::uint8_t>(y, x) = cellAt(x, y);
  }
  cv::setNumThreads(1);
  for (auto _ : state) {
    state.PauseTiming();
    cv::Mat copy = cells.clone();
    state.ResumeTiming();
    cv::floodFill(copy, cv::Point(5, 5), cv::Scalar(kUnknown));
  }
}
BENCHMARK(pictureFillOpenCv)
    ->Name("PictureFillOpenCV")
    ->ArgName("map")
    ->Arg(4'000)
    ->Arg(12'000)
    ->Unit(benchmark::kMillisecond);

/// Undoing and redoing the fill of all, with the count of what is changed.
void pictureUndo(benchmark::State& state) {
  EditedGrid grid(mapOf(int(state.range(0))));
  const auto saved = grid.snapshot();
  Canvas canvas(grid);
  floodFill(canvas, 5, 5, {kUnknown, {}});
  const Patch patch = canvas.take();
  grid.apply(patch);
  DifferenceCount count;
  for (auto _ : state) {
    grid.revert(patch);
    count.recount(grid, *saved, patch);
    state.PauseTiming();
    grid.apply(patch);
    state.ResumeTiming();
  }
}
BENCHMARK(pictureUndo)->Name("PictureUndo")->ArgName("map")->Arg(12'000)->Unit(benchmark::kMillisecond);

void pictureCount(benchmark::State& state) {
  EditedGrid grid(mapOf(int(state.range(0))));
  const auto saved = grid.snapshot();
  Canvas canvas(grid);
  floodFill(canvas, 5, 5, {kUnknown, {}});
  const Patch patch = canvas.take();
  grid.apply(patch);
  DifferenceCount count;
  for (auto _ : state) count.recount(grid, *saved, patch);
  state.counters["cells"] = double(count.cells);
}
BENCHMARK(pictureCount)->Name("PictureCount")->ArgName("map")->Arg(12'000)->Unit(benchmark::kMillisecond);

void pictureSpecks(benchmark::State& state) {
  const EditedGrid grid(mapOf(int(state.range(0))));
  Tidied tidied;
  for (auto _ : state) {
    Canvas canvas(grid);
    tidied = removeSpecks(canvas, canvas.all(), 4);
    benchmark::DoNotOptimize(canvas.take());
  }
  state.counters["specks"] = double(tidied.pieces);
}
BENCHMARK(pictureSpecks)
    ->Name("PictureSpecks")
    ->ArgName("map")
    ->Arg(4'000)
    ->Arg(12'000)
    ->Unit(benchmark::kMillisecond);

// The window itself, on a map in a file.

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

template <typename Done>
bool waitFor(Done done) {
  QElapsedTimer waited;
  waited.start();
  while (!done() && waited.elapsed() < 120'000)
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 5);
  return done();
}

/// How long the thread that draws the window was away at most, between two turns of its loop.
template <typename Done>
double longestTurnUntil(Done done) {
  double longest = 0;
  QElapsedTimer waited;
  waited.start();
  while (!done() && waited.elapsed() < 120'000) {
    const auto from = Clock::now();
    QCoreApplication::processEvents();
    longest = std::max(longest, msSince(from));
  }
  return longest;
}

class Desk {
 public:
  explicit Desk(int edge)
      : edge_(edge), settings_(folder_.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {
    QFile pgm(folder_.filePath(QStringLiteral("hall.pgm")));
    (void)pgm.open(QIODevice::WriteOnly);
    const QByteArray size = QByteArray::number(edge);
    pgm.write("P5\n" + size + ' ' + size + "\n255\n");
    QByteArray row(edge, char(254));
    for (int y = 0; y < edge; ++y) {
      for (int x = 0; x < edge; ++x) {
        const std::uint8_t cell = cellAt(x, y);
        row[x] = char(cell == kFree ? 254 : cell == kOccupied ? 0 : 205);
      }
      pgm.write(row);
    }
    QFile yaml(folder_.filePath(QStringLiteral("hall.yaml")));
    (void)yaml.open(QIODevice::WriteOnly);
    yaml.write(
        "image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
        "free_thresh: 0.196\n");
  }

  /// Until it can be edited; milliseconds.
  double open() {
    window_.reset();
    ui::MainWindow::Dependencies wanted{
        [](const QString& address,
           const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          robot::files::FileOptions options;
          options.path = address.mid(int(qstrlen("file:")));
          return std::make_unique<robot::files::FileRobot>(address, options);
        },
        settings_};
    wanted.addresses = robot::Addresses({robot::files::addressScheme()});
    window_ = std::make_unique<ui::MainWindow>(std::move(wanted));
    window_->resize(1366, 768);
    window_->show();
    window_->view()->setAnimationMs(0);
    QCoreApplication::processEvents();
    const auto from = Clock::now();
    (void)window_->connectTo(QStringLiteral("file:") + folder_.filePath(QStringLiteral("hall.yaml")));
    (void)waitFor([this] { return editing().isOpen(); });
    return msSince(from);
  }
  /// The tool is in the hand, `cells` cells a pixel in the middle of the map.
  void begin(double cells, int across) {
    QMetaObject::invokeMethod(window_->actionList().find(QLatin1String("pictureTool")), "trigger");
    editing().setAcross(across);
    geometry::ViewTransform camera = window_->mapScene()->view();
    camera.center_m = {edge_ * 0.025, edge_ * 0.025};
    camera.scale_m_per_px = 0.05 * cells;
    window_->view()->moveTo(camera, false);
    (void)waitFor([this] { return settled(); });
  }
  edit::PictureEditing& editing() { return *window_->findChild<ui::PictureController*>()->editing(); }
  bool settled() { return window_->mapScene()->settled(); }
  QWidget* map() { return window_->view()->viewport(); }
  void mouse(QEvent::Type type, const QPointF& at) {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, at, map()->mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QCoreApplication::sendEvent(map(), &event);
  }

 private:
  int edge_;
  QTemporaryDir folder_;
  QSettings settings_;
  std::unique_ptr<ui::MainWindow> window_;
};

Desk& desk(int edge) {
  static std::unique_ptr<Desk> made;
  static int made_edge = 0;
  if (!made) qAddPostRoutine([] { made.reset(); });  // a window ends before its application
  if (!made || std::exchange(made_edge, edge) != edge) made = std::make_unique<Desk>(edge);
  return *made;
}

void report(benchmark::State& state, const char* name, std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  state.counters[std::string(name) + "_p50_ms"] = ms[ms.size() / 2];
  state.counters[std::string(name) + "_p99_ms"] = ms[ms.size() * 99 / 100];
}

void windowOpens(benchmark::State& state) {
  for (auto _ : state) state.SetIterationTime(desk(int(state.range(0))).open() / 1000);
}
BENCHMARK(windowOpens)
    ->Name("PictureWindowOpens")
    ->ArgName("map")
    ->Arg(12'000)
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// A stroke by hand: from the movement of the mouse to the frame, and to the frame that has all of it.
void windowStroke(benchmark::State& state) {
  constexpr int kMoves = 300;
  Desk& at = desk(int(state.range(0)));
  at.open();
  at.begin(double(state.range(2)), int(state.range(1)));
  std::vector<double> frame, shown;
  for (auto _ : state) {
    const QPointF middle = QPointF(at.map()->rect().center());
    at.mouse(QEvent::MouseButtonPress, middle);
    for (int i = 0; i < kMoves; ++i) {
      const double angle = 2 * M_PI * i / 100, far = 80.0 + i / 3.0;
      const auto from = Clock::now();
      at.mouse(QEvent::MouseMove, middle + QPointF(std::cos(angle), std::sin(angle)) * far);
      QCoreApplication::processEvents();
      at.map()->repaint();
      frame.push_back(msSince(from));
      (void)waitFor([&] { return at.settled(); });
      at.map()->repaint();
      shown.push_back(msSince(from));
    }
    at.mouse(QEvent::MouseButtonRelease, middle);
  }
  report(state, "frame", frame);
  report(state, "shown", shown);
}
BENCHMARK(windowStroke)
    ->Name("PictureWindowStroke")
    ->ArgNames({"map", "brush", "cells_a_pixel"})
    ->Args({12'000, 9, 1})
    ->Args({12'000, 101, 1})
    ->Args({12'000, 101, 10})
    ->Args({12'000, 1'000, 10})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// Filling and tidying up: how long until it is there, and how long the window stood still at most.
void windowLongWork(benchmark::State& state) {
  Desk& at = desk(int(state.range(0)));
  at.open();
  at.begin(10, 9);
  double still = 0, undo = 0;
  const double pixel_m = 0.05;
  for (auto _ : state) {
    const auto from = Clock::now();
    if (state.range(1) == 0) {
      at.editing().setKind(at.editing().kind() == Kind::Unknown ? Kind::Free : Kind::Unknown);
      at.editing().fill({5 * pixel_m, 5 * pixel_m});
    } else {
      at.editing().lookFor(edit::Tidying::Specks, 4);
    }
    still = std::max(still, msSince(from));
    still = std::max(still,
                     longestTurnUntil([&] { return !at.editing().reckoning() && !at.editing().looking(); }));
    state.SetIterationTime(msSince(from) / 1000);
    const auto undone = Clock::now();
    at.editing().dropPreview();
    at.editing().undoStack().undo();
    undo = std::max(undo, msSince(undone));
  }
  state.counters["window_stood_ms"] = still;
  state.counters["undo_ms"] = undo;
}
BENCHMARK(windowLongWork)
    ->Name("PictureWindowFill0Specks1")
    ->ArgNames({"map", "what"})
    ->Args({12'000, 0})
    ->Args({12'000, 1})
    ->Iterations(2)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
