// Decides which requests fail, and how: depends on the seed, the request's key and the attempt.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "simulator/noise.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {

enum class FaultKind { None, Drop, Truncate, WrongSize, Corrupt, HttpError, StatusError };

struct Fault {
  FaultKind kind = FaultKind::None;
  int delay_ms = 0;
  int http_status = 500;
  std::uint64_t dice = 0;  // for other random choices of the fault
};

enum class WriteFault { None, Error, Drop, LoseAnswer, Ignore };

/// Safe from any thread.
class FaultPlan {
 public:
  FaultPlan(const Faults& faults, std::uint32_t seed) : faults_(faults), seed_(seed) {}

  Faults faults() const {
    const std::lock_guard lock(mutex_);
    return faults_;
  }
  void setFaults(const Faults& faults) {
    const std::lock_guard lock(mutex_);
    faults_ = faults;
  }

  /// The result for the next attempt of `key`.
  Fault draw(const std::string& key) {
    const std::lock_guard lock(mutex_);
    Dice dice(next(key));

    Fault fault;
    fault.http_status = faults_.error_status;
    fault.dice = dice.next();
    const int jitter = std::clamp(faults_.jitter_ms, 0, kLongestDelayMs);
    fault.delay_ms =
        std::clamp(faults_.latency_ms, 0, kLongestDelayMs) + (jitter > 0 ? dice.integer(0, jitter) : 0);
    double lot = unitFrom(dice.next());
    for (const auto& [rate, kind] : {std::pair{faults_.drop_rate, FaultKind::Drop},
                                     {faults_.truncate_rate, FaultKind::Truncate},
                                     {faults_.wrong_size_rate, FaultKind::WrongSize},
                                     {faults_.corrupt_rate, FaultKind::Corrupt},
                                     {faults_.error_rate, FaultKind::HttpError},
                                     {faults_.status_code_rate, FaultKind::StatusError}}) {
      if (!(rate > 0)) continue;
      if (lot < rate) {
        fault.kind = kind;
        break;
      }
      lot -= rate;
    }
    return fault;
  }

  /// What happens to a changing request. `dice` decides the rest.
  WriteFault drawWrite(const std::string& key, std::uint64_t& dice) {
    const std::lock_guard lock(mutex_);
    Dice throws(next(key));
    dice = throws.next();
    double lot = unitFrom(throws.next());
    for (const auto& [rate, fault] : {std::pair{faults_.write_error_rate, WriteFault::Error},
                                      {faults_.drop_writes, WriteFault::Drop},
                                      {faults_.lose_write_answers, WriteFault::LoseAnswer},
                                      {faults_.ignore_writes, WriteFault::Ignore}}) {
      if (lot < rate) return fault;
      lot -= rate;
    }
    return WriteFault::None;
  }

  bool drawCut(const std::string& key) {
    const std::lock_guard lock(mutex_);
    return faults_.cut_downloads > 0 && unitFrom(Dice(next(key)).next()) < faults_.cut_downloads;
  }

 private:
  static constexpr std::size_t kMostKeys = 500'000;
  static constexpr int kLongestDelayMs = 600'000;

  std::uint64_t next(const std::string& key) {
    if (tries_.size() > kMostKeys) tries_.clear();
    std::uint64_t h = hashOf(seed_, 53, tries_[key]++);
    for (const char c : key) h = mix(h ^ static_cast<unsigned char>(c));
    return h;
  }

  mutable std::mutex mutex_;
  Faults faults_;
  const std::uint32_t seed_;
  std::map<std::string, std::uint32_t> tries_;
};

/// Bytes that are not a protobuf message.
inline std::string garbage(std::uint64_t seed) {
  Dice dice(seed);
  std::string bytes(static_cast<std::size_t>(dice.integer(200, 4000)), '\0');
  for (char& byte : bytes) byte = static_cast<char>(dice.next() & 0xFF);
  bytes[0] = '\x07';  // wire type 7 does not exist: no parser can take it for a message
  return bytes;
}

}  // namespace mapwright::simulator
