// A bag as a command reads it: looks it up by name and waits for the data.
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
  /// Connects to the robot of `words`; requests only its bags, without needing a live connection.
  static CommandResult<BagReading> open(MapsCommand& command, const BagsWords& words);

  MapReading& robot() const { return *robot_; }
  robot::BagLibrary& library() const { return *library_; }
  /// The bag of this name, or else the recording. A name that is not listed is requested anyway: the robot
  /// then says what is wrong.
  robot::BagKey keyOf(const std::string& name) const;
  /// Names the bag, where it is about one.
  CommandFailure failure(const map::Failure& failed) const;

  /// Opens it for replaying.
  CommandResult<replay::Reading*> replay(const std::string& name);
  /// For reading once from one end to the other; Whole keeps complete texts.
  enum class Texts { Short, Whole };
  CommandResult<replay::Reading*> readThrough(const std::string& name, Texts texts);
  /// Runs until `done`, which is called again after each read. Ends with a failure if the robot cannot
  /// deliver a range, or keeps failing.
  std::optional<CommandFailure> waitUntil(const std::function<bool()>& done);
  /// Passes on the ranges that overlap `from_s` to `to_s`, in order; without limits all of them, whatever
  /// times they state. Reads nothing else. Ends if `take` fails.
  using TakeRange = std::function<std::optional<CommandFailure>(const replay::Chunk&)>;
  std::optional<CommandFailure> readRanges(std::optional<double> from_s, std::optional<double> to_s,
                                           const TakeRange& take);
  /// Reads the whole bag; its index is complete afterwards.
  std::optional<CommandFailure> readWhole();
  /// The exact state at `at_s`.
  CommandResult<replay::Moment> momentAt(double at_s);
  /// Notes topics that a file does not contain. Robots only report topics that they have sent.
  void noteUnknown(const std::vector<std::string>& topics);
  /// Notes messages before `until_s` that could not be read or have no time stamp.
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
