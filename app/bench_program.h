// mapwright bench: a program of its own, mapwright-bench, started in place of this one.
#pragma once

#include <string>
#include <vector>

namespace mapwright::app {

/// Hands over to mapwright-bench beside this program; returns an exit code only when it is not there.
int bench(const std::vector<std::string>& arguments);

}  // namespace mapwright::app
