#include "net/backoff.h"

#include <algorithm>

namespace mapwright::net {

Backoff::Backoff(std::chrono::milliseconds first, std::chrono::milliseconds limit, std::uint32_t seed)
    : first_(first), limit_(limit), random_(seed) {}

std::chrono::milliseconds Backoff::next() {
  const double doubled = double(first_.count()) * double(1u << std::min(tries_, 20));
  ++tries_;
  const double jitter = std::uniform_real_distribution<double>(1.0, 1.25)(random_);
  const double wait = std::min(doubled * jitter, double(limit_.count()));
  return std::chrono::milliseconds(
      std::max<std::int64_t>(std::int64_t(wait), std::min(first_, limit_).count()));
}

void Backoff::reset() { tries_ = 0; }

}  // namespace mapwright::net
