// How long to wait before trying again.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>

namespace mapwright::net {

/// Exponential backoff with jitter: the n-th wait lies between `first` * 2^n and 1.25 times that, at most
/// `limit`. The first wait is never shorter than `first`.
class Backoff {
 public:
  Backoff(std::chrono::milliseconds first, std::chrono::milliseconds limit, std::uint32_t seed)
      : first_(first), limit_(limit), random_(seed) {}
  std::chrono::milliseconds next() {
    const double doubled = double(first_.count()) * double(1u << std::min(tries_++, 20));
    const double jitter = std::uniform_real_distribution<double>(1.0, 1.25)(random_);
    const std::chrono::milliseconds wait(std::int64_t(std::min(doubled * jitter, double(limit_.count()))));
    return std::max(wait, std::min(first_, limit_));
  }
  void reset() { tries_ = 0; }

 private:
  std::chrono::milliseconds first_, limit_;
  int tries_ = 0;
  std::minstd_rand random_;
};

}  // namespace mapwright::net
