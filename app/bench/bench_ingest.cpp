// From a robot's gzipped cells to a texture with its levels: the product's way against the plain one, in one
// run, and the memory that a texture holds. Source of the data: Cartographer's painting, 41 % of the cells
// known.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <random>
#include <span>
#include <vector>
#include <zlib.h>

#include <benchmark/benchmark.h>

#include "cells/cell_texture.h"
#include "cells/decode_cells.h"

namespace {

using mapwright::cells::CellPair;
using mapwright::cells::CellTexture;

constexpr int kEdge = 400;
constexpr double kResolutionM = 0.05;
constexpr double kKnownShare = 0.41;
constexpr int kTextures = 8;  // several, so that no cache holds the one answer
constexpr int kRays = 2880;

/// A room as a laser scanner sees it: free space fanned out from the middle, walls where the rays end, and
/// the noise of hits and misses that real probability grids have.
std::vector<CellPair> scannedRoom(std::uint32_t seed) {
  std::minstd_rand random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> reach(kRays);
  const double phase = uniform(random) * 2 * std::numbers::pi;
  for (int ray = 0; ray < kRays; ++ray) {
    const double angle = 2 * std::numbers::pi * ray / kRays;
    reach[std::size_t(ray)] = 0.72 + 0.16 * std::sin(3 * angle + phase) +
                              0.1 * std::sin(7 * angle + 2 * phase) + 0.06 * std::sin(23 * angle);
  }
  // The rays are scaled until the share of known cells is the one that was measured.
  std::vector<CellPair> cells;
  double scale = double(kEdge) / 2;
  for (int round = 0; round < 12; ++round) {
    std::minstd_rand noise(seed + 1);
    cells.assign(std::size_t(kEdge) * kEdge, CellPair{});
    std::size_t known = 0;
    for (int v = 0; v < kEdge; ++v) {
      for (int u = 0; u < kEdge; ++u) {
        const double x = u - kEdge / 2.0;
        const double y = v - kEdge / 2.0;
        const double turn = std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
        const double limit = scale * reach[std::size_t(turn * kRays) % kRays];
        const double distance = std::hypot(x, y);
        if (distance > limit + 1.5) {
          continue;
        }
        const double jitter = uniform(noise);
        const bool wall = distance > limit - 1.5;
        if (distance > 0.8 * limit && !wall && jitter < 0.08) {
          continue;  // what the rays missed
        }
        // Cartographer's odds move in steps, one for every scan that saw the cell: few distinct values.
        const int scans = 1 + int(jitter * jitter * 12 * (1.2 - distance / (limit + 1.5)));
        const int delta = wall ? -std::min(127, 24 * scans) : std::min(127, 6 * scans + 10);
        cells[std::size_t(v) * kEdge + std::size_t(u)] =
            delta > 0 ? CellPair{std::uint8_t(delta), 0} : CellPair{0, std::uint8_t(-delta)};
        ++known;
      }
    }
    const double share = double(known) / double(cells.size());
    scale *= std::sqrt(kKnownShare / share);
  }
  return cells;
}

std::vector<std::uint8_t> gzipped(std::span<const CellPair> cells) {
  std::vector<std::uint8_t> plain;
  plain.reserve(2 * cells.size());
  for (const CellPair& cell : cells) {
    plain.push_back(cell.value);
    plain.push_back(cell.alpha);
  }
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::vector<std::uint8_t> packed(deflateBound(&stream, uLong(plain.size())));
  stream.next_in = plain.data();
  stream.avail_in = uInt(plain.size());
  stream.next_out = packed.data();
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.erase(packed.end() - std::ptrdiff_t(stream.avail_out), packed.end());
  deflateEnd(&stream);
  return packed;
}

std::vector<std::vector<std::uint8_t>> packedTextures() {
  std::vector<std::vector<std::uint8_t>> packed;
  for (std::uint32_t seed = 1; seed <= kTextures; ++seed) {
    packed.push_back(gzipped(scannedRoom(seed)));
  }
  return packed;
}

/// The plain way: zlib, a cell at a time, every level a dense picture.
std::vector<std::vector<CellPair>> plainLevels(std::span<const std::uint8_t> packed) {
  std::vector<std::uint8_t> plain(std::size_t(2) * kEdge * kEdge);
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = const_cast<Bytef*>(packed.data());
  stream.avail_in = uInt(packed.size());
  stream.next_out = plain.data();
  stream.avail_out = uInt(plain.size());
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END) {
    return {};
  }
  std::vector<std::vector<CellPair>> levels(1);
  levels[0].resize(std::size_t(kEdge) * kEdge);
  for (std::size_t i = 0; i < levels[0].size(); ++i) {
    levels[0][i] = {plain[2 * i], plain[2 * i + 1]};
  }
  for (int edge = kEdge; edge > 8; edge = (edge + 1) / 2) {
    const std::vector<CellPair>& fine = levels.back();
    const int half = (edge + 1) / 2;
    std::vector<CellPair> coarse(std::size_t(half) * std::size_t(half));
    for (int v = 0; v < half; ++v) {
      for (int u = 0; u < half; ++u) {
        int value = 0;
        int alpha = 0;
        for (int row = 2 * v; row < std::min(2 * v + 2, edge); ++row) {
          for (int column = 2 * u; column < std::min(2 * u + 2, edge); ++column) {
            const CellPair& cell = fine[std::size_t(row) * std::size_t(edge) + std::size_t(column)];
            value += cell.value;
            alpha += cell.alpha;
          }
        }
        coarse[std::size_t(v) * std::size_t(half) + std::size_t(u)] = {std::uint8_t((value + 2) / 4),
                                                                       std::uint8_t((alpha + 2) / 4)};
      }
    }
    levels.push_back(std::move(coarse));
  }
  return levels;
}

void ingestPlainZlib(benchmark::State& state) {
  const auto packed = packedTextures();
  std::size_t next = 0;
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto levels = plainLevels(packed[next++ % packed.size()]);
    if (levels.empty()) {
      state.SkipWithError("the data does not inflate");
      break;
    }
    bytes = 0;
    for (const auto& level : levels) {
      bytes += level.size() * sizeof(CellPair);
    }
    benchmark::DoNotOptimize(levels.back().data());
  }
  state.counters["textures/s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["MB_per_Mcell"] = double(bytes) / (double(kEdge) * kEdge);
}
BENCHMARK(ingestPlainZlib)->Unit(benchmark::kMicrosecond);

void ingestDecodeCells(benchmark::State& state) {
  const auto packed = packedTextures();
  std::size_t next = 0;
  std::size_t bytes = 0;
  double known = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto texture =
        mapwright::cells::decodeCells(packed[next++ % packed.size()], kEdge, kEdge, kResolutionM, 0);
    if (!texture) {
      state.SkipWithError("cells that cannot be decoded");
      break;
    }
    bytes = (*texture)->bytes();
    known = double((*texture)->observedCells()) / (double(kEdge) * kEdge);
    benchmark::DoNotOptimize(texture->get());
  }
  state.counters["textures/s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["MB_per_Mcell"] = double(bytes) / (double(kEdge) * kEdge);
  state.counters["known"] = known;
}
BENCHMARK(ingestDecodeCells)->Unit(benchmark::kMicrosecond);

void expandLevel(benchmark::State& state) {
  const auto texture = CellTexture::fromPairs(kEdge, kEdge, kResolutionM, scannedRoom(1));
  const int level = int(state.range(0));
  for ([[maybe_unused]] auto _ : state) {
    const auto dense = texture->expand(level);
    benchmark::DoNotOptimize(dense.data.data());
  }
}
BENCHMARK(expandLevel)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMicrosecond);

}  // namespace
