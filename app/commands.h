// The subcommands of mapwright and their common options (docs/how-to/add-a-command.md).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <QString>

#include "app/robot_access.h"

namespace CLI {
class App;
}

namespace mapwright::app {

/// The options before the subcommand, and the arguments that Qt takes.
struct Invocation {
  const std::string& robot;
  const AccessWords& access;
  int& argc;
  char** argv;
};

/// Uses the robot given before the subcommand if the subcommand names none; `access` gets the options given
/// there.
void inherit(std::string& robot, AccessWords& access, const Invocation& before);

class Commands {
 public:
  /// The exit code (docs/command-line.md).
  using Run = std::function<int(const Invocation&)>;

  /// `program` outlives this.
  explicit Commands(CLI::App& program) : program_(program) {}
  CLI::App& program() { return program_; }

  /// `command` must not have subcommands of its own.
  void add(const CLI::App* command, Run run) { runs_.emplace_back(command, std::move(run)); }
  /// For a command that talks to a robot: also applies the options given before it.
  template <typename Words>
  void add(const CLI::App* command, std::shared_ptr<Words> words,
           std::type_identity_t<std::function<int(const Words&, int&, char**)>> run) {
    add(command, [words = std::move(words), run = std::move(run)](const Invocation& before) {
      inherit(words->robot, words->access, before);
      return run(*words, before.argc, before.argv);
    });
  }

  /// Runs the command that was given; nullopt: none was given.
  std::optional<int> run(const Invocation& before) const;

 private:
  CLI::App& program_;
  std::vector<std::pair<const CLI::App*, Run>> runs_;
};

/// Adds --robot, --secret-file, --secret-file-for and --ca-file; `about`: which addresses it accepts. Values
/// are written into the arguments, here and below, which must outlive `command`.
void addRobot(CLI::App& command, std::string& robot, AccessWords& access, const QString& about);
/// --secret-file, --secret-file-for and --ca-file.
void addAccess(CLI::App& command, AccessWords& access);
/// Adds --timeout in seconds; `about`: what is given up then, empty = waiting.
void addTimeout(CLI::App& command, double& timeout_s, const QString& about = {});
/// --report
void addReport(CLI::App& command, std::string& path);
/// --json
void addJson(CLI::App& command, bool& json);

// In the order of --help.
void addSimulate(Commands& commands);
void addSnapshot(Commands& commands);
void addMaps(Commands& commands);
void addProjections(Commands& commands);
void addWaypoints(Commands& commands);
void addBags(Commands& commands);
void addRecord(Commands& commands);
void addClouds(Commands& commands);
void addTopics(Commands& commands);

}  // namespace mapwright::app
