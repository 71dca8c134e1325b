// How long to wait before trying again.
#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace mapwright::net {

/// Exponential backoff with jitter: the n-th wait lies between `first` * 2^n and 1.25 times that, at most
/// `limit`. The first wait is never shorter than `first`.
class Backoff {
 public:
  Backoff(std::chrono::milliseconds first, std::chrono::milliseconds limit, std::uint32_t seed);
  std::chrono::milliseconds next();
  void reset();

 private:
  std::chrono::milliseconds first_, limit_;
  int tries_ = 0;
  std::minstd_rand random_;
};

}  // namespace mapwright::net
