// The requests to the simulator, and how many at the same time.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

#include "simulator/simulator.h"

namespace mapwright::simulator {

/// Keeps the newest million requests. Safe from any thread.
class RequestLog {
 public:
  /// A request has arrived. The number identifies its entry for finish().
  std::uint64_t begin(RequestRecord record, bool is_submap) {
    const std::lock_guard lock(mutex_);
    if (is_submap) ++submaps_in_progress_;
    record.at_s = seconds();
    record.concurrent = submaps_in_progress_;
    records_.push_back(std::move(record));
    if (records_.size() > kMostRecords) {
      records_.pop_front();
      ++first_;
    }
    return first_ + records_.size() - 1;
  }
  /// Its last byte was written, or it was given up (status 0).
  void finish(std::uint64_t number, bool is_submap, int status, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (is_submap) --submaps_in_progress_;
    if (number < first_) return;
    RequestRecord& record = records_[static_cast<std::size_t>(number - first_)];
    record.until_s = seconds();
    record.status = status;
    record.bytes = bytes;
  }

  std::vector<RequestRecord> records() const {
    const std::lock_guard lock(mutex_);
    return {records_.begin(), records_.end()};
  }
  void clear() {  // requests in progress keep counting
    const std::lock_guard lock(mutex_);
    first_ += records_.size();
    records_.clear();
  }

 private:
  static constexpr std::size_t kMostRecords = 1'000'000;
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  }

  mutable std::mutex mutex_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::deque<RequestRecord> records_;
  std::uint64_t first_ = 0;  // number of records_.front()
  int submaps_in_progress_ = 0;
};

/// One entry of the log: finished once, at the latest by the destructor.
class LoggedRequest {
 public:
  LoggedRequest(RequestLog& log, RequestRecord record, bool is_submap)
      : log_(log), is_submap_(is_submap), number_(log.begin(std::move(record), is_submap)) {}
  ~LoggedRequest() { finish(0, 0); }
  LoggedRequest(const LoggedRequest&) = delete;
  LoggedRequest& operator=(const LoggedRequest&) = delete;
  void finish(int status, std::size_t bytes) {
    if (!std::exchange(finished_, true)) log_.finish(number_, is_submap_, status, bytes);
  }

 private:
  RequestLog& log_;
  const bool is_submap_;
  const std::uint64_t number_;
  bool finished_ = false;
};

}  // namespace mapwright::simulator
