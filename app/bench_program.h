// mapwright bench: starts a separate program, mapwright-bench, in place of this one.
#pragma once

#include <string>
#include <vector>

namespace mapwright::app {

/// Replaces this process with mapwright-bench from the same folder; returns an exit code only if it is
/// missing.
int bench(const std::vector<std::string>& arguments);

}  // namespace mapwright::app
