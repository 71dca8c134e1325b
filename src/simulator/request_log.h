// What was asked of the simulator, and how much of it at the same time.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "simulator/simulator.h"

namespace mapwright::simulator {

/// Holds the newest million requests. Safe from any thread.
class RequestLog {
 public:
  /// A request has come. The number names its line for finish().
  std::uint64_t begin(RequestRecord record, bool is_submap);
  /// Its last byte was written, or it was given up (status 0).
  void finish(std::uint64_t number, bool is_submap, int status, std::size_t bytes);

  std::vector<RequestRecord> records() const;
  void clear();  // requests under way go on counting

 private:
  double seconds() const;

  mutable std::mutex mutex_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::deque<RequestRecord> records_;
  std::uint64_t first_ = 0;  // number of records_.front()
  int submaps_under_way_ = 0;
};

/// One line of the log: finished once, at the latest when it goes away.
class LoggedRequest {
 public:
  LoggedRequest(RequestLog& log, RequestRecord record, bool is_submap);
  ~LoggedRequest();
  LoggedRequest(const LoggedRequest&) = delete;
  LoggedRequest& operator=(const LoggedRequest&) = delete;
  void finish(int status, std::size_t bytes);

 private:
  RequestLog& log_;
  const bool is_submap_;
  const std::uint64_t number_;
  bool finished_ = false;
};

}  // namespace mapwright::simulator
