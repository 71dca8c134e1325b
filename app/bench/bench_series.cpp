// Five million samples: taking them in, and drawing them 2000 pixels wide. The baseline is what one does
// first: keep them in a list and look at all that are in view.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "series/series.h"

namespace {

using namespace mapwright;
using series::Sample;

constexpr int kSamples = 5'000'000, kColumns = 2'000;
constexpr double kStep_s = 0.01;

std::vector<Sample> samples() {
  std::vector<Sample> all;
  all.reserve(kSamples);
  for (int i = 0; i < kSamples; ++i)
    all.push_back({i * kStep_s, std::sin(i * 1e-4) + (i % 99'991 == 0 ? 5 : 0)});
  return all;
}

series::Series made(const std::vector<Sample>& all) {
  series::Series series({.most_samples = kSamples});
  series.insert(0, kSamples * kStep_s, all);
  return series;
}

void seriesAppend(benchmark::State& state) {
  const std::vector<Sample> all = samples();
  for (auto _ : state) {
    series::Series series({.most_samples = kSamples});
    for (const Sample& each : all) series.append(each.at_s, each.value);
    benchmark::DoNotOptimize(series.size());
    state.counters["bytes_per_sample"] = double(series.bytes()) / kSamples;
  }
  state.SetItemsProcessed(state.iterations() * kSamples);
}
BENCHMARK(seriesAppend)->Unit(benchmark::kMillisecond);

void seriesAppendNaively(benchmark::State& state) {
  const std::vector<Sample> all = samples();
  for (auto _ : state) {
    std::vector<Sample> list;
    for (const Sample& each : all) list.push_back(each);
    benchmark::DoNotOptimize(list.data());
  }
  state.SetItemsProcessed(state.iterations() * kSamples);
}
BENCHMARK(seriesAppendNaively)->Unit(benchmark::kMillisecond);

/// As a bag is read: from the wanted time back to its start, 1000 samples each.
void seriesInsertBackwards(benchmark::State& state) {
  const std::vector<Sample> all = samples();
  constexpr int kRange = 1'000;
  for (auto _ : state) {
    series::Series series({.most_samples = kSamples});
    for (int from = kSamples - kRange; from >= 0; from -= kRange)
      series.insert(from * kStep_s, (from + kRange) * kStep_s, {all.data() + from, kRange});
    benchmark::DoNotOptimize(series.size());
  }
  state.SetItemsProcessed(state.iterations() * kSamples);
}
BENCHMARK(seriesInsertBackwards)->Unit(benchmark::kMillisecond);

/// The share of all that is in view, in percent.
void seriesView(benchmark::State& state) {
  const series::Series series = made(samples());
  const double until_s = kSamples * kStep_s * double(state.range(0)) / 100;
  for (auto _ : state) benchmark::DoNotOptimize(series.strokes(0, until_s, kColumns));
}
BENCHMARK(seriesView)->Arg(100)->Arg(10)->Arg(1)->Unit(benchmark::kMicrosecond);

void seriesViewNaively(benchmark::State& state) {
  const std::vector<Sample> all = samples();
  const double until_s = kSamples * kStep_s * double(state.range(0)) / 100, width_s = until_s / kColumns;
  for (auto _ : state) {
    std::vector<std::pair<double, double>> columns(
        kColumns, {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
    for (const Sample& each : all) {
      if (each.at_s >= until_s) break;
      auto& [least, greatest] = columns[std::min(std::size_t(each.at_s / width_s), columns.size() - 1)];
      least = std::min(least, each.value);
      greatest = std::max(greatest, each.value);
    }
    benchmark::DoNotOptimize(columns.data());
  }
}
BENCHMARK(seriesViewNaively)->Arg(100)->Arg(10)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
