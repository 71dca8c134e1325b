// mapwright-bench: the benchmarks and their baselines, in one run. Arguments go to Google Benchmark.
#include <csignal>
#include <cstdio>
#include <string_view>

#include <benchmark/benchmark.h>

#include "app/display.h"
#include "app/exit_code.h"
#include "app/log.h"

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  static_cast<void>(mapwright::app::startLog({}));
  int qt_argc = 1;
  char* qt_argv[] = {argv[0], nullptr};
  mapwright::app::OffscreenApplication application(qt_argc, qt_argv);
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--help" || word == "-h") {
      std::printf(
          "Options go to Google Benchmark: --benchmark_filter=REGEX, --benchmark_list_tests, "
          "--benchmark_format=json, --benchmark_min_time=SECONDS\n");
      return mapwright::app::kDone;
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return mapwright::app::kUsage;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return mapwright::app::kDone;
}
