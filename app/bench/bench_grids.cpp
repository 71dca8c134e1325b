// Reading whole maps: our pyramid next to QImageReader, OpenCV and libvips on the same file, each in a
// process of its own so that its peak memory is its own. Choose a size by its name:
// --benchmark_filter=GridLoad/4000.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <QImageReader>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <spng.h>

#include "grids/grid_pyramid.h"
#include "render/sample_grid.h"

namespace {

using namespace mapwright;
using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point from) {
  return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

struct Size {
  int width, height;
  std::string name() const { return std::to_string(width) + "x" + std::to_string(height); }
};

std::uint32_t noise(std::uint32_t seed) {
  seed ^= seed >> 16;
  seed *= 0x7feb352d;
  seed ^= seed >> 15;
  seed *= 0x846ca68b;
  return seed ^ seed >> 16;
}

/// What a robot's map is like: halls in unknown ground, walls of a few cells, some shelves, and speckle where
/// the lidar was in doubt.
std::uint8_t mapCell(int x, int y) {
  constexpr int kHall = 3000, kRoom = 400;
  const int hall_x = x / kHall, hall_y = y / kHall;
  if (noise(std::uint32_t(hall_x * 131 + hall_y)) % 10 < 4) return 128;
  const int room_x = x % kRoom, room_y = y % kRoom;
  const std::uint32_t room = noise(std::uint32_t(x / kRoom * 7919 + y / kRoom));
  const bool door = (room_x > 150 && room_x < 190) || (room_y > 150 && room_y < 190);
  if ((room_x < 3 || room_y < 3) && !door) return std::uint8_t(noise(std::uint32_t(x * 31 + y)) % 48);
  if (room % 8 == 0) return 128;
  if (room % 3 == 0 && room_x % 40 > 30 && room_y % 90 > 15 && room_x > 40)
    return room_x % 40 == 31 ? 20 : 128;
  const std::uint32_t dice = noise(std::uint32_t(y) * 65599u + std::uint32_t(x));
  const int wall_distance = std::min(room_x, room_y);
  if (wall_distance < 8 && dice % 3 == 0) return std::uint8_t(160 + dice / 3 % 90);
  if (dice % 200 == 0) return std::uint8_t(dice / 200 % 256);
  return 255;
}

bool writeMap(const Size& size, const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  spng_set_png_file(context.get(), file);
  spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 6);
  spng_ihdr header{};
  header.width = std::uint32_t(size.width);
  header.height = std::uint32_t(size.height);
  header.bit_depth = 8;
  spng_set_ihdr(context.get(), &header);
  bool good = spng_encode_image(context.get(), nullptr, 0, SPNG_FMT_PNG,
                                SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE) == 0;
  std::vector<std::uint8_t> row(std::size_t(size.width));
  for (int y = 0; good && y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) row[std::size_t(x)] = mapCell(x, y);
    const int result = spng_encode_row(context.get(), row.data(), row.size());
    good = result == 0 || (result == SPNG_EOI && y + 1 == size.height);
  }
  return std::fclose(file) == 0 && good;
}

/// The files of this run, each made when it is first asked for.
class MapFiles {
 public:
  /// Empty when it cannot be written.
  std::string file(const Size& size) {
    const std::string path = folder_.filePath(QString::fromStdString(size.name() + ".png")).toStdString();
    if (!made_.contains(path)) made_[path] = writeMap(size, path);
    return made_[path] ? path : std::string();
  }
  std::string folder(const std::string& name) const {
    return folder_.filePath(QString::fromStdString(name)).toStdString();
  }

 private:
  QTemporaryDir folder_;
  std::map<std::string, bool> made_;
};

struct Outcome {
  double complete_ms = 0, first_rows_ms = 0;
  double peak_mb = 0, cpu_ms = 0;
  bool refused = false;
};

double peakMb(const rusage& usage) { return double(usage.ru_maxrss) / 1024; }
double cpuMs(const rusage& usage) {
  const auto ms = [](const timeval& time) { return double(time.tv_sec) * 1e3 + double(time.tv_usec) / 1e3; };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

double residentMb() {
  long all = 0, resident = 0;
  if (std::FILE* statm = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(statm, "%ld %ld", &all, &resident) != 2) resident = 0;
    std::fclose(statm);
  }
  return double(resident) * double(::sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

/// Runs `work` in a child; its peak counts beyond what it had when it started.
bool inChild(const std::function<void(Outcome&)>& work, Outcome& outcome) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return false;
  const pid_t child = ::fork();
  if (child < 0) return false;
  if (child == 0) {
    const double before = residentMb();
    Outcome own;
    work(own);
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    own.peak_mb = peakMb(usage) - before;
    own.cpu_ms = cpuMs(usage);
    const ssize_t written = ::write(ends[1], &own, sizeof(own));
    ::_exit(written == ssize_t(sizeof(own)) ? 0 : 1);
  }
  ::close(ends[1]);
  const bool good = ::read(ends[0], &outcome, sizeof(outcome)) == ssize_t(sizeof(outcome));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return good;
}

/// Runs a program; false when it is not there or fails.
bool runProgram(std::vector<std::string> words, Outcome& outcome) {
  const auto from = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) return false;
  if (child == 0) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  outcome.complete_ms = msSince(from);
  outcome.peak_mb = peakMb(usage);
  outcome.cpu_ms = cpuMs(usage);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void readOurs(const std::string& path, const std::string& sidecars, Outcome& outcome) {
  grids::GridOptions options;
  options.sidecar_folder = sidecars;
  if (!sidecars.empty()) options.fingerprint = path;
  const auto from = Clock::now();
  auto reading = grids::openGridFile(path, options);
  if (!reading) {
    outcome.refused = true;
    return;
  }
  const std::atomic<bool> cancelled{false};
  bool first = true;
  const auto problem = (*reading)->read(cancelled, [&] {
    if (first && (*reading)->pyramid()->tile(0, 0, 0)) outcome.first_rows_ms = msSince(from);
    first = false;
  });
  outcome.complete_ms = msSince(from);
  outcome.refused = problem.has_value();
}

void readQt(const std::string& path, Outcome& outcome) {
  const auto from = Clock::now();
  QImageReader::setAllocationLimit(0);
  QImageReader reader(QString::fromStdString(path));
  const QImage image = reader.read();
  outcome.complete_ms = outcome.first_rows_ms = msSince(from);
  outcome.refused = image.isNull();
}

void readOpenCv(const std::string& path, Outcome& outcome) {
  const auto from = Clock::now();
  try {
    outcome.refused = cv::imread(path, cv::IMREAD_UNCHANGED).empty();
  } catch (const cv::Exception&) {
    outcome.refused = true;
  }
  outcome.complete_ms = outcome.first_rows_ms = msSince(from);
}

/// What all benchmarks of a run share: the files, and QImageReader's figures to compare with.
struct Run {
  MapFiles files;
  std::map<std::string, Outcome> baseline;
};

using Contender = std::function<bool(const std::string& path, const Run& run, Outcome& outcome)>;

void measure(benchmark::State& state, const std::shared_ptr<Run>& run, const Size& size,
             const std::string& name, const Contender& contender) {
  const std::string path = run->files.file(size);
  if (path.empty()) return state.SkipWithError("the map could not be written");
  Outcome outcome;
  for (auto _ : state) {
    if (!contender(path, *run, outcome)) return state.SkipWithError("not installed, or it failed");
    state.SetIterationTime(outcome.complete_ms / 1e3);
  }
  state.counters["peak_MB"] = outcome.peak_mb;
  state.counters["cpu_ms"] = outcome.cpu_ms;
  if (outcome.first_rows_ms > 0) state.counters["first_rows_ms"] = outcome.first_rows_ms;
  if (outcome.refused) state.counters["refused"] = 1;
  if (name == "qimagereader") run->baseline[size.name()] = outcome;
  const auto baseline = run->baseline.find(size.name());
  if (baseline == run->baseline.end() || outcome.refused) return;
  state.counters["time_vs_qt"] = outcome.complete_ms / baseline->second.complete_ms;
  state.counters["memory_vs_qt"] = outcome.peak_mb / baseline->second.peak_mb;
}

std::vector<std::pair<std::string, Contender>> contenders() {
  const auto forked = [](void (*read)(const std::string&, Outcome&)) {
    return [read](const std::string& path, const Run&, Outcome& outcome) {
      return inChild([&](Outcome& own) { read(path, own); }, outcome);
    };
  };
  const auto ours = [](const char* sidecars) {
    return [sidecars](const std::string& path, const Run& run, Outcome& outcome) {
      const std::string folder = *sidecars == '\0' ? std::string() : run.files.folder(sidecars);
      return inChild([&](Outcome& own) { readOurs(path, folder, own); }, outcome);
    };
  };
  return {
      {"qimagereader", forked(readQt)},
      {"ours", ours("sidecars")},
      {"ours_reopened", ours("sidecars")},
      {"ours_in_memory", ours("")},
      {"opencv", forked(readOpenCv)},
      {"vipsthumbnail",
       [](const std::string& path, const Run& run, Outcome& outcome) {
         return runProgram({"vipsthumbnail", path, "-s", "1024", "-o", run.files.folder("thumbnail.png")},
                           outcome);
       }},
      {"vips_pyramid",
       [](const std::string& path, const Run& run, Outcome& outcome) {
         return runProgram({"vips", "tiffsave", path, run.files.folder("pyramid.tif"), "--tile", "--pyramid",
                            "--compression", "lzw", "--bigtiff"},
                           outcome);
       }},
  };
}

// What a view of a whole map costs: the quick look that a window shows first, and the exact picture. One
// thread, tiles of 256 pixels as the window makes them.

grids::Reduction reductionOf(bool average) {
  return average ? grids::Reduction::Average : grids::Reduction::OccupiedWins;
}

struct Sampled {
  std::map<std::string, render::PlacedGrid> maps;  // by size and reduction, each made when first asked for

  const render::PlacedGrid& map(const Size& size, bool average) {
    render::PlacedGrid& made = maps[size.name() + (average ? "a" : "o")];
    if (made.cells) return made;
    const auto builder =
        grids::buildGrid(size.width, size.height, grids::CellCode::Gray, reductionOf(average));
    std::vector<std::uint8_t> row(std::size_t(size.width));
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) row[std::size_t(x)] = mapCell(x, y);
      builder->pushRow(row);
    }
    builder->finish();
    made = {builder->pyramid(), {size.width, size.height, 0.05, {0, 0, 0}}};
    return made;
  }
};

struct ViewCase {
  Size size;
  double cells_per_pixel;
  double rotation;
  bool average;
  render::Sampling sampling;
  std::string name() const {
    std::array<char, 120> text;
    std::snprintf(text.data(), text.size(), "GridView/%s/%g_cells%s/%s%s", size.name().c_str(),
                  cells_per_pixel, rotation != 0 ? "_turned" : "", average ? "average_" : "",
                  sampling == render::Sampling::Quick ? "quick" : "exact");
    return text.data();
  }
};

void measureView(benchmark::State& state, const std::shared_ptr<Sampled>& sampled, const ViewCase& view) {
  constexpr int kTile = 256;
  const render::PlacedGrid& placed = sampled->map(view.size, view.average);
  render::PixelGrid tile;
  tile.scale_m_per_px = placed.reference.resolution_m * view.cells_per_pixel;
  tile.rotation_rad = view.rotation;
  tile.origin_m = placed.reference.worldFromCell({view.size.width / 2.0, view.size.height / 2.0});
  tile.width_px = tile.height_px = kTile;
  // As far as the map reaches, but no more than a window shows.
  const int across = std::clamp(int(view.size.width / view.cells_per_pixel / kTile / 2), 1, 3);
  const int down = std::clamp(int(view.size.height / view.cells_per_pixel / kTile / 2), 1, 2);
  int tiles = 0;
  double ms = 0;
  for (auto _ : state) {
    const auto from = Clock::now();
    for (int y = -down; y < down; ++y) {
      for (int x = -across; x < across; ++x) {
        tile.first_column = x * kTile;
        tile.first_row = y * kTile;
        benchmark::DoNotOptimize(render::sampleGrid(tile, placed, nullptr, view.sampling));
        ++tiles;
      }
    }
    ms += msSince(from);
  }
  state.counters["ms_a_tile"] = ms / tiles;
}

[[maybe_unused]] const bool views_registered = [] {
  const auto sampled = std::make_shared<Sampled>();
  for (const Size& size : {Size{4000, 3000}, Size{20768, 13612}, Size{34641, 34641}}) {
    for (const double cells : {2.0, 8.0, 34.6}) {
      for (const double rotation : {0.0, 0.3}) {
        for (const bool average : {false, true}) {
          for (const render::Sampling sampling : {render::Sampling::Quick, render::Sampling::Exact}) {
            const ViewCase view{size, cells, rotation, average, sampling};
            benchmark::RegisterBenchmark(view.name().c_str(), [sampled, view](benchmark::State& state) {
              measureView(state, sampled, view);
            })->Unit(benchmark::kMillisecond);
          }
        }
      }
    }
  }
  return true;
}();

[[maybe_unused]] const bool registered = [] {
  const auto run = std::make_shared<Run>();
  for (const Size& size : {Size{4000, 3000}, Size{20768, 13612}, Size{34641, 34641}}) {
    for (const auto& [name, contender] : contenders()) {
      benchmark::RegisterBenchmark(("GridLoad/" + size.name() + "/" + name).c_str(),
                                   [run, size, name = name, contender = contender](benchmark::State& state) {
                                     measure(state, run, size, name, contender);
                                   })
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime()
          ->Iterations(1);
    }
  }
  return true;
}();

}  // namespace
