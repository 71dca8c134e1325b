// The subcommands of mapwright and their common options (docs/how-to/add-a-command.md).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QString>
#include <tl/expected.hpp>

#include "app/exit_code.h"
#include "app/robot_access.h"

namespace CLI {
class App;
}  // namespace CLI

namespace mapwright::app {

/// Why a command could not do its job: a sentence and the exit code that it comes with.
struct CommandFailure {
  int exit_code = 0;
  QString sentence;
  bool reported = true;  // also to --report
};
template <typename T>
using CommandResult = tl::expected<T, CommandFailure>;
/// The options given make no sense together or on their own.
inline tl::unexpected<CommandFailure> wrong(const QString& sentence) {
  return tl::make_unexpected(CommandFailure{kUsage, sentence});
}
/// The file of --report is another output, which is not written either.
inline tl::unexpected<CommandFailure> sharedOutput(const QString& sentence) {
  return tl::make_unexpected(CommandFailure{kUsage, sentence, false});
}
/// The same failure as the result of something else.
template <typename Result>
auto passOn(const Result& failed) {
  return tl::make_unexpected(failed.error());
}

/// The options of every command that talks to a robot, as typed; empty = not given.
struct RobotArguments {
  std::string robot;
  AccessArguments access;
  double timeout_s = 60;
  std::string report;
  bool json = false;
};

/// The options before the subcommand, and the arguments that Qt takes.
struct Invocation {
  const std::string& robot;
  const AccessArguments& access;
  int& argc;
  char** argv;
};

/// Uses the robot given before the subcommand if the subcommand names none, and the options given there: its
/// --secret-file belongs to its --robot.
void inherit(RobotArguments& args, const Invocation& before);

class Commands {
 public:
  /// The exit code (docs/command-line.md).
  using Run = std::function<int(const Invocation&)>;

  /// `program` outlives this.
  explicit Commands(CLI::App& program) : program_(program) {}
  CLI::App& program() { return program_; }

  /// `command` must not have subcommands of its own.
  void add(const CLI::App* command, Run run) { runs_.emplace_back(command, std::move(run)); }
  /// Runs the command that was given; nullopt: none was given.
  std::optional<int> run(const Invocation& before) const;

 private:
  CLI::App& program_;
  std::vector<std::pair<const CLI::App*, Run>> runs_;
};

/// What --help says, as CLI11 takes it.
inline std::string help(const QString& text) { return text.toStdString(); }

/// Adds --robot, --secret-file, --secret-file-for and --ca-file; `about`: which addresses it accepts. Values
/// are written into the arguments, here and below, which must outlive `command`.
void addRobot(CLI::App& command, RobotArguments& args, const QString& about);
/// --secret-file, --secret-file-for and --ca-file.
void addAccess(CLI::App& command, AccessArguments& access);
/// Adds --timeout in seconds; `about`: what is given up then, empty = waiting.
void addTimeout(CLI::App& command, double& timeout_s, const QString& about = {});
/// --report
void addReport(CLI::App& command, std::string& path);
/// --force, of what people edit or cannot make again; pictures and reports are replaced without it
/// (notCreatedReason()).
void addForce(CLI::App& command, bool& force);
/// --json
void addJson(CLI::App& command, bool& json);

/// A sentence if --timeout is out of range.
std::optional<QString> noTimeoutReason(double timeout_s);
/// "12", "-0.5", "1e-3".
bool isDecimal(const std::string& word);
/// "1,-0.5, 2": decimal numbers separated by commas, absolute values up to 1e9; nullopt = anything else.
std::optional<std::vector<double>> numbersFrom(const std::string& typed);
/// Names the types of the options of `app` and its subcommands that are typed as text and are files or
/// numbers.
void nameTypes(CLI::App& app);
/// Makes every option of `app` and its subcommands refuse empty values, and numeric ones anything but decimal
/// numbers ("nan", "inf", "0x10" and "5 m" are refused).
void refuseOddWords(CLI::App& app);

// In the order of --help.
void addSimulate(Commands& commands);
void addSnapshot(Commands& commands);
void addCompare(Commands& commands);
void addSuite(Commands& commands);
void addMaps(Commands& commands);
/// Subcommands of `maps`: where the robot is.
void addPoses(Commands& commands, CLI::App& maps);
/// Subcommands of `maps`: whole maps on their way.
void addMapTransfers(Commands& commands, CLI::App& maps);
void addProjections(Commands& commands);
/// Below `waypoints` or `overlays`.
enum class CarriedKind { Waypoints, Overlays };
void addCarry(Commands& commands, CLI::App& parent, CarriedKind kind);
void addWaypoints(Commands& commands);
void addOverlays(Commands& commands);
void addBags(Commands& commands);
void addRecord(Commands& commands);
void addClouds(Commands& commands);
void addSlam(Commands& commands);
/// Subcommands of `slam`: the pose graph.
void addSlamGraph(Commands& commands, CLI::App& slam);
/// Subcommands of `slam`: new state files.
void addSlamDrop(Commands& commands, CLI::App& slam);
/// Subcommands of `slam`: whether submaps agree.
void addSlamAgreement(Commands& commands, CLI::App& slam);
void addTopics(Commands& commands);
void addProbe(Commands& commands);

/// A subcommand with the options that all commands for a robot have.
CLI::App* addRobotCommand(CLI::App& parent, const char* name, const QString& about, const QString& robots,
                          RobotArguments& args);

}  // namespace mapwright::app
