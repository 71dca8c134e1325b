#include "work/budgets.h"

#include <algorithm>

namespace mapwright::work {

Budgets budgetsFrom(std::size_t bytes) {
  // As they have proved themselves: with the usual budget 256 MiB, 64, 192, 64, 64 and 128.
  const std::size_t part = std::max(bytes, kLeastBudget) / 24;
  return {8 * part, 2 * part, 6 * part, 2 * part, 2 * part, 4 * part};
}

}  // namespace mapwright::work
