// The subcommands of mapwright, and the options that many of them have (docs/how-to/add-a-command.md).
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

/// What was given before the subcommand, and what Qt takes.
struct Invocation {
  const std::string& robot;
  const AccessWords& access;
  int& argc;
  char** argv;
};

/// Where `robot` was not named with the subcommand it is the one before it; `access` gets what was given
/// there.
void inherit(std::string& robot, AccessWords& access, const Invocation& before);

class Commands {
 public:
  /// The exit code (docs/command-line.md).
  using Run = std::function<int(const Invocation&)>;

  /// `program` outlives this.
  explicit Commands(CLI::App& program) : program_(program) {}
  CLI::App& program() { return program_; }

  /// `command`: one that has no subcommands of its own.
  void add(const CLI::App* command, Run run) { runs_.emplace_back(command, std::move(run)); }
  /// One that speaks to a robot: what was given before it holds for it, too.
  template <typename Words>
  void add(const CLI::App* command, std::shared_ptr<Words> words,
           std::type_identity_t<std::function<int(const Words&, int&, char**)>> run) {
    add(command, [words = std::move(words), run = std::move(run)](const Invocation& before) {
      inherit(words->robot, words->access, before);
      return run(*words, before.argc, before.argv);
    });
  }

  /// Runs the one that was given; nullopt: none was.
  std::optional<int> run(const Invocation& before) const;

 private:
  CLI::App& program_;
  std::vector<std::pair<const CLI::App*, Run>> runs_;
};

/// --robot, with --secret-file, --secret-file-for and --ca-file; `about`: which addresses it takes. What is
/// typed goes into what is handed in, here and below, which outlives `command`.
void addRobot(CLI::App& command, std::string& robot, AccessWords& access, const QString& about);
/// --secret-file, --secret-file-for and --ca-file.
void addAccess(CLI::App& command, AccessWords& access);
/// --timeout in seconds; `about`: what is given up then, empty = waiting.
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
