// A bag as a command reads it: looks it up by name and waits for the data.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/robot_command.h"
#include "excerpt/time_span.h"
#include "replay/reading.h"
#include "robot/bag_library.h"

namespace mapwright::app {

/// The options as typed; empty = not given. Times: timeFrom().
struct BagsArguments : RobotArguments {
  BagsArguments() { timeout_s = 300; }
  std::string name;                        // of a bag or a recording (mapwright bags list)
  std::string from, to, at;                // times
  std::vector<std::string> topics;         // frames, export: of these alone
  std::string kinds;                       // events: of these groups alone
  std::string output;                      // download: the file; "" = named after the bag. export, track
  std::string format;                      // export, track; "" = by the extension of the file
  std::string suffix, duration, category;  // record
  std::vector<std::string> files;          // merge: the inputs
  std::string against;                     // report: another bag, or one and its time: OTHER@TIME
  double every_s = 60;                     // split
  bool yes = false, force = false;
};

class BagReading {
 public:
  /// Connects to the robot of the command; requests only its bags, without needing a live connection.
  static CommandResult<BagReading> open(RobotCommand& command, const QString& address = {});

  RobotReading& robot() const { return *robot_; }
  robot::BagLibrary& library() const { return *library_; }
  /// The bag of this name, or else the recording. A name that is not listed is requested anyway: the robot
  /// then says what is wrong.
  robot::BagKey keyOf(const std::string& name) const;
  /// Names the bag, where it is about one.
  tl::unexpected<CommandFailure> failure(const map::Failure& failed) const;

  /// Opens it for replaying.
  CommandResult<replay::Reading*> replay(const std::string& name);
  /// For reading once from one end to the other; Whole keeps complete texts.
  enum class Texts { Short, Whole };
  CommandResult<replay::Reading*> readThrough(const std::string& name, Texts texts);
  /// Runs until `done`, which is called again after each read. Ends with a failure if the robot cannot
  /// deliver a range, or keeps failing.
  CommandResult<void> waitUntil(const std::function<bool()>& done);
  /// Passes on the ranges that overlap `from_s` to `to_s`, in order; without limits all of them, whatever
  /// times they state. Reads nothing else. Ends if `use` fails.
  using UseRange = std::function<CommandResult<void>(const replay::Chunk&)>;
  CommandResult<void> readRanges(std::optional<double> from_s, std::optional<double> to_s,
                                 const UseRange& use);
  /// Reads the whole bag; its index is complete afterwards.
  CommandResult<void> readWhole();
  /// The exact state at `at_s`.
  CommandResult<replay::Moment> momentAt(double at_s);
  /// Notes what was asked for and is not there: notFound().
  void reportNotFound(const std::vector<std::string>& topics, const excerpt::TimeSpan& span,
                      std::size_t messages, const std::set<std::string>& found);
  /// Notes messages before `until_s` that could not be read or have no time stamp, and the parts of the bag
  /// from `from_s` to there that the robot refused.
  void reportUnreadable(double until_s, std::optional<double> from_s = {});

 private:
  BagReading() = default;
  CommandResult<replay::Reading*> open(const std::string& name, replay::Reading::Options options);
  /// Fails if everything until then that has messages was refused.
  CommandResult<void> anyRead(double until_s) const;
  RobotReading* robot_ = nullptr;
  robot::BagLibrary* library_ = nullptr;
  std::unique_ptr<replay::Reading> reading_;
  /// Messages that could not be read, by the start of their range.
  std::shared_ptr<std::map<double, std::int64_t>> unreadable_ =
      std::make_shared<std::map<double, std::int64_t>>();
};

/// Adds an option for a time of a recording; words that can be none are refused.
enum class Needed { No, Yes };
void addTime(CLI::App& command, const std::string& name, std::string& word, Needed needed = Needed::No);
/// Such a time of `bag`, as it is typed in the window (excerpt::timeTyped); with its day, or in seconds since
/// 1970, it may lie outside. The error names the option.
CommandResult<double> timeFrom(const std::string& word, const QString& option, const robot::BagInfo& bag);
/// --from and --to.
CommandResult<excerpt::TimeSpan> timeSpanFrom(const BagsArguments& args, const robot::BagInfo& bag);
/// False: it is no time of any recording.
bool isTime(const std::string& word);
/// The same in a bag of the robot at `address`, which is asked when the bag begins and ends if need be.
CommandResult<double> timeIn(const RobotArguments& args, const QString& address, const std::string& bag,
                             const std::string& word, const QString& option);

/// Sentences on what was asked for and is not there: these topics, or anything within these times.
QStringList notFound(const std::vector<std::string>& topics, const excerpt::TimeSpan& span,
                     std::size_t messages, const std::set<std::string>& found);

/// "frames/%05d.png" and 7 -> "frames/00007.png"; empty where there is no %d, %0Nd or more than one.
QString numbered(const QString& pattern, int number);

// Files made of bags.
CommandResult<int> bagsExport(RobotCommand& command, const BagsArguments& args);
CommandResult<int> bagsTrack(RobotCommand& command, const BagsArguments& args);
CommandResult<int> bagsRepair(RobotCommand& command, const BagsArguments& args);
CommandResult<int> bagsSplit(RobotCommand& command, const BagsArguments& args);
CommandResult<int> bagsMerge(RobotCommand& command, const BagsArguments& args);
CommandResult<int> bagsReport(RobotCommand& command, const BagsArguments& args);

}  // namespace mapwright::app
