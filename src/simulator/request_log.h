// The requests to the simulator, and how many at the same time.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "simulator/simulator.h"

namespace mapwright::simulator {

/// Keeps the newest million requests. Safe from any thread.
class RequestLog {
 public:
  /// A request has arrived. The number identifies its entry for finish().
  std::uint64_t begin(RequestRecord record, bool is_submap);
  /// Its last byte was written, or it was given up (status 0).
  void finish(std::uint64_t number, bool is_submap, int status, std::size_t bytes);

  std::vector<RequestRecord> records() const;
  void clear();  // requests in progress keep counting

 private:
  double seconds() const;

  mutable std::mutex mutex_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::deque<RequestRecord> records_;
  std::uint64_t first_ = 0;  // number of records_.front()
  int submaps_under_way_ = 0;
};

/// One entry of the log: finished once, at the latest by the destructor.
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
