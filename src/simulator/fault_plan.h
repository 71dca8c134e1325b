// Decides which requests fail, and how: depends on the seed, the request's key and the attempt.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "simulator/simulator.h"

namespace mapwright::simulator {

enum class FaultKind { None, Drop, Truncate, WrongSize, Corrupt, HttpError, StatusError };

struct Fault {
  FaultKind kind = FaultKind::None;
  int delay_ms = 0;
  int http_status = 500;
  std::uint64_t dice = 0;  // for other random choices of the fault
};

enum class WriteFault { None, Error, Drop, LoseAnswer };

/// Safe from any thread.
class FaultPlan {
 public:
  FaultPlan(const Faults& faults, std::uint32_t seed) : faults_(faults), seed_(seed) {}

  Faults faults() const;
  void setFaults(const Faults& faults);
  /// The result for the next attempt of `key`.
  Fault draw(const std::string& key);
  /// What happens to a changing request. `dice` decides the rest.
  WriteFault drawWrite(const std::string& key, std::uint64_t& dice);

 private:
  std::uint64_t next(const std::string& key);

  mutable std::mutex mutex_;
  Faults faults_;
  const std::uint32_t seed_;
  std::map<std::string, std::uint32_t> tries_;
};

/// The protobuf `body` with a width and height that do not match its cells.
std::string withWrongSize(const std::string& body);
/// Bytes that are not a protobuf message.
std::string garbage(std::uint64_t seed);
/// An answer whose StatusResponse reports an error.
std::string statusAnswer(int code, const std::string& message);

}  // namespace mapwright::simulator
