// A bag as a command reads it: found by its name, waited for.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bags.h"
#include "app/maps_command.h"
#include "excerpt/time_span.h"
#include "replay/reading.h"
#include "robot/bag_library.h"

namespace mapwright::app {

class BagReading {
 public:
  /// Asks the robot of `words`; nothing but its bags is asked for, and no live link is needed.
  static CommandResult<BagReading> open(MapsCommand& command, const BagsWords& words);

  MapReading& robot() const { return *robot_; }
  robot::BagLibrary& library() const { return *library_; }
  /// The bag, or else the recording, of this name. One that is not listed is asked for all the same: what is
  /// wrong with it the robot says.
  robot::BagKey keyOf(const std::string& name) const;
  /// Names the bag, where it is about one.
  CommandFailure failure(const map::Failure& failed) const;

  /// Opens it for replaying.
  CommandResult<replay::Reading*> replay(const std::string& name);
  /// To be read once from one end to the other: whole texts, where they are what is wanted.
  enum class Texts { Short, Whole };
  CommandResult<replay::Reading*> readThrough(const std::string& name, Texts texts);
  /// Until `done`, which is asked again whenever something was read. A range that the robot cannot give, or
  /// fails to give again and again, ends it.
  std::optional<CommandFailure> waitUntil(const std::function<bool()>& done);
  /// Range by range, in their order, those that hold something of `from_s` to `to_s`; without them all,
  /// whatever the told times are. Nothing else is read. A failure of `take` ends it.
  using TakeRange = std::function<std::optional<CommandFailure>(const replay::Chunk&)>;
  std::optional<CommandFailure> readRanges(std::optional<double> from_s, std::optional<double> to_s,
                                           const TakeRange& take);
  /// The bag to its very ends; its index knows all of it then.
  std::optional<CommandFailure> readWhole();
  /// The world of `at_s`, exactly.
  CommandResult<replay::Moment> momentAt(double at_s);
  /// Those of the topics that a file does not hold; robots tell only of what they have sent.
  void noteUnknown(const std::vector<std::string>& topics);
  /// What was read until then lacks what cannot be read, or has no stamp: says so.
  void noteUnreadable(double until_s);

 private:
  BagReading() = default;
  CommandResult<replay::Reading*> open(const std::string& name, replay::Reading::Options options);
  MapReading* robot_ = nullptr;
  robot::BagLibrary* library_ = nullptr;
  std::unique_ptr<replay::Reading> reading_;
  /// Messages that could not be read, by the start of their range.
  std::shared_ptr<std::map<double, std::int64_t>> unreadable_ =
      std::make_shared<std::map<double, std::int64_t>>();
};

/// Seconds since the epoch, or ISO 8601 (without a zone: UTC). The error names the option.
CommandResult<double> timeFrom(const std::string& word, const QString& option);

/// --from and --to.
CommandResult<excerpt::TimeSpan> timeSpanFrom(const BagsWords& words);

}  // namespace mapwright::app
