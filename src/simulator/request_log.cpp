#include "simulator/request_log.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kMostRecords = 1'000'000;

}  // namespace

double RequestLog::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

std::uint64_t RequestLog::begin(RequestRecord record, bool is_submap) {
  const std::lock_guard lock(mutex_);
  if (is_submap) ++submaps_under_way_;
  record.at_s = seconds();
  record.concurrent = submaps_under_way_;
  records_.push_back(std::move(record));
  if (records_.size() > kMostRecords) {
    records_.pop_front();
    ++first_;
  }
  return first_ + records_.size() - 1;
}

void RequestLog::finish(std::uint64_t number, bool is_submap, int status, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (is_submap) --submaps_under_way_;
  if (number < first_) return;
  RequestRecord& record = records_[static_cast<std::size_t>(number - first_)];
  record.until_s = seconds();
  record.status = status;
  record.bytes = bytes;
}

std::vector<RequestRecord> RequestLog::records() const {
  const std::lock_guard lock(mutex_);
  return {records_.begin(), records_.end()};
}

void RequestLog::clear() {
  const std::lock_guard lock(mutex_);
  first_ += records_.size();
  records_.clear();
}

LoggedRequest::LoggedRequest(RequestLog& log, RequestRecord record, bool is_submap)
    : log_(log), is_submap_(is_submap), number_(log.begin(std::move(record), is_submap)) {}

LoggedRequest::~LoggedRequest() { finish(0, 0); }

void LoggedRequest::finish(int status, std::size_t bytes) {
  if (finished_) return;
  finished_ = true;
  log_.finish(number_, is_submap_, status, bytes);
}

}  // namespace mapwright::simulator
