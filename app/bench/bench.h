// mapwright bench: the benchmarks and their baselines, in one run.
#pragma once

#include <string>
#include <vector>

namespace mapwright::app {

/// Passes `arguments` to Google Benchmark and runs what they select. Returns an exit code.
int bench(const std::vector<std::string>& arguments, char* program);

}  // namespace mapwright::app
