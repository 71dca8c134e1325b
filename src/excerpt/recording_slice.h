// A part of a recording on this computer as an MCAP file of its own: its messages unchanged, the state before
// it, and all attachments.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "excerpt/excerpt.h"
#include "fault/fault.h"
#include "recording/source.h"

namespace mapwright::excerpt {

using GoesOn = std::function<bool(double share)>;

/// A recording that parts are cut out of; what was found out for one helps with the next. One thread.
class Slicing {
 public:
  /// The error does not contain the name of the file.
  static tl::expected<Slicing, Fault> open(const std::string& path);
  Slicing(Slicing&&) noexcept;
  ~Slicing();
  recording::Source& source() const;

  /// Copies the part selected by `order` (an MCAP file). What was said before the span and still counts then
  /// is written first (robot::recorded::EarlierMessages), on channels with the metadata said=before
  /// (recorder/layout.h): played alone the part shows what the whole shows in that time. Blocks; calls
  /// `goes_on` now and then with the share done (0..1); if that returns false it stops and nothing is left.
  /// nullopt: stopped by `goes_on`.
  tl::expected<std::optional<Written>, Fault> slice(const Order& order, const GoesOn& goes_on = {});

 private:
  struct Parts;
  explicit Slicing(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// The same for one part of the recording `path`.
tl::expected<std::optional<Written>, Fault> sliceRecording(const std::string& path, const Order& order,
                                                           const GoesOn& goes_on = {});

}  // namespace mapwright::excerpt
