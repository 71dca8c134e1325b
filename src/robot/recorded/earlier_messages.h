// What was said earlier in a recording and still counts at a time, for those who cut parts out of it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "recording/source.h"

namespace mapwright::robot::recorded {

/// When it was said: its log time, but for what a part of a recording says of the time before it
/// (recorder/layout.h).
std::int64_t saidNs(const recording::Message& message);

/// Of all topics, also those that are not drawn (Lasting). One thread, that of the file, which outlives it.
class EarlierMessages {
 public:
  explicit EarlierMessages(recording::Source& file);
  ~EarlierMessages();
  /// Reads on, at most so many messages; true: everything before `at_ns` is known.
  bool reach(std::int64_t at_ns, int most);
  /// In the order in which they were said.
  std::vector<recording::Message> before(std::int64_t at_ns);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mapwright::robot::recorded
