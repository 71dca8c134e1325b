// A part of a bag as an MCAP file, laid out like a session recorded here (recorder/layout.h): played alone it
// shows what the bag shows in that time, except how it came about.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "disk/file_error.h"
#include "excerpt/time_span.h"
#include "excerpt/whole_target.h"
#include "recording/mcap_writer.h"
#include "robot/bag_library.h"

namespace mapwright::excerpt {

/// One thread. finish() gives the file its name; without it nothing is left.
class BagMcap {
 public:
  static tl::expected<std::unique_ptr<BagMcap>, disk::FileError> create(const std::string& path,
                                                                        const std::string& address,
                                                                        const std::string& bag,
                                                                        const TimeSpan& span);
  BagMcap(const BagMcap&) = delete;
  BagMcap& operator=(const BagMcap&) = delete;

  /// In playing order. Of messages before the span the last one of each topic is kept as its initial state;
  /// messages after it are left out.
  std::optional<disk::FileError> take(const robot::BagMessage& message, std::string_view json);
  std::optional<disk::FileError> finish();

  std::int64_t messages() const { return messages_; }  // in the span
  std::int64_t saidBefore() const { return said_before_; }

 private:
  BagMcap(std::string path, TimeSpan span) : path_(std::move(path)), span_(span) {}
  std::optional<disk::FileError> begin();
  std::optional<disk::FileError> write(const std::string& topic, bool before, double log_s, double stamp_s,
                                       std::string_view json);

  std::string path_;
  TimeSpan span_;
  WholeTarget* target_ = nullptr;  // the writer's
  std::unique_ptr<recording::McapWriter> writer_;
  struct Said {
    double stamp_s = 0;
    std::string json;
  };
  std::map<std::string, Said> said_;  // by topic
  std::map<std::string, std::uint32_t> sequences_;
  bool begun_ = false;
  std::int64_t messages_ = 0, said_before_ = 0;
};

}  // namespace mapwright::excerpt
