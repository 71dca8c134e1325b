#include "app/bench/bench.h"

#include <cstdio>

#include <QApplication>
#include <benchmark/benchmark.h>

#include "app/display.h"
#include "app/exit_code.h"

namespace mapwright::app {

int bench(const std::vector<std::string>& arguments, char* program) {
  chooseOffscreenPlatform();
  int qt_argc = 1;
  char* qt_argv[] = {program, nullptr};
  QApplication application(qt_argc, qt_argv);
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int argc = int(words.size());
  for (const std::string& word : arguments) {
    if (word == "--help" || word == "-h") {
      std::printf(
          "Options go to Google Benchmark: --benchmark_filter=REGEX, --benchmark_list_tests, "
          "--benchmark_format=json, --benchmark_min_time=SECONDS\n");
      return kDone;
    }
  }
  benchmark::Initialize(&argc, argv.data());
  if (benchmark::ReportUnrecognizedArguments(argc, argv.data())) return kUsage;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return kDone;
}

}  // namespace mapwright::app
