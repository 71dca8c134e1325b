// Decides which requests fail, and how: depends on the seed, the request and the attempt.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "simulator/noise.h"
#include "simulator/simulator.h"

namespace mapwright::simulator {

/// What happens to one request.
struct Verdict {
  std::optional<FaultKind> kind;  // none of the delays
  int delay_ms = 0;
  int number = 0;          // of the row
  std::uint64_t dice = 0;  // for other random choices

  bool is(FaultKind other) const { return kind == other; }
  /// Whether the request is carried out.
  bool isDone() const { return !is(FaultKind::Drop) && !is(FaultKind::Refuse) && !is(FaultKind::Ignore); }
  bool isAnswered() const { return !is(FaultKind::Drop) && !is(FaultKind::Cut) && !is(FaultKind::Silence); }
};

/// Safe from any thread.
class FaultPlan {
 public:
  static constexpr int kLongestDelayMs = 600'000;

  FaultPlan(const Faults& faults, std::uint32_t seed) : faults_(faults), seed_(seed) {}

  Faults faults() const {
    const std::lock_guard lock(mutex_);
    return faults_;
  }
  void setFaults(const Faults& faults) {
    const std::lock_guard lock(mutex_);
    faults_ = faults;
  }
  bool isSilent(std::string_view topic) const {
    const std::lock_guard lock(mutex_);
    return std::find(faults_.silent.begin(), faults_.silent.end(), topic) != faults_.silent.end();
  }

  /// `of`: what kinds of request it is. `target`: a path, with or without a query, or the name of a service.
  Verdict decide(unsigned of, std::string_view method, std::string_view target) {
    const std::lock_guard lock(mutex_);
    std::vector<const RequestFault*> rows;
    for (const RequestFault& row : faults_.requests) {
      if ((row.of & of) != 0 && isBelow(target.substr(0, target.find('?')), row.path)) rows.push_back(&row);
    }
    Verdict verdict;
    if (rows.empty()) return verdict;
    Dice dice(next(method, target));
    verdict.dice = dice.next();
    for (const RequestFault* row : rows) {
      const int most_ms = std::clamp(row->number, 0, kLongestDelayMs);
      if (row->kind == FaultKind::Delay) verdict.delay_ms += most_ms;
      if (row->kind == FaultKind::Jitter && most_ms > 0) verdict.delay_ms += dice.integer(0, most_ms);
    }
    double lot = unitFrom(dice.next());
    for (const RequestFault* row : rows) {
      if (row->kind == FaultKind::Delay || row->kind == FaultKind::Jitter) continue;
      if (row->kind == FaultKind::Ignore && (of & kWrites) == 0) continue;
      if (lot < row->rate) {
        verdict.kind = row->kind;
        verdict.number = row->number;
        break;
      }
      lot -= row->rate;
    }
    return verdict;
  }

 private:
  static constexpr std::size_t kMostKeys = 500'000;

  static bool isBelow(std::string_view path, std::string_view prefix) {
    if (!path.starts_with(prefix)) return false;
    return prefix.empty() || prefix.ends_with('/') || path.size() == prefix.size() ||
           path[prefix.size()] == '/';
  }

  std::uint64_t next(std::string_view method, std::string_view target) {
    const std::string key =
        (method == "GET" ? std::string() : std::string(method) + ' ') + std::string(target);
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

/// A map's resolution as Faults::grid_fault leaves it; nullopt if it is left out.
inline std::optional<double> faultyResolution(double resolution, std::string_view fault) {
  if (fault == "no-resolution") return std::nullopt;
  return fault == "zero-resolution" ? 0 : fault == "negative-resolution" ? -resolution : resolution;
}

/// Bytes that are not a protobuf message.
inline std::string garbage(std::uint64_t seed) {
  Dice dice(seed);
  std::string bytes(static_cast<std::size_t>(dice.integer(200, 4000)), '\0');
  for (char& byte : bytes) byte = static_cast<char>(dice.next() & 0xFF);
  bytes[0] = '\x07';  // wire type 7 does not exist: no parser can take it for a message
  return bytes;
}

}  // namespace mapwright::simulator
